"""Whole proofs that went well, kept for the next run under the digest of all that they are made from.

A proof is made from the table and the layout without lengths, and from what is `measured` of these: the controller, the
plant, claims, invariants, witnesses and texts get nothing else.  The name of a kept proof is the digest of these
values, of this program, and of the engine and what it runs on: another proof has another name.  A file that is damaged,
or that this user has not sealed (`proof/engines/cache.py`), is not believed.
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import interlock
from interlock.app.proved import Proved, TextVerdict
from interlock.model.contents import digest
from interlock.model.layout import Layout
from interlock.model.measured import measured
from interlock.proof.engines.cache import Cache
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import ClaimResult, ProofResult, Verdict, Witness
from interlock.table.rows import InterlockingTable

SOLVERS = ("python-sat", "z3-solver", "cvc5")

Good = tuple[ProofResult, tuple[TextVerdict, ...]]
"""A proof without a blemish, and texts that equal their controller."""


def name(limits: Limits, layout: Layout, table: InterlockingTable) -> str:
    """The name under which the proof of a layout and its table is kept."""
    form = f"{_program()} {digest(layout.bare, measured(layout), table.bare)}"
    return limits.cache.key(lambda: form, limits.engine)


def look(cache: Cache, key: str) -> Good | None:
    """The proof of that name, if it is there."""
    began = time.monotonic()
    body = cache.text(key)
    if body is None:
        return None
    told = json.loads(body)
    claims = tuple(ClaimResult(id_, words, Verdict.PROVED, places, (), 0.0) for id_, words, places in told["claims"])
    runs = tuple(Witness(route, True, steps, text) for route, steps, text in told["witnesses"])
    seconds = time.monotonic() - began
    proof = ProofResult(claims, told["invariants"], (), told["obligations"], runs, seconds, kept=True)
    return proof, tuple(TextVerdict(file, ()) for file in told["texts"])


def keep(cache: Cache, key: str, proved: Proved) -> None:
    """Keep a proof, if nothing is left to be said of it."""
    proof = proved.proof
    if proof is not None and proved.green and not proof.dropped and not proved.notes:
        told = {
            "claims": [[c.id, c.sentence, c.places] for c in proof.claims],
            "invariants": proof.invariants,
            "obligations": proof.obligations,
            "witnesses": [[w.route, w.steps, w.text] for w in proof.witnesses],
            "texts": [t.file for t in proved.texts],
        }
        cache.keep_text(key, json.dumps(told))


@cache
def _program() -> str:
    """The digest of this program, and what it runs on."""
    top = Path(interlock.__file__).parent
    sources = hashlib.sha256()
    for file in sorted(top.rglob("*.py")):
        body = file.read_bytes()
        sources.update(f"{file.relative_to(top)} {len(body)}\n".encode() + body)
    return " ".join([sources.hexdigest(), sys.version, *map(_version, SOLVERS)])


def _version(solver: str) -> str:
    try:
        return version(solver)
    except PackageNotFoundError:  # cvc5 is an extra
        return "none"
