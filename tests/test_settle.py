"""Which protection is taken where: no machine is wanted both ways over one route, and none is left unprotected that
could be protected (R5, Zwieschutz)."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from itertools import product
from operator import or_
from typing import Any

import pytest

from interlock.derivation.flank import Allowed, Requester
from interlock.derivation.settle import Place, Settlement, beside
from interlock.model.elements import EdgeId, MachineId, NodeId, Position, SectionId
from interlock.table.cells import Provider, ProviderKind

Demands = Mapping[MachineId, Position]


class Given:
    """What would protect each requester, by its name, preferred ones first."""

    def __init__(self, sets: Mapping[str, Sequence[Demands]]) -> None:
        self._sets = sets

    def of(self, r: Requester, allowed: Allowed) -> Iterator[tuple[Provider, ...]]:
        for one in self._sets[r.name]:
            if all(allowed(m, x) for m, x in one.items()):
                yield tuple(Provider(ProviderKind.POINT, m, x) for m, x in one.items())

    def preferred(self, r: Requester) -> tuple[Provider, ...] | None:
        return next(self.of(r, lambda m, x: True), None)


def demands(option: Sequence[Provider]) -> dict[MachineId, Position]:
    return {MachineId(p.name): p.position for p in option if p.position is not None}


def requester(name: str) -> Requester:
    return Requester(name, NodeId(name), EdgeId(name), SectionId("s"), 0.0, None)


def agree(one: Demands, other: Demands) -> bool:
    return all(other.get(m, x) is x for m, x in one.items())


def settled(
    sets: Sequence[Sequence[Demands]], over: Sequence[int], paths: Sequence[Demands], hostile: Sequence[int]
) -> Settlement:
    """Places with what would protect each, the routes over it as bits, and what the path of each route needs."""
    every, names = (1 << len(paths)) - 1, [f"P{i}.normal" for i in range(len(sets))]
    places = [
        Place((SectionId("s"), i + 1), requester(name), bits, beside(bits, hostile, every))
        for i, (name, bits) in enumerate(zip(names, over, strict=True))
    ]
    options: Any = Given(dict(zip(names, sets, strict=True)))
    return Settlement(places, paths, options)


M = [MachineId(x) for x in "ABCD"]
N, R = Position.NORMAL, Position.REVERSE


@pytest.mark.parametrize("seed", range(600))
def test_a_route_wants_no_machine_both_ways_and_no_place_is_given_up_that_could_be_protected(seed: int) -> None:
    """Up to five places of up to three routes: what is chosen agrees with each path over it and with whatever else is
    chosen over one of its routes.  With up to four places (the search is bounded: with more, one may be given up that
    need not be) it finds what there is: where all can be protected without a contradiction, they are; and where that
    holds of any two routes that can be set together, too, none become hostile for a flank."""
    dice = random.Random(seed)
    routes, machines = dice.randint(1, 3), M[: dice.randint(2, 4)]
    hostile = [1 << i for i in range(routes)]
    for i, j in product(range(routes), repeat=2):
        if i < j and dice.random() < 0.5:
            hostile[i] |= 1 << j
            hostile[j] |= 1 << i
    paths = [{m: dice.choice((N, R)) for m in machines if dice.random() < 0.2} for _ in range(routes)]
    sets = [
        [{m: dice.choice((N, R)) for m in dice.sample(machines, dice.randint(1, 2))} for _ in range(dice.randint(1, 3))]
        for _ in range(dice.randint(1, 5))
    ]
    over = [dice.randint(1, (1 << routes) - 1) for _ in sets]
    found = settled(sets, over, paths, hostile)

    chosen = {at: demands(option) for at, option in found.chosen.items()}
    assert {*chosen, *found.impossible} == {*range(len(sets))} and not {*chosen} & {*found.impossible}
    for at, one in chosen.items():
        assert one in sets[at]
        assert all(agree(one, paths[i]) for i in range(routes) if over[at] >> i & 1)
        assert all(agree(one, chosen[q]) for q in chosen if over[q] & over[at])

    def fits(those: Sequence[Demands], scope: Sequence[int]) -> bool:
        """Nothing contradicts in these sets: each place looks at the routes of its scope."""
        return all(
            all(agree(one, paths[i]) for i in range(routes) if scope[at] >> i & 1)
            and all(agree(one, those[q]) for q in range(len(those)) if scope[at] & over[q])
            for at, one in enumerate(those)
        )

    few = len(sets) <= 4
    if few and any(fits(those, over) for those in product(*sets)):
        assert not found.impossible
    aside = [beside(bits, hostile, (1 << routes) - 1) for bits in over]
    if few and any(fits(those, aside) for those in product(*sets)):
        assert len(chosen) == len(sets) and fits([chosen[at] for at in range(len(sets))], aside)


def test_the_partner_of_a_scissors_does_not_give_way() -> None:
    """Nothing else is offered there: the other place takes its second choice, or none."""
    partner = Place(
        (SectionId("s"), 1), Requester("X.1a", NodeId("X"), EdgeId("e"), SectionId("s"), 0.0, None, M[0]), 1, 1
    )
    other = Place((SectionId("s"), 2), requester("P.normal"), 1, 1)
    for rest in ([], [{M[1]: R}]):
        options: Any = Given({"X.1a": [{M[0]: N}], "P.normal": [{M[0]: R}, *rest]})
        found = Settlement([other, partner], [{}], options)
        assert demands(found.chosen[1]) == {M[0]: N}
        assert found.impossible == ([] if rest else [0])


def test_beside_a_route_is_whatever_can_be_set_with_it_and_itself() -> None:
    """Routes 0 and 1 are hostile, as every route is to itself; 2 to none of them."""
    hostile = [0b011, 0b011, 0b100]
    assert beside(0b001, hostile, 0b111) == 0b101
    assert reduce(or_, (beside(1 << i, hostile, 0b111) for i in (0, 1))) == 0b111
