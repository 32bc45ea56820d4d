"""Names that could clash in PLC text."""

from __future__ import annotations

import itertools

from interlock.logic.lower import lower
from tests.layouts import grown

TEXT = """interlock: 1
name: demo
boundaries:
  W: {{approach: {0} 100}}
  E: {{trains: out}}
tracks:
  main: [W, {1} 100]
points:
  {2}: {{section: {3}, toe: main.end, normal: E, reverse: stub.start}}
signals:
  {4}: {{from: W, into: {1}}}
buffers: [Z]
conditions:
  {5}: {{signals: [{4}]}}
"""


def test_kinds_may_share_names_even_awkward_ones() -> None:
    """Every PLC name begins with a prefix of its kind, so that even these names do not clash."""
    awkward = ["ALL", "R1", "1", "VALID"]
    for words in itertools.permutations(awkward, 3):
        a, b, c = words
        text = TEXT.format("ap", a, a, b, a, c).replace("reverse: stub.start", "reverse: Z")
        made = grown(text)
        assert made is not None
        layout, table, _ = made
        controller = lower(layout, table)  # raises MalformedController on a clash
        names = [i.name for i in controller.inputs] + [s.name for s in controller.state]
        names += [s.name for s in controller.steps] + [o.name for o in controller.outputs]
        assert len({n.upper() for n in names}) == len(names)
        assert max(map(len, names)) <= 24
