"""Check a proof again without trusting what made it: `python -m interlock.verify proofs/NAME`.

This file needs Python's standard library alone and no other file of the package.  It reads the written system and

1. compares the SHA-256 of every file that the manifest names, and of the manifest itself;
2. builds the facts and the goals again from the system: a definition gives its halves, an invariant is a fact of the
   old state and two goals (it holds at the restart; it holds after a step), a lemma or claim is a goal of every step;
3. checks every lemma and goal, in order, by unit propagation along the given hints: with all of its literals false,
   each clause that is named forces a literal, and the last one is left with none.  What may be named: for a goal of the
   step all of the above, for the others the initial condition; and lemmas and goals of the step that stand before it.

Then, by induction over the steps, every claim holds in every step of every run of the written system.
That the system is the railway and its controller is not checked here: read it, or derive it again.
"""

from __future__ import annotations

import hashlib
import json
import lzma
import sys
import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

Node = tuple[Any, ...]
"""`("v", name)`, `("!", node)`, `("&", nodes)`, `("|", nodes)`, `("T",)` or `("F",)`."""
TRUE: Node = ("T",)
FALSE: Node = ("F",)


class Rejected(Exception):
    """The bundle does not prove what it says."""


def need(ok: bool, why: str) -> None:
    """Reject unless."""
    if not ok:
        raise Rejected(why)


# --- expressions -----------------------------------------------------------------------------------


def read(text: str) -> Node:
    """An expression from its text."""
    stack: list[tuple[str, bool, list[Node]]] = [("", False, [])]
    for word in text.replace("(", " ( ").replace(")", " ) ").replace("! ", "!").split():
        if word in ("(", "!("):
            stack.append(("", word == "!(", []))
        elif word in ("&", "|") and not stack[-1][0] and not stack[-1][2] and len(stack) > 1:
            stack[-1] = (word, *stack[-1][1:])
        elif word == ")":
            need(len(stack) > 1 and stack[-1][0] != "", f"malformed expression {text[:60]}")
            op, sign, args = stack.pop()
            node: Node = (op, tuple(args))
            stack[-1][2].append(negate(node) if sign else node)
        else:
            sign, name = word.startswith("!"), word.lstrip("!")
            need(name != "" and len(word) - len(name) <= 1, f"malformed expression {text[:60]}")
            leaf: Node = TRUE if name == "T" else FALSE if name == "F" else ("v", name)
            stack[-1][2].append(negate(leaf) if sign else leaf)
    need(len(stack) == 1 and len(stack[0][2]) == 1, f"malformed expression {text[:60]}")
    return stack[0][2][0]


def negate(x: Node) -> Node:
    """NOT."""
    return FALSE if x == TRUE else TRUE if x == FALSE else x[1] if x[0] == "!" else ("!", x)


def either(xs: Iterable[Node]) -> Node:
    """OR, flat, without repetition, TRUE when two operands contradict each other."""
    flat: dict[Node, None] = {}
    for x in xs:
        for y in x[1] if x[0] == "|" else (x,):
            if y == TRUE:
                return TRUE
            if y != FALSE:
                flat.setdefault(y)
    if any(negate(y) in flat for y in flat):
        return TRUE
    return FALSE if not flat else next(iter(flat)) if len(flat) == 1 else ("|", tuple(flat))


def conjuncts(x: Node) -> tuple[Node, ...] | None:
    """The parts of a conjunction, or None."""
    if x[0] == "&":
        return tuple(x[1])
    if x[0] == "!" and x[1][0] == "|":
        return tuple(negate(a) for a in x[1][1])
    return None


def split(x: Node) -> list[Node]:
    """Clauses that together say the same."""
    together = conjuncts(x)
    if together is not None:
        return [y for a in together for y in split(a)]
    if x[0] == "|":
        inner = [(i, c) for i, a in enumerate(x[1]) if (c := conjuncts(a)) is not None]
        if len(inner) == 1:
            i, those = inner[0]
            return [y for b in those for y in split(either((*x[1][:i], *x[1][i + 1 :], b)))]
    return [] if x == TRUE else [x]


def pattern(x: Node, numbers: dict[str, int]) -> str:
    """The text of an expression with leaves numbered in order of appearance."""
    if x[0] == "v":
        return str(numbers.setdefault(x[1], len(numbers) + 1))
    if x[0] == "!":
        return "!" + pattern(x[1], numbers)
    if x[0] in "&|":
        return f"({x[0]} {' '.join(pattern(a, numbers) for a in x[1])})"
    return str(x[0])


# --- the system ------------------------------------------------------------------------------------


