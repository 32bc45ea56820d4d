"""The words of two neighbours on one line with a direction token, over a link: in order, and with old ones again."""

from __future__ import annotations

from collections import deque
from random import Random

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.simulate.run import load
from tests.layouts import built
from tests.scenarios import TOKEN

WORDS = {"NG_E": "YTG_E", "NN_E": "YTN_E", "NH_E": "YTH_E"}
"""What one reads, and what the other tells for it."""
HOLDS = 70
"""For how many scans of a second the hand of the special manual change is held."""


def both_have_it(seed: int, scans: int, old: float) -> tuple[bool, int]:
    """Whether both ends come to have the direction, and how often it changed hands; `old`: the share of readings that
    are of one of the last fifteen telegrams, and not the last."""
    rng, (_, _, controller) = Random(seed), built(TOKEN)
    names = load(runtime_py(controller, []))
    clear = {i.name: int(i.name.startswith(("CLR_", "DN_"))) for i in controller.inputs}
    ends = [names["Controller"]() for _ in range(2)]
    under_way: list[deque[tuple[int, dict[str, int]]]] = [deque(), deque()]
    heard: list[list[dict[str, int]]] = [[dict.fromkeys(WORDS, 0)] for _ in range(2)]
    hand, changes, last = [0, 0], 0, [0, 0]
    for now in range(scans):
        told = []
        for me, end in enumerate(ends):
            while under_way[1 - me] and under_way[1 - me][0][0] <= now:
                heard[me].append(under_way[1 - me].popleft()[1])
            read = rng.choice(heard[me][-15:]) if rng.random() < old else heard[me][-1]
            silent = all(not w["NG_E"] and not w["NH_E"] for link in under_way for _, w in link)
            silent = silent and not any(h[-1]["NG_E"] or h[-1]["NH_E"] for h in heard)
            idle = silent and not any(e.state["BH_E"] or e.state["BG_E"] for e in ends)  # as agreed by telephone
            hand[me] = 0 if not (idle or end.state["BG_E"]) else max(0, hand[me] - 1)
            if idle and not any(hand) and rng.random() < 0.02:
                hand[me] = HOLDS
            words = dict.fromkeys(WORDS, 0) if rng.random() < 0.1 else read
            wants = {"NR_E": int(rng.random() < 0.3), "LC_E": int(rng.random() < 0.7), "TKN_E": int(hand[me] > 0)}
            had = end.state["BH_E"]
            told.append(end.scan({**clear, "VALID": int(rng.random() < 0.98), **words, **wants}, 1000))
            changes += end.state["BH_E"] and not had
        for me, outputs in enumerate(told):
            last[me] = max(last[me], now + 1 + rng.randint(0, 5))
            under_way[me].append((last[me], {n: int(outputs[o]) for n, o in WORDS.items()}))
        if all(end.state["BH_E"] for end in ends):
            return True, changes
    return False, changes


@pytest.mark.parametrize("seed", range(4))
def test_words_that_come_late_but_in_order_never_give_both_ends_the_direction_and_old_ones_do(seed: int) -> None:
    both, changes = both_have_it(seed, 3000, 0.0)
    assert not both and changes > 5
    assert both_have_it(seed, 9000, 0.05)[0], "A-NEIGHBOUR is needed, and the cabinet has to see to it"
