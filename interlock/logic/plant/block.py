"""The line beyond a boundary with a direction token, and the neighbour at its other end (R12).

The neighbour follows the same rules as the controller.  Each end sees the other by telegrams, which come late or not at
all, but whole and in order: what it sees was told in some scan since the last telegram.  Trains run on the line; the
neighbour sends them only while it has the token.
"""

from __future__ import annotations

from typing import Protocol

from interlock.logic import names
from interlock.logic.expr import FALSE, Expr, conj, disj, implies, neg, var
from interlock.logic.plant.kinds import ASSUMPTIONS, Assumption, Hazard, Plant, TokenWires, Wiring
from interlock.logic.plant.words import has_token, line, o, seen_by, telegram
from interlock.model.elements import Boundary, NodeId
from interlock.model.layout import Layout


class Beyond(Protocol):
    """What the line needs of the plant in the making."""

    layout: Layout
    w: Wiring
    p: Plant
    dropped: frozenset[str]

    def choice(self, name: names.Name, text: str) -> Expr:
        """A free choice of the world."""
        ...

    def clock(self, name: names.Name, hold: Expr, text: str) -> Expr:
        """A clock of the world."""
        ...


def outside(b: Boundary) -> str:
    """Where a train stands that is about to come in."""
    return b.approach or names.outside(b.node)


def _telegrams(x: Beyond, n: NodeId, wire: TokenWires) -> None:
    """What each end was told last: by a telegram that has come, whole, or by the one before."""
    p = x.p
    told = x.choice(names.TELEGRAM_COMES(n), f"a telegram comes from the neighbour at {n}")
    tells = x.choice(names.TELEGRAM_REACHES(n), f"a telegram reaches the neighbour at {n}")
    words = {"has": f"the neighbour at {n} has the direction", "gives": f"the neighbour at {n} gives the direction"}
    for w in ("has", "gives"):
        p.state[names.NEIGHBOUR_TOKEN(n, w)] = words[w]
        p.state[names.TELEGRAM(n, w)] = f"the last telegram from {n}: {words[w]}"
        p.next[names.TELEGRAM(n, w)] = disj((conj((told, has_token(n, w))), conj((neg(told), telegram(n, w)))))
        p.state[names.SEEN_BY(n, w)] = f"the last telegram that reached the neighbour at {n}: {w}"
        own = var(wire.have if w == "has" else wire.give)
        p.next[names.SEEN_BY(n, w)] = disj((conj((tells, own)), conj((neg(tells), seen_by(n, w)))))


def neighbour(x: Beyond, b: Boundary) -> None:
    """What the neighbour does, and what happens on the line; before the trains move."""
    p, n, wire = x.p, b.node, x.w.token[b.node]
    has, gives, fresh = (has_token(n, w) for w in ("has", "gives", "fresh"))
    empty = conj((neg(line(n, "out")), neg(line(n, "in")), neg(o(outside(b)))))
    ours = disj((var(wire.have), var(wire.give)))
    take = conj((seen_by(n, "gives"), fresh, neg(has), neg(gives)))
    p.events[names.TOKEN_MOVES(n, "takes")] = take
    give = conj(
        (
            has,
            fresh,
            neg(line(n, "in")),
            neg(o(outside(b))),
            x.choice(names.TOKEN_MOVES(n, "gives"), f"the neighbour at {n} gives the direction"),
        )
    )
    p.events[names.TOKEN_MOVES(n, "gives")] = give
    lost = x.choice(names.TOKEN_MOVES(n, "lost"), f"the neighbour at {n} is restarted")
    p.events[names.TOKEN_MOVES(n, "lost")] = lost
    agreed = conj((empty, neg(ours), neg(has), neg(gives), neg(seen_by(n, "gives")), neg(telegram(n, "gives"))))
    held = x.clock(
        names.AGREED_LONG(n), conj((var(x.w.valid), var(wire.manual))), f"the hand at {n} is held as long as agreed"
    )
    manual = conj(
        (
            agreed,
            neg(held),
            neg(take),
            x.choice(
                names.TOKEN_MOVES(n, "manual"),
                f"the neighbour at {n} takes the direction, as agreed by telephone",
            ),
        )
    )
    p.events[names.TOKEN_MOVES(n, "manual")] = manual
    p.events[names.SENDS(n)] = conj((has, neg(give), x.choice(names.SENDS(n), f"the neighbour at {n} sends a train")))
    _telegrams(x, n, wire)
    p.state[names.NEIGHBOUR_TOKEN(n, "fresh")] = f"the neighbour at {n} has seen the direction not given"
    p.next[names.NEIGHBOUR_TOKEN(n, "has")] = conj((disj((has, take, manual)), neg(give), neg(lost)))
    p.next[names.NEIGHBOUR_TOKEN(n, "gives")] = conj((disj((gives, give)), neg(seen_by(n, "has")), neg(lost)))
    p.next[names.NEIGHBOUR_TOKEN(n, "fresh")] = conj((disj((fresh, neg(seen_by(n, "gives")))), neg(take), neg(lost)))
    told_now = {w: p.next[names.TELEGRAM(n, w)] for w in ("has", "gives")}
    for name, true in (
        (wire.gives, told_now["gives"]),
        (wire.keeps, neg(told_now["gives"])),
        (wire.has, told_now["has"]),
    ):
        _assume(x, "A-NEIGHBOUR", implies(conj((var(x.w.valid), var(name))), true))
    stale = disj((telegram(n, "has"), telegram(n, "gives"), seen_by(n, "gives")))
    alone = conj((empty, neg(has), neg(gives), neg(stale), neg(take)))
    _assume(x, "A-AGREED", implies(held, alone))
    p.initial += at_a_restart(n, disj((line(n, "in"), o(outside(b)))))


