"""The program as a library: what `import interlock` offers, each step a function from one frozen value to the next.

Nothing here prints, and nothing of a layout is kept when its values are let go.  Threads take turns (expressions are
made with one table at a time); to prove several layouts at once, use processes.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import field
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType

from interlock.app.check import Checked, audited, check_file, derived, second_opinion
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Severity, Sink
from interlock.diag.extras import install
from interlock.diag.render import full
from interlock.emit.bundle import not_replaced, strangers, write_folder
from interlock.exceptions import Whole
from interlock.frontend import Source, load_text
from interlock.frontend import load as load_file
from interlock.logic.controller import Controller
from interlock.logic.expr import interning
from interlock.logic.lower import lower as lower_table
from interlock.model.layout import Layout
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import ClaimResult, Progress, ProofResult, Verdict, Witness, quiet
from interlock.table.rows import InterlockingTable


class LayoutError(Whole):
    """A layout that has errors; `diagnostics` has all of them, each with its code, place and fix, and the message is
    what `interlock check` would print."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...], sources: Mapping[str, str]) -> None:
        super().__init__(full([d for d in diagnostics if d.severity is Severity.ERROR], sources))
        self.diagnostics = diagnostics


class NotProved(Exception):
    """Something is refuted or open, so that nothing may be written."""


@dataclass(frozen=True)
class Compiled:
    """What became of a layout: its proof, and its outputs by their path in the folder.

    Unless everything is proved there is neither PLC text nor runtime among the files.
    """

    layout: Layout
    proof: ProofResult
    proved: bool
    """Every claim is proved, every route driven by its witness, and every text equals the controller."""
    diagnostics: tuple[Diagnostic, ...]
    files: Mapping[str, bytes] = field(repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "files", MappingProxyType(dict(self.files)))

    def __reduce__(self) -> tuple[object, ...]:
        """For another process: a view of a dictionary cannot be pickled."""
        return Compiled, (self.layout, self.proof, self.proved, self.diagnostics, dict(self.files))

    def write(self, folder: str | os.PathLike[str]) -> Path:
        """Write the files to a folder that bears the layout's name, in a folder of outputs; returns it.

        An older output is replaced as a whole.  Raises `NotProved` when something is not proved, FileExistsError when
        something is there that interlock has not written, and OSError.
        """
        if not self.proved:
            raise NotProved(f"{self.layout.name} is not proved")
        target = Path(folder) / self.layout.name
        if found := strangers(target):
            raise FileExistsError(not_replaced(target, found))
        write_folder(target, self.files)
        return target


def load(path: str | os.PathLike[str]) -> Layout:
    """The layout in a file.  Raises `LayoutError` when it cannot be read or has errors."""
    sink = Sink()
    layout, source = load_file(os.fsdecode(path), sink)
    return _sound(layout, source, sink)


def loads(text: str, name: str = "layout.yaml") -> Layout:
    """The layout in a text; `name` is how its diagnostics call it.  Raises `LayoutError`."""
    _given("loads", text, str, "a layout's text", "`load` reads a file, and decodes it")
    sink = Sink()
    layout, source = load_text(name, text, sink)
    return _sound(layout, source, sink)


def _sound(layout: Layout | None, source: Source, sink: Sink) -> Layout:
    if layout is None or sink.has_errors:
        raise LayoutError(sink.diagnostics, source.texts)
    return layout


def check(path: str | os.PathLike[str]) -> Checked:
    """A layout file with all of its diagnostics, warnings too; its layout and table are None when it has errors."""
    return check_file(os.fsdecode(path))


def derive(layout: Layout) -> InterlockingTable:
    """The interlocking table of a layout, seen in the same way by the audit.  Raises `LayoutError`."""
    _layout("derive", layout)
    found = derived(layout.name, layout, Source(layout.name, ""), Sink())
    found = audited(found, second_opinion(found))
    if not found.ok or found.table is None:
        raise LayoutError(found.diagnostics, {})
    return found.table


def lower(layout: Layout, table: InterlockingTable) -> Controller:
    """The controller of a table.  Raises ValueError for the table of another layout."""
    _layout("lower", layout)
    _given("lower", table, InterlockingTable, "a table", "`derive(layout)` makes one")
    if table.layout_digest != layout.digest:
        raise ValueError(f"the table is that of another layout, not of {layout.name}")
    with interning():
        return lower_table(layout, table)


