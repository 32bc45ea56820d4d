"""Random single edits of emitted texts: `python -m tests.campaigns.text_edits --count 1200`.

Each edit is judged by the proof that text equals controller.  What the proof accepts must be harmless: edited and
original text are run side by side on random scans, and a difference there would be an edit that was missed.

`--c99`: edits of the C runtime instead, run as gcc compiles it.
"""

from __future__ import annotations

import argparse
import random
import re
import struct
import subprocess
import sys
import tempfile
import types
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from interlock.emit.c99.runtime import runtime_c
from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.proof.equivalence.c_text import compare_c
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.mutation.texts import PYTHON_EDITS, ST_EDITS
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.st.dialects.dialect import Dialect
from interlock.st.meaning import Execution, Numbers
from interlock.st.restart import RESTART
from tests.c_driver import RESTART as POWER_ON
from tests.c_driver import SCAN, answers, built_by_gcc
from tests.layouts import built
from tests.test_equal import random_inputs

LAYOUTS = ("fig2_2", "fig2_3_split", "mine11", "incline_hoist", "crossing_line")
FATES = ("refuted", "not in the subset", "same meaning", "MISSED")

C_EDITS: dict[str, tuple[str, tuple[str, ...]]] = {
    "c-and-for-or": (r"\|\|", ("&&", "|")),
    "c-or-for-and": (r"&&", ("||", "&", ",")),
    "c-not-dropped": (r"!(?=[\w(])", ("", "!!", "~")),
    "c-not-added": (r"(?<=&& )(?=[a-z]+\.)", ("!",)),
    "c-operator": (r"==", ("=", "!=", "<=", ">")),
    "c-number": (r"\b\d+u?\b", ("0", "1", "2", "01", "0x1", "65537", "70000u")),
    "c-truth": (r"\b(?:true|false)\b", ("true", "false", "0", "begun")),
    "c-type": (r"\b(?:bool|u?int\d+_t)\b(?= )", ("char", "uint8_t", "uint16_t", "int", "volatile bool", "bool")),
    "c-specifier": (r"\b(?:static|const|extern) ", ("", "register ", "volatile ", "static ")),
    "c-object": (r"\b(?:in|now|next|wire|IL_\w+_in|IL_\w+_out)(?=\.)", ("in", "now", "next", "wire")),
    "c-bracket": (r"[(){}]", ("", "((", "))", "{", "}")),
    "c-statement": (r"\n  [a-z][^;{}]*;", ("", "\n  return;", "\n  now = next;", ";")),
    "c-line": (r"\n", ("", "\n#if 0\n", "\n/*", "*/\n", " \\ \n", "\n//", "\n#define in now\n", "\n;")),
    "c-comment": (r"(?<=/\*)[^*]*(?=\*/)", (" *\\ \n/ return; /* ", " */ ; /* ", " */ || true /* ", " \\\n", " /* ")),
    "c-name": (r"(?<=\.)[A-Z]\w*", ("VALID", "REQ", "linux", "true")),
}
"""By kind of edit what is replaced, in comments too, and by what."""


@dataclass(frozen=True)
class Edited:
    """One edit: of which text, of what kind, and what became of it."""

    text: str
    kind: str
    fate: str


def one_edit(controller: Controller, dialect: Dialect | None, rng: random.Random) -> Edited | None:
    """A random edit of a dialect's files (None: of the Python runtime), judged; None when nothing was found to edit."""
    if dialect is None:
        files = {"runtime.py": runtime_py(controller, [])}
    else:
        files = write_st(controller, dialect, ["made for a test"])
    name = rng.choice(sorted(files))
    edits = PYTHON_EDITS if dialect is None else ST_EDITS
    kind = rng.choice(sorted(edits))
    places = edits[kind](files[name], dialect is None)
    if not places:
        return None
    place = rng.choice(places)
    text = place.edited(files[name], rng.choice(place.instead))
    changed = {**files, name: text}
    if dialect is None:
        found = compare_runtime(controller, text)
    else:
        found = compare_dialect(controller, dialect, changed)
    where = dialect.name if dialect is not None else "runtime"
    if not found.proved:
        unread = any("cannot be read" in d.text for d in found.differences)
        return Edited(where, kind, "not in the subset" if unread else "refuted")
    before, after = (python(f) if dialect is None else _text(dialect, f) for f in (files, changed))
    return Edited(where, kind, "same meaning" if alike(controller, before, after, rng) else "MISSED")


