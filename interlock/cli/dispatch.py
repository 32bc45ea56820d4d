"""`interlock dispatch`: commands, completion plans, deadlocks."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import click

from interlock.app.dispatch import Dispatched, dispatch, replay_file
from interlock.app.own import write_whole
from interlock.app.replay import BadPlan, from_text, to_text
from interlock.cli.common import (
    FINDINGS,
    NOT_PROVED,
    OK,
    Amount,
    failed,
    force_option,
    format_option,
    look_ahead_option,
    number_of,
    progress,
    put_json,
    show,
    told,
    without_rule_option,
)
from interlock.diag import render
from interlock.dispatch.language import beside
from interlock.dispatch.plan.search import Verdict
from interlock.dispatch.policy import Policy

_CUT = re.compile(r"[^:>]+:[^:>]+")
"""A command whose destination the shell has taken for the name of a file: `12:W>E` without quotes arrives as `12:W`."""
POLICIES = [str(p) for p in Policy]


@click.command("dispatch")
@click.argument("layout")
@click.argument("commands", nargs=-1, metavar="[COMMAND]...")
@click.option("--length", type=Amount(1, 2000), default=60.0, show_default=True, help="Length of each train in metres.")
@click.option("--timings", type=click.IntRange(0, 10_000), default=0, help="Run the commands this many times.")
@click.option(
    "--gap", type=click.IntRange(1, 1000), default=5, show_default=True, help="Scans between one timing and the next."
)
@look_ahead_option
@click.option("--policy", type=click.Choice(POLICIES), help="Who goes first on a single line that two voyages share.")
@click.option("--explore", "exploring", is_flag=True, help="Explore every state; tell the shortest deadlock.")
@without_rule_option
@click.option(
    "--failed",
    "failing",
    multiple=True,
    metavar="MACHINE",
    help="Plan with points that are not detected: P1, or stay: P1:N.",
)
@click.option("--occupied", multiple=True, metavar="SECTION", help="Plan with a section that is reported occupied.")
@click.option("--plan", type=click.Path(dir_okay=False), help="Write the completion plan to this file.")
@click.option("--orders", type=click.Path(), help="The dispatch file; by default LAYOUT with the ending .dispatch.")
@click.option("--replay", type=click.Path(dir_okay=False), help="Replay this plan file instead.")
@force_option
@format_option
def command(
    layout: str,
    commands: tuple[str, ...],
    length: float,
    timings: int,
    gap: int,
    look_ahead: int,
    policy: str | None,
    exploring: bool,
    without_rule: bool,
    failing: tuple[str, ...],
    occupied: tuple[str, ...],
    plan: str | None,
    orders: str | None,
    replay: str | None,
    force: bool,
    form: str,
) -> None:
    """Carry out commands on the controller with its plant; without any, the orders of the dispatch file.

    A COMMAND is the name of a voyage, or a number with origin and destinations: 12:W>E, 12:W>E+q4 (over q4),
    12:W>s8_xc3>OUT (there and back), 12:q9/X6>W (from where it stands before X6).

    Put a COMMAND in quotes, '12:W>E': a shell takes > for itself, and writes what is shown into a file E.
    """
    _refuse_cut(commands)
    if replay is not None:
        sys.exit(_replay(layout, replay, form))
    if (failing or occupied) and (timings or exploring):
        raise click.UsageError("with --failed and --occupied a plan is made, and nothing is run or explored")
    with progress(layout) as report:
        report("planning", 0, 0)
        found = dispatch(
            layout,
            commands,
            length_m=length,
            timings=timings,
            gap=gap,
            rule=not without_rule,
            exploring=exploring,
            look_ahead=look_ahead,
            file=orders,
            policy=policy,
            failed=failing,
            occupied=occupied,
        )
    written = plan if found.plan is not None else None
    if plan is not None and found.plan is not None:
        _write_plan(to_text(found.plan), Path(plan), [Path(layout), Path(orders or beside(layout))], force, form)
    if form == "json":
        put_json(_body(found) | {"written": written})
    else:
        _print(found, form)
        if written is not None:
            click.echo(f"written: {written}")
    sys.exit(_code(found))


def _refuse_cut(commands: tuple[str, ...]) -> None:
    """A command without a destination is told on the standard error: what goes to the other one is in that file."""
    cut = next((c for c in commands if _CUT.fullmatch(c)), None)
    if cut is not None:
        raise click.UsageError(
            f"{cut} names no destination.  Put the command in quotes, '{cut}>DESTINATION'.  Where it had one without "
            "them, the shell has taken the > for itself, and has written this run's results into a file of that name"
        )


def _write_plan(text: str, target: Path, read: list[Path], force: bool, form: str) -> None:
    """The plan into its file, which is none of those that were read, and no other one's."""
    try:
        if target.exists() and any(f.exists() and target.samefile(f) for f in read):
            failed(f"{target} is what is read: choose another file with --plan", form)
            sys.exit(FINDINGS)
        if target.exists() and not force and not _is_plan(target):
            failed(f"{target} exists and is no completion plan; --force overwrites it", form)
            sys.exit(FINDINGS)
        write_whole(target, text.encode())
    except OSError as error:
        failed(told(error, target), form)
        sys.exit(FINDINGS)


def _is_plan(file: Path) -> bool:
    try:
        from_text(file.read_text("utf-8"))
    except (BadPlan, UnicodeDecodeError):
        return False
    return True


def _code(found: Dispatched) -> int:
    if not found.ok or found.answer is None or found.timings.stuck or (found.replayed and found.replayed.wrong):
        return FINDINGS
    if any(o.troubles for o in found.timings.outcomes) or found.answer.verdict is Verdict.NONE:
        return FINDINGS
    return NOT_PROVED if found.answer.verdict is Verdict.UNKNOWN else OK


