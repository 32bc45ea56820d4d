"""Questions of one place: indexed families of routes, their partition, canonical forms."""
