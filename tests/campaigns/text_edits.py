"""Random single edits of emitted texts: `python -m tests.campaigns.text_edits --count 1200`.

Each edit is judged by the proof that text equals controller.  What the proof accepts must be harmless: edited and
original text are run side by side on random scans, and a difference there would be an edit that was missed.
"""

from __future__ import annotations

import argparse
import random
import sys
import types
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

from interlock.emit.python.runtime import runtime_py
from interlock.logic.controller import Controller
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect
from interlock.proof.mutation.texts import PYTHON_EDITS, ST_EDITS
from interlock.st.dialects import DIALECTS, Dialect, write_st
from interlock.st.meaning import Execution, Numbers
from interlock.st.restart import RESTART
from tests.layouts import built
from tests.test_equal import random_inputs

LAYOUTS = ("fig2_2", "fig2_3_split", "mine11", "incline_hoist", "crossing_line")
FATES = ("refuted", "not in the subset", "same meaning", "MISSED")


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
    given = args.parse_args()
    rng = random.Random(given.seed)
    controllers = {n: built(n)[2] for n in LAYOUTS}
    found: list[Edited] = []
    while len(found) < given.count:
        edited = one_edit(controllers[rng.choice(LAYOUTS)], rng.choice((*DIALECTS, None)), rng)
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
