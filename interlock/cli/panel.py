"""`interlock run --panel`: where the panel listens, who may come, and how it ends."""

from __future__ import annotations

import gc
import ipaddress
import json
import secrets
import socket
import sys
from collections.abc import Mapping
from datetime import datetime
from pathlib import Path

import click

from interlock.app.run import Ready
from interlock.cli.common import end_as_by_ctrl_c, ended, ending, told
from interlock.cli.operator_place import answering
from interlock.field.alone import InUse
from interlock.field.operator_place import DOES, Reply
from interlock.field.plc import Link
from interlock.panel.desk import Desk
from interlock.panel.operating import Person
from interlock.panel.recorder import Recorder
from interlock.panel.server import Access, listening, serve


def opened(host: str, port: int, operate: str, look: str) -> tuple[socket.socket, Access]:
    """A socket, and the tokens that are asked for; made up where others can reach the panel and none are given."""
    try:
        sock = listening(host, port)
    except OSError as error:
        raise click.UsageError(f"the panel cannot listen on {host} port {port}: {error.strerror or error}") from None
    if not _alone(sock):
        operate = operate or secrets.token_urlsafe(12)
        look = look or secrets.token_urlsafe(12)
    return sock, Access(operate, look)


def _alone(sock: socket.socket) -> bool:
    """Only this computer can reach it."""
    return ipaddress.ip_address(sock.getsockname()[0]).is_loopback


def run_panel(
    ready: Ready,
    links: Mapping[str, Link] | None,
    cycle_ms: int,
    sock: socket.socket,
    access: Access,
    record: Path | None,
    form: str,
    place: tuple[str, int] | None = None,
    requests: bool = False,
) -> None:
    """Serve the panel until interrupted; `place`: where the operator's place listens on Modbus, and `requests` whether
    it may ask."""
    gc.enable()  # off in the short-lived commands; this one runs on
    assert ready.layout is not None
    record = record or Path(f"{ready.layout.name}-{datetime.now():%Y%m%d-%H%M%S}.log")
    about = dict(DOES.values())

    def ask(who: str, what: str, name: str, reply: Reply) -> None:
        desk.ask(Person(who, True), {"do": what, about[what]: name}, lambda told: reply(bool(told["ok"])))

    with answering(ready, place, ask if requests else None) as server:  # takes no request before the first scan
        try:
            recorder = Recorder(record, ready)
        except (InUse, OSError, ValueError) as error:
            raise click.UsageError(f"the record cannot be written: {told(error, record)}") from None
        desk = Desk(ready, links, cycle_ms, recorder)
        _welcome(sock, access, record, form)
        end_as_by_ctrl_c()
        if server is not None:
            desk.publish = server.publish
        try:
            serve(desk, access, sock)
        finally:
            _say(ending(desk.ran.unwritten, desk.ran.longest_s, cycle_ms), form)
    if desk.broken:
        click.echo(f"error: the controller has stopped: {desk.broken}", err=True)
        sys.exit(70)
    raise KeyboardInterrupt  # nothing else ends it, even where the process was told to ignore the signal


def _welcome(sock: socket.socket, access: Access, record: Path, form: str) -> None:
    """Where the panel is, for whom, and where everything is recorded."""
    host, port = sock.getsockname()[:2]
    at = f"http://{f'[{host}]' if ':' in host else host}:{port}/"
    _say({"panel": at + (f"#token={access.operate}" if access.operate else "")}, form)
    if access.look:
        _say({"to look": f"{at}#token={access.look}"}, form)
    if ipaddress.ip_address(host).is_unspecified:
        _say({"from elsewhere": f"write the name of this computer instead of {host}"}, form)
    _say({"record": str(record)}, form)


def _say(event: dict[str, object], form: str) -> None:
    if form == "json":
        click.echo(json.dumps(event, ensure_ascii=False))
    elif "stopped" in event:
        click.echo(ended(event))
    else:
        click.echo("".join(f"{k}: {v}" for k, v in event.items()))
    sys.stdout.flush()
