"""Tests run from the top of the project."""

from __future__ import annotations

import os
import shutil
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from interlock.app.run import Ready
from interlock.panel.desk import Desk
from tests import panels
from tests.browsers import browser
from tests.field import two_substations
from tests.pages import Server, serving_process
from tests.panels import QUICK, proved, quick, unproved

TOP = Path(__file__).resolve().parent.parent
LEFT = pytest.StashKey[int]()


NEEDED = {"ABC": ("berkeley-abc", "abc"), "Chromium": ("chromium", "chromium-browser"), "gcc": ("gcc",)}
"""What tests of the group `external` need on the machine, and the names by which it is found."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--external` runs the tests that need ABC, Chromium or gcc, and those alone."""
    parser.addoption(
        "--external", action="store_true", help="run the tests that need ABC, Chromium or gcc, and no others"
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """One group or the other; without a program of the group nothing of it begins."""
    external = bool(config.getoption("--external"))
    missing = [name for name, those in NEEDED.items() if not any(map(shutil.which, those))]
    if external and missing:
        raise pytest.UsageError(f"the group `external` needs {' and '.join(missing)}")
    left = [x for x in items if ("external" in x.keywords) is not external]
    items[:] = [x for x in items if ("external" in x.keywords) is external]
    config.stash[LEFT] = 0 if external else len(left)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Say what was not run."""
    left = config.stash.get(LEFT, 0)
    if hasattr(config, "workerinput"):
        return
    if not config.getoption("--external"):
        count = f"{left} tests" if left else "the tests"
        terminalreporter.write_line(f"not run: {count} that need ABC, Chromium or gcc (`pytest --external` runs them)")


@pytest.fixture(autouse=True, scope="module")
def _no_thread_left() -> Iterator[None]:
    """A module of tests leaves no thread behind: the prover forks, and a fork of a process with threads may wait for a
    lock that nobody holds any more."""
    before = set(threading.enumerate())
    yield
    left = [t for t in threading.enumerate() if t not in before]
    for thread in left:
        thread.join(10)
    assert not [t.name for t in left if t.is_alive()]


@pytest.fixture(autouse=True)
def _at_the_top(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(TOP)
    monkeypatch.setenv("NO_COLOR", "1")
    os.environ.setdefault("PYTHONHASHSEED", "0")


@pytest.fixture(autouse=True)
def _configured_apart(monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory) -> None:
    """No test reads or writes the user's own settings."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path_factory.getbasetemp() / "config"))
    monkeypatch.setenv("APPDATA", str(tmp_path_factory.getbasetemp() / "config"))


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    """A browser for all tests of a module; each opens contexts of its own."""
    with browser() as found:
        yield found


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    """The panel of Heishan as a process, with short delays."""
    with serving_process(quick(tmp_path)) as one:
        yield one


@pytest.fixture(scope="module")
def ready(tmp_path_factory: pytest.TempPathFactory) -> Ready:
    """Heishan with short delays, proved, for the tests of the panel."""
    return proved(quick(tmp_path_factory.mktemp("panel")))


@pytest.fixture(scope="module")
def at_work(ready: Ready) -> Iterator[tuple[Desk, Any]]:
    """A panel of Heishan that the tests of a module use."""
    with panels.at_work(ready) as found:
        yield found


@pytest.fixture(scope="module")
def lab() -> Iterator[tuple[Desk, Any]]:
    """The same of the laboratory of flank protection."""
    with panels.at_work(panels.flank_lab()) as found:
        yield found


@pytest.fixture(scope="module")
def single_line() -> Iterator[tuple[Desk, Any]]:
    """The same of a passing loop with call-on signals and a direction token."""
    with panels.at_work(unproved(Path("layouts/passing_loop.yaml").read_text("utf-8") + QUICK)) as found:
        yield found


@pytest.fixture(scope="module")
def mine(tmp_path_factory: pytest.TempPathFactory) -> Ready:
    """mine11 with two substations, proved, for the tests of the field."""
    return two_substations(tmp_path_factory.mktemp("field"))