def one_c_edit(controller: Controller, rng: random.Random) -> Edited | None:
    """A random edit of the C file or its header, judged; what cannot be compiled is harmless."""
    files = runtime_c(controller, [])
    name, kind = rng.choice(sorted(files)), rng.choice(sorted(C_EDITS))
    pattern, instead = C_EDITS[kind]
    places = list(re.finditer(pattern, files[name]))
    if not places:
        return None
    place, new = rng.choice(places), rng.choice(instead)
    if place.group() == new:
        return None
    changed = {**files, name: files[name][: place.start()] + new + files[name][place.end() :]}
    found = compare_c(controller, changed)
    if not found.proved:
        unread = any("cannot be read" in d.text for d in found.differences)
        return Edited("c99", kind, "not in the subset" if unread else "refuted")
    given = bytearray(POWER_ON)
    for _ in range(600):
        inputs = random_inputs(controller, rng)
        given += SCAN + struct.pack("<I", rng.choice((100, 1000, 1001, 20_000)))
        given += bytes(inputs[i.name] for i in controller.inputs if not i.size)
        given += b"".join(struct.pack("<h", inputs[i.name]) for i in controller.inputs if i.size)
    same = compiled(controller, tuple(changed.items()), bytes(given))
    whole = compiled(controller, tuple(files.items()), bytes(given))
    return Edited("c99", kind, "same meaning" if same in (None, whole) else "MISSED")


def compiled(controller: Controller, files: tuple[tuple[str, str], ...], given: bytes) -> bytes | None:
    """What a C runtime answers; None where gcc refuses it."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            program = built_by_gcc(controller, dict(files), Path(folder), warnings=())
        except subprocess.CalledProcessError:
            return None
        return answers(program, given)


Scan = Callable[[dict[str, int], int], dict[str, bool]]


def _text(dialect: Dialect, files: dict[str, str]) -> Scan:
    numbers = Numbers()
    run: Execution[int] = Execution(dialect.read(files), numbers)

    def scan(inputs: dict[str, int], dt_ms: int) -> dict[str, bool]:
        numbers.dt_ms = dt_ms
        return {k: bool(v) for k, v in run.scan({**inputs, **({RESTART: 0} if dialect.restart else {})}).items()}

    return scan


def python(files: dict[str, str]) -> Scan:
    module = types.ModuleType("runtime")
    exec(compile(files["runtime.py"], "runtime.py", "exec"), module.__dict__)
    running: Scan = module.Controller().scan
    return running


def alike(controller: Controller, a: Scan, b: Scan, rng: random.Random, scans: int = 200) -> bool:
    for _ in range(scans):
        inputs, dt_ms = random_inputs(controller, rng), rng.choice((100, 1000, 20_000))
        if a(inputs, dt_ms) != b(inputs, dt_ms):
            return False
    return True


def main() -> None:
    """Run the campaign; exit status 1 when an edit was missed."""
    args = argparse.ArgumentParser(description=__doc__)
    args.add_argument("--count", type=int, default=1200)
    args.add_argument("--seed", type=int, default=1)
    args.add_argument("--c99", action="store_true", help="edits of the C runtime; needs gcc")
    given = args.parse_args()
    rng = random.Random(given.seed)
    controllers = {n: built(n)[2] for n in LAYOUTS}
    found: list[Edited] = []
    dialects = (*BY_NAME.values(), None)
    while len(found) < given.count:
        controller = controllers[rng.choice(LAYOUTS)]
        edited = one_c_edit(controller, rng) if given.c99 else one_edit(controller, rng.choice(dialects), rng)
        if edited is not None:
            found.append(edited)
    keys: dict[str, Callable[[Edited], str]] = {"text": lambda e: e.text, "edit": lambda e: e.kind}
    for title, key in keys.items():
        print(f"| {title} | edits | {' | '.join(FATES)} |\n|---|---|{'---|' * len(FATES)}")
        for k in sorted({key(e) for e in found}):
            mine = [e for e in found if key(e) == k]
            count = Counter(e.fate for e in mine)
            print(f"| {k} | {len(mine)} | {' | '.join(str(count[f]) for f in FATES)} |")
        print()
    total = Counter(e.fate for e in found)
    changing = given.count - total["same meaning"]
    print(f"{given.count} edits, {changing} of them change the meaning: {changing - total['MISSED']} refuted.")
    sys.exit(1 if total["MISSED"] else 0)


if __name__ == "__main__":
    main()
