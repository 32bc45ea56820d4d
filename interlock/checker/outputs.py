"""The other files of a bundle: whether they are those that were certified, what they say to people, what nobody reads.

Of a Python or C runtime the names of routes and the sentences are compared with the table of words, which is compared
with the text; so are the comments beside the codes of the text.  Whatever else stands in a file is named as not read.
"""

from __future__ import annotations

import ast
import csv
import hashlib
import io
import json
import lzma
import os
import re
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from itertools import islice
from pathlib import Path, PurePosixPath
from typing import Any

from interlock.checker.reading import loaded
from interlock.checker.said import Published
from interlock.checker.specification import FOLDER
from interlock.checker.told import Telling
from interlock.verify import Rejected, need

CODE = re.compile(r"\w+\.(\w+)\s*:?=\s*(\d+);\s*(?:\(\*(.*?)\*\)|/\*(.*?)\*/)", re.DOTALL)
"""A word gets a code, in Structured Text or C, and what a comment says of it."""
WORD = re.compile(r"\b(YX_R\d+) : INT := 0;\s*\(\*(.*?)\*\)", re.DOTALL)
ENTRY = re.compile(r'\s*\{\s*"((?:[^"\\\n]|\\[0-7]{3})*)",\s*(\d+)(?:,\s*&\w+\.(\w+))?\s*\}\s*(,?)')
MANY = 10_000
"""Files of a folder that are looked for."""
LARGEST = 100_000_000
"""Bytes in the parts of a workbook."""
SIGNS = 8
"""With which a sign is written that cannot stand in a comment, at most."""
COLUMNS = ["Word", "Code", "Says", "Rule", "About"]
HEAD = re.compile(r"\w+_routes\[(\d+)\]\s*=\s*\{")


@dataclass(frozen=True)
class Bundle:
    """The files that a certificate ties, by their paths below the outputs of the layout; None what is not there."""

    top: PurePosixPath
    """The folder of the outputs, as the certificate names it."""
    text: str
    own: tuple[str, ...]
    """Files of the certificate itself."""
    outputs: Mapping[str, bytes | None]
    stray: tuple[str, ...] = ()
    """Files that lie there and that neither the certificate nor the manifest of outputs names."""
    torn: str = ""
    """Why a file that the certificate ties is none of the manifest of outputs: told where all else is right."""


def bundle(folder: Path, files: Mapping[str, bytes], text: str, layout: Iterable[str]) -> Bundle:
    """What belongs to a certificate.  files: what it ties itself, by path; layout: those of them that are the layout.
    Raises Rejected for a file that is another than the outputs' manifest names."""
    top = PurePosixPath(text).parents[2]
    below = {n: PurePosixPath(n).relative_to(top) for n in files if top in PurePosixPath(n).parents}
    own = [n for n in files if n not in below and n not in layout]
    found: dict[str, bytes | None] = {str(x): files[n] for n, x in below.items() if n not in layout}
    torn = ""
    listed = json.loads(found.get("manifest.json") or b'{"files": {}}')["files"]
    for name, digest in listed.items():
        path = PurePosixPath(name)
        need(
            not path.is_absolute() and ".." not in path.parts,
            f"the manifest of outputs names {name}, which is elsewhere",
        )
        if name not in found:
            file = folder / top / name
            found[name] = file.read_bytes() if file.is_file() else None
        raw = found[name]
        if raw is not None and _digest(name, raw) != digest:
            why = f"{name} is not the file that the manifest of outputs names"
            need(name in map(str, below.values()), why)
            torn = torn or why
    here = islice(
        (Path(at) / n for at, below_, names in os.walk(folder / top) for n in (*names, *_links(at, below_))), MANY
    )
    stray = {str(x.relative_to(folder / top)) for x in here} - {*found, *(str(x) for x in below.values())}
    mine = ("manifest.json", *own)
    return Bundle(top, str(PurePosixPath(text).relative_to(top)), mine, found, tuple(sorted(stray)), torn)


def _links(at: str, folders: Iterable[str]) -> Iterator[str]:
    """Those of some folders that are links, which tools follow and nobody else here does."""
    return (n for n in folders if (Path(at) / n).is_symlink())