Clause = tuple[str, tuple[str, ...]]
"""A fact or goal: its pattern and the leaves in order."""


def words_of(text: str) -> tuple[str, list[str]]:
    """An expression with its names numbered from 1 in order of appearance, and the names."""
    numbers: dict[str, int] = {}
    out: list[str] = []
    for word in text.replace("(", " ( ").replace(")", " ) ").replace("! ", "!").split():
        if word not in ("(", "!(", ")", "&", "|", "T", "F", "!T", "!F"):
            name = word[1:] if word[0] == "!" else word
            if name == "" or name[0] == "!":
                raise Rejected(f"malformed expression {text[:60]}")
            word = f"{word[: -len(name)]}{numbers.setdefault(name, len(numbers) + 1)}"
        out.append(word)
    return " ".join(out), list(numbers)


@lru_cache(1 << 16)
def numbered(text: str, defines: bool) -> list[tuple[str, list[int]]]:
    """The clauses of an expression whose names are numbers, or of the definition of 0 by it: pattern and leaves."""
    x, own = read(text), ("v", "0")
    clauses = split(either((negate(own), x))) + split(either((negate(x), own))) if defines else split(x)
    found = []
    for c in clauses:
        numbers: dict[str, int] = {}
        found.append((sys.intern(pattern(c, numbers)), list(map(int, numbers))))
    return found


def clauses_of(text: str, later: Mapping[str, str] | None = None) -> list[Clause]:
    """The clauses of an expression, one step later where that is given."""
    words, names = words_of(text)
    if later is not None:
        names = [later.get(v, v) for v in names]
    return [(form, tuple([names[n - 1] for n in leaves])) for form, leaves in numbered(words, False)]


def halves(definitions: list[list[str]]) -> Iterator[Clause]:
    """The clauses of definitions, each of which reads only what was defined before it: so a step has all values."""
    left = {name for name, _ in definitions}
    for name, meaning in definitions:
        words, names = words_of(meaning)
        need(left.isdisjoint(names), f"{name} is defined by what comes after it")
        left.discard(name)
        names.insert(0, name)
        for form, leaves in numbered(words, True):
            yield form, tuple([names[n] for n in leaves])


class System:
    """Facts and goals of a written system."""

    def __init__(self, text: str) -> None:
        lines = text.splitlines()
        need(lines[:1] == ["interlock-system 2"], "system.txt is of another kind")
        self.claims: dict[str, int] = {}
        later: dict[str, str] = {}
        parts: dict[str, list[list[str]]] = {k: [] for k in ("ini", "def", "asm", "val", "start")}
        owed: list[tuple[str, str]] = []
        words = {"ini": 1, "def": 2, "asm": 2, "inv": 3, "lemma": 1, "val": 2, "claim": 3, "start": 1}
        for line in lines[1:]:
            kind, _, rest = line.partition(" ")
            if kind in ("sentence", "assumed", "timer"):
                continue
            if kind == "state":
                need(rest not in later, f"{rest} is twice a state variable")
                later[rest] = rest + "'"
                continue
            need(kind in words, f"unknown line {line[:60]}")
            said = rest.split(" ", words[kind] - 1)
            need(len(said) == words[kind], f"a line without all its words: {line[:60]}")
            if kind in parts:
                parts[kind].append(said)
            else:
                owed.append((kind, said[-1]))
                if kind == "claim":
                    self.claims[said[0]] = self.claims.get(said[0], 0) + 1
        names = [name for name, _ in parts["def"]]
        need(len(set(names)) == len(names), "a name is defined twice")
        need(set(later.values()) <= set(names), "a state variable has no next value")
        state, known = frozenset(later), frozenset((*names, *later))
        need(state.isdisjoint(names), "a state variable is defined within the step")
        self.steps = list(halves(parts["def"]))
        self.steps += [c for _, x in parts["asm"] for c in clauses_of(x)]
        invariants = [x for kind, x in owed if kind == "inv"]
        base = [c for x in invariants for c in clauses_of(x)]
        for form, leaves in base:  # else the input of one step would be taken for that of the next
            need(state.issuperset(leaves), f"the invariant {form[:40]} speaks of more than the state")
        self.steps += base
        for name, size in parts["val"]:
            need(int(size) <= min(len(lines), 9999), f"{name} has more values than anything here can speak of")
            values = [f"{name}={k}" for k in range(int(size))]
            need(known.isdisjoint(values), f"{name} is no input, and so may have two values")
            self.steps += [(sys.intern("(| !1 !2)"), (a, b)) for i, a in enumerate(values) for b in values[i + 1 :]]
        self.initial = [c for (x,) in parts["ini"] for c in clauses_of(x)]
        for form, leaves in self.initial:
            need(state.issuperset(leaves), f"the initial condition {form[:40]} speaks of more than the state")
        self.goals = [(c, False) for c in base]
        for kind, x in owed:
            self.goals += [(c, True) for c in clauses_of(x, later if kind == "inv" else None)]
        self.goals += [(c, False) for (x,) in parts["start"] for c in clauses_of(x)]
        self.starts = bool(parts["start"])
        self.invariants = len(invariants)


