"""The emitted Python runtime as its user meets it: routes by name, and inputs that are what they should be."""

from __future__ import annotations

import re
import types
from typing import Any

import pytest

from interlock.emit.python.runtime import runtime_py
from interlock.model.elements import Position
from interlock.proof.equivalence.python_text import compare_runtime
from tests.layouts import SHIPPED, built


def module_of(name: str) -> Any:
    module = types.ModuleType("runtime")
    exec(compile(runtime_py(built(name)[2], []), "runtime.py", "exec"), module.__dict__)
    return module


@pytest.mark.parametrize("name", SHIPPED)
def test_the_table_of_routes_has_every_route_by_every_name(name: str) -> None:
    _, table, _ = built(name)
    runtime = module_of(name)
    for row in table.routes:
        for each in (row.id, *row.names):
            assert runtime.Controller.request(each) == {"REQ": row.number}
    assert set(runtime.ROUTES.values()) == {row.number for row in table.routes}


def test_a_route_is_set_by_its_name() -> None:
    """After the restart: release what is clear, then ask for a route by name and see its sections locked."""
    _, table, controller = built("fig2_2")
    row = table.routes[0]
    one = module_of("fig2_2").Controller()
    sym = controller.symbols
    lying = [name for (_, position), name in sym.machines.detected.items() if position is Position.NORMAL]
    quiet = {i.name: 0 for i in controller.inputs} | dict.fromkeys([sym.valid, *sym.sections.clear.values(), *lying], 1)
    for _ in range(4000):
        one.scan({**quiet, sym.sections.release_all: 1}, 100)
        one.scan(quiet, 100)
    route = sym.routes[0]
    assert route.id == row.id and not any(one.state[sym.sections.lock[way]] for way in route.path.ways)
    one.scan({**quiet, **one.request(row.id)}, 100)
    assert all(one.state[sym.sections.lock[way]] for way in route.path.ways)


def test_what_is_no_input_is_refused_by_name_and_changes_nothing() -> None:
    one = module_of("fig2_2").Controller()
    before = dict(one.state), dict(one.elapsed)
    for inputs, dt_ms, error, said in (
        ({"VALIDD": 1}, 100, ValueError, "VALIDD"),
        (None, 100, TypeError, "inputs are None"),
        ([("VALID", 1)], 100, TypeError, "no dictionary"),
        ({"VALID": "1"}, 100, TypeError, "input VALID is '1'"),
        ({"VALID": None}, 100, TypeError, "input VALID is None"),
        ({"REQ": 1.5}, 100, TypeError, "input REQ is 1.5"),
        ({}, -1, ValueError, "dt_ms is -1"),
        ({}, float("nan"), ValueError, "dt_ms is nan"),
        ({}, float("inf"), ValueError, "dt_ms is inf"),  # every delay would be over
        ({}, "100", TypeError, "dt_ms is '100'"),
        ({}, True, TypeError, "dt_ms is True"),
    ):
        with pytest.raises(error, match=re.escape(said)):
            one.scan(inputs, dt_ms)
        assert (dict(one.state), dict(one.elapsed)) == before
    with pytest.raises(ValueError, match="there is no route X1-Z"):
        one.request("X1-Z")
    assert one.scan({"VALID": True, "REQ": 99}, 100)  # a number that names nothing asks for nothing


def test_a_bit_that_is_neither_0_nor_1_makes_all_inputs_lost() -> None:
    """The points read normal, and the other contact something that is no bit: read as 0 it would prove them."""
    one = module_of("fig2_2").Controller()
    controller = built("fig2_2")[2]
    sym = controller.symbols
    lying = dict.fromkeys([sym.valid, *sym.sections.clear.values(), "DN_P1"], 1)
    quiet = {i.name: 0 for i in controller.inputs} | lying
    for _ in range(4000):
        one.scan({**quiet, sym.sections.release_all: 1}, 100)
        one.scan(quiet, 100)
    for _ in range(60):
        out = one.scan({**quiet, **one.request("X1-A")}, 100)
    assert out["YP_X1"] and not out["YS_X1"]
    state = dict(one.state)
    for wrong in (2, -1, 255):
        one.state = dict(state)
        assert one.scan({**quiet, "DR_P1": wrong}, 100)["YS_X1"]


def test_a_table_of_routes_that_says_something_else_is_refused() -> None:
    _, _, controller = built("fig2_2")
    text = runtime_py(controller, [])
    assert compare_runtime(controller, text).proved
    head, rest = text.split("ROUTES = {\n")
    for changed in (
        head + "ROUTES = {\n" + rest.replace(": 1,", ": 2,", 1),
        head + "ROUTES = {\n" + rest.split("\n", 1)[1],
        head + "ROUTES = {\n    'other': 1,\n" + rest,
        text.replace("ROUTES[route]", "1", 1),
    ):
        assert changed != text and not compare_runtime(controller, changed).proved
