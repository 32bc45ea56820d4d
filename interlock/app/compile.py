"""From a layout file to its outputs: load, derive, audit, lower, prove, emit, prove the text.

Nothing here prints.  PLC text is written only when everything is proved, or marked when it is not.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from interlock import __version__
from interlock.diag import Diagnostic, Severity, Sink, Stopped
from interlock.frontend import Source, load
from interlock.logic.controller import Controller
from interlock.model.layout import Layout
from interlock.proof.runner import Limits, Progress, ProofResult, Verdict, quiet
from interlock.table.rows import InterlockingTable


@dataclass(frozen=True)
class Checked:
    """A layout file with its diagnostics; layout and table are None when there are errors."""

    path: str
    source: Source
    diagnostics: tuple[Diagnostic, ...]
    layout: Layout | None = None
    table: InterlockingTable | None = None

    @property
    def ok(self) -> bool:
        """No errors."""
        return self.layout is not None and not any(d.severity is Severity.ERROR for d in self.diagnostics)


@dataclass(frozen=True)
class Proved:
    """A checked layout with its proof (None when it has errors)."""

    checked: Checked
    proof: ProofResult | None = None
    text_equal: bool | None = None
    text_differences: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    notes: tuple[Diagnostic, ...] = ()

    @property
    def green(self) -> bool:
        """Everything proved; UNKNOWN is never green."""
        return (
            self.proof is not None
            and self.proof.proved
            and self.text_equal is not False
            and not any(d.severity is Severity.ERROR for d in self.notes)
        )

    @property
    def unknown(self) -> bool:
        """Something could not be decided, and nothing is refuted."""
        verdicts = {c.verdict for c in self.proof.claims} if self.proof is not None else set()
        return Verdict.UNKNOWN in verdicts and Verdict.REFUTED not in verdicts


def check_file(path: str) -> Checked:
    """Load and derive; audit the derived table."""
    from interlock.audit import audit
    from interlock.derive import derive

    sink = Sink()
    try:
        layout, source = load(path, sink)
        if layout is None:
            return Checked(path, source, sink.diagnostics)
        table = derive(layout, sink)
        if not sink.has_errors:
            for finding in audit(layout, table):
                sink.add(
                    "IL4007",
                    f"route {finding.route}, {finding.column}: {finding.text}",
                    None,
                    "this is a defect of interlock; please report the layout",
                )
    except Stopped as stopped:
        return Checked(path, Source(path, ""), stopped.diagnostics)
    placed = tuple(_place(d, source, path) for d in sink.diagnostics)
    return Checked(path, source, placed, layout, table)


def _place(d: Diagnostic, source: Source, path: str) -> Diagnostic:
    """Diagnostics of the derivation point at the element that they speak of."""
    if d.span is not None:
        return d
    if d.code == "IL2008" and source.context is not None:
        for i, w in enumerate(source.context.file.waive):
            if f" {w.flank} " in d.message:
                return replace(d, span=source.context.at("waive", i, "flank"))
    file = source.context.file if source.context else None
    if file is None:
        return replace(d, span=source.at("name"))
    for word in "".join(c if c not in ",:;()" else " " for c in d.message).split():
        for name in (word, word.split(".")[0], word.split("-")[0]):
            for room in ("points", "signals", "routes", "crossings"):
                if name in getattr(file, room):
                    return replace(d, span=source.at(room, name))
            for track, items in file.tracks.items():
                for i, item in enumerate(items):
                    if item.split()[0] == name and source.context is not None:
                        return replace(d, span=source.context.at("tracks", track, i))
    return replace(d, span=source.at("name"))


def prove_file(path: str, limits: Limits | None = None, progress: Progress = quiet) -> Proved:
    """Check a file and prove its controller and the text that would be emitted."""
    checked = check_file(path)
    if not checked.ok:
        return Proved(checked)
    return _prove(checked, limits, progress)[0]


def _prove(checked: Checked, limits: Limits | None, progress: Progress) -> tuple[Proved, dict[str, bytes]]:
    from interlock.logic.lower import lower
    from interlock.proof.runner import prove
    from interlock.proof.system import System
    from interlock.proof.translation import compare_st

    assert checked.layout is not None and checked.table is not None
    controller = lower(checked.layout, checked.table)
    system = System(checked.layout, controller)
    proof = prove(system, limits, progress)
    progress("comparing the text", 0, 1)
    texts = _texts(checked.layout, controller, proof)
    translation = compare_st(controller, texts[f"st/iec/{checked.layout.name}.st"].decode())
    notes = list(_notes(checked, proof))
    notes += [
        Diagnostic("IL5001", Severity.ERROR, f"text and controller differ at {d.name}: {d.text}")
        for d in translation.differences
    ]
    return Proved(
        checked, proof, translation.proved, tuple(d.name for d in translation.differences), (), tuple(notes)
    ), texts


def _notes(checked: Checked, proof: ProofResult) -> list[Diagnostic]:
    span = checked.source.at("name")
    out = []
    for c in proof.claims:
        where = ", ".join(c.open[:6]) + (" ..." if len(c.open) > 6 else "")
        if c.verdict is Verdict.REFUTED:
            out.append(
                Diagnostic(
                    "IL5001",
                    Severity.ERROR,
                    f"{c.id} is refuted at {where}: {c.sentence}",
                    span,
                    "read the counterexample below; change the layout, or remove the waiver",
                )
            )
        elif c.verdict is Verdict.UNKNOWN:
            out.append(
                Diagnostic(
                    "IL5002",
                    Severity.ERROR,
                    f"{c.id} could not be decided at {where}: {c.sentence}",
                    span,
                    "nothing may be concluded; try `--search-depth` or report the layout",
                )
            )
    for w in proof.witnesses:
        if not w.ok:
            out.append(
                Diagnostic(
                    "IL4006",
                    Severity.ERROR,
                    f"route {w.route} cannot be driven: {w.text}",
                    span,
                    "check lengths, directions and conditions on its way",
                )
            )
    return out


def _header(layout: Layout, proof: ProofResult) -> list[str]:
    claims = json.dumps(claims_json(proof), sort_keys=True)
    head = [
        f"Interlocking {layout.name}, made by interlock {__version__}. Standard program, not certified.",
        "Not an F-program.",
        f"layout {layout.digest}",
        f"claims {hashlib.sha256(claims.encode()).hexdigest()}",
    ]
    if not proof.proved:
        head.insert(0, "NOT PROVED: for study only, never for a railway")
    return head


def claims_json(proof: ProofResult) -> list[dict[str, object]]:
    """Verdicts as data, without timings, so that the bytes are reproducible."""
    return [
        {"id": c.id, "verdict": str(c.verdict), "places": c.places, "open": list(c.open), "sentence": c.sentence}
        for c in proof.claims
    ]


def _texts(layout: Layout, controller: Controller, proof: ProofResult) -> dict[str, bytes]:
    from interlock.emit.python.runtime import runtime_py
    from interlock.st.lower import lower_st
    from interlock.st.printer import print_unit

    header = _header(layout, proof)
    return {
        f"st/iec/{layout.name}.st": print_unit(lower_st(controller, header)).encode(),
        "runtime.py": runtime_py(controller, header).encode(),
    }


def build(
    path: str, *, unproved: bool = False, limits: Limits | None = None, progress: Progress = quiet
) -> tuple[Proved, dict[str, bytes]]:
    """All outputs of a layout in memory; empty when there are errors, no PLC text when something is open."""
    checked = check_file(path)
    if not checked.ok:
        return Proved(checked), {}
    proved, texts = _prove(checked, limits, progress)
    files = _documents(checked, proved)
    if proved.green or unproved:
        files |= texts
    return replace(proved, files=tuple(sorted(files))), files


def _documents(checked: Checked, proved: Proved) -> dict[str, bytes]:
    from interlock.emit.tables.export import matrix_csv, table_csv, table_html, table_json, table_xlsx
    from interlock.logic.plant import ASSUMPTIONS

    layout, table, proof = checked.layout, checked.table, proved.proof
    assert layout is not None and table is not None and proof is not None
    watermark = "" if proved.green else "NOT PROVED: for study only, never for a railway"
    body = {
        "schema": "interlock-proof/1",
        "layout": layout.name,
        "layout_digest": layout.digest,
        "proved": proved.green,
        "claims": claims_json(proof),
        "text": {f"st/iec/{layout.name}.st": "PROVED equal to the controller" if proved.text_equal else "NOT EQUAL"},
        "assumptions": ASSUMPTIONS,
        "invariants": proof.invariants,
        "dropped_invariants": list(proof.dropped),
        "obligations": proof.obligations,
        "witnesses": [{"route": w.route, "ok": w.ok, "scans": w.steps, "text": w.text} for w in proof.witnesses],
        "counterexamples": [
            {"claim": c.id, "place": c.story.place, "steps": list(c.story.steps)} for c in proof.claims if c.story
        ],
    }
    return {
        "table.json": table_json(table).encode(),
        "table.csv": table_csv(table).encode(),
        "table.xlsx": table_xlsx(layout, table),
        "table.html": table_html(layout, table, claims_json(proof), watermark).encode(),
        "matrix.csv": matrix_csv(table).encode(),
        "proof.json": (json.dumps(body, indent=1, ensure_ascii=False) + "\n").encode(),
    }


def finish(checked: Checked, files: dict[str, bytes]) -> dict[str, bytes]:
    """The files with their manifest."""
    from interlock.emit.bundle import with_manifest

    assert checked.layout is not None
    return with_manifest(
        files,
        {
            "layout": checked.layout.name,
            "layout_digest": checked.layout.digest,
            "tool": f"interlock {__version__}",
        },
    )


def compile_file(
    path: str,
    out: Path,
    check: bool = False,
    unproved: bool = False,
    limits: Limits | None = None,
    progress: Progress = quiet,
) -> Proved:
    """Write the outputs of a layout (or compare them with what is there)."""
    from interlock.emit.bundle import differences, is_bundle, write_folder

    proved, files = build(path, unproved=unproved, limits=limits, progress=progress)
    layout = proved.checked.layout
    if not files or layout is None:
        return proved
    files = finish(proved.checked, files)
    target = out / layout.name
    span = proved.checked.source.at("name")
    notes = list(proved.notes)
    if check:
        notes += [
            Diagnostic("IL5003", Severity.ERROR, f"{target}: {d}", span, f"run `interlock compile {path} -o {out}`")
            for d in differences(target, files)
        ]
    elif not is_bundle(target):
        notes.append(
            Diagnostic(
                "IL5004",
                Severity.ERROR,
                f"{target} exists and was not made by interlock",
                span,
                "choose another folder with -o, or move it away",
            )
        )
    else:
        try:
            write_folder(target, files)
        except OSError as error:
            notes.append(
                Diagnostic(
                    "IL5004",
                    Severity.ERROR,
                    f"{target}: {error.strerror}",
                    span,
                    "check the folder and its permissions",
                )
            )
    if not proved.green and not unproved and not check:
        notes.append(
            Diagnostic(
                "IL5006",
                Severity.ERROR,
                "no PLC text and no runtime were written",
                span,
                "everything must be PROVED first; `--unproved` writes them with a mark, for study",
            )
        )
    return replace(proved, files=tuple(sorted(files)), notes=tuple(notes))


@dataclass(frozen=True)
class Reason:
    """One item of a cell with its reason."""

    column: str
    item: str
    rule: str
    text: str


def why(path: str, route: str, column: str | None) -> tuple[Checked, tuple[Reason, ...], tuple[Diagnostic, ...]]:
    """The reasons of a route's cells."""
    from interlock.diag.suggest import did_you_mean
    from interlock.table.columns import COLUMNS

    checked = check_file(path)
    if checked.table is None:
        return checked, (), ()
    rows = [r for r in checked.table.routes if route in (r.id, str(r.number), *r.names)]
    if not rows:
        known = [n for r in checked.table.routes for n in (r.id, *r.names)]
        return (
            checked,
            (),
            (
                Diagnostic(
                    "IL5005",
                    Severity.ERROR,
                    f"{path} has no route {route}",
                    None,
                    did_you_mean(route, known) or "known: " + ", ".join(known),
                ),
            ),
        )
    picked = [c for c in COLUMNS if column in (None, c.key, c.en)]
    if not picked:
        return (
            checked,
            (),
            (
                Diagnostic(
                    "IL5005",
                    Severity.ERROR,
                    f"there is no column {column}",
                    None,
                    did_you_mean(column or "", [c.key for c in COLUMNS]),
                ),
            ),
        )
    reasons = [Reason(c.en, item, b.rule, b.text) for c in picked for r in rows for item, b in c.items(r)]
    return checked, tuple(reasons), ()


def explain(code: str) -> str | None:
    """The page of a diagnostic code, or None."""
    from importlib import resources

    page = resources.files("interlock").joinpath(f"docs/codes/{code.upper()}.md")
    return page.read_text("utf-8") if code.upper()[2:].isdigit() and page.is_file() else None


def run_many(work: Callable[..., Proved], calls: Sequence[tuple[object, ...]], jobs: int) -> list[Proved]:
    """Several layouts on several processes; the results are in the order of the calls."""
    from concurrent.futures import ProcessPoolExecutor

    with ProcessPoolExecutor(min(jobs, len(calls))) as pool:
        return [f.result() for f in [pool.submit(work, *c) for c in calls]]
