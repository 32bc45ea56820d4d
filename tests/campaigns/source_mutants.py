"""Small changes of the source text that derives tables and controllers, and who notices them: nobody of the four
opinions of this project thought of these mutants.

Each mutant is one change of one place of one module (a comparison turned round, a condition left out, a branch taken
always or never, a statement deleted ...), made when a fresh process imports it.  That process derives the layouts
given below.  A mutant that changes no controller is *the same*.  Otherwise the first that objects is told: the front
end or the derivation with an error (*refused*), an exception (*broken*), the audit, the proof, or the second checker,
which reads the layout file itself.  What nobody objects to is listed.

python -m tests.campaigns.source_mutants --count 600 --results FILE > proofs/source_mutants.md
"""

from __future__ import annotations

import argparse
import ast
import copy
import hashlib
import importlib.machinery
import json
import platform
import random
import resource
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from os import cpu_count
from pathlib import Path
from typing import Any

import yaml

from tests.campaigns.origin import processor

ROOT = Path(__file__).resolve().parent.parent.parent
SOURCE = ROOT / "interlock"
REASONS = Path(__file__).with_suffix(".yaml")
ROOMS = (
    "frontend/resolve.py",
    "frontend/added.py",
    "frontend/overlaps.py",
    "frontend/places.py",
    "model/*.py",
    "derivation/*.py",
    "logic/lower/*.py",
)
LARGE = ("cn6502", "terminus_slip", "two_loops", "turning_loop", "swing", "branches", "mine11", "fig2_3_whole")
"""Layouts that are left out: each takes seconds, and others have what they have."""
PROVED_AT_MOST = 12
"""Layouts whose changed controller is proved and checked, for one mutant; which, is drawn anew for each."""
SECONDS, BYTES = 300, 6 << 30

FLIPPED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
}


# --- mutants of a module -------------------------------------------------------------------------


@dataclass(frozen=True)
class Mutation:
    """One change of a syntax tree: where, what stands there and what is put in its place, and how to do it."""

    line: int
    what: str
    make: Callable[[], None]


def mutations(tree: ast.AST) -> list[Mutation]:
    """Every mutation of a module, in the order of the text; annotations and texts are left alone."""
    found: list[Mutation] = []
    for field, value in ast.iter_fields(tree):
        if field in ("annotation", "returns", "decorator_list"):
            continue
        children = enumerate(value) if isinstance(value, list) else [(None, value)]
        for at, child in children:
            if isinstance(child, ast.AST):
                found += (_put(tree, field, at, child, kind, new) for kind, new in _instead(child))
                found += mutations(child)
    return found


def _put(parent: ast.AST, field: str, at: int | None, old: ast.AST, kind: str, new: ast.AST) -> Mutation:
    def make() -> None:
        if at is None:
            setattr(parent, field, new)
        else:
            getattr(parent, field)[at] = new

    line = next((n.lineno for n in ast.walk(old) if hasattr(n, "lineno")), 0)
    return Mutation(line, f"{kind}: `{_short(old)}` -> `{_short(new)}`", make)


def _short(node: ast.AST) -> str:
    return " ".join(ast.unparse(node).split())[:80]


