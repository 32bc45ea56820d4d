"""Outputs: tables, Structured Text files, the Python runtime, manifests."""
