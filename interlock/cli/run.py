"""`interlock run`: the proved runtime as a soft PLC against real inputs and outputs, or with a panel in a browser."""

from __future__ import annotations

import gc
import importlib.util
import json
import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from contextlib import closing, suppress
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from interlock.app.alarms import TRAIN, Watch
from interlock.app.answers import Answers
from interlock.app.check import Checked
from interlock.app.run import BadCommand, Operator, Ready, beyond_modbus, prepare, run
from interlock.cli.common import (
    end_as_by_ctrl_c,
    ended,
    ending,
    exit_code,
    format_option,
    progress,
    proof_body,
    show_proof,
)
from interlock.cli.heard import Heard
from interlock.cli.lines import Line, Lines, Reply
from interlock.cli.operator_place import answering, parsed
from interlock.dataclass import dataclass
from interlock.diag.extras import install
from interlock.dispatch.arbiter import Full
from interlock.field.alone import Alone, InUse, Lock, hold
from interlock.field.modbus import ModbusLink
from interlock.field.plc import Cycle, Link
from interlock.field.polling import Beside
from interlock.logic.cabinet import substations
from interlock.model.layout import Layout


@dataclass(frozen=True)
class _Place:
    """Where a substation is reached."""

    host: str
    port: int
    device: int


def _places(layout: Layout, given: tuple[str, ...]) -> tuple[dict[str, _Place], list[Lock]]:
    """Where each substation is, from what --modbus says, and the locks by which nobody else may write there until the
    command ends."""
    stations = tuple(s.name for s in substations(layout))
    places: dict[str, _Place] = {}
    for text in given:
        station, _, rest = text.rpartition("=")
        station = station or (stations[0] if len(stations) == 1 else "")
        host, _, tail = rest.rpartition(":")
        port, _, device = tail.partition("/")
        if station not in stations or not host or not port.isdecimal() or not (device or "1").isdecimal():
            raise click.UsageError(f"{text}: write SUBSTATION=HOST:PORT[/DEVICE]; substations: {', '.join(stations)}")
        if not (0 < int(port) < 65536 and int(device or 1) < 256):
            raise click.UsageError(f"{text}: a port is between 1 and 65535, a device between 0 and 255")
        if station in places:
            raise click.UsageError(f"{text}: --modbus says twice where {station} is")
        places[station] = _Place(host.strip("[]"), int(port), int(device or 1))
    missing = sorted(set(stations) - set(places))
    if missing:
        raise click.UsageError(f"--modbus is missing for {', '.join(missing)}")
    try:
        held = hold([f"{p.host}:{p.port}/{p.device}" for p in places.values()])
        for lock in held:
            click.get_current_context().call_on_close(lock.close)
    except InUse as error:
        raise click.UsageError(str(error)) from None
    return places, held


def _prepared(layout: str, modbus: tuple[str, ...]) -> tuple[Ready, dict[str, Link] | None]:
    """The layout, proved, and the links to its substations, whose addresses are looked at before; None without any."""
    places: dict[str, _Place] = {}
    held: list[Lock] = []

    def checked(found: Checked) -> None:
        if not modbus:
            return
        assert found.layout is not None
        found_places, locks = _places(found.layout, modbus)
        places.update(found_places)
        held.extend(locks)
        if why := beyond_modbus(found):
            raise click.UsageError(why)

    with progress(layout) as report:
        ready = prepare(layout, None, report, checked)
    if ready.allocation is None or not modbus:
        return ready, None
    a = ready.allocation
    return ready, {s: Alone(ModbusLink(a, s, p.host, p.port, p.device), held) for s, p in places.items()}


def _needs(module: str, what: str, extra: str) -> None:
    """An extra that has to be installed."""
    if importlib.util.find_spec(module) is None:
        raise click.UsageError(f"{what} needs the extra `{extra}`: {install(extra)}")


Say = Callable[[dict[str, Any]], None]
"""How an event is told: on a line of JSON, or for people."""


@dataclass(frozen=True)
class Clock:
    """The cycle time in milliseconds, and after how many cycles it is over."""

    cycle_ms: int
    cycles: int | None


