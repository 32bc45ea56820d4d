"""From a layout file to its folder of outputs.

Nothing here prints.  PLC text is written only when everything is proved, or marked when it is not.
"""

from __future__ import annotations

import errno
import json
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from interlock import __version__
from interlock.app.check import Checked, derive_file
from interlock.app.draw import plan_notes
from interlock.app.making import NOT_PROVED, claims_json
from interlock.app.prove import prove_derived
from interlock.app.proved import Proved
from interlock.app.target import target_notes
from interlock.app.writing import written_for
from interlock.diag import Diagnostic, Severity, Sink, Span
from interlock.emit.bundle import differences, left_beside, not_replaced, strangers, with_manifest, write_folder
from interlock.emit.drawing import opening, place, plan_svg
from interlock.emit.io import channels_csv, equipment_csv, names_csv, tags_xlsx, words_csv
from interlock.emit.report import player_html, report_html
from interlock.emit.tables.document import table_json
from interlock.emit.tables.export import (
    matrix_csv,
    sheet_csv,
    table_csv,
    voyages_csv,
)
from interlock.emit.tables.railml import railml_json
from interlock.emit.tables.workbook import table_xlsx
from interlock.frontend import load
from interlock.logic.cabinet import allocate
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.logic.plant import assumed_of
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Progress, quiet
from interlock.st.dialects import BY_NAME
from interlock.table.national import national_sheets


def build(
    path: str,
    *,
    unproved: bool = False,
    limits: Limits | None = None,
    progress: Progress = quiet,
    dialects: Sequence[str] = (),
) -> tuple[Proved, dict[str, bytes]]:
    """All outputs of a layout file in memory; empty when there are errors, no PLC text when something is open."""
    progress("deriving", 0, 0)
    return build_derived(derive_file(path), unproved=unproved, limits=limits, progress=progress, dialects=dialects)


def build_derived(
    derived: Checked,
    *,
    unproved: bool = False,
    limits: Limits | None = None,
    progress: Progress = quiet,
    dialects: Sequence[str] = (),
) -> tuple[Proved, dict[str, bytes]]:
    """The same of a layout that is derived."""
    proved, texts = prove_derived(derived, limits, progress, dialects)
    checked = proved.checked
    if not checked.ok:
        return proved, {}
    progress("writing tables and plan", 0, 0)
    assert checked.layout is not None
    drawing = place(checked.layout)
    proved = replace(proved, notes=(*proved.notes, *plan_notes(drawing.notes, checked.source)))
    plan = plan_svg(checked.layout, drawing)
    files, notes = _documents(checked, proved, plan)
    proved = replace(proved, notes=(*proved.notes, *notes))
    if proved.green or unproved:
        files |= texts
    for claim, trace in proved.traces:
        files[f"counterexamples/{claim}.itf.json"] = trace.encode()
        files[f"counterexamples/{claim}.html"] = player_html(trace).encode()
    files["index.html"] = _report(checked, proved, plan, files).encode()
    return replace(proved, files=tuple(sorted(files))), files


def _documents(checked: Checked, proved: Proved, plan: str) -> tuple[dict[str, bytes], tuple[Diagnostic, ...]]:
    """Everything but texts and report, and what there is to say of the controller for which it is meant."""
    layout, table, proof = checked.layout, checked.table, proved.proof
    assert layout is not None and table is not None and proof is not None
    with interning():
        controller = lower(layout, table)
        allocation = allocate(layout, controller)
        notes = target_notes(layout, controller, checked.source)
    body = {
        "schema": "interlock-proof/1",
        "layout": layout.name,
        "layout_digest": layout.digest,
        "proved": proved.green,
        "claims": claims_json(proof.claims),
        "text": {t.file: "PROVED equal to the controller" if t.equal else "NOT EQUAL" for t in proved.texts},
        "assumptions": assumed_of(layout),
        "invariants": proof.invariants,
        "dropped_invariants": list(proof.dropped),
        "obligations": proof.obligations,
        "witnesses": [{"route": w.route, "ok": w.ok, "scans": w.steps, "text": w.text} for w in proof.witnesses],
        "counterexamples": [
            {"claim": c.id, "place": c.story.place, "steps": list(c.story.steps)} for c in proof.claims if c.story
        ],
    }
    files = {
        "table.json": table_json(layout, table).encode(),
        "table.csv": table_csv(table).encode(),
        "table.xlsx": table_xlsx(layout, table, "" if proved.green else NOT_PROVED),
        "plan.svg": opening(plan, "" if proved.green else NOT_PROVED).encode(),
        "matrix.csv": matrix_csv(table).encode(),
        "table_railml.json": railml_json(layout, table).encode(),
        **({"voyages.csv": voyages_csv(table).encode()} if table.voyages else {}),
        **{f"table_{form.key}.csv": sheet_csv(form).encode() for form in national_sheets(layout, table)},
        "io/channels.csv": channels_csv(layout, controller, allocation).encode(),
        "io/equipment.csv": equipment_csv(layout, allocation).encode(),
        **({"io/names.csv": told.encode()} if (told := names_csv(layout)) else {}),
        "io/words.csv": words_csv(controller).encode(),
        "io/tags_tia.xlsx": tags_xlsx(layout, allocation),
        "proof.json": (json.dumps(body, indent=1, ensure_ascii=False) + "\n").encode(),
    }
    return files, notes


