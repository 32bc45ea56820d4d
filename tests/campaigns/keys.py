"""Every key of the language against controllers that pass over it: what refuses them, naively and ably forged.

python -m tests.campaigns.keys > proofs/keys.md

Naively: text and written system of the other layout.  Ably: the other layout's text beside a written system of the
author's own layout, with just those of its claims that the specification asks for; what is then not proved is named.
"""

from __future__ import annotations

import sys

from interlock.checker import plant
from interlock.checker import specification as data
from interlock.checker.check import agree
from interlock.checker.claims import asked, parts, unsaid
from interlock.checker.moves import World
from interlock.checker.railway import Railway
from interlock.checker.reading import loaded
from interlock.checker.written import written
from interlock.logic.lower import lower
from interlock.proof.certificate.bundle import system_text
from interlock.proof.certificate.facts import FactBase
from interlock.proof.claims import Facts, strengthening
from interlock.proof.claims import claims as claimed
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.inductive import inductive, open_claims
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System
from interlock.verify import Rejected
from tests.campaigns.origin import origin
from tests.layouts import grown
from tests.test_every_key import CANNOT_MATTER, RESTRICTS, Case
from tests.written import told

NO_SEARCH = Limits(search_depth=0, search_s=0)
UNCHANGED = "nothing: the other layout's controller keeps all that is claimed of the author's"
NONE = "cannot be made: the one controller lacks variables of the other"


def naive(case: Case) -> str:
    """What the second checker says of a good bundle of the other layout; VERIFIED where it takes it."""
    _, system, text = told(case.other)
    try:
        found = agree(loaded(case.author), system, text, data.shipped())
    except Rejected as e:
        return str(e)
    return f"not compared: {found.left}" if found.left else "VERIFIED"


def able(case: Case) -> str:
    """What is left open, or what the checker says, of a written system of the author's with the other's controller."""
    ours, theirs = grown(case.author), grown(case.other)
    if ours is None or theirs is None:
        return "cannot be made: the front end refuses the author's layout by itself"
    try:
        system = System(ours[0], lower(theirs[0], theirs[1]))
        facts = Facts(system)
        invariants, every, start = strengthening(facts), claimed(facts), start_claim(system.loop)
    except Exception:  # variables of which the other controller has none
        return NONE
    body, text = loaded(case.author), told(case.other)[2]
    try:
        w = written(system_text(FactBase(system.relation, system.initial, invariants, every, start)))
        world = World(Railway(body), w)
        plant.define(world, data.shipped())
        wanted = asked(data.shipped().claims, world)
        lines = [not unsaid(set(parts(x)), wanted.get(id_, set())) for id_, _, x in w.claims]
        kept = tuple(c for c, fits in zip(every, lines, strict=True) if fits)
        agreed = system_text(FactBase(system.relation, system.initial, invariants, kept, start))
        agree(body, agreed, text, data.shipped())
    except Rejected as e:
        return str(e)
    open_ = open_claims(system, inductive(system, NO_SEARCH)[0], kept, NO_SEARCH)
    return f"not proved: {', '.join(open_)}" if open_ else UNCHANGED


def main() -> int:
    """Print the page; 1 where a controller was taken that passes over a key."""
    print("# Every key of the language, passed over\n")
    print((__doc__ or "").split("\n\n")[2].strip().replace("\n", " "))
    print(f"\n`python -m tests.campaigns.keys` {origin()}.")
    print("\n| key | a good bundle of the other layout | an able forgery |\n|---|---|---|")
    taken = 0
    for key, case in RESTRICTS.items():
        own = agree(*told(case.author), data.shipped()) if grown(case.author) else None
        plain = naive(case)
        taken += plain == "VERIFIED" or (own is not None and own.left != ())
        print(f"| {key} | {_cell(plain)} | {_cell(able(case))} |", flush=True)
    print(f"\n{len(RESTRICTS)} keys, {taken} of them taken.  The others cannot matter:\n")
    print("| key | why |\n|---|---|")
    for key, why in CANNOT_MATTER.items():
        print(f"| {key} | {why} |")
    return 1 if taken else 0


def _cell(x: str) -> str:
    return (x if len(x) < 170 else x[:160] + " ...").replace("|", "/")


if __name__ == "__main__":
    sys.exit(main())
