"""A layout, the emitted text and a certificate together: what was compared, and what was not."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

import yaml

from interlock.checker import claims, controller, outputs, pinned, plant, said
from interlock.checker.doubted import doubts
from interlock.checker.drawing import Unread
from interlock.checker.railway import Railway, safe
from interlock.checker.reading import loaded
from interlock.checker.scan import execute
from interlock.checker.specification import Specification, shipped
from interlock.checker.speeds import stated_throughout
from interlock.checker.told import Telling
from interlock.checker.written import written
from interlock.verify import ERRORS, Rejected, check_files, need, verify, why

LONGEST = 60
"""Signs of a layout's name, that of the folder of its outputs."""


@dataclass(frozen=True)
class Checked:
    """What was found equal, and what of the written system nobody compared: while there is any, nothing is VERIFIED."""

    compared: tuple[str, ...]
    left: tuple[str, ...]


def check(layout: Path, folder: Path) -> Checked:
    """Raises Rejected where the three do not agree, OSError where a file cannot be read."""
    raw = layout.read_bytes()
    body = _body(layout, raw.decode("utf-8-sig"))
    files = check_files(folder)
    own = hashlib.sha256(raw).digest()
    of_it = [n for n, x in files.items() if hashlib.sha256(x).digest() == own]
    need(of_it != [], f"the certificate is of another layout: {layout} is none of its files")
    proof = verify(folder, files)
    text = _text(files, str(body["name"]))
    system = files["system.txt"].decode()
    bundle = outputs.bundle(folder, files, text, of_it)
    table = outputs.published(bundle)
    found = agree(body, system, files[text].decode(), shipped(), table)
    compared = (
        outputs.compare(bundle, table, lambda: Telling(Railway(body), written(system)))
        if table is not None
        else [bundle.text]
    )
    need(not bundle.torn, bundle.torn)
    program = f"{bundle.text.removesuffix('.st')}_io.st"
    same, apart = pinned.compare(layout, program, bundle.outputs.get(program))
    compared = [*compared, program] if same else compared
    read = f"read: {(folder / text).resolve()}"
    told = (proof, *found.compared, *filter(None, [same]), read, outputs.unread(bundle, compared))
    return Checked(told, (*found.left, *filter(None, [apart])))


def agree(
    body: dict[str, Any], system: str, text: str, spec: Specification, published: said.Published | None = None
) -> Checked:
    """Layout, written system and Structured Text, whatever is proved of the system; raises Rejected where they do not
    say the same.  published: what is told of words, where a table is certified with the text."""
    w = written(system)
    scan = execute(text, frozenset(w.state), w.definitions)
    same = f"{safe(str(body['name']))}.st says the same: {controller.compare(scan, w)}"
    try:
        world = Telling(Railway(body), w)
    except Unread as unread:
        return Checked((same,), (f"plant, assumptions and claims (the checker does not read {unread})",))
    stated_throughout(world)
    defined = plant.define(world, spec)
    claimed = claims.asked(spec.claims, world)
    told, silent = claims.compare(world, spec, claimed, w)
    moves = plant.compare(world, spec, defined, w, scan)
    claims.outputs_read(claimed, scan.outputs)
    spoken, strange = said.compare(world, spec, scan, published)
    names = f"under the assumptions {', '.join(claims.assumed(world, spec))}{_contradicted(world)}"
    left = [f"the claims {', '.join(silent)}"] if silent else []
    return Checked((same, told, moves, names, spoken), (*left, *strange))


def _contradicted(world: Telling) -> str:
    """Where the layout's own numbers leave an assumption no room."""
    return "".join(f"; but {x}" for x in doubts(world.lengths))


def _body(layout: Path, text: str) -> dict[str, Any]:
    try:
        body = loaded(text)
    except yaml.YAMLError as e:
        what = getattr(e, "problem", None) or "it cannot be read"
        raise Rejected(f"{layout} is no YAML, or none with one meaning: {what}") from e
    if not isinstance(body, dict) or not isinstance(body.get("name"), str):
        raise Rejected(f"{layout} is no layout with a name")
    need("/" not in body["name"], f"{layout}: the name {body['name']} has a /, and no folder of outputs can bear it")
    need(len(body["name"]) <= LONGEST, f"{layout}: its name has more than {LONGEST} signs, and no folder can bear it")
    return body


def _text(files: Collection[str], name: str) -> str:
    """The emitted Structured Text that the manifest names."""
    wanted = (name, "st", "iec", f"{safe(name)}.st")
    found = [n for n in files if PurePosixPath(n).parts[-4:] == wanted]
    need(len(found) == 1, f"the certificate names no Structured Text of {name}, or several")
    return found[0]


def report(layout: Path, folder: Path, checked: Callable[[Path, Path], Checked] = check) -> int:
    """Say in words what was found; 0 VERIFIED, 1 REJECTED, 3 when something was not compared."""
    try:
        found = checked(layout, folder)
    except ERRORS as e:
        print(f"{layout} {folder}: REJECTED  {why(e)}")
        return 1
    print(f"{layout} {folder}: {'VERIFIED' if not found.left else 'CHECKED'}")
    for line in found.compared:
        print(f"  {line}")
    if found.left:
        print(f"  not compared with the layout: {', '.join(found.left)}; so nothing is said to be verified of it")
    return 3 if found.left else 0
