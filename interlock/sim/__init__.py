"""Trains on a running controller."""
