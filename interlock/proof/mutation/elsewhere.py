"""Controllers with a wrong number, or a wrong moment: an equation reads what belongs to another element of the same
kind, or what was so a scan ago.

What a renumbering by hand, a wire on the neighbour's terminal, or an image that is updated late would make of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial

from interlock.logic.controller import Controller, Equation, Join, StateVar, Term
from interlock.logic.expr import Expr, Substitution, disj, var, variables
from interlock.logic.names import Name, spelled
from interlock.proof.mutation.points import Mutation, following, with_outputs, with_values

Put = Callable[[Mapping[Name, Expr]], Controller]


def read_elsewhere(c: Controller) -> Iterator[Mutation]:
    """Each variable that an equation or output reads is that of the next element, where there is another one."""
    timers, wires = [t.name for t in c.timers], [s.name for s in c.steps if isinstance(s, Equation)]
    other = following([*(i.name for i in c.inputs), *(s.name for s in c.state), *timers, *wires])
    steps = {s.name: s.expr for s in c.steps if isinstance(s, Equation)}
    after, shown = {e.name: e.expr for e in c.next}, {o.name: o.expr for o in c.outputs}
    parts: tuple[tuple[str, Mapping[Name, Expr], Put], ...] = (
        ("", steps, partial(with_values, c, False)),
        ("next ", after, partial(with_values, c, True)),
        ("output ", shown, partial(with_outputs, c)),
    )
    for where, values, put in parts:
        for name, x in values.items():
            read = sorted(set(variables((x,))))
            for v in (v for v in read if v in other and other[v].sort == v.sort and other[v] not in read):
                wrong = Substitution({v: var(other[v])})(x)
                words = (where, name, " reads ", other[v], " for ", v)
                yield Mutation(f"{where}{name.sort} elsewhere", "elsewhere", words, partial(put, {name: wrong}))


LATE: dict[str, tuple[tuple[str, ...], bool]] = {
    "occupation": (("CLR",), False),
    "contacts": (("DN", "DR"), False),
    "cancellations": (("CAN",), False),
    "blocks": (("BLK",), False),
    "clear times that outlast a scan of occupation": (("RT",), True),
    "contacts that outlast their loss by a scan": (("DN", "DR"), True),
    "conditions that outlast their loss by a scan": (("E",), True),
    "lamps that outlast their filament by a scan": (("RL", "GL", "CL", "NL", "UL", "VL"), True),
    "valid inputs that outlast their loss by a scan": (("VALID",), True),
}
"""What is read late, by the beginnings of its names; True: as well as in time, so that what is lost is lost late."""


def read_late(c: Controller) -> Iterator[Mutation]:
    """All variables of a kind are read as they were a scan ago."""
    for what, (sorts, lasts) in LATE.items():
        known = [*(i.name for i in c.inputs), *(t.name for t in c.timers)]
        late = {n: spelled(f"OLD_{n}") for n in known if n.sort in sorts}
        if late:
            yield Mutation("read late", what, ("late: ", what), partial(_remembering, c, late, lasts))


def _remembering(c: Controller, late: Mapping[Name, Name], lasts: bool) -> Controller:
    put = Substitution({n: disj((var(n), var(o))) if lasts else var(o) for n, o in late.items()})

    def wrong(e: Equation) -> Equation:
        return replace(e, terms=tuple(t._replace(expr=put(t.expr)) for t in e.terms))

    state = (*c.state, *(StateVar(o, False, "a scan ago") for o in late.values()))
    own = (Equation(o, Join.ALL, (Term(var(n), "as it was"),), "a scan ago") for n, o in late.items())
    steps = tuple(wrong(s) if isinstance(s, Equation) else s for s in c.steps)
    after = (*map(wrong, c.next), *own)
    return replace(c, outputs=(), state=state, steps=steps, next=after).with_outputs(c.outputs)
