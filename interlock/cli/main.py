"""The entry point: picks a verb, and turns what goes wrong inside into exit code 70 instead of a traceback.

Exit codes: 0 fine, 1 findings or refuted, 2 usage, 3 could not be proved (or memory or open files ran out), 70 internal
error, 130 interrupted, 141 the reader has closed the pipe.
"""

from __future__ import annotations

import gc
import importlib
import io
import json
import os
import sys
from itertools import pairwise
from typing import Any, NoReturn

import click

from interlock import __version__
from interlock.cli.limits import limit_of

INTERRUPTED = 130  # 128 and the number of the signal, as shells have it
UNREAD = 141  # the same, where whoever reads the output has closed it: `interlock check ... | head -1`

DEPTH = 10_000
"""How deep calls may be: what is in rear of a signal, or beyond it, is followed section by section."""

TOO_LONG = (
    "more sections follow on one another here without a main signal, or more is nested, than interlock can follow; "
    "put a main signal between them"
)

VERBS = {
    "init": "Write a starter layout, or a large one for trials.",
    "check": "Report every problem in the layouts (fast, without proof).",
    "compile": "Derive the tables, prove the controller, write all outputs.",
    "pin": "Record the channel allocation of a layout's cabinets, so that addresses stay.",
    "prove": "Prove every safety claim for every possible train movement.",
    "availability": "Run every two compatible routes together, and show that neither hinders the other.",
    "commission": "Write the tests for commissioning, each tried on the emitted runtime.",
    "certify": "Write the proof as files that can be checked independently.",
    "verify": "Check certificates, with code that shares nothing with the prover.",
    "run": "Run the proved runtime, on Modbus TCP or with a panel in the browser.",
    "export": "Write the whole system as a circuit for other proof engines.",
    "draw": "Draw the track plan as SVG.",
    "play": "Make a page that replays a trace or a record.",
    "why": "Print the reason for each cell of a route's row.",
    "diff": "Print what has changed in the interlocking table between two layouts.",
    "dispatch": "Carry out train commands on the controller and its plant; show plans and deadlocks.",
    "simulate": "Simulate shifts of a fleet on the emitted runtime.",
    "record": "Check event logs, convert them to Parquet, query them with SQL.",
    "blocks": "Compute block section lengths from the traffic, and compare the layout's own.",
    "schedule": "Plan the trains of a DISPLIB dispatching problem.",
    "explain": "Explain a diagnostic, rule, claim, function, assumption or principle.",
    "mutate": "Change table, controller and texts on purpose, one change at a time; see what notices.",
    "schema": "Print the JSON Schema of the layout language, of pins, or of table.json.",
}


class _Unread(Exception):
    """Nobody reads on.  (By itself click makes an exit code 1 of that, as of findings.)"""


class _Verbs(click.Group):
    """Loads a verb's module only when it is called, so that `--help` is quick."""

    def make_context(self, *args: Any, **more: Any) -> click.Context:
        try:
            return super().make_context(*args, **more)
        except BrokenPipeError:
            raise _Unread from None

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            raise _Unread from None

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(VERBS)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(VERBS.items()))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in VERBS:
            return None
        module = importlib.import_module(f"interlock.cli.{cmd_name}")
        command = module.command
        assert isinstance(command, click.Command)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] not in VERBS and not args[0].startswith("-"):
            import difflib

            near = difflib.get_close_matches(args[0], VERBS, n=1)
            hint = f" Did you mean {near[0]}?" if near else ""
            if args[0].endswith((".yaml", ".yml")):
                hint = f" Say what to do with it, for instance: interlock compile {args[0]}"
            ctx.fail(f"No such command '{args[0]}'.{hint}")
        return super().resolve_command(ctx, args)


@click.group(cls=_Verbs, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="interlock")
@click.pass_context
def cli(ctx: click.Context) -> None:
    """From a track layout to a proved interlocking table, Structured Text and a Python runtime.

    Start with: interlock init -o NAME.yaml

    Its language: interlock explain language, or of one key: interlock explain overlaps
    """
    if os.environ.get("NO_COLOR"):
        ctx.color = False


def main() -> None:
    """Run the command line."""
    try:
        _run()
    except (_Unread, BrokenPipeError):
        os._exit(UNREAD)


def _run() -> None:
    _closed_streams()
    sys.setrecursionlimit(DEPTH)
    gc.disable()  # what a command builds lives to its end, which is soon: the collector would only walk it
    try:
        code = cli(standalone_mode=False)
    except SystemExit as end:
        _leave(end.code)
    except (click.Abort, KeyboardInterrupt):
        _interrupted()
    except click.ClickException as error:
        _say(error)
        _leave(error.exit_code)
    except (_Unread, BrokenPipeError):
        raise
    except Exception as error:
        if (limit := limit_of(error)) is not None:
            _failed(limit[0])
            _leave(limit[1])
        if isinstance(error, RecursionError):
            _failed(TOO_LONG)
            _leave(1)
        if "keyboard interrupt" in str(error):  # what a solver says that was interrupted
            _interrupted()
        if os.environ.get("INTERLOCK_DEBUG"):
            raise
        _failed(
            f"{type(error).__name__}: {error}\n"
            "This is a defect of interlock, not of your layout. Please report it with the layout; "
            "INTERLOCK_DEBUG=1 shows where it happened.",
            "internal error",
        )
        sys.exit(70)
    else:
        _leave(code if isinstance(code, int) else 0)


def _closed_streams() -> None:
    """A stream that the caller has closed, as a service may, is one that nobody reads; what finds no room on the
    standard error is dropped."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), mode, encoding="utf-8"))
    told = sys.stderr
    if told is sys.__stderr__ and told is not None:
        lossy = io.BufferedWriter(_Lossy(told.fileno(), "w", closefd=False))
        sys.stderr = io.TextIOWrapper(lossy, told.encoding, told.errors, line_buffering=True)


class _Lossy(io.FileIO):
    """Where what finds no room is dropped: what is being done is told beside the work, and does not end it."""

    def write(self, data: Any, /) -> int:
        try:
            return super().write(data) or len(data)
        except BrokenPipeError:
            raise
        except OSError:
            return len(data)


def _json() -> bool:
    """Whether the command line asks for JSON, whatever else is wrong with it."""
    args = sys.argv[1:]
    return "--format=json" in args or any(a == "--format" and b == "json" for a, b in pairwise(args))


def _say(error: click.ClickException) -> None:
    """What is wrong with the command line."""
    if not _json():
        error.show()
        return
    context = error.ctx if isinstance(error, click.UsageError) else None
    _put(error.format_message(), f"{context.command_path if context else 'interlock'} --help")


def _failed(text: str, kind: str = "error") -> None:
    """Why nothing came of it."""
    if _json():
        try:
            _put(text, None)
            sys.stdout.flush()
            return
        except OSError:  # nor does this fit
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    click.echo(f"{kind}: {text}", err=True)


def _put(error: str, fix: str | None) -> None:
    body = {"ok": False, "error": error, "code": None, "fix": fix}
    click.echo(json.dumps(body, indent=2, ensure_ascii=False))


def _interrupted() -> NoReturn:
    click.echo("interrupted", err=True)
    _leave(INTERRUPTED)


def _leave(code: int | str | None) -> NoReturn:
    """End at once: to take apart what a large layout has built would take seconds."""
    if isinstance(code, str):
        click.echo(code, err=True)
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except BrokenPipeError:
        raise
    except OSError:  # there is no room: what was said did not arrive
        os._exit(1)
    os._exit(code if isinstance(code, int) else int(code is not None))


if __name__ == "__main__":
    main()