def _report(checked: Checked, proved: Proved, plan: str, files: dict[str, bytes]) -> str:
    layout, table, proof = checked.layout, checked.table, proved.proof
    assert layout is not None and table is not None and proof is not None
    return report_html(
        layout,
        table,
        plan,
        claims_json(proof.claims),
        [(t.file, t.equal) for t in proved.texts],
        assumed_of(layout),
        files,
        "" if proved.green else NOT_PROVED,
    )


def finish(checked: Checked, files: dict[str, bytes]) -> dict[str, bytes]:
    """The files with their manifest."""
    assert checked.layout is not None
    return with_manifest(
        files,
        {
            "layout": checked.layout.name,
            "layout_digest": checked.layout.digest,
            "tool": f"interlock {__version__}",
        },
    )


NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""What a system says where nothing more can be stored."""
ELSEWHERE = "move away what is yours, or choose another folder with -o"
"""What to do where a folder is not replaced."""


def _named(tools: Sequence[str]) -> list[str]:
    """Dialects as an option names them: `all` for those of the PLC text."""
    rest = [d for d in tools if d not in BY_NAME]
    return ["all", *rest] if BY_NAME.keys() <= set(tools) else list(tools)


def compile_file(
    path: str,
    out: Path,
    check: bool = False,
    unproved: bool = False,
    limits: Limits | None = None,
    dialects: Sequence[str] = (),
    progress: Progress = quiet,
) -> Proved:
    """Write the outputs of a layout (or compare them with what is there)."""
    began = time.monotonic()
    progress("deriving", 0, 0)
    derived = derive_file(path)
    there = written_for(out / derived.layout.name) if derived.layout is not None else ()
    tools = dialects or (there if check else ())
    proved, files = build_derived(derived, unproved=unproved, limits=limits, progress=progress, dialects=tools)
    layout = proved.checked.layout
    if not files or layout is None:
        return proved
    files = finish(proved.checked, files)
    target = out / layout.name
    span = proved.checked.source.at("name")
    notes = list(proved.notes)
    if check:
        again = " ".join((f"interlock compile {path} -o {out}", *(f"--dialect {d}" for d in _named(tools))))
        notes += [
            Diagnostic("IL5003", Severity.ERROR, f"{target}: {d}", span, f"run `{again}`")
            for d in differences(target, files)
        ]
    else:
        notes += _delivered(target, files, span)
        gone = [d for d in there if d not in tools]
        if gone and (proved.green or unproved) and notes == list(proved.notes):
            tools_gone = [
                d for d in gone if d != "iec"
            ]  # that text is always written, its cross-reference if asked for
            what = [f"the text for {', '.join(tools_gone)}"] if tools_gone else []
            what += ["io/xref_iec.csv"] if "iec" in gone else []
            text = f"{target}: {' and '.join(what)} {'is' if len(what) == 1 else 'are'} not written any more"
            fix = f"`{' '.join(f'--dialect {d}' for d in gone)}` writes it"
            notes.append(Diagnostic("IL5012", Severity.INFO, text, span, fix))
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
    notes += left(target, span)
    seconds = time.monotonic() - began
    return replace(proved, files=tuple(sorted(files)), notes=tuple(notes), seconds=seconds)


def left(target: Path, span: Span | None) -> list[Diagnostic]:
    """What earlier runs have left beside a folder."""
    said = "is not needed: an earlier run was killed before it took it away, or could not remove it"
    fix = "remove it, if no other run is writing there"
    return [Diagnostic("IL5013", Severity.WARNING, f"{p} {said}", span, fix) for p in left_beside(target)]


def _delivered(target: Path, files: dict[str, bytes], span: Span | None) -> list[Diagnostic]:
    """Write a folder of outputs; why it is not written, if so."""
    if found := strangers(target):
        return [Diagnostic("IL5004", Severity.ERROR, not_replaced(target, found), span, ELSEWHERE)]
    try:
        write_folder(target, files)
    except OSError as error:
        text = f"{target}: {error.strerror}"
        fix = "make room there" if error.errno in NO_ROOM else "check the folder and its permissions"
        return [Diagnostic("IL5004", Severity.ERROR, text, span, fix)]
    return []


def names_twice(paths: Sequence[str]) -> tuple[Diagnostic, ...]:
    """Layouts of one name would overwrite each other's outputs."""
    first: dict[str, str] = {}
    found = []
    for path in paths:
        layout, source = load(path, Sink())
        if layout is None:
            continue
        before = first.setdefault(layout.name.lower(), path)
        if before != path:
            message = f"{path} bears the name {layout.name}, as {before} does: their outputs would overwrite each other"
            fix = "rename one of them, or compile them into different folders with -o"
            found.append(Diagnostic("IL5004", Severity.ERROR, message, source.at("name"), fix))
    return tuple(found)
