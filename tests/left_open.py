"""Which claims a controller leaves open: for controllers that are wrong."""

from __future__ import annotations

from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.proof.claims import Facts, claims
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.system.transition import System


def left_open(layout: Layout, controller: Controller) -> set[str]:
    """The claims that do not follow from the invariants that the controller keeps, by their ids.

    As the proof decides it, but for the runs of the routes: a wrong controller is to fail a claim, and one under which
    no train can run is no proof that a claim tells it.
    """
    system = System(layout, controller)
    kept, _, _ = inductive(system, Limits())
    return set(open_claims(system, kept, claims(Facts(system)), Limits()))