def _digest(name: str, raw: bytes) -> str:
    """Of a workbook that of its parts: how they are packed tells nothing.  Raises Rejected where it is none."""
    if not name.endswith(".xlsx"):
        return hashlib.sha256(raw).hexdigest()
    try:
        with zipfile.ZipFile(io.BytesIO(raw)) as book:
            parts = book.infolist()
            need(sum(x.file_size for x in parts) <= LARGEST, f"{name} is larger when unpacked than any workbook is")
            told = [(x.filename.encode(), book.read(x)) for x in parts]
    except (zipfile.BadZipFile, zlib.error, NotImplementedError, EOFError, lzma.LZMAError) as e:
        raise Rejected(f"{name} is no workbook: {e}") from e
    whole = b"".join(b"%d %s %d\n%s" % (len(n), n, len(x), x) for n, x in told)
    return hashlib.sha256(whole).hexdigest()


@cache
def _spec() -> Any:
    return loaded((FOLDER / "outputs.yaml").read_text("utf-8"))


def unread(b: Bundle, compared: Iterable[str]) -> str:
    """What of the files nobody compared, in one line.  compared: the outputs of which something was."""
    left = _spec()["outputs"]
    program = f"{b.text.removesuffix('.st')}_io.st"
    known = {b.text: left["{text}"], program: left["{io}"], **left}
    here = {n: known.get(n, left["{c}"]) for n in (b.text, *compared)}
    parts = [f"of {n} {x['left']}" for n, x in sorted(here.items()) if x["left"]]
    whole = [n for n in b.outputs if n not in here and b.outputs[n] is not None]
    whole += [f"{n} of the certificate" for n in b.own if n not in _spec()["certificate"]]
    gone = [n for n, x in b.outputs.items() if x is None]
    absent = f"; not there: {', '.join(sorted(gone))}" if gone else ""
    absent += f"; certified by nobody: {', '.join(b.stray)}" if b.stray else ""
    return f"not read: {'; '.join([*parts, ', '.join(sorted(whole))]).rstrip('; ')}{absent}"


# --- what is said in them --------------------------------------------------------------------------------


def compare(b: Bundle, table: Published, world: Callable[[], Telling]) -> list[str]:
    """The outputs in which something was compared with the table of words.  world: asked for where
    the layout gives names of its own to routes."""
    read = [b.text, "manifest.json", "io/words.csv"]
    said = (b.outputs[b.text] or b"").decode()
    _comments(b.text, said, table)
    for word, text in WORD.findall(said):
        told = _like(table.words.get(word, ""), text.strip().partition(": what it does")[0])
        need(told, f"{b.text} calls {word} {text.strip()!r}")
    for name, raw in b.outputs.items():
        if raw is not None and name == "runtime.py":
            _python(name, raw.decode(), table, world)
        elif raw is not None and re.fullmatch(r"c99/[^/]+\.c", name):
            _c(name, raw.decode(), table, world)
        else:
            continue
        read.append(name)
    return read


def published(b: Bundle) -> Published | None:
    """What io/words.csv says of words, if the certificate ties the table; else None."""
    if b.outputs.get("manifest.json") is None:
        return None
    raw = b.outputs.get("io/words.csv")
    if raw is None:
        raise Rejected("io/words.csv is not there, or the manifest of outputs does not name it")
    codes: dict[int, str] = {}
    rules: dict[int, str] = {}
    words: dict[str, str] = {}
    told = csv.reader(io.StringIO(raw.decode("utf-8"), newline=""), strict=True)
    need(next(told, None) == COLUMNS, f"io/words.csv has other columns than {', '.join(COLUMNS)}")
    for row in told:
        need(len(row) == len(COLUMNS), "io/words.csv has a row with more or fewer cells than its head")
        word, code, says, rule, _ = row
        need((word == "") is not (code == ""), "io/words.csv has a row that is of a word and of a code, or of neither")
        twice = word in words or (code.isdecimal() and int(code) in codes)
        need(not twice, f"io/words.csv says two things of {word or code}")
        if word:
            words[word] = says
        else:
            need(str(int(code)) == code, f"io/words.csv writes a code {code}")
            codes[int(code)], rules[int(code)] = says, rule
    return Published(codes, words, rules)