def prove(
    layout: Layout,
    controller: Controller,
    *,
    jobs: int = 1,
    engine: str = "minisat",
    search_depth: int = 16,
    search_seconds: float = 60.0,
    progress: Progress = quiet,
) -> ProofResult:
    """One verdict for each claim about a controller and the trains on its layout; UNKNOWN is never green.

    `jobs` processes (forks); `engine` is minisat, z3 or cvc5 (extra `recheck`); what does not follow is searched for
    in runs of `search_depth` scans, for `search_seconds` a claim.  Raises ValueError for another engine, for a number
    that leaves nothing to be done, and for the controller of another layout; TypeError for an argument of another kind;
    ModuleNotFoundError for an engine whose extra is not installed.
    """
    from interlock.proof.engines import ENGINES
    from interlock.proof.prover import prove as decide
    from interlock.proof.system.transition import System

    _layout("prove", layout)
    _given("prove", controller, Controller, "a controller", "`lower(layout, table)` makes one")
    _one_of((engine,), ENGINES, "engine")
    if engine in _ENGINES:
        _needs(*_ENGINES[engine], f"the engine {engine}")
    _positive(jobs=jobs, search_depth=search_depth)
    _positive(float, search_seconds=search_seconds)
    _called(progress)
    inside = {s for s, section in layout.track.section.items() if not section.approach}
    if controller.name != layout.name or set(controller.symbols.ways.ends) != inside:
        raise ValueError(f"the controller is that of another layout, not of {layout.name}")
    limits = Limits(engine=engine, jobs=jobs, search_depth=search_depth, search_s=search_seconds)
    with interning(controller.nodes):
        return decide(System(layout, controller), limits, progress)


def _positive(kind: type[int] | type[float] = int, **numbers: float) -> None:
    """Raises TypeError for what is no number of a kind (a whole one is one of any), ValueError for one below."""
    for name, x in numbers.items():
        if not isinstance(x, (int, kind)):
            what = "a whole number" if kind is int else "a number"
            raise TypeError(f"{name} is {what}, and {x!r} is of type {type(x).__name__}")
        if not x > 0:
            raise ValueError(f"{name} is {x}; it must be above 0")


def _called(progress: object) -> None:
    if not callable(progress):
        said = f"progress is a function (stage, done, total), and {progress!r} is of type {type(progress).__name__}"
        raise TypeError(said)


def compile(layout: Layout, *, jobs: int = 1, dialects: tuple[str, ...] = (), progress: Progress = quiet) -> Compiled:
    """Derive, audit, lower and prove a layout, write its texts, read them back and compare them: all outputs.

    Raises `LayoutError`, ValueError for `jobs` below 1 and for a dialect that is none, and TypeError for an argument of
    another kind.  `dialects`: other tools'
    forms of the PLC text, beside the portable one; `c99` (extra `c99`) is the C runtime, and ModuleNotFoundError where
    that extra is not installed.
    """
    from interlock.app.compile import build_derived, finish
    from interlock.app.texts import C99
    from interlock.st.dialects import BY_NAME

    _layout("compile", layout)
    _one_of(dialects, (*BY_NAME, C99), "dialect")
    if C99 in dialects:
        _needs("pycparser", "c99", f"the dialect {C99}")
    _positive(jobs=jobs)
    _called(progress)
    begun = derived(layout.name, layout, Source(layout.name, ""), Sink())
    proved, files = build_derived(begun, limits=Limits(jobs=jobs), progress=progress, dialects=dialects)
    if proved.proof is None:
        raise LayoutError(proved.checked.diagnostics, {})
    told = (*proved.checked.diagnostics, *proved.notes)
    return Compiled(layout, proved.proof, proved.green, told, finish(proved.checked, files))


_ENGINES = {"cvc5": ("cvc5", "recheck")}
"""Of engines that are not installed with interlock: the module, and the extra that brings it."""


def _needs(module: str, extra: str, what: str) -> None:
    """Raises ModuleNotFoundError, which says how an extra is installed, before any work is done."""
    if find_spec(module) is None:
        raise ModuleNotFoundError(f"{what} needs the extra `{extra}`: {install(extra)}", name=module)


def _given(function: str, value: object, wanted: type, what: str, how: str) -> None:
    """Raises TypeError for a value of another kind, and says what makes one that is wanted."""
    if not isinstance(value, wanted):
        told = repr(value) if isinstance(value, str) and len(value) < 80 else "it"
        kind = type(value).__name__
        raise TypeError(f"{function} takes {what} ({wanted.__name__}), and {told} is of type {kind}: {how}")


def _layout(function: str, value: object) -> None:
    _given(function, value, Layout, "a layout", "`load(path)` or `loads(text)` makes one")


def _one_of(names: Iterable[str], known: Iterable[str], what: str) -> None:
    """What is asked for by a name that nothing bears is refused: it would be left out without a word."""
    if isinstance(names, str):
        raise ValueError(f"write a tuple: ('{names}',)")
    for name in names:
        if name not in known:
            raise ValueError(f"there is no {what} {name!r}; there are {', '.join(known)}")


__all__ = [
    "Checked",
    "ClaimResult",
    "Compiled",
    "Controller",
    "Diagnostic",
    "InterlockingTable",
    "Layout",
    "LayoutError",
    "NotProved",
    "ProofResult",
    "Severity",
    "Verdict",
    "Witness",
    "check",
    "compile",
    "derive",
    "load",
    "loads",
    "lower",
    "prove",
]