def _place(modbus: tuple[str, ...], panel: bool, operator_modbus: str | None, requests: bool) -> tuple[str, int] | None:
    """The address of the operator's place on Modbus, if any; options that do not go together are an error."""
    if not modbus and not panel:
        raise click.UsageError("say --modbus SUBSTATION=HOST:PORT for each substation, or --panel")
    if modbus:
        _needs("pymodbus", "Modbus", "field")
    if requests and operator_modbus is None:
        raise click.UsageError("--operator-requests goes with --operator-modbus [HOST:]PORT")
    place = None if operator_modbus is None else parsed(operator_modbus)
    if place is not None:
        _needs("pymodbus", "Modbus", "field")
    return place


class _Typed:
    """Commands as they are typed or come over Modbus."""

    def __init__(self, ready: Ready, say: Say) -> None:
        assert ready.layout is not None and ready.controller is not None and ready.allocation is not None
        self._operator, self._say = Operator(ready), say
        self._watch, self._dt_ms = Watch(ready.layout, ready.controller, ready.allocation), 0
        self._answers = Answers(ready)
        self._stood: dict[str, str] = {}
        symbols = ready.controller.symbols
        self._stops = {"stop", *(f"cancel {g}" for g in symbols.cancellation.cancel)}
        self._stops |= {f"{n}=1" for n in (*symbols.cancellation.cancel.values(), *symbols.sections.blocked.values())}
        self._lines = Lines(lambda text: " ".join(text.split()) in self._stops)

    def listen(self) -> None:
        """Take what is typed, until there is no more."""
        with suppress(BrokenPipeError):  # the run ends with it
            for line in sys.stdin:
                self.take(line)

    def take(self, line: str) -> None:
        """Take a line that is typed."""
        if why := self._lines.put("", line):
            self._say({"refused": why})

    def asked(self, who: str, what: str, name: str, reply: Reply) -> None:
        """Take a request that came over Modbus."""
        self._lines.put(who, f"{what} {name}", reply)

    def ask(self, last: Cycle | None, dt_ms: int) -> Mapping[str, int]:
        """The inputs of the next cycle."""
        operator, say = self._operator, self._say
        self._dt_ms = dt_ms
        for line, why_not in self._lines.due():
            if line.text:
                self._do(line, why_not)
        found = operator.inputs(last, dt_ms)
        for gone in operator.withdrawn():
            say({"refused": f"{gone.name} is not asked for any more: {gone.why}"})
        for name in operator.presses.let_go():
            say({"let_go": name})
        for news in operator.news():
            say({"voyage": news})
        return found

    def _do(self, line: Line, why_not: str) -> None:
        """Carry out a line, or say why not."""
        say, taken = self._say, not why_not
        if line.who:
            say({"asked": line.text, "who": line.who})
        if why_not:
            say({"refused": f"{line.text}: {why_not}"})
        else:
            try:
                for route in self._operator.type(line.text):
                    say({"route": route, "automatic": False})
            except (BadCommand, Full) as error:
                taken = False
                say({"refused": str(error)})
            self._held(line.text)
        line.reply(taken)

    def _held(self, line: str) -> None:
        """Say what is pressed, or held, after a line that has set it."""
        name, sign, _ = line.partition("=")
        presses, name = self._operator.presses, name.strip()
        if sign and name in presses.pressed:
            value, seconds = presses.pressed[name].value, presses.press_ms(name) / 1000
            self._say({"pressed": name, "value": value, "for_s": seconds})
        elif sign or line == "free":
            self._say({"held": dict(sorted(self._operator.held.items()))})

    def begin(self) -> None:
        """Start as the text for a PLC does, with every section blocked, and say so."""
        if blocked := self._operator.block_all():
            self._say({"blocked": blocked})

    def after(self, cycle: Cycle) -> Iterable[str]:
        """The keys of the alarms that stand after a cycle; those that are new or over are said, and what has become of
        requests."""
        self._watch.after(cycle, self._dt_ms)
        stand = {key: text for key, (text, _) in {**self._watch.past, **self._watch.causes}.items()}
        for key in [k for k in stand if k not in self._stood]:
            self._say({"alarm": stand[key], "stands": True})
        for key in [k for k in self._stood if k not in stand]:
            self._say({"alarm": self._stood[key], "stands": False})
        self._stood = stand
        for answer in self._answers.after(cycle, self._dt_ms):
            self._say(answer)
        return (*stand, *(f"{TRAIN} {n}" for n in self._operator.numbers.alarms))


