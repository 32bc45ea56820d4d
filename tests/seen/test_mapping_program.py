"""The mapping program as IEC compilers read it: addresses in a VAR part of their own, and a task that runs it."""

from __future__ import annotations

import re

import pytest

from interlock.logic.cabinet import allocate
from interlock.st.printer import print_unit
from interlock.st.program import io_program
from interlock.st.structures import structured
from tests.layouts import SHIPPED, built


@pytest.mark.parametrize("name", SHIPPED)
def test_no_var_part_mixes_variables_with_and_without_an_address(name: str) -> None:
    layout, _, controller = built(name)
    text = print_unit(structured(io_program(controller, allocate(layout, controller), [])))
    for part in re.findall(r"^VAR\n(.*?)^END_VAR", text, re.MULTILINE | re.DOTALL):
        lines = part.splitlines()
        assert len({" AT %" in line for line in lines}) == 1
    assert re.search(r"TASK \w+\(INTERVAL := T#\d+ms", text) and text.rstrip().endswith("END_CONFIGURATION")
