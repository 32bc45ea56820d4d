"""`interlock simulate`: shifts of a fleet on the emitted runtime."""

from __future__ import annotations

import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NoReturn

import click

from interlock.app.horizon import Compared, compared
from interlock.app.own import write_whole
from interlock.app.setting import Setting, prepare
from interlock.app.shift import StaysLocked
from interlock.app.shifts import NoCluster, executing, many, mean
from interlock.app.turns import NoHorizon
from interlock.app.worked import Options, Worked
from interlock.cli.common import (
    FINDINGS,
    OK,
    Amount,
    failed,
    force_option,
    format_option,
    jobs_option,
    look_ahead_option,
    progress,
    put_json,
    show,
    told,
    took,
    without_rule_option,
)
from interlock.diag import Diagnostic, Sink
from interlock.diag.render import as_json
from interlock.dispatch.assign import Assigning
from interlock.simulate.mishaps import TRIAL, Rates


@click.command("simulate")
@click.argument("layout")
@click.option(
    "--dispatch", "file", type=click.Path(), help="The dispatch file; by default LAYOUT with the ending .dispatch."
)
@click.option("--shifts", type=click.IntRange(1, 100_000), default=1, show_default=True, help="Number of shifts.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Seed of the first shift.")
@click.option("--hours", type=Amount(0, 240, min_open=True), help="Hours of a shift, instead of the file's.")
@click.option("--assign", type=click.Choice([str(a) for a in Assigning]), default="in_turn", show_default=True,
              help="Which order an idle train takes.")  # fmt: skip
@look_ahead_option
@without_rule_option
@click.option(
    "--faults", is_flag=True, help="Let detectors, points, the link and wagons fail, far more often than in service."
)
@click.option("--steady", is_flag=True, help="Let work take exactly the minutes in the file.")
@click.option("--planned", is_flag=True, help="Let a plan of the next hour and a half order the requests.")
@click.option("--optimum", type=Amount(0, min_open=True), metavar="SECONDS",
              help="Plan the same hours for this many seconds, and compare (with --steady).")  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path, file_okay=False), help="A folder for the records.")
@click.option("--dask", metavar="ADDRESS", help="A Dask cluster that does the work, instead of processes here.")
@jobs_option
@force_option
@format_option
def command(
    layout: str,
    file: str | None,
    shifts: int,
    seed: int,
    hours: float | None,
    assign: str,
    look_ahead: int,
    without_rule: bool,
    faults: bool,
    steady: bool,
    planned: bool,
    optimum: float | None,
    output: Path | None,
    dask: str | None,
    jobs: int,
    force: bool,
    form: str,
) -> None:
    """Run shifts of the fleet in the dispatch file of LAYOUT on the runtime as it is emitted, and count what comes out.

    The same seed gives the same record, byte for byte.  Ends with 1 if trains stood for ever, came to a wrong place, or
    came to harm.
    """
    if optimum is not None and not steady:
        raise click.UsageError("--optimum compares with work of fixed length: it needs --steady")
    _, problems, setting, texts = prepare(layout, file)
    if setting is None:
        show(problems, dict(texts), form)
        sys.exit(FINDINGS)
    rates, kept = TRIAL if faults else Rates(), output is not None
    options = Options(hours, Assigning(assign), not without_rule, look_ahead, rates, kept, steady, planned)
    began = time.monotonic()
    seeds = range(seed, seed + shifts)

    try:
        with progress("shifts") as report, executing(jobs, dask) as executor:
            done = many(
                layout, file, seeds, options, executor, lambda k: report(f"{10 * k // shifts * 10} % done", k, shifts)
            )
        files = _write(output, setting, done, force) if output is not None else []
        best, why = (None, None) if optimum is None else _best(setting, hours, optimum, jobs)
    except StaysLocked as error:
        _not_simulated(setting, str(error), texts, form)
    except NoCluster as error:
        failed(str(error), form)
        sys.exit(FINDINGS)
    except OSError as error:
        failed(told(error, Path(error.filename or str(output))), form)
        sys.exit(FINDINGS)
    if form == "json":
        body = _body(done, files) | ({} if best is None else {"planned": best.planned, "most": best.most})
        put_json(body if why is None else body | {"ok": False, "diagnostics": as_json([why], texts)})
    else:
        _print(setting, done, files, took(began))
        if best is not None:
            _compare(done, best)
        if why is not None:
            show([why], dict(texts), form)
    sys.exit(FINDINGS if why is not None or any(any(w.wrong.counts().values()) for w in done) else OK)


def _not_simulated(setting: Setting, text: str, texts: Mapping[str, str], form: str) -> NoReturn:
    """Why there is no shift."""
    sink, fix = Sink(), "what nothing reports clear stays locked: leave it out in a copy of the layout"
    sink.add("IL6012", text, setting.orders.root.span, f"{fix}, or use `interlock dispatch`")
    show(sink.diagnostics, dict(texts), form)
    sys.exit(FINDINGS)


