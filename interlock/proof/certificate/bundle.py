"""What is written for `interlock verify`: the system, the proof, and a manifest that ties them to every file.

system.txt   definitions, assumptions, timers, initial condition, invariants, claims with their sentences, one a line
proof.txt    for every goal the clauses that show it, and before it the lemmas among them; compressed (.xz)
needed.txt   which term of the controller each claim rests on
manifest.json   SHA-256 of both, of the layout file and of every emitted file, and of the manifest itself

Expressions are written as `a`, `!a`, `(& a b)`, `(| a b)`; `T` and `F` are the constants.

**Theorem.**  Reading is the inverse of writing: each line has one reading, so that what is checked is the system that
was proved; and whoever changes a file keeps its digest only by a collision of SHA-256.  (Prefix notation, of which no
text has two readings: Lukasiewicz, 1929; that nobody finds a collision is believed, not proved: FIPS 180-4.)
"""

from __future__ import annotations

import hashlib
import json
import lzma
from collections.abc import Iterable, Iterator, Mapping

from interlock import __version__
from interlock.logic.expr import AND, EQ, FALSE, NOT, TRUE, VAR, Expr
from interlock.logic.plant import ASSUMPTIONS
from interlock.proof.certificate.engine import LocalProof
from interlock.proof.certificate.facts import FactBase
from interlock.proof.claims import CLAIMS

SYSTEM, PROOF, NEEDED, MANIFEST = "system.txt", "proof.txt.xz", "needed.txt", "manifest.json"


def text(x: Expr) -> str:
    """An expression with names."""
    if x.op is VAR:
        return x.name
    if x.op is EQ:
        return f"{x.name}={x.value}"
    if x.op is NOT:
        return f"!{text(x.args[0])}"
    if x is TRUE or x is FALSE:
        return "T" if x is TRUE else "F"
    return f"({'&' if x.op is AND else '|'} {' '.join(text(a) for a in x.args)})"


def system_text(base: FactBase) -> str:
    """The system, its invariants and its claims."""
    return "\n".join(_system(base)) + "\n"


def _system(base: FactBase) -> Iterator[str]:
    relation = base.relation
    yield "interlock-system 2"
    for claim in dict.fromkeys(c.id for c in base.claims):
        yield f"sentence {claim} {CLAIMS[claim]}"
    for name in dict.fromkeys(a.id for a in relation.assumptions):
        words = ASSUMPTIONS.get(name) or next(a.text for a in relation.assumptions if a.id == name)
        yield f"assumed {name} {words}"
    for v in relation.state:
        yield f"state {v}"
    for x in base.initial.parts:
        yield f"ini {text(x)}"
    for name, x in relation.definitions.items():
        yield f"def {name} {text(x)}"
    for a in relation.assumptions:
        yield f"asm {a.id} {text(a.expr)}"
    for t in relation.timers.values():
        yield f"timer {t.name} {t.input} {t.preset_ms}"
    for name, size in relation.sizes.items():
        yield f"val {name} {size}"
    for i in base.invariants:
        yield f"inv {_word(i.id)} {_word(i.place)} {text(i.expr)}"
    for c in base.claims:
        yield f"claim {c.id} {_word(c.place)} {text(c.expr)}"
    if base.start is not None:
        yield f"start {text(base.start)}"


def _word(place: str) -> str:
    return place.replace(" ", "_")


def proof_bytes(proof: LocalProof) -> bytes:
    """The proof, compressed; raises ValueError when some goal is open."""
    return lzma.compress(proof_text(proof).encode(), preset=1)


def proof_text(proof: LocalProof) -> str:
    """A line for each lemma and goal; raises ValueError when some goal is open."""
    if proof.open:
        raise ValueError("some goal is not proved")
    lines = ["interlock-proof 4"]
    for o in proof.obligations:
        lines += [f"{_words(lemma.clause)}:{_words(lemma.hints)}" for lemma in o.lemmas]
        lines.append(_words(o.hints))
    return "\n".join(lines) + "\n"


def _words(numbers: Iterable[int]) -> str:
    return " ".join(map(str, numbers))


def manifest_text(name: str, files: Mapping[str, bytes]) -> str:
    """The manifest: digests by path, relative to the bundle, and its own digest."""
    body: dict[str, object] = {
        "schema": "interlock-certificate/1",
        "layout": name,
        "tool": f"interlock {__version__}",
        "files": {path: hashlib.sha256(data).hexdigest() for path, data in sorted(files.items())},
    }
    own = hashlib.sha256(json.dumps(body, sort_keys=True).encode()).hexdigest()
    return json.dumps({**body, "own": own}, indent=1, ensure_ascii=False) + "\n"