def _replay(layout: str, plan: str, form: str) -> int:
    checked, problems, done = replay_file(layout, plan)
    if form == "json":
        body = None if done is None else {"wrong": done.wrong, "grant_scans": done.grant, "scans": done.scans}
        told_ = render.as_json(list(problems), checked.source.texts)
        ok = done is not None and done.wrong is None
        put_json({"file": checked.path, "ok": ok, "diagnostics": told_, "replayed": body})
    elif done is None:
        show(problems, checked.source.texts, form)
    elif done.wrong:
        click.echo(f"{plan}: fails on the controller: {done.wrong}")
    else:
        click.echo(f"{plan}: replayed in {done.scans} scans; each route granted within {done.grant} scans")
    return OK if done is not None and done.wrong is None else FINDINGS


def _body(found: Dispatched) -> dict[str, object]:
    x, r = found.explored, found.replayed
    stuck = next((o.stuck for o in found.timings.outcomes if o.stuck), {})
    return {
        "file": found.checked.path,
        "ok": _code(found) == OK,
        "diagnostics": render.as_json(list(found.diagnostics), {**found.checked.source.texts, **found.texts}),
        "orders": [
            {"name": d.name, "trains": d.trains, "from": d.order.from_, "to": d.order.to} for d in found.given.derived
        ],
        "orders_left": list(found.given.left),
        "verdict": None if found.answer is None else str(found.answer.verdict),
        "plan": None if found.plan is None else [list(m) for m in found.plan.moves],
        "replayed": None
        if r is None
        else {"wrong": r.wrong, "grant_scans": r.grant, "open_scans": r.opened, "scans": r.scans},
        "in_the_way": [*found.in_the_way.faults, *found.in_the_way.blocked],
        "caught": list(found.caught),
        "others": str(found.others) if found.caught else None,
        "explored": None
        if x is None
        else {
            "states": x.states,
            "unsafe": len(x.unsafe),
            "deadlocks": x.standing,
            "deadlocked_states": len(x.deadlocks),
            "moves_between_safe_states": x.safe_moves,
            "moves_held_back": x.refused_moves,
        },
        "story": list(found.deadlock.story) if found.deadlock is not None else [],
        "shown": found.deadlock.shown if found.deadlock is not None else None,
        "timings": len(found.timings.outcomes),
        "stuck": found.timings.stuck,
        "stuck_because": dict(stuck),
    }


def _print(found: Dispatched, form: str) -> None:
    if not found.ok or found.answer is None:
        show(found.diagnostics, {**found.checked.source.texts, **found.texts}, form)
        if found.answer is None:
            return
    for d in found.given.derived:
        ways = max(len(j.steps) for j in d.journeys.values())
        click.echo(f"order {d.name}: {d.trains} trains from {d.order.from_} to {d.order.to}, {ways} places on the way")
    if found.given.left:
        click.echo(f"not in the plan, in which each train has one order: {', '.join(found.given.left)}")
    said = str(found.answer.verdict) if found.answer else ""
    if found.plan is not None and found.replayed is not None:
        click.echo(f"{click.style(said, fg='green')}  {number_of(len(found.plan.moves), 'route')}:")
        for train, route in found.plan.moves:
            click.echo(f"  {train:10} {route}")
        r = found.replayed
        held = f"fails: {r.wrong}" if r.wrong else f"each granted within {r.grant} scans, open within {r.opened} more"
        where = ", where nothing has failed" if found.in_the_way.faults else ""
        click.echo(f"replayed on the controller with its plant{where}: {held}")
    elif said == Verdict.NONE:
        _none(found)
    else:
        click.echo(f"{click.style(said, fg='yellow')}  whether a plan exists was not found out")
    x = found.explored
    if x is not None:
        click.echo(
            f"states {x.states} (where each train stands, and by which route it came there), unsafe {len(x.unsafe)}; "
            f"deadlocks {x.standing} (by where the trains stand)"
        )
        click.echo(
            f"moves between safe states {x.safe_moves}, none of them held back; "
            f"moves into unsafe states {x.refused_moves}, all held back"
        )
        if found.deadlock is not None and found.deadlock.story:
            click.echo("the shortest deadlock without the rule:")
            for n, line in enumerate(found.deadlock.story, 1):
                click.echo(f"  {n}. {line}")
            click.echo(f"  {found.deadlock.shown}")
    if found.timings.outcomes:
        rule = "with the rule" if found.timings.rule else "without the rule"
        click.echo(f"{rule}: {found.timings.stuck} of {len(found.timings.outcomes)} timings stand for ever")
        stuck = next((o for o in found.timings.outcomes if o.stuck), None)
        for train, why in (stuck.stuck if stuck else {}).items():
            click.echo(f"  {train}: {why}")


def _none(found: Dispatched) -> None:
    """Who is caught, what becomes of the others, and on what this rests."""
    names = " and ".join(found.caught) + (" is caught" if len(found.caught) == 1 else " are caught")
    things = [*found.in_the_way.faults, *(f"{s} (blocked)" for s in found.in_the_way.blocked)]
    why = f", with {', '.join(things)} in the way" if things else ""
    click.echo(f"{click.style('NONE', fg='red')}  no plan exists, shown by exhaustive search: {names}{why}")
    if len(found.caught) < len(found.errands):
        can = "can all go on" if found.others is Verdict.PLAN else "UNKNOWN: whether they can go on was not found out"
        click.echo(f"the others: {can}")
    click.echo(
        "assumed: every train stands at its origin already, from outside in the section before its boundary; "
        "none comes back to where it was"
    )