def at_a_restart(n: str, sent: Expr) -> list[Expr]:
    """The line and the neighbour are as the token's rules have left them; `sent`: a train is on its way to us."""
    has, gives, fresh = (has_token(n, w) for w in ("has", "gives", "fresh"))
    return [
        neg(conj((has, gives))),
        neg(conj((seen_by(n, "has"), seen_by(n, "gives")))),
        neg(conj((telegram(n, "has"), telegram(n, "gives")))),
        implies(line(n, "out"), neg(disj((has, sent, telegram(n, "has"), seen_by(n, "gives"))))),
        implies(disj((gives, telegram(n, "gives"))), neg(sent)),
        implies(disj((gives, telegram(n, "gives"))), neg(seen_by(n, "gives"))),
        implies(telegram(n, "gives"), neg(has)),
        implies(gives, fresh),
        implies(conj((gives, disj((line(n, "out"), seen_by(n, "has"))))), telegram(n, "gives")),
        implies(conj((fresh, seen_by(n, "gives"))), neg(disj((has, sent)))),
        implies(conj((fresh, seen_by(n, "gives"))), neg(telegram(n, "has"))),
    ]


def on_the_line(x: Beyond, b: Boundary, leaves: Expr) -> None:
    """Trains on the line, once it is known when a head goes out to it."""
    p, n, wire = x.p, b.node, x.w.token[b.node]
    arrives = x.choice(names.LINE_ARRIVED(n), f"the train on the line beyond {n} has arrived")
    last = x.choice(names.LINE_LAST(n), f"no further train is on the line to {n}")
    appears = p.events.get(names.APPEARS(outside(b)), FALSE)
    p.waits[n] = names.STANDS(outside(b))
    p.state[names.ON_LINE(n, "out")] = f"a train is on the line beyond {n}, going out"
    p.next[names.ON_LINE(n, "out")] = disj((conj((line(n, "out"), neg(arrives))), leaves))
    p.state[names.ON_LINE(n, "in")] = f"a train is on the line to {n}"
    p.next[names.ON_LINE(n, "in")] = disj((conj((line(n, "in"), neg(conj((appears, last))))), p.events[names.SENDS(n)]))
    there = [line(n, "out"), line(n, "in"), o(outside(b))]
    still = [p.next[names.ON_LINE(n, "out")], p.next[names.ON_LINE(n, "in")], p.next[names.STANDS(outside(b))]]
    stands = disj(conj(pair) for pair in zip(there, still, strict=True))
    _assume(x, "A-LINE", implies(conj((var(x.w.valid), var(wire.clear))), neg(stands)))
    head_on = disj(
        (
            conj((leaves, disj((line(n, "in"), o(outside(b)), p.events[names.SENDS(n)])))),
            conj((p.events[names.SENDS(n)], line(n, "out"))),
        )
    )
    p.hazards.append(Hazard("LINE", n, head_on))


def _assume(x: Beyond, id_: str, expr: Expr) -> None:
    if id_ not in x.dropped:
        x.p.assumptions.append(Assumption(id_, ASSUMPTIONS[id_], expr))
