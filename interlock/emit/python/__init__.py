"""The Python runtime: one file that stands alone."""
