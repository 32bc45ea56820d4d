"""Proof: the controller, run against the physics, keeps every claim in every reachable state."""
