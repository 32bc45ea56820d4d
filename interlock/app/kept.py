"""Whole proofs that went well, kept for the next run under the digest of all that they are about.

A change of a layout that changes neither its controller nor anything that is claimed of it asks for the same proof
again.  The name of a kept file is the digest of this program, of the engine, and of everything that the proof, the
witnesses and the comparison of the texts read: another proof has another name.  A file that is damaged is not believed.
"""

from __future__ import annotations

import hashlib
import json
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from functools import cache, partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import interlock
from interlock.app.texts import TextVerdict
from interlock.logic.controller import Controller
from interlock.proof.contents import digest
from interlock.proof.invariants import Claim, Facts, strengthening
from interlock.proof.limits import Limits
from interlock.proof.pool import Begun
from interlock.proof.runner import ProofResult, if_proved
from interlock.proof.system import System
from interlock.proof.witness import Witness

SOLVERS = ("python-sat", "z3-solver", "cvc5")

Good = tuple[ProofResult, tuple[TextVerdict, ...]]
"""A proof without a blemish, and texts that equal their controller."""


class Kept(ExitStack):
    """One proof in the folder of `--cache`, until the end of a `with` block."""

    def __init__(self, limits: Limits, controller: Controller) -> None:
        """Begin to look for the name of the proof, beside what its owner does."""
        super().__init__()
        self._began = time.monotonic()
        self._limits = limits
        self._key = ""
        self._digests: list[Begun] = []
        self._begin(partial(digest, controller))

    def _begin(self, *tasks: Callable[[], str]) -> None:
        self._digests.append(self.enter_context(Begun(tasks, self._limits.jobs)))

    def about(self, system: System) -> None:
        """The system that is proved, and what carries its proof."""
        self._begin(
            partial(_invariants, system),
            partial(digest, system.layout.bare, system.plant, system.definitions, system.initial_parts),
        )

    def look(self, claims: tuple[Claim, ...]) -> Good | None:
        """The proof of the claims, if it is there."""
        cache = self._limits.cache
        form = " ".join([_program(), digest(claims), *(x for begun in self._digests for x in begun.results())])
        self._key = cache.key(lambda: form, self._limits.engine)
        body = cache.text(self._key)
        if body is None:
            return None
        told = json.loads(body)
        runs = tuple(Witness(route, True, steps, text) for route, steps, text in told["witnesses"])
        seconds = time.monotonic() - self._began
        proof = ProofResult(if_proved(claims), told["invariants"], (), told["obligations"], runs, seconds, kept=True)
        return proof, tuple(TextVerdict(file, ()) for file in told["texts"])

    def keep(self, proof: ProofResult, texts: tuple[TextVerdict, ...]) -> None:
        """Keep the proof, if nothing is left to be said of it."""
        if proof.proved and not proof.dropped and texts and all(t.equal for t in texts):
            told = {
                "invariants": proof.invariants,
                "obligations": proof.obligations,
                "witnesses": [[w.route, w.steps, w.text] for w in proof.witnesses],
                "texts": [t.file for t in texts],
            }
            self._limits.cache.keep_text(self._key, json.dumps(told))


def _invariants(system: System) -> str:
    return digest(strengthening(Facts(system)))


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
