"""Edits of the emitted Python runtime that change what Python does, not only what is seen: none is accepted."""

from __future__ import annotations

import itertools
import random
import re
import types
from functools import cache

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.logic.expr import evaluate, var
from interlock.logic.names import spelled
from interlock.proof.equivalence.python_text import BadRuntime, _Reader, compare_runtime
from interlock.st.meaning import Symbol
from tests.layouts import built


@cache
def emitted() -> tuple[Controller, str]:
    controller = built("fig2_2")[2]
    return controller, runtime_py(controller, ["made for a test"])


END = r"\Z"
SCAN = r"(        \) = map\(self\.state\.__getitem__, STATE\)\n)"
"""After which the equations begin."""

MODULE = [
    (r"\A", "# coding: utf-7\n"),
    (r"\A", "# -*- coding: latin-1 -*-\n"),
    (r"\A", "# vim: set fileencoding=unicode_escape :\n"),
    (r"\A# made for a test", "#coding=utf-16"),
    (r"\n\n\nclass", "\n\n\n@cached\nclass"),
    (r"\n\n\nclass", "\n\n\nimport os\n\n\nclass"),
    (r"\n\n\nclass", "\n\n\nfrom other import STATE\n\n\nclass"),
    (r"\n\n\nclass", "\n\n\nSTATE['K_DP'] = False\n\n\nclass"),
    (r"\n\n\nclass", "\nSTATE = {}\n\n\nclass"),
    (r"\n\n\nclass", "\nmin = max\n\n\nclass"),
    (r"\n\n\nclass", "\n\n\ndef isinstance(a, b): return True\n\n\nclass"),
    (r"\n\n\nclass", "; True\n\n\nclass"),
    (r"class Controller:", "class Controller(dict):"),
    (r"class Controller:", "class Controller(metaclass=Other):"),
    (END, "Controller.cycle_max_ms = 10**9\n"),
    (END, "Controller.scan = None\n"),
    (END, "TIMERS = dict.fromkeys(TIMERS, 0)\n"),
    (END, "\nclass Controller(Controller):\n    cycle_max_ms = 10**9\n"),
    (END, "\n    def __getattr__(self, name):\n        return True\n"),
    (END, "\n    def _timer(self, name, on, dt_ms):\n        return on\n"),
    (END, "\n    def __setattr__(self, name, value):\n        pass\n"),
    (END, "    cycle_max_ms = 10**9\n"),
    (END, "# end\x0cController = None\n"),
    (END, "#\rController = None\n"),
]

TABLES = [
    (r"(INPUTS = \{\n)(    [^\n]*\n)(    [^\n]*\n)", r"\1\3\2"),
    (r"(STATE = \{\n)(    [^\n]*\n)(    [^\n]*\n)", r"\1\3\2"),
    (r"'VALID': \(0, 2\)", "'VALID': (0.0, 2)"),
    (r"'VALID': \(0, 2\)", "'VALID': (False, 2)"),
    (r"('REQ': \(\d+, \d+)\)", r"\1.0)"),
    (r"('REQ': \(\d+, )\d+\)", r"\1 10**6)"),
    (r"ROUTES = \{\n    ('[^']*'): 1,", r"ROUTES = {\n    \1: 1.0,"),
    (r"ROUTES = \{\n    ('[^']*'): 1,", r"ROUTES = {\n    \1: True,"),
    (r"STATE = \{\n", "STATE = {\n    'OTHER': 5,\n"),
    (r"STATE = \{\n", "STATE = {\n    **{},\n"),
    (r"'K_DP': True", "'K_DP': 1"),
    (r"'K_DP': True", "'K_DP': not False"),
    (r"'YP_X1': False", "'YP_X1': 0"),
    (r"(TIMERS = \{\n    '\w+': \d+)", r"\1.0"),
    (r"(TIMERS = \{\n    '\w+': )\d+", r"\1'9'"),
    (r"(TIMERS = \{\n    '\w+': )\d+", r"\1float('inf')"),
    (r"(CANCELLED_AFTER = \{\n    )1:", r"\g<1>1.0:"),
    (r"HELD_UNTIL = \{\n", "HELD_UNTIL = {\n    10001: (('AH_R1', 'AT_X1'),),\n"),
    (r"LEFT = \{\n", "LEFT = {\n    10001: ('X1', 'U_q1', 'P_q1', 'RT_q1', 'AT_X1', 'REL_q1'),\n"),
    (r"OCCUPIED = \{\n", "OCCUPIED = {\n    10001: (('CLR_q1',), (), 'it is free'),\n"),
    (r"CAUSES = \{\n", "CAUSES = {\n    -1: ((), 'nothing', 'R1'),\n"),
    (r"(AT_STOP = \{\n    \d+: \(\()0, ", r"\g<1>"),
    (r"(SAID = \{\n    )0:", r"\g<1>False:"),
    (r"\nTIMERS = ", "\nTIMERS: dict = "),
    (r"\nTIMERS = ", "\nTIMERS = STATE = "),
]

