"""Plans after which every train is where it may stay: found here, believed by nobody before they were replayed."""
