"""Every exception of the package goes from one process to another and is there what it was here."""

from __future__ import annotations

import importlib
import pickle
import pkgutil
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import pytest

import interlock
from interlock.app.turns import NoHorizon
from interlock.dispatch.commands import BadOrder
from interlock.dispatch.plan.errands import NoVoyage
from interlock.logic.cabinet import BadAddress
from interlock.model.too_many import TooManyWays
from interlock.panel.commands import Refused
from interlock.panel.entry import NotKnown
from interlock.planning.displib import BadFile
from interlock.record.tables import NoTables

MISSPELT = (
    "interlock: 1\nname: x\nboundaries: {W: {approach: a0 600}}\nbuffers: [B]\ntracks: {t: [W, north 400, B]}\n"
    "signals: {X: {from: W, into: noth}}\n"
)


def not_a_layout(text: str) -> interlock.LayoutError:
    with pytest.raises(interlock.LayoutError) as caught:
        interlock.loads(text)
    return caught.value


MADE: list[Exception] = [
    not_a_layout(MISSPELT),
    BadOrder("IL6001", "there is no train 7", ("6", "8"), "7", "name another"),
    NoVoyage("no route leads there", "name another signal"),
    NoHorizon("the trains have no timetable", "fleet", "1"),
    BadAddress("GR_X", "I0.9 is no address"),
    NoTables(),
    BadFile("line 3", "this is no JSON"),
    Refused("it is locked", "X", "q1"),
    NotKnown("it has no route"),
    TooManyWays("signals", "X1", "1,025 ways lead from it", "put a signal on the way"),
]


def test_every_exception_that_is_made_in_a_way_of_its_own_is_here() -> None:
    for module in pkgutil.walk_packages(interlock.__path__, "interlock."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    found, new = set(), [Exception]
    while new:
        of = new.pop()
        new += of.__subclasses__()
        if of.__module__.startswith("interlock.") and "__init__" in vars(of):
            found.add(of)
    assert found == {type(e) for e in MADE}


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
@pytest.mark.parametrize("error", MADE, ids=lambda e: type(e).__name__)
def test_it_is_read_again_as_it_was(error: Exception, protocol: int) -> None:
    again = pickle.loads(pickle.dumps(error, protocol))
    assert (type(again), again.args, str(again)) == (type(error), error.args, str(error))
    left, right = vars(again), vars(error)
    if isinstance(error, interlock.LayoutError):
        assert [d.fix for d in left["diagnostics"]] == [d.fix for d in right["diagnostics"]] == ["did you mean north?"]
    else:
        assert left == right


def refused(text: str) -> str:
    return interlock.loads(text).name


def test_a_layout_with_errors_breaks_no_pool_of_processes() -> None:
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        with pytest.raises(interlock.LayoutError, match="did you mean north"):
            pool.submit(refused, MISSPELT).result(timeout=60)
        assert pool.submit(refused, MISSPELT.replace("noth", "north")).result(timeout=60) == "x"