# --- clauses ---------------------------------------------------------------------------------------


class Form:
    """A pattern with its leaves numbered from 1, taken apart into clauses.

    `defs`: for each conjunction (-1) or disjunction (1) within it, inner ones first, its operands; `lits`: what one of
    which must hold.  Operands are numbers of leaves, and after these of the `defs`, negative when negated.
    """

    def __init__(self, text: str, arity: int) -> None:
        x = read(text)
        self.arity = arity
        self.defs: list[tuple[int, list[int]]] = []
        self.lits = [self._number(y) for y in (() if x == FALSE else x[1] if x[0] == "|" else (x,))]

    def _number(self, x: Node) -> int:
        if x[0] == "v":
            return int(x[1])
        if x[0] == "!":
            return -self._number(x[1])
        args = [self._number(y) for y in x[1]] if x[0] in "&|" else []  # a constant: all of nothing, or one of it
        self.defs.append((1 if x[0] in "|F" else -1, args))
        return self.arity + len(self.defs)


form_of = lru_cache(1 << 16)(Form)


def values(lits: Iterable[int], value: list[int]) -> list[int]:
    """The values of some literals."""
    return [value[x] if x > 0 else -value[-x] for x in lits]


class Known:
    """Facts as clauses by number, and what was shown to follow from them."""

    def __init__(self, facts: Iterable[Clause]) -> None:
        self.clauses: list[frozenset[int]] = []
        self._leaves: dict[str, int] = {}
        self._nodes: dict[tuple[int, ...], int] = {}
        for c in facts:
            self.clauses.append(self.literals(c))

    def literals(self, said: Clause) -> frozenset[int]:
        """A clause with numbers: leaves have them in order of appearance, and what stands for a conjunction or a
        disjunction is a new one, after clauses that say what it means."""
        text, names = said
        form, leaves, nodes = form_of(text, len(names)), self._leaves, self._nodes
        value = [0]
        for name in names:
            value.append(leaves.get(name) or leaves.setdefault(name, len(leaves) + len(nodes) + 1))
        for sign, lits in form.defs:
            args = [sign * x for x in values(lits, value)]
            node = nodes.get((sign, *args))
            if node is None:
                node = nodes[sign, *args] = len(leaves) + len(nodes) + 1
                self.clauses.append(frozenset((-sign * node, *args)))
                self.clauses.extend([frozenset((sign * node, -x)) for x in args])
            value.append(node)
        return frozenset(values(form.lits, value))

    def check(self, clause: Iterable[int], hints: list[int]) -> None:
        """With all of the clause false each hint leaves one literal that is true, and the last of them none."""
        false, clauses = set(clause), self.clauses
        need(min(hints, default=0) >= 0 and max(hints, default=-1) < len(clauses), "a hint names no clause")
        for h in hints:
            left = clauses[h] - false
            if not left:
                return
            if len(left) > 1:
                raise Rejected("a hint is not unit")
            for x in left:
                false.add(-x)
        raise Rejected("the hints do not lead to a contradiction")

    def lemma(self, line: str) -> None:
        """A clause that follows, and by what."""
        clause, _, hints = line.partition(":")
        said = list(map(int, clause.split()))
        need(
            all(0 < abs(x) <= len(self._leaves) + len(self._nodes) for x in said), "a literal of a lemma has no meaning"
        )
        self.check(said, list(map(int, hints.split())))
        self.clauses.append(frozenset(said))


# --- the whole -------------------------------------------------------------------------------------


def _missing(folder: Path, missing: list[str], of: int) -> tuple[bool, str]:
    """Whether every file is there; where the first that is not was looked for, and why there."""
    if not missing:
        return True, ""
    beside = all("/" not in path for path in missing)
    fix = (
        "copy the certificate whole" if beside else "put layout, outputs and certificate back as they lay to each other"
    )
    looked = f"{missing[0]} is not there (looked for at {(folder / missing[0]).resolve()})"
    are = "is" if len(missing) == 2 else "are"
    more = f", nor {are} {len(missing) - 1} more of the {of} files that manifest.json names, seen from its folder"
    return False, f"{looked}{more if missing[1:] else ''}: {fix}, or run `interlock certify` anew"


