"""Trains in metres on the emitted runtime: a third opinion, written from physics and from the documents.

Nothing here knows the plant, the claims or the prover; a contract in pyproject.toml forbids importing them.  The
runtime is taken as text and executed; what trains may do follows from lengths, speeds and brakes; a hazard is what a
bystander would call one: two vehicles in the same place, a point that moves under a train, a train over an open bridge.
"""

from interlock.simulate.run import Outcome, simulate

__all__ = ["Outcome", "simulate"]
