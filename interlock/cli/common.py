"""What the verbs share: options, progress, rendering, exit codes."""

from __future__ import annotations

import json
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

from interlock.diag import Diagnostic, Severity
from interlock.diag import render as renderers

if TYPE_CHECKING:
    from interlock.app.proved import Proved
    from interlock.proof.verdict import ClaimResult

OK, FINDINGS, NOT_PROVED = 0, 1, 3

layouts_argument = click.argument("layouts", nargs=-1, required=True, metavar="LAYOUT...")
format_option = click.option(
    "--format",
    "form",
    type=click.Choice(["full", "concise", "json"]),
    default="full",
    show_default=True,
    help="How results are shown.",
)
jobs_option = click.option(
    "-j",
    "--jobs",
    type=click.IntRange(1, 64),
    default=1,
    show_default=True,
    help="Processes: layouts side by side, or the parts of one.",
)


def show(diagnostics: Iterable[Diagnostic], sources: dict[str, str], form: str) -> None:
    """Print diagnostics; notes of severity info take one line each."""
    found = list(diagnostics)
    if form == "concise":
        click.echo(renderers.concise(found, sources), nl=False)
        return
    on_terminal = sys.stdout.isatty()
    width = shutil.get_terminal_size().columns if on_terminal else None
    paint = _painted if on_terminal and not os.environ.get("NO_COLOR") else renderers.bare
    serious = [d for d in found if d.severity is not Severity.INFO]
    click.echo(renderers.full(serious, sources, width, paint), nl=False)
    click.echo(renderers.concise([d for d in found if d.severity is Severity.INFO], sources), nl=False)


def _painted(text: str, severity: Severity) -> str:
    return click.style(text, fg={Severity.ERROR: "red", Severity.WARNING: "yellow"}.get(severity), bold=True)


def put_json(body: Any) -> None:
    """Print JSON."""
    click.echo(json.dumps(body, indent=2, ensure_ascii=False))


def exit_code(proofs: Sequence[Proved]) -> int:
    """1 when anything is wrong, else 3 when something is open, else 0."""
    if any(not p.checked.ok for p in proofs) or any(not p.green and not p.unknown for p in proofs):
        return FINDINGS
    return NOT_PROVED if any(p.unknown for p in proofs) else OK


@contextmanager
def progress(label: str) -> Iterator[Callable[[str, int, int], None]]:
    """A progress bar after one second, on a terminal only."""
    if not sys.stderr.isatty():
        yield lambda stage, done, total: None
        return
    began = time.monotonic()
    bar: Any = None
    task: Any = None

    def report(stage: str, done: int, total: int) -> None:
        nonlocal bar, task
        if bar is None:
            if time.monotonic() - began < 1:
                return
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

            bar = Progress(
                TextColumn("{task.description}"),
                BarColumn(),
                TimeElapsedColumn(),
                console=Console(stderr=True),
                transient=True,
            )
            bar.start()
            task = bar.add_task(label, total=total)
        bar.update(task, description=f"{label}: {stage}", completed=done, total=total)

    try:
        yield report
    finally:
        if bar is not None:
            bar.stop()


_COLOURS = {"PROVED": "green", "REFUTED": "red", "UNKNOWN": "yellow"}


def proof_body(p: Proved) -> dict[str, Any]:
    """A proof as data."""
    body: dict[str, Any] = {
        "file": p.checked.path,
        "ok": p.green,
        "diagnostics": renderers.as_json(
            [*p.checked.diagnostics, *p.notes], {p.checked.source.file: p.checked.source.text}
        ),
        "files": list(p.files),
    }
    if p.proof is not None:
        body |= {
            "claims": [
                {
                    "id": c.id,
                    "verdict": str(c.verdict),
                    "sentence": c.sentence,
                    "places": c.places,
                    "seconds": round(c.seconds, 4),
                    "open": list(c.open),
                    "story": list(c.story.steps) if c.story else None,
                }
                for c in p.proof.claims
            ],
            "witnesses": [{"route": w.route, "ok": w.ok, "text": w.text} for w in p.proof.witnesses],
            "text_equals_controller": p.text_equal,
            "texts": {t.file: t.equal for t in p.texts},
            "seconds": round(p.proof.seconds, 3),
            "kept": p.proof.kept,
        }
    return body


def show_proof(p: Proved, form: str, verbose: bool) -> None:
    """A proof for people."""
    sources = {p.checked.source.file: p.checked.source.text}
    if not p.checked.ok:
        show(p.checked.diagnostics, sources, form)
        click.echo(f"{p.checked.path}: {renderers.summary(p.checked.diagnostics) or 'errors'}")
        return
    show([d for d in p.checked.diagnostics if d.severity is not Severity.INFO], sources, form)
    if p.proof is None:
        return
    ok = sum(w.ok for w in p.proof.witnesses)
    if verbose or not (p.proof.proved and p.text_equal):
        for c in p.proof.claims:
            mark = click.style(f"{c.verdict:8}", fg=_COLOURS[c.verdict])
            count = _number(c.places, "place") if c.places else "nothing to claim"
            click.echo(f"  {mark if c.places else ' ' * 8} {c.id:15} {count:>16}  {c.sentence}")
        for t in p.texts:
            same = "PROVED  " if t.equal else "REFUTED "
            click.echo(f"  {click.style(same, fg=_COLOURS[same.strip()])} {t.file} = controller")
    show(p.notes, sources, form)
    for c in p.proof.claims:
        if c.story:
            click.echo(f"  Counterexample to {c.id}:")
            for n, step in enumerate(c.story.steps, 1):
                click.echo(f"    {n}. {step}")
    if p.unknown:
        verdict = click.style("COULD NOT BE PROVED", fg="red")
    elif p.proof.proved and p.text_equal:
        verdict = click.style("PROVED", fg="green")
    else:
        verdict = click.style("NOT SAFE", fg="red")
    routes = len(p.proof.witnesses)
    click.echo(
        f"{p.checked.path}: {verdict}  {_claimed(p.proof.claims)}; {routes} routes, {ok} driven by a witness, "
        f"text {'=' if p.text_equal else 'differs from'} controller, "
        f"{'as an earlier run has proved it' if p.proof.kept else f'{p.proof.seconds:.1f} s'}"
    )


def _claimed(claims: Sequence[ClaimResult]) -> str:
    """What was claimed of this layout, at how many places, and how much of it is proved."""
    said = [c for c in claims if c.places]
    proved = sum(c.verdict == "PROVED" for c in said)
    places, silent = sum(c.places for c in said), len(claims) - len(said)
    found = "all proved" if proved == len(said) else f"{proved} of them proved everywhere"
    counted = f"{_number(len(said), 'claim')} at {_number(places, 'place')}, {found}"
    return (
        f"{counted}; {_number(silent, 'claim')} {'has' if silent == 1 else 'have'} nothing to claim here"
        if silent
        else counted
    )


def _number(n: int, of: str) -> str:
    return f"{n} {of}" if n == 1 else f"{n} {of}s"