LARGEST = 1_000_000_000
"""Bytes of a file of a certificate at most (our choice)."""


def check_files(folder: Path) -> dict[str, bytes]:
    """The manifest's digests agree with the files; returns what was read, so that nothing is read twice."""
    need((folder / "manifest.json").is_file(), "no certificate: there is no manifest.json in this folder")
    raw = (folder / "manifest.json").read_bytes()
    manifest = json.loads(raw)
    need({*manifest} == {"schema", "layout", "tool", "files", "own"}, "manifest.json is of another kind")
    own = manifest.pop("own", None)
    need(own == hashlib.sha256(json.dumps(manifest, sort_keys=True).encode()).hexdigest(), "the manifest was changed")
    again = json.dumps({**manifest, "own": own}, indent=1, ensure_ascii=False) + "\n"
    need(again.encode() == raw, "the manifest was changed")
    files: dict[str, str] = manifest["files"]
    need({"system.txt", "proof.txt.xz"} <= set(files), "the manifest names no proof")
    alike = {unicodedata.normalize("NFC", path).casefold() for path in files}
    need(len(alike) == len(files), "two names of the manifest are one name on some computers")
    away = [path for path in files if PurePosixPath(path).is_absolute() or PureWindowsPath(path).anchor]
    need(not away, f"the manifest names {away[:1]}, which lies in no place of its own")
    need(*_missing(folder, [path for path in files if not (folder / path).exists()], len(files)))
    there = {path: folder / path for path in files if (folder / path).is_file()}  # no pipe, no device
    large = [path for path, file in there.items() if file.stat().st_size > LARGEST]
    need(not large, f"{large[:1]} has more bytes than any file of a certificate")
    found = {path: file.read_bytes() for path, file in there.items()}
    for path, digest in files.items():
        need(
            path in found and hashlib.sha256(found[path]).hexdigest() == digest,
            f"{path} is not the file proved: it was changed or written anew",
        )
    return found


def verify(folder: Path, files: dict[str, bytes] | None = None) -> str:
    """A summary in one line; raises Rejected, OSError or ValueError.  files: what `check_files` has read."""
    files = check_files(folder) if files is None else files
    system, reader = System(files["system.txt"].decode()), lzma.LZMADecompressor()
    proof = reader.decompress(files["proof.txt.xz"], 50_000_000 + 200 * len(files["system.txt"]))
    need(reader.eof, "proof.txt.xz is not whole, or larger than its system can need")
    lines = proof.decode().split("\n")
    need(lines[0] == "interlock-proof 4" and lines[-1] == "", "proof.txt is of another kind")
    start, steps = Known(system.initial), Known(system.steps)
    rest = iter(lines[1:-1])
    for goal, of_step in system.goals:
        known = steps if of_step else start
        clause = known.literals(goal)
        line = next(rest, None)
        while line is not None and ":" in line:
            known.lemma(line)
            line = next(rest, None)
        need(line is not None, "not every goal has its proof")
        known.check(clause, list(map(int, (line or "").split())))
        if of_step:
            known.clauses.append(clause)
    need(next(rest, None) is None, "proof.txt goes on after the last goal")
    return (
        f"the written system keeps its {len(system.claims)} claims at {sum(system.claims.values())} places"
        f"{', and P-START at the restart' if system.starts else ''}: "
        f"{system.invariants} invariants, {len(system.goals)} obligations, {len(files)} files"
    )


MALFORMED = (ValueError, LookupError, TypeError, AttributeError, ArithmeticError, lzma.LZMAError)
ERRORS = (Rejected, OSError, RuntimeError, MemoryError, *MALFORMED)
"""What a certificate that is not one may raise."""


def why(error: BaseException) -> str:
    """Why a certificate is rejected."""
    return str(error) if isinstance(error, Rejected) else f"{type(error).__name__}: {error}"


def judge(folder: str) -> tuple[bool, str]:
    """Whether a bundle is accepted, and its summary or the reason."""
    try:
        return True, verify(Path(folder))
    except ERRORS as error:
        return False, why(error)


def main(folders: list[str]) -> int:
    """Verify bundles; 0 when all are accepted."""
    good = 0
    for name in folders:
        accepted, text = judge(name)
        good += accepted
        print(f"{name}: {'ACCEPTED' if accepted else 'REJECTED'}  {text}")
    return 0 if good == len(folders) > 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
