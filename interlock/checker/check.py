"""A layout, the emitted text and a certificate together: what was compared, and what was not."""

from __future__ import annotations

import hashlib
import lzma
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from interlock.checker import claims, controller, plant
from interlock.checker.drawing import Unread, loaded
from interlock.checker.moves import World
from interlock.checker.railway import Railway, safe
from interlock.checker.scan import execute
from interlock.checker.specification import Specification, shipped
from interlock.checker.written import written
from interlock.verify import Rejected, check_files, need, verify


@dataclass(frozen=True)
class Checked:
    """What was found equal, and what of the written system nobody compared: while there is any, nothing is VERIFIED."""

    compared: tuple[str, ...]
    left: tuple[str, ...]


def check(layout: Path, folder: Path) -> Checked:
    """Raises Rejected where the three do not agree, OSError where a file cannot be read."""
    body = _body(layout)
    files = check_files(folder)
    own = hashlib.sha256(layout.read_bytes()).hexdigest()
    need(own in files.values(), f"the certificate is of another layout: {layout} is none of its files")
    proof = verify(folder)
    text = _text(folder, files, str(body["name"]))
    system = (folder / "system.txt").read_text("utf-8")
    found = agree(body, system, text.read_text("utf-8"), shipped())
    read = f"read: {text.resolve()}, and of the outputs nothing else: no mapping program, no other dialect"
    return Checked((proof, *found.compared, read), found.left)


def agree(body: dict[str, Any], system: str, text: str, spec: Specification) -> Checked:
    """Layout, written system and Structured Text, whatever is proved of the system; raises Rejected where they do not
    say the same."""
    w = written(system)
    scan = execute(text, frozenset(w.state), w.definitions)
    said = f"{body['name']}.st says the same: {controller.compare(scan, w)}"
    try:
        world = World(Railway(body), w)
    except Unread as unread:
        return Checked((said,), (f"plant, assumptions and claims (the checker does not read {unread})",))
    defined = plant.define(world, spec)
    claimed = claims.asked(spec.claims, world)
    told, silent = claims.compare(world, spec, claimed, w)
    moves = plant.compare(world, spec, defined, w, scan)
    claims.outputs_read(claimed, scan.outputs)
    names = f"under the assumptions {', '.join(claims.assumed(world, spec))}"
    return Checked((said, told, moves, names), (f"the claims {', '.join(silent)}",) if silent else ())


def _body(layout: Path) -> dict[str, Any]:
    try:
        body = loaded(layout.read_text("utf-8"))
    except yaml.YAMLError as e:
        raise Rejected(f"{layout} is no YAML") from e
    if not isinstance(body, dict) or not isinstance(body.get("name"), str):
        raise Rejected(f"{layout} is no layout with a name")
    return body


def _text(folder: Path, files: dict[str, str], name: str) -> Path:
    """The emitted Structured Text that the manifest names."""
    found = [n for n in files if n.endswith(f"{name}/st/iec/{safe(name)}.st")]
    need(len(found) == 1, f"the certificate names no Structured Text of {name}, or several")
    return folder / found[0]


def report(layout: Path, folder: Path) -> int:
    """Say in words what was found; 0 VERIFIED, 1 REJECTED, 3 when something was not compared."""
    try:
        found = check(layout, folder)
    except (Rejected, OSError, ValueError, KeyError, IndexError, TypeError, RecursionError, lzma.LZMAError) as e:
        print(f"{layout} {folder}: REJECTED  {e if isinstance(e, Rejected) else f'{type(e).__name__}: {e}'}")
        return 1
    print(f"{layout} {folder}: {'VERIFIED' if not found.left else 'CHECKED'}")
    for line in found.compared:
        print(f"  {line}")
    if found.left:
        print(f"  not compared with the layout: {', '.join(found.left)}; so nothing is said to be verified of it")
    return 3 if found.left else 0