def _best(
    setting: Setting, hours: float | None, seconds: float, jobs: int
) -> tuple[Compared | None, Diagnostic | None]:
    """What a plan brings out; or why there is nothing that shifts can be compared with."""
    try:
        return compared(setting, hours or setting.orders.file.shift_h, seconds, jobs), None
    except NoHorizon as error:
        sink, fix = Sink(), "leave out `--optimum`; the shifts themselves are run all the same"
        text = f"`--optimum` makes no plan of this: {error}"
        sink.add("IL6012", text, setting.orders.at(*error.at, key=True), fix)
        return None, sink.diagnostics[0]


def _compare(done: Sequence[Worked], best: Compared) -> None:
    """How near the shifts come to what can be brought out at all."""
    m = mean([w.trains for w in done]).value
    ratio = f"{m / best.planned:.2f} of it" if best.planned else "nothing to compare with"
    most = "no plan has more" if best.most == best.planned else f"none has more than {best.most} ({m / best.most:.2f})"
    click.echo(f"  a plan without signals and drivers brings out {best.planned}: {ratio}; {most}")


def _write(output: Path, setting: Setting, done: Sequence[Worked], force: bool) -> list[str]:
    """The record of each shift.  Raises `OSError`, for a file that is there and says something else, too."""
    output.mkdir(parents=True, exist_ok=True)
    files = []
    for w in done:
        target = output / f"{setting.layout.name}-{w.seed}.log"
        if target.exists() and not force and target.read_bytes() != w.log:
            raise FileExistsError(17, "there is another record; --force overwrites it", str(target))
        write_whole(target, w.log)
        files.append(str(target))
    return files


def _body(done: Sequence[Worked], files: Sequence[str]) -> dict[str, object]:
    m = mean([w.trains for w in done])
    return {
        "ok": not any(any(w.wrong.counts().values()) for w in done),
        "trains_a_shift": m.value,
        "confidence_95": m.half if m.count > 1 else None,
        "shifts": [
            {
                "seed": w.seed,
                "trains": w.trains,
                "tipped": w.tipped,
                "late": w.late,
                "tonnes": w.tonnes,
                "brought": w.brought,
                "scans": w.scans,
                "movements": w.movements,
                "held_back": w.delays.refused,
                "alarms": len(w.alarms),
                "plans": w.planning.made,
                "by_rules": w.planning.by_rules,
                "chain": w.chain,
                "what_was_wrong": w.wrong.texts,
                **{k.replace(" ", "_"): v for k, v in w.wrong.counts().items()},
            }
            for w in done
        ],
        "files": list(files),
    }


def _print(setting: Setting, done: Sequence[Worked], files: Sequence[str], took: str) -> None:
    fleet = len(setting.orders.file.fleet)
    many_ = f"{len(done)} shifts, seeds {done[0].seed} to {done[-1].seed}" if len(done) > 1 else f"seed {done[0].seed}"
    click.echo(f"{setting.layout.name}: {fleet} trains, {many_}")
    m = mean([w.trains for w in done])
    sure = f" (95 % confidence interval of the mean {m.least:.2f} to {m.value + m.half:.2f})"
    click.echo(f"  trains tipped a shift: {m.value:.4g}{sure if m.count > 1 else ''}")
    for ore in sorted({x for w in done for x in w.tonnes}):
        t = mean([w.tonnes.get(ore, 0.0) for w in done])
        spread = f" ± {t.half:.4g}" if t.value >= t.half else f" (0 to {t.value + t.half:.4g})"
        click.echo(f"  tonnes of {ore} a shift: {t.value:.6g}" + (spread if t.count > 1 else ""))
    for d in setting.derived:
        x = mean([w.tipped.get(d.name, 0) for w in done])
        late = mean([w.late.get(d.name, 0) for w in done]).value
        many_late = f"{late:.4g}" if late else "none"
        after = "" if d.order.by is None else f", {many_late} of them after {d.order.by:g} h"
        many = f"{x.value:.4g} of {d.trains} trains"
        if d.order.tonnes is not None:
            brought = mean([w.brought.get(d.name, 0.0) for w in done]).value
            many = f"{brought:.6g} of {d.order.tonnes:g} t, in {x.value:.4g} trains"
        click.echo(f"  order {d.name}: {many} from {d.order.from_}{after}")
    for name in done[0].wrong.counts():
        count = sum(w.wrong.counts()[name] for w in done)
        click.echo(f"  {name}: {click.style(str(count), fg='red' if count else 'green')}")
    for w in done:
        for text in w.wrong.texts[:5]:
            click.echo(f"    seed {w.seed}: {text}")
    click.echo(
        f"  {sum(w.scans for w in done):,} scans, {sum(w.movements for w in done):,} signals passed, "
        f"{sum(w.delays.refused for w in done):,} requests held back, "
        f"{sum(len(w.alarms) for w in done):,} alarms; {took}"
    )
    if plans := sum(w.planning.made for w in done):
        click.echo(f"  {plans:,} plans made; given up for the rules {sum(w.planning.by_rules for w in done)} times")
    if len(done) == 1:
        click.echo(f"  chain of the record: {done[0].chain}")
    if files:
        click.echo(f"  written: {files[0]}" + (f" and {len(files) - 1} more" if len(files) > 1 else ""))