def _comments(name: str, text: str, table: Published) -> None:
    """Beside a code stands its sentence."""
    for word, code, *either in CODE.findall(text):
        said = "".join(either)
        wanted = table.codes.get(int(code))
        told = wanted is None or _like(wanted, said.strip())
        need(told, f"{name} says beside the code {code} of {word} {said.strip()!r}")


def _like(wanted: str, text: str) -> bool:
    """A sentence as it stands, or as it is written where not every sign can stand: for each of those a few others, or
    none.  All ways to read it are followed at once, so that no sentence takes long."""
    if text == wanted:
        return True
    ends = {0}
    for c in wanted:
        plain = c.isascii() and c.isprintable() and c not in "*\\?]>"
        ends = (
            {e + 1 for e in ends if text[e : e + 1] == c}
            if plain
            else {e + n for e in ends for n in range(SIGNS + 1) if e + n <= len(text)}
        )
    return len(text) in ends


def _routes(name: str, routes: Mapping[str, int], table: Published, world: Callable[[], Telling]) -> None:
    """Every route by the name that the table has, and otherwise by those that the layout gives it."""
    own = {text.removeprefix("route "): int(w.removeprefix("YX_R")) for w, text in table.words.items()}
    for text, number in own.items():
        need(
            routes.get(text) == number, f"{name} has {routes.get(text)} as the number of the route {text}, not {number}"
        )
    others = sorted(routes.keys() - own.keys())
    if not others:
        return
    told = world()
    named = told.r.body.get("routes") or {}
    for text in others:
        known = text in named and routes[text] in own.values()
        known = known and told.leads_so(named[text], routes[text])
        need(known, f"{name} calls {text!r} a route that the layout does not call so")


def _python(name: str, text: str, table: Published, world: Callable[[], Telling]) -> None:
    """ROUTES and SAID of a Python runtime, each written once."""
    try:
        tree = ast.parse(text)
        bound = [x.id for x in ast.walk(tree) if isinstance(x, ast.Name) and not isinstance(x.ctx, ast.Load)]
        found = {}
        for x in tree.body:
            if isinstance(x, ast.Assign) and isinstance(x.targets[0], ast.Name) and isinstance(x.value, ast.Dict):
                keys = list(map(ast.literal_eval, filter(None, x.value.keys)))
                if x.targets[0].id in ("ROUTES", "SAID"):
                    found[x.targets[0].id] = ast.literal_eval(x.value)
                    need(len({*keys}) == len(x.value.keys), f"{name} says two things of one key")
    except (SyntaxError, ValueError) as e:
        raise Rejected(f"{name} is no Python: {e}") from e
    for which in ("ROUTES", "SAID"):
        need(which in found and bound.count(which) == 1, f"{name} has no {which}, or several")
    _routes(name, found["ROUTES"], table, world)
    need({*found["SAID"]} == {*table.codes}, f"{name} explains other codes than io/words.csv")
    for code, (said, rule) in found["SAID"].items():
        ok = _shown(table.codes[code]) == said and table.rules.get(code, "") == rule
        need(ok, f"{name} says of the code {code} {said!r} ({rule})")


def _shown(text: str) -> str:
    return "".join(c if c.isprintable() else "?" for c in text)


def _c(name: str, text: str, table: Published, world: Callable[[], Telling]) -> None:
    """The table of routes of a C runtime, and the comments beside its codes."""
    heads = list(HEAD.finditer(text))
    need(len(heads) == 1, f"{name} has no table of routes, or several")
    at, routes = heads[0].end(), {}
    more = True
    while more:
        entry = ENTRY.match(text, at)
        if entry is None:
            raise Rejected(f"{name} has a table of routes that is not known here")
        called = re.sub(rb"\\([0-7]{3})", lambda x: bytes([int(x[1], 8) & 255]), entry[1].encode()).decode()
        need(called not in routes, f"{name} has the route {called} twice")
        routes[called] = int(entry[2])
        need(entry[3] in (None, f"YX_R{entry[2]}"), f"{name} shows {entry[3]} as the word of the route {called}")
        at, more = entry.end(), entry[4] == ","
    need(len(routes) == int(heads[0][1]), f"{name} has {len(routes)} routes, and says that it has {heads[0][1]}")
    _routes(name, routes, table, world)
    _comments(name, text, table)