FIXED_PART = [
    (r"say=False\):", "say=True):"),
    (r"dt_ms, say=False", "dt_ms=0, say=False"),
    (r"def __init__\(self\):", "def __init__(self, state={}):"),
    (r"dict\(STATE\)", "STATE"),
    (r"before is None", "before == None"),
    (r"before is None", "not before"),
    (r"if not on:", "if on is False:"),
    (r"cycle_max_ms = \d+", "cycle_max_ms = 1e9"),
    (r"raise TypeError\(f'input[^\n]*", "continue"),
    (
        r"            value = int\(value\)",
        "            try:\n                value = int(value)\n            except: pass",
    ),
    (r"or dt_ms > self\.cycle_max_ms:", "or (dt_ms := 0) > self.cycle_max_ms:"),
    (r"doubtful or dt_ms", "dt_ms"),
    (r"doubtful = doubtful or ", "doubtful = "),
    (r"size == 2 and ", "size == 3 and "),
    (r"        unknown = ", "        global STATE\n        unknown = "),
    (r"        if doubtful or", "\tif doubtful or"),
]

COMPUTED = [
    (SCAN, r"\1        self.state = dict(STATE)\n"),
    (SCAN, r"\1        self = Controller()\n"),
    (SCAN, r"\1        dt_ms = True\n"),
    (SCAN, r"\1        bool = True\n"),
    (SCAN, r"\1        __debug__ = True\n"),
    (SCAN, r"\1        global STATE\n"),
    (SCAN, r"\1        import os\n"),
    (SCAN, r"\1        return dict(OUTPUTS)\n"),
    (SCAN, r"\1        self.state['K_DP'] = False\n"),
    (SCAN, r"\1\n"),
    (r"map\(read\.__getitem__, INPUTS\)", "map(inputs.__getitem__, INPUTS)"),
    (r"map\(read\.__getitem__, INPUTS\)", "map(inputs.get, INPUTS)"),
    (r"map\(read\.__getitem__, INPUTS\)", "map(read.__getitem__, STATE)"),
    (r"map\(read\.__getitem__, INPUTS\)", "read.values()  # in order"),
    (r"map\(self\.state\.__getitem__, STATE\)", "map(STATE.__getitem__, STATE)"),
    (r"map\(self\.state\.__getitem__, STATE\)", "self.state.values()"),
    (r"            VALID, (\w+),", r"            \1, VALID,"),
    (r"            VALID, (\w+),", r"            VALID, VALID,"),
    (r"            VALID, (\w+),", r"            VALID, \1, \1,"),
    (r"            VALID, ", r"            "),
    (r"            VALID, ", r"            *VALID, "),
    (r"            VALID, ", r"            STATE, "),
    (r"            VALID, ", r"            VALID,  # "),
    (r"\n            VALID, ", "\n\t    VALID, "),
    (r"            (PWR, [^\n]*)\n", r"            \1\n            __debug__,\n"),
    (r"REQ == 1\)", "REQ is 1)"),
    (r"REQ == 1\)", "REQ := 1)"),
    (r"REQ == 1\)", "REQ == 1.0)"),
    (r"REQ == 1\)", "REQ == 1 == 1)"),
    (r"REQ == 1\)", "REQ == 0b1)"),
    (r"REQ == 1\)", "REQ == \uff11)"),
    (r", dt_ms\)\n", ", 2 * dt_ms)\n"),
    (r", dt_ms\)\n", ", dt_ms=dt_ms)\n"),
    (r"( = self\._timer\()'(\w+)'", r"\1'\2' ''"),
    (r"(            'Y\w+': )bool\((\w+)\),", r"\1\2,"),
    (r"(            'Y\w+': )bool\((\w+)\),", r"\1bool(\2) or True,"),
    (r"(            'Y\w+': )bool\((\w+)\),", r"\1bool([\2]),"),
    (r"            (N_PWR), (\w+),", r"            \2, \1,"),
    (r"            (N_PWR), (\w+),", r"            \1, \1,"),
    (r"            (N_PWR), ", r"            PWR, "),
    (r"            (N_PWR), ", r"            "),
    (r"            (N_PWR), ", r"            not \1, "),
    (r"zip\(STATE, map\(bool, \(", "zip(STATE, map(int, ("),
    (r"zip\(STATE, map\(bool, \(", "zip(self.state, map(bool, ("),
    (r"        \)\)\)\)\n", "        ))), PWR=True)\n"),
    (r"\n                1: ", "\n                01: "),
    (r"        if say:", "        if not say:"),
    (r"        self\.state = dict", "        self.state |= dict"),
]


