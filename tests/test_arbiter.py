"""Requests of four kinds: their order, none lost, each refusal with its reason, the wait against its bound."""

from __future__ import annotations

from random import Random

import pytest

from interlock.dispatch.arbiter import MOST, SCANS, Arbiter, Full, Request, Source
from interlock.dispatch.panel import RouteIndications, Stage
from interlock.model.elements import RouteId, SectionId, SignalId

DT_MS = 300


def stage(k: int) -> Stage:
    s = SectionId(f"s{k}")
    shown = RouteIndications(None, {s: f"clear {k}"}, {s: f"locked {k}"})
    return Stage(RouteId(f"R{k}"), k, SignalId(f"G{k}"), (s,), None, shown)


def in_order(arbiter: Arbiter) -> list[Request]:
    return sorted(arbiter.waiting, key=lambda r: r.key(arbiter.wait_ms))


def made_now(arbiter: Arbiter, seen: dict[str, int]) -> Request | None:
    """As the dispatcher does where no run competes: the first that nothing seen keeps back."""
    return next((arbiter.make(r) for r in in_order(arbiter) if arbiter.may(r, seen)), None)


def test_the_order_of_document_a() -> None:
    arbiter = Arbiter()
    seen = {f"clear {k}": 1 for k in range(9)} | {f"locked {k}": 0 for k in range(9)}
    made = [
        arbiter.add(stage(0), Source.PLANNED),
        arbiter.add(stage(1), Source.REMOTE, forward=False),
        arbiter.add(stage(2), Source.REMOTE),
        arbiter.add(stage(3), Source.LOCAL),
        arbiter.add(stage(4), Source.REMOTE, inclined=True),
        arbiter.add(stage(5), Source.LOCAL, inclined=True),
        arbiter.add(stage(6), Source.HAND),
    ]
    assert [made.index(r) for r in in_order(arbiter)] == [6, 5, 4, 3, 2, 1, 0]
    assert made_now(arbiter, seen) is made[6]


def test_equal_requests_come_by_time_then_number() -> None:
    arbiter = Arbiter()
    first = arbiter.add(stage(1), Source.REMOTE)
    second = arbiter.add(stage(0), Source.REMOTE)
    assert in_order(arbiter) == [first, second]
    arbiter.tick({}, DT_MS)
    third = arbiter.add(stage(2), Source.REMOTE)
    assert in_order(arbiter) == [first, second, third]
    keys = [r.key(0) for r in arbiter.waiting]
    assert len(set(keys)) == len(keys)
    assert arbiter.add(stage(1), Source.REMOTE) is first, "the same again is the same"


def test_one_that_has_waited_too_long_comes_before_what_is_asked_for_by_hand_in_whatever_class() -> None:
    """Without the principle `priorities` all are of one class, and `priority_wait_s` counts all the same (R18)."""
    arbiter = Arbiter(wait_ms=10 * DT_MS)
    planned = arbiter.add(stage(0), Source.PLANNED)
    for _ in range(9):
        arbiter.tick({}, DT_MS)
    hand = arbiter.add(stage(1), Source.HAND)
    assert in_order(arbiter) == [hand, planned]
    arbiter.tick({}, DT_MS)
    assert in_order(arbiter) == [planned, hand]


def test_a_request_that_cannot_be_granted_is_kept_and_its_reason_told() -> None:
    arbiter = Arbiter()
    r = arbiter.add(stage(0), Source.REMOTE)
    seen = {"clear 0": 0, "locked 0": 0}
    assert made_now(arbiter, seen) is None and r.reason == "s0 is not clear"
    seen["clear 0"], seen["locked 0"] = 1, 1
    assert made_now(arbiter, seen) is None and r.reason == "s0 is locked"
    seen["locked 0"] = 0
    assert made_now(arbiter, seen) is r and not arbiter.answered(seen)
    assert r in arbiter.waiting and r.reason.startswith("refused: ") and arbiter.said == [f"R0, remote: {r.reason}"]
    seen["locked 0"] = 1
    arbiter.make(r)
    assert arbiter.answered(seen) and arbiter.waiting == []


def test_by_hand_is_tried_once_in_any_case() -> None:
    arbiter = Arbiter()
    r = arbiter.add(stage(0), Source.HAND)
    seen = {"clear 0": 0, "locked 0": 0}
    assert made_now(arbiter, seen) is r and not arbiter.answered(seen)
    arbiter.tick(seen, 6_000)
    assert made_now(arbiter, seen) is None and r.reason == "s0 is not clear"


def test_too_many_requests_are_refused_at_once() -> None:
    arbiter = Arbiter()
    for k in range(MOST):
        arbiter.add(stage(k), Source.REMOTE)
    with pytest.raises(Full, match="R777: 200 requests wait"):
        arbiter.add(stage(777), Source.REMOTE)


def hour(seed: int, wait_ms: int) -> tuple[Arbiter, int, int]:
    """An hour of requests of all four kinds, favoured ones in excess; the longest wait of a free one, and the bound."""
    rng, arbiter = Random(seed), Arbiter(wait_ms)
    count = 40
    seen = {f"clear {k}": 1 for k in range(count)} | {f"locked {k}": 0 for k in range(count)}
    made, served, longest, bound, busy = 0, 0, 0, 0, 0
    free: dict[Request, int] = {}
    bounds: dict[Request, int] = {}
    for _ in range(3_600_000 // DT_MS):
        for k in range(count):
            if rng.random() < 0.01:
                seen[f"clear {k}"] = int(k < 3 or rng.random() < 0.7)  # the first three are always free
        while len(arbiter.waiting) < 30:
            source = rng.choices(list(Source), (8, 3, 1, 1))[0]
            before = len(arbiter.waiting)
            arbiter.add(stage(rng.randrange(count)), source, rng.random() < 0.7, rng.random() < 0.7)
            made += len(arbiter.waiting) > before
            if len(arbiter.waiting) == before:
                break
        arbiter.tick(seen, DT_MS)
        for r in arbiter.waiting:
            free[r] = free.get(r, 0) + DT_MS if int(r.stage.route[1:]) < 3 else 0
            if wait_ms and r.turn_ms >= wait_ms and r not in bounds:
                bounds[r] = arbiter.bound_scans(r)
        if busy:
            busy -= 1
            if not busy:
                k = arbiter.asked.stage.number if arbiter.asked else 0
                seen[f"locked {k}"] = int(k < 3 or rng.random() < 0.6)
                served += arbiter.answered(seen)
                seen[f"locked {k}"] = 0
            continue
        one = made_now(arbiter, seen)
        if one is not None:
            busy = SCANS - 1
            if free.get(one, 0) and one.tries == 1:
                longest = max(longest, free[one])
                bound = max(bound, wait_ms + bounds.get(one, 0) * DT_MS)
                assert not wait_ms or free[one] <= wait_ms + (bounds.get(one, 0) + 1) * DT_MS
    assert made == served + len(arbiter.waiting) + bool(busy and arbiter.asked not in arbiter.waiting), "none is lost"
    return arbiter, longest, bound


@pytest.mark.parametrize("seed", range(3))
def test_the_wait_keeps_its_bound_for_an_hour(seed: int) -> None:
    _, longest, bound = hour(seed, 30_000)
    assert 0 < longest <= bound + DT_MS


def test_without_ageing_the_last_in_order_wait_longer() -> None:
    assert hour(0, 0)[1] > hour(0, 30_000)[1]