def _run(
    ready: Ready,
    links: Mapping[str, Link],
    clock: Clock,
    place: tuple[str, int] | None,
    requests: bool,
    say: Heard,
) -> None:
    """Run on real inputs and outputs until it is over or somebody ends it, and say what changes."""
    typed = _Typed(ready, say)
    typed.begin()
    gc.enable()  # off in the short-lived commands; this one runs on
    threading.Thread(target=typed.listen, daemon=True).start()
    end_as_by_ctrl_c()
    before: dict[str, bool] = {}
    said: tuple[object, ...] = ()
    longest, left, ms = 0.0, dict[str, str](), clock.cycle_ms
    try:
        with (
            answering(ready, place, typed.asked if requests else None) as server,
            closing(run(ready, links, ms, clock.cycles, typed.ask, poll=Beside(), left=left.update)) as cycles_run,
        ):
            for result, took in cycles_run:
                standing = typed.after(result)
                if server is not None:
                    server.publish(result, standing)
                longest = max(longest, took)
                if (result.valid, result.lost) != said:
                    said = (result.valid, result.lost)
                    say({"inputs": "valid" if result.valid else "NOT VALID", "lost": list(result.lost)})
                for name, value in result.outputs.items():
                    if before.get(name) is not value and (before or value):
                        say({"output": name, "value": int(value)})
                before = dict(result.outputs)
    except KeyboardInterrupt:
        pass
    except BaseException:
        say.close()
        raise
    say.close(ending(left, longest, ms))


@click.command("run")
@click.argument("layout", type=click.Path())
@click.option("--modbus", multiple=True, help="SUBSTATION=HOST:PORT[/DEVICE], one for each substation.")
@click.option("--panel", is_flag=True, help="The mimic panel in a browser; without --modbus on a simulated railway.")
@click.option("--host", default="127.0.0.1", show_default=True, help="With --panel: the address on which it listens.")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8420,
    show_default=True,
    help="With --panel: the port; 0 takes any that is free.",
)
@click.option(
    "--token", envvar="INTERLOCK_TOKEN", default="", help="With --panel: the token that lets a browser operate."
)
@click.option(
    "--look-token",
    envvar="INTERLOCK_LOOK_TOKEN",
    default="",
    help="With --panel: the token that lets a browser look only.",
)
@click.option(
    "--record",
    type=click.Path(path_type=Path, dir_okay=False),
    help="With --panel: the log in which everything is recorded, continued if it exists; else NAME-DATE-TIME.log.",
)
@click.option(
    "--operator-modbus",
    "operator_modbus",
    metavar="[HOST:]PORT",
    help="The operator's place on Modbus TCP: words of routes, outputs, alarms; without a host on this computer only.",
)
@click.option(
    "--operator-requests",
    "requests",
    is_flag=True,
    help="With --operator-modbus: requests may be written, too, by whoever reaches it.",
)
@click.option(
    "--cycle", "cycle_ms", type=click.IntRange(10, 1000), default=100, show_default=True, help="Cycle time in ms."
)
@click.option("--cycles", type=click.IntRange(1), default=None, help="Stop after this many cycles (otherwise: Ctrl-C).")
@format_option
def command(
    layout: str,
    modbus: tuple[str, ...],
    panel: bool,
    host: str,
    port: int,
    token: str,
    look_token: str,
    record: Path | None,
    operator_modbus: str | None,
    requests: bool,
    cycle_ms: int,
    cycles: int | None,
    form: str,
) -> None:
    """Prove LAYOUT, then run its runtime on Modbus TCP, or with --panel on a simulated railway.

    Without --panel every section is blocked at first, as in the text for a PLC: BLK_q1=0 takes the block off section
    q1, free all.  With it only what a record that --record goes on with has as blocked.
    A line of input is a command for one cycle, a line a cycle: set ROUTE, swing SIGNAL, cancel SIGNAL, release, or
    stop, which cancels every route and gives up every voyage.  To stop or to cancel waits for no other line, and is
    never too late; what else is older than five seconds is not done.
    Voyage NAME opens the routes of a voyage one after the other, each when its train stands before it, until it is done
    or voyage NAME end gives it up; voyage 12:W>E does so for locomotive 12 from W to E.
    From then on numbers step with the sections that are reported occupied, and what does not fit is an alarm; nothing
    is asked for its train until train 12 q4 says where it stands.
    VARIABLE=VALUE sets switches (blocks, automatic working, a crossing or device closed by hand), which stay until
    they are set otherwise, and presses buttons (REL_q1=1), for two seconds; a move of points by hand for their
    supervision time, the special manual change of direction for its delay and two seconds at most.  Every change of an
    output is printed.  A standard computer is no safety PLC: for trials, not for a railway.
    """
    place = _place(modbus, panel, operator_modbus, requests)
    _only_there(panel)
    sock = None
    if panel:
        for module in ("starlette", "uvicorn", "websockets"):
            _needs(module, "the panel", "panel")
        from interlock.cli.panel import opened

        sock, tokens = opened(host, port, token, look_token)
    ready, links = _prepared(layout, modbus)
    say = _json if form == "json" else _text
    if form == "json":
        click.echo(say(proof_body(ready.proved)))
    else:
        show_proof(ready.proved, form, False)
    if ready.allocation is None:
        sys.exit(exit_code([ready.proved]))
    if sock is not None:
        from interlock.cli.panel import run_panel

        run_panel(ready, links, cycle_ms, sock, tokens, record, form, place, requests)
        return
    assert links is not None
    _run(ready, links, Clock(cycle_ms, cycles), place, requests, Heard(say))


