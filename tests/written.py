"""Written systems and texts of layouts as the product writes them, nothing of it proved: for the second checker."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from interlock.checker.reading import loaded
from interlock.logic.lower import lower
from interlock.proof.certificate.bundle import system_text
from interlock.proof.certificate.facts import FactBase
from interlock.proof.claims import Facts, strengthening
from interlock.proof.claims import claims as claimed
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from tests.layouts import grown


@cache
def told(source: str) -> tuple[dict[str, Any], str, str]:
    """A layout as the second checker reads it, its written system, and its Structured Text."""
    found = grown(source)
    assert found is not None
    layout, table, _ = found
    system = System(layout, lower(layout, table))
    facts, start = Facts(system), start_claim(system.loop)
    written = system_text(FactBase(system.relation, system.initial, strengthening(facts), claimed(facts), start))
    (text,) = write_st(system.loop.controller, BY_NAME["iec"], []).values()
    return loaded(source), written, text


def shipped(name: str) -> tuple[dict[str, Any], str, str]:
    """The same of a shipped layout."""
    return told(Path(f"layouts/{name}.yaml").read_text("utf-8"))
