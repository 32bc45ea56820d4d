"""What the verbs share: options, progress, rendering, exit codes."""

from __future__ import annotations

import json
import math
import shutil
import signal
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from threading import Timer
from typing import TYPE_CHECKING, Any

import click

from interlock.diag import Diagnostic, Severity
from interlock.diag import render as renderers

if TYPE_CHECKING:
    from interlock.app.proved import Proved
    from interlock.proof.induction.verdict import ClaimResult

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
look_ahead_option = click.option(
    "--look-ahead",
    type=click.IntRange(1, 50),
    default=1,
    show_default=True,
    help="How many routes ahead of a train are opened.",
)

without_rule_option = click.option(
    "--without-rule", is_flag=True, help="Ask for routes whether or not a plan exists after them."
)

jobs_option = click.option(
    "-j",
    "--jobs",
    type=click.IntRange(1, 64),
    default=1,
    show_default=True,
    help="Processes: layouts side by side, or the parts of one.",
)


class Amount(click.FloatRange):
    """A number within bounds; "not a number" lies within none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        found = super().convert(value, param, ctx)
        if isinstance(found, float) and not math.isfinite(found):
            self.fail(f"{value} is not in the range {self._describe_range()}.", param, ctx)
        return found


force_option = click.option("--force", is_flag=True, help="Overwrite a file that interlock has not written.")


def show(diagnostics: Iterable[Diagnostic], sources: dict[str, str], form: str) -> None:
    """Print diagnostics; notes of severity info take one line each.  As JSON they are all that is said."""
    found = list(diagnostics)
    if form == "json":
        put_json(
            {
                "ok": not any(d.severity is Severity.ERROR for d in found),
                "diagnostics": renderers.as_json(found, sources),
            }
        )
        return
    if form == "concise":
        click.echo(renderers.concise(found, sources, _painted), nl=False)
        return
    width = shutil.get_terminal_size().columns if sys.stdout.isatty() else None
    serious = [d for d in found if d.severity is not Severity.INFO]
    info = [d for d in found if d.severity is Severity.INFO]
    click.echo(renderers.full(serious, sources, width, _painted), nl=False)
    click.echo(renderers.concise(info, sources, _painted), nl=False)


_SEVERITIES = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.INFO: "blue"}


def _painted(text: str, severity: Severity) -> str:
    return click.style(text, fg=_SEVERITIES[severity], bold=True)


def put_json(body: Any) -> None:
    """Print JSON."""
    click.echo(json.dumps(body, indent=2, ensure_ascii=False))


def failed(message: str, form: str, code: str = "", fix: str = "") -> None:
    """Say why a command could not do its work: on the error stream, or as JSON."""
    if form == "json":
        put_json({"ok": False, "error": message, "code": code or None, "fix": fix or None})
        return
    mark = click.style(f"error[{code}]" if code else "error", fg="red", bold=True)
    click.echo(f"{mark}: {message}" + (f"\n  fix: {fix}" if fix else ""), err=True)


def told(error: Exception, path: Path) -> str:
    """An error in words."""
    if isinstance(error, OSError):
        return f"{path}: {error.strerror}"
    return f"{path}: not UTF-8 text" if isinstance(error, UnicodeDecodeError) else str(error)


def end_as_by_ctrl_c() -> None:
    """From now on whoever asks the process to end does so as by Ctrl-C, so that the outputs are written restrictive."""
    for name in ("SIGTERM", "SIGHUP"):
        if (ending := getattr(signal, name, None)) is not None:  # Windows has no SIGHUP
            signal.signal(ending, _end)


def _end(number: int, frame: object) -> None:
    raise KeyboardInterrupt


def ending(unwritten: Mapping[str, str], longest_s: float, cycle_ms: int) -> dict[str, Any]:
    """The last event of a run; `unwritten`: the substations that could not be written at the end, and why."""
    stopped = "every output that could be reached is restrictive"
    event = {"stopped": stopped, "ms": round(longest_s * 1000, 1), "of": cycle_ms}
    return event | ({"not_written": dict(unwritten)} if unwritten else {})


def ended(event: Mapping[str, Any]) -> str:
    """The same for people."""
    left = [
        f"NOT WRITTEN: substation {name}: {why}; its own watch has to let go of its outputs"
        for name, why in event.get("not_written", {}).items()
    ]
    last = f"stopped; the longest cycle took {event['ms']} ms of {event['of']} ms"
    return "\n".join([event["stopped"], *left, last])


def took(began: float) -> str:
    """The time since then, by the clock on the wall."""
    return f"{time.monotonic() - began:.1f} s"


def exit_code(proofs: Sequence[Proved]) -> int:
    """1 when anything is wrong, else 3 when something is open, else 0."""
    if any(not p.checked.ok for p in proofs) or any(not p.green and not p.unknown for p in proofs):
        return FINDINGS
    return NOT_PROVED if any(p.unknown for p in proofs) else OK


@contextmanager
def progress(label: str) -> Iterator[Callable[[str, int, int], None]]:
    """What is being done: on a terminal a bar, after one second; elsewhere a line for each stage.

    A stage whose length nobody knows has a total of 0: its bar only moves.
    """
    shown = _Bar(label) if sys.stderr.isatty() else _Lines(label)
    try:
        yield shown.report
    finally:
        shown.end()


class _Lines:
    def __init__(self, label: str) -> None:
        self._label, self._stage = label, ""

    def report(self, stage: str, done: int, total: int) -> None:
        """A line when a stage begins."""
        del done, total
        if stage != self._stage:
            self._stage = stage
            click.echo(f"{self._label}: {stage}", err=True)

    def end(self) -> None:
        """Nothing is left to be said."""


class _Bar:
    def __init__(self, label: str) -> None:
        self._label = label
        self._now: tuple[str, int, int] = ("", 0, 0)
        self._bar: Any = None
        self._later = Timer(1, self._begin)
        self._later.daemon = True
        self._later.start()

    def _begin(self) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

        columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
        bar = Progress(*columns, console=Console(stderr=True), transient=True)
        bar.add_task(self._label, total=None)
        bar.start()
        self._bar = bar
        self.report(*self._now)

    def report(self, stage: str, done: int, total: int) -> None:
        """Where the work stands."""
        self._now = (stage, done, total)
        if self._bar is not None:
            text = f"{self._label}: {stage}" if stage else self._label
            self._bar.update(self._bar.task_ids[0], description=text, completed=done, total=total or None)

    def end(self) -> None:
        """Take it away."""
        self._later.cancel()
        self._later.join()
        if self._bar is not None:
            self._bar.stop()


def each(work: Callable[..., Any], calls: Sequence[tuple[Any, ...]], jobs: int) -> list[Any]:
    """Work on layouts, the first argument of each call: in turn, with a progress report as the last argument; or, with
    more than one job, several beside each other."""
    if jobs > 1 and len(calls) > 1:
        from interlock.proof.engines.pool import apart

        done = 0
        with progress("layouts") as report:

            def note(n: int) -> None:
                nonlocal done
                done += 1
                report(f"{done} of {len(calls)} done", done, len(calls))

            return apart(work, calls, jobs, note)
    results = []
    for c in calls:
        with progress(c[0]) as report:
            results.append(work(*c, report))
    return results


_COLOURS = {"PROVED": "green", "REFUTED": "red", "UNKNOWN": "yellow"}


def proof_body(p: Proved) -> dict[str, Any]:
    """A proof as data."""
    body: dict[str, Any] = {
        "file": p.checked.path,
        "ok": p.green,
        "diagnostics": renderers.as_json([*p.checked.diagnostics, *p.notes], p.checked.source.texts),
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
            "wall_seconds": round(p.seconds, 3),
            "kept": p.proof.kept,
        }
    return body


def show_proof(p: Proved, form: str, verbose: bool) -> None:
    """A proof for people."""
    sources = p.checked.source.texts
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
            count = number_of(c.places, "place") if c.places else "nothing to claim"
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
    elif p.text_equal and all(c.verdict == "PROVED" for c in p.proof.claims if c.places):
        verdict = click.style("CANNOT BE DRIVEN", fg="red")
    else:
        verdict = click.style("NOT SAFE", fg="red")
    routes = number_of(len(p.proof.witnesses), "route")
    click.echo(
        f"{p.checked.path}: {verdict}  {_claimed(p.proof.claims)}; {routes}, {ok} driven by a witness, "
        f"text {'=' if p.text_equal else 'differs from'} controller, "
        f"{'as an earlier run has proved it, ' if p.proof.kept else ''}{p.seconds:.1f} s"
    )


def _claimed(claims: Sequence[ClaimResult]) -> str:
    """What was claimed of this layout, at how many places, and how much of it is proved."""
    said = [c for c in claims if c.places]
    proved = sum(c.verdict == "PROVED" for c in said)
    places, silent = sum(c.places for c in said), len(claims) - len(said)
    found = "all proved" if proved == len(said) else f"{proved} of them proved everywhere"
    counted = f"{number_of(len(said), 'claim')} at {number_of(places, 'place')}, {found}"
    return (
        f"{counted}; {number_of(silent, 'claim')} {'has' if silent == 1 else 'have'} nothing to claim here"
        if silent
        else counted
    )


def number_of(n: int, of: str) -> str:
    """`1 route`, `2 routes`."""
    return f"{n} {of}" if n == 1 else f"{n} {of}s"