def _only_there(panel: bool) -> None:
    """An option that the other kind of run has is refused: nobody shall believe in a record that is not written."""
    context = click.get_current_context()
    for name in ("cycles",) if panel else ("host", "port", "record", "token", "look_token"):
        if context.get_parameter_source(name) is ParameterSource.COMMANDLINE:
            raise click.UsageError(f"--{name.replace('_', '-')} goes {'without' if panel else 'with'} --panel")


def _json(event: dict[str, Any]) -> str:
    """One event on one line."""
    return json.dumps(event, ensure_ascii=False)


def _text(event: dict[str, Any]) -> str:
    """The same for people."""
    match event:
        case {"route": route, "refused": text, "rule": rule}:
            return f"  route {route} is refused: {text} ({rule})"
        case {"swing": signal_, "refused": text}:
            return f"  swing {signal_} is refused: {text}"
        case {"route": route, "at_stop": waits}:
            return f"  route {route} is set, its signal at stop: {'; '.join(waits)}"
        case {"route": route, "automatic": _}:
            return f"  route {route} no longer works automatically"
        case {"refused": text} | {"voyage": text}:
            return f"  {text}"
        case {"asked": line, "who": who}:
            return f"  {who} asks: {line}"
        case {"alarm": text, "stands": stands}:
            return f"  {'ALARM' if stands else 'over'}: {text}"
        case {"held": held}:
            return f"  held: {', '.join(f'{n}={v}' for n, v in held.items()) or 'nothing'}"
        case {"pressed": name, "value": value, "for_s": seconds}:
            return f"  {name} = {value} for {seconds:g} s at most"
        case {"let_go": name}:
            return f"  {name} = 0 again"
        case {"blocked": blocked}:
            first = next(iter(blocked.values()))
            return f"blocked: {', '.join(blocked)}; {first}=0 takes the block off one, free off all"
        case {"inputs": state, "lost": lost}:
            return f"inputs {state}{''.join(f'; {x}' for x in lost)}"
        case {"output": name, "value": value}:
            return f"  {name} = {value}"
        case {"stopped": _}:
            return ended(event)
        case {"not_told": number}:
            return f"  {number} lines were not written here: nobody had read what came before"
    return ""