def _instead(x: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    """What may stand in the place of a node."""
    match x:
        case ast.Compare(left=left, ops=[op], comparators=others) if type(op) in FLIPPED:
            yield "comparison", ast.Compare(left, [FLIPPED[type(op)]()], others)
        case ast.BoolOp(op=op, values=values):
            for k in range(len(values)):
                rest = values[:k] + values[k + 1 :]
                yield "left out", ast.BoolOp(op, rest) if len(rest) > 1 else rest[0]
            yield "and, or", ast.BoolOp(ast.Or() if isinstance(op, ast.And) else ast.And(), values)
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            yield "not", operand
        case ast.IfExp(body=body, orelse=orelse):
            yield "always", body
            yield "never", orelse
        case ast.If():
            yield "always", _with(x, test=ast.Constant(True))
            yield "never", _with(x, test=ast.Constant(False))
        case ast.comprehension(ifs=ifs):
            for k in range(len(ifs)):
                yield "filter", _with(x, ifs=ifs[:k] + ifs[k + 1 :])
        case ast.Constant(value=bool(value)):
            yield "constant", ast.Constant(not value)
        case ast.Constant(value=int(value) | float(value)):
            yield "number", ast.Constant(value + 1)
            yield "number", ast.Constant(value - 1)
        case ast.BinOp(left=left, op=ast.BitOr() | ast.Add() | ast.Sub() | ast.BitAnd(), right=right):
            yield "left out", left
            yield "left out", right
        case ast.Continue():
            yield "jump", ast.Break()
        case ast.Break():
            yield "jump", ast.Continue()
        case ast.AugAssign() | ast.Expr(value=ast.Call() | ast.Yield() | ast.YieldFrom()):
            yield "deleted", ast.Pass()
        case ast.Tuple(elts=elts, ctx=ast.Load()) | ast.Set(elts=elts) if any(isinstance(e, ast.Starred) for e in elts):
            for k in range(len(elts)):
                yield "left out", _with(x, elts=elts[:k] + elts[k + 1 :])


def _with(x: ast.AST, **fields: Any) -> ast.AST:
    new = copy.copy(x)
    for name, value in fields.items():
        setattr(new, name, value)
    return new


def install(module: str, number: int) -> Mutation:
    """Make the mutation when the module (a path below the package) is imported."""
    path = SOURCE / module
    tree = ast.parse(path.read_text("utf-8"))
    mutation = mutations(tree)[number]
    mutation.make()
    changed = compile(ast.fix_missing_locations(tree), str(path), "exec")
    plain = importlib.machinery.SourceFileLoader.get_code

    def get_code(self: importlib.machinery.SourceFileLoader, name: str) -> Any:
        return changed if Path(self.path) == path else plain(self, name)

    importlib.machinery.SourceFileLoader.get_code = get_code  # type: ignore[method-assign]
    return mutation


# --- one mutant ----------------------------------------------------------------------------------


def layouts() -> list[Path]:
    """The layouts that each mutant derives."""
    found = [*(ROOT / "layouts").glob("*.yaml"), *(ROOT / "tests" / "layouts_for_tests").glob("*.yaml")]
    return sorted(p for p in found if p.stem not in LARGE)


def behaviour(controller: Any) -> dict[str, str]:
    """What a controller does, equation by equation; the order of operands does not matter, nor does any note."""
    from interlock.logic.controller import Timer

    known: dict[int, str] = {}

    def form(x: Any) -> str:
        if id(x) not in known:
            parts = sorted(form(a) for a in x.args)
            text = f"{int(x.op)}({','.join(parts)})" if parts else str(x)
            known[id(x)] = text if len(text) < 99 else hashlib.sha256(text.encode()).hexdigest()
        return known[id(x)]

    found = {f"input {i.name}": f"{i.size} {i.restrictive}" for i in controller.inputs}
    found |= {f"initial {s.name}": str(s.initial) for s in controller.state}
    for s in controller.steps:
        found[f"{s.name}"] = f"TON {s.input} {s.preset_ms}" if isinstance(s, Timer) else form(s.expr)
    found |= {f"next {e.name}": form(e.expr) for e in controller.next}
    found |= {f"output {o.name}": f"{form(o.expr)} {o.restrictive}" for o in controller.outputs}
    for w in controller.words.words:
        found[f"word {w.name}"] = " ".join(f"{form(c.condition)}:{c.value}" for c in w.cases) + f" {w.otherwise}"
    return found


def derived(path: Path) -> tuple[Any, dict[str, str] | str]:
    """A checked file with what its controller does, or with the errors for which it has none."""
    from interlock.app.check import derive_file
    from interlock.diag import Severity
    from interlock.logic.lower import lower

    found = derive_file(str(path))
    if not found.ok or found.layout is None or found.table is None:
        return found, " ".join(sorted({d.code for d in found.diagnostics if d.severity is Severity.ERROR}))
    return found, behaviour(lower(found.layout, found.table))


def noticed(base: Mapping[str, dict[str, str] | str]) -> dict[str, Any]:
    """Who notices the mutant that is installed, and what nobody notices."""
    from interlock.app.check import second_opinion

    changed: list[tuple[Path, Any, list[str]]] = []
    for path in layouts():
        before = base[path.stem]
        try:
            found, after = derived(path)
            if after == before:
                continue
            if isinstance(after, str):
                return {"by": "refused", "where": f"{path.stem}: {after}"}
            if isinstance(before, str):
                changed.append((path, found, [f"no longer refused: {before}"]))
            elif objections := second_opinion(found):
                return {"by": "audit", "where": f"{path.stem}: {len(objections)} objections"}
            else:
                names = sorted(n for n in {*before, *after} if before.get(n) != after.get(n))
                changed.append((path, found, names))
        except Exception as e:
            return {"by": "broken", "where": f"{path.stem}: {type(e).__name__}"}
    if not changed:
        return {"by": "the same"}
    drawn = random.Random(str(changed[0][2])).sample(changed, min(len(changed), PROVED_AT_MOST))
    for path, found, _ in drawn:
        if by := _refuted(path, found):
            return by
    told = [f"{p.stem}: {', '.join(n[:4])}{' ...' if len(n) > 4 else ''} ({len(n)})" for p, _, n in changed[:3]]
    return {"by": "nobody", "where": "; ".join(told), "layouts": len(changed), "judged": len(drawn)}


def _refuted(path: Path, found: Any) -> dict[str, Any] | None:
    """By whom, of proof and second checker, if by one."""
    from interlock.app.prove import prove_derived
    from interlock.checker.check import agree
    from interlock.checker.specification import shipped
    from interlock.proof.induction.verdict import Verdict, quiet
    from tests.written import told

    try:
        proved = prove_derived(found, None, quiet)[0]
        if not proved.green:
            claims = proved.proof.claims if proved.proof is not None else ()
            open_ = [c.id for c in claims if c.verdict is not Verdict.PROVED]
            return {"by": "proof", "where": f"{path.stem}: {' '.join(open_) or 'text'}"}
    except Exception as e:
        return {"by": "broken", "where": f"{path.stem}: {type(e).__name__}"}
    try:
        left = agree(*told(path.read_text("utf-8")), shipped()).left
    except Exception as e:
        left = (f"{type(e).__name__}: {e}",)
    return {"by": "checker", "where": f"{path.stem}: {left[0][:160]}"} if left else None


# --- all of them ---------------------------------------------------------------------------------


def drawn(count: int, seed: int) -> list[tuple[str, int]]:
    """So many mutants by module and number, at random from all."""
    modules = sorted({p for room in ROOMS for p in SOURCE.glob(room)})
    every = [
        (p.relative_to(SOURCE).as_posix(), n)
        for p in modules
        for n in range(len(mutations(ast.parse(p.read_text("utf-8")))))
    ]
    random.Random(seed).shuffle(every)
    print(f"{len(every)} mutants of {len(modules)} modules", file=sys.stderr)
    return every[:count]


def one(module: str, number: int, base: Path) -> None:
    """In a process of its own: what becomes of one mutant, as a line of JSON; with number -1 of the source as it is."""
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    if number < 0:
        base.write_text(json.dumps({p.stem: derived(p)[1] for p in layouts()}), "utf-8")
        return
    mutation = install(module, number)
    told = {"module": module, "number": number, "line": mutation.line, "what": mutation.what}
    try:
        told |= noticed(json.loads(base.read_text("utf-8")))
    except Exception as e:  # when it is imported
        told |= {"by": "broken", "where": type(e).__name__}
    print(json.dumps(told))


def carried_out(todo: list[tuple[str, int]], results: Path) -> list[dict[str, Any]]:
    """The results of mutants, those that a file has already and those that are added to it."""
    known = [json.loads(x) for x in results.read_text("utf-8").splitlines()] if results.exists() else []
    have = {(x["module"], x["number"]) for x in known}
    base = results.with_suffix(".base.json")
    command = [sys.executable, "-m", "tests.campaigns.source_mutants", "--base", str(base), "--one"]
    subprocess.run([*command, "", "-1"], cwd=ROOT, check=True)
    for module, number in todo:
        if (module, number) in have:
            continue
        try:
            run = subprocess.run(
                [*command, module, str(number)], cwd=ROOT, capture_output=True, text=True, timeout=SECONDS
            )
            told = json.loads(run.stdout)
        except (subprocess.TimeoutExpired, json.JSONDecodeError) as e:
            told = {"module": module, "number": number, "by": "broken", "where": type(e).__name__}
        known.append(told)
        with results.open("a", encoding="utf-8") as out:
            print(json.dumps(told), file=out, flush=True)
    wanted = set(todo)
    return [x for x in known if (x["module"], x["number"]) in wanted]


ORDER = ("the same", "refused", "broken", "audit", "proof", "checker", "nobody")
HEAD = """# Small changes of the source, and who notices them

`python -m tests.campaigns.source_mutants --count {count}` at commit {commit}, {processor}, {cores} cores.

{explained}

{count} mutants drawn at random; {changing} of them change what some layout's controller does, or stop it, and
{left} of these are noticed by nobody.

| room | {columns} |
|---|{rule}|
{rows}
"""
EXPLAINED = """One change of one place of one module each, made when a fresh process imports it; {layouts} layouts.
*The same*: no controller changes.  Otherwise the first that objects: an error of front end or derivation
(*refused*), an exception (*broken*), the *audit*, the *proof*, or the second *checker*, which reads the layout file
itself."""


def page(found: list[dict[str, Any]]) -> str:
    """The table, and what nobody noticed."""
    commit = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    rooms: dict[str, Counter[str]] = {}
    for x in found:
        room = x["module"] if x["module"].startswith("frontend/") else x["module"].rsplit("/", 1)[0]
        rooms.setdefault(room, Counter())[x["by"]] += 1
    total = sum(rooms.values(), Counter())
    rows = [
        f"| {r} | {' | '.join(str(c[o]) for o in ORDER)} |" for r, c in [*sorted(rooms.items()), ("**all**", total)]
    ]
    text = HEAD.format(
        count=len(found),
        commit=commit.stdout.strip(),
        processor=f"{processor()} ({platform.machine()})",
        cores=cpu_count(),
        explained=EXPLAINED.format(layouts=len(layouts())),
        changing=len(found) - total["the same"],
        left=total["nobody"],
        columns=" | ".join(ORDER),
        rule="|".join("---" for _ in ORDER),
        rows="\n".join(rows),
    )
    left = [x for x in found if x["by"] == "nobody"]
    reasons = {(x["module"], x["what"]): x["because"] for x in yaml.safe_load(REASONS.read_text("utf-8"))}
    if left:
        text += "\nWhat nobody noticed:\n\n" + "\n".join(
            f"- `{x['module']}`, line {x['line']}, {x['what']}: {x['layouts']} layouts ({x['where']}).  "
            + reasons.get((x["module"], x["what"]), "**Not explained.**")
            for x in sorted(left, key=lambda x: (x["module"], x["line"]))
        )
        text += "\n"
    return text


def main() -> int:
    """One mutant, or so many and the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=600)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--results", type=Path, default=Path("source_mutants.jsonl"), help="kept, and gone on with")
    parser.add_argument("--one", nargs=2, metavar=("MODULE", "NUMBER"), help="one mutant, for the command itself")
    parser.add_argument("--base", type=Path)
    args = parser.parse_args()
    if args.one:
        one(args.one[0], int(args.one[1]), args.base)
        return 0
    print(page(carried_out(drawn(args.count, args.seed), args.results)), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