@pytest.mark.parametrize(("old", "new"), [*MODULE, *TABLES, *FIXED_PART, *COMPUTED])
def test_no_edit_that_python_takes_otherwise_is_accepted(old: str, new: str) -> None:
    controller, text = emitted()
    changed = re.sub(old, new, text, count=1)
    assert changed != text and not compare_runtime(controller, changed).proved


def test_the_state_is_not_taken_again_when_it_has_been_committed() -> None:
    """Then a name would stand for what is, where it is read as what was."""
    controller, text = emitted()
    assert compare_runtime(controller, text).proved
    begin = text.index("        (\n            PWR")
    block = text[begin : text.index("STATE)\n", begin) + len("STATE)\n")]
    before, after = (text.replace(at, at + block, 1) for at in (block, "        ))))\n"))
    assert compare_runtime(controller, before).proved and not compare_runtime(controller, after).proved


def test_the_encoding_that_a_comment_names_lets_a_comment_run() -> None:
    """What everybody reads as a comment returns before anything is computed; without the first line it does not."""
    controller, text = emitted()
    noted = re.sub(SCAN + r"([^\n]*)", r"\1\2  # \\n        return OUTPUTS", text, count=1)
    assert noted != text and compare_runtime(controller, noted).proved
    for top, runs in (("# unicode_escape", False), ("# coding: unicode_escape", True)):
        module = types.ModuleType("runtime")
        exec(compile(f"{top}\n{noted}".encode(), "runtime.py", "exec"), module.__dict__)
        assert (module.Controller().scan({}, 100) is module.OUTPUTS) is runs
        assert compare_runtime(controller, f"{top}\n{noted}").proved is not runs


def _written(rng: random.Random, deep: int) -> str:
    """An expression with brackets wherever two kinds of operators meet, and here and there where none is needed."""
    if not deep or rng.random() < 0.2:
        return rng.choice(["a", "b", "c", "(r == 3)", "True", "False"])
    inner = [_written(rng, deep - 1) for _ in range(rng.randint(1, 3))]
    if len(inner) == 1:
        return f"not {inner[0]}" if " " not in inner[0] or inner[0][0] == "(" else f"({inner[0]})"
    word = rng.choice([" and ", " or "])
    return word.join(x if re.fullmatch(r"(not )*\w+|\(r == 3\)", x) else f"({x})" for x in inner)


def test_expressions_are_read_as_python_reads_them_or_refused() -> None:
    """As they are emitted all are taken; with characters exchanged, only those that mean to Python what is read."""
    reader = _Reader(*emitted())
    reader.values = {n: var(spelled(n)) for n in "abc"} | {"r": Symbol("r")}
    rng = random.Random(3)
    refused = 0
    for k in range(400):
        text = _written(rng, 4)
        if k % 2:
            at = rng.randrange(len(text))
            text = text[:at] + rng.choice("()ab ") + text[at + rng.randint(0, 1) :]
        try:
            found = reader._value(text)
        except BadRuntime:
            assert k % 2, text
            refused += 1
            continue
        for bits in itertools.product((0, 1), repeat=4):
            values = dict(zip("abc", bits, strict=False)) | {"r": 3 * bits[3]}
            assert evaluate(found, values.__getitem__, {}) == bool(eval(text, values.copy())), text
    assert 80 <= refused <= 190
    for text in (
        "a and b or c",
        "a or b and c",
        "a b",
        "(a)(b)",
        "()",
        "not",
        "a and",
        "r",
        "r == 03",
        "r == \u00b2",  # a digit, but no decimal one
        "r == \u0663",
        f"r == {'9' * 5000}",
        "a == 1",
        "(" * 999,
    ):
        with pytest.raises(BadRuntime):
            reader._value(text)
