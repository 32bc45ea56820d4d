"""A name has a family and what it stands at; its text is made in one module, and nobody takes it apart."""

from __future__ import annotations

import ast
import pickle
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from interlock.logic import names
from interlock.logic.names import Form, Kind, Name, each, families, of_block, spelled
from interlock.proof.system.transition import System
from tests.layouts import built

APART = {"split", "rsplit", "partition", "rpartition", "startswith", "endswith", "removeprefix", "removesuffix"}
MATCHING = {"compile", "match", "fullmatch", "search", "findall", "finditer", "sub", "subn"}
ROOMS = ("logic", "proof", "sim", "st", "emit")

READ = {
    "logic/naming.py": "the patterns of families",
    "logic/cabinet.py": "addresses that the layout states",
    "proof/witnesses/availability.py": "reasons why a run fails",
    "proof/engines/cache.py": "files of the cache",
    "proof/engines/z3_sat.py": "models of Z3",
    "proof/certificate/refute.py": "proofs of a solver",
    "proof/mutation/weakenings.py": "lists of families, as they stand in this module",
    "proof/mutation/judge.py": "ids of claims",
    "proof/equivalence/python_text.py": "the emitted runtime",
    "proof/equivalence/c_text.py": "the emitted C",
    "emit/c99/runtime.py": "names of files",
    "proof/induction/story.py": "ids of claims, notes of inputs",
    "proof/mutation/texts.py": "emitted texts",
    "st/dialects/dialect.py": "names of blocks",
    "st/dialects/plcopen.py": "names of blocks, XML",
    "st/dialects/codesys.py": "names of blocks, XML",
    "logic/at_stop.py": "sentences",
    "logic/kept_locked.py": "sentences",
    "st/dialects/strict.py": "rules of XML",
    "st/dialects/twincat.py": "printed texts",
    "st/dialects/siemens.py": "names of blocks and files, printed texts",
    "st/dialects/awl.py": "printed texts",
    "st/dialects/ladder.py": "names of blocks, XML",
    "st/dialects/classic.py": "names of blocks and files",
    "st/shared.py": "names of blocks, and of terminals with their station",
    "st/structures.py": "names of blocks",
    "st/index.py": "names of blocks, and of terminals with their station",
    "st/dialects/symbols.py": "addresses and notes in a table of symbols",
    "proof/equivalence/tags.py": "names with their station, and addresses, in a table of tags",
    "st/lint.py": "names as a PLC tool takes them",
    "st/meaning.py": "paths of instances in a text",
    "st/parser.py": "Structured Text",
    "emit/report/drawn.py": "pictures",
    "emit/bundle.py": "names of files",
    "emit/python/runtime.py": "how names of a family are written",
    "st/printer.py": "lines that end with a comment",
    "emit/report/page.py": "names of files",
    "emit/io/lists.py": "elements of which a word speaks",
    "emit/tables/schema.py": "where a field stands in a value",
    "emit/tables/paper.py": "cells of printed tables",
    "emit/drawing/canvas.py": "names of machines and points, as they are printed",
    "emit/drawing/sheets.py": "parts of a picture",
}
"""Modules that take texts apart, and which; none of these texts is the name of a variable."""


def taken_apart(tree: ast.AST) -> Iterator[int]:
    """Lines in which a text is taken apart: by a method or a regular expression, or by the place of its letters."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            of = node.func.value
            if node.func.attr in APART or (isinstance(of, ast.Name) and of.id == "re" and node.func.attr in MATCHING):
                yield node.lineno
        if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Attribute) and node.value.attr == "name":
            yield node.lineno


def test_no_name_is_taken_apart() -> None:
    root = Path(names.__file__).parents[1]
    found = {
        str(path.relative_to(root)): lines
        for room in ROOMS
        for path in sorted((root / room).rglob("*.py"))
        if (lines := sorted(taken_apart(ast.parse(path.read_text("utf-8")))))
    }
    assert found.keys() == READ.keys(), {f: found.get(f) for f in found.keys() ^ READ.keys()}


@pytest.mark.parametrize("layout", ["terminus_slip", "heishan", "incline_hoist", "crossing_line", "flank_lab"])
def test_every_name_of_a_system_is_made_of_its_fields(layout: str) -> None:
    found, _, controller = built(layout)
    system = System(found, controller)
    elements = {
        Kind.SECTION: {str(s.id) for s in found.track.sections}
        | {names.outside(b.node) for b in found.track.boundaries},
        Kind.MACHINE: {str(m) for m in found.machines},
        Kind.SIGNAL: {str(g.id) for g in found.signalling.signals} | {str(x.id) for x in found.signalling.distants},
        Kind.ROUTE: {str(r.number) for r in controller.symbols.routes},
    }
    computed = {e.name: e.group for e in (*controller.equations, *controller.next)}
    for name in (*system.relation.state, *system.relation.definitions, *system.relation.inputs):
        assert isinstance(name, Name) and name.family.key
        plain = name
        while plain.form is not None:
            plain = plain.base
        assert plain == plain.family(*plain.at) and plain.family is name.family
        owner = name.owner
        if owner is not None and owner.kind in elements:
            assert owner.id in elements[owner.kind]
        group = computed.get(name, "")
        if owner is not None and owner.kind in (Kind.SECTION, Kind.SIGNAL, Kind.OVERLAP, Kind.ZONE, Kind.LINE):
            assert group in ("", str(owner), "alarms")
    assert all(system.relation.later[n] is n.next and n.next.base is n and n.next.primed for n in system.relation.state)


def test_names_that_are_made_of_others() -> None:
    lock = names.LOCK("q-1", 2)
    assert (lock, lock.at, str(lock.owner), lock.head, lock.sort) == ("L_q_1_2", ("q-1", 2), "section q-1", "L", "L")
    assert lock is names.LOCK("q-1", 2) and lock.next is lock.next and lock.next == "L_q_1_2'"
    assert (lock.next.owner, lock.next.base, lock.next.head) == (lock.owner, lock, "L'")
    assert names.choice(names.HEAD("J|1", "q1")) == "?head.J|1.q1"
    assert names.covered(names.APPROACH_OVER("X1")) == "cov.AT_X1"
    speed = names.SPEED_ASPECT("N8", 40)
    assert (speed, speed.head, speed.sort) == ("YV40_N8", "YV40", "YV")
    any_route = each(names.ACTIVE(3))
    assert any_route == each(names.ACTIVE(12)) != each(names.ACTIVE(3).next)
    assert any_route.indexed and of_block(any_route, 4).base is any_route and of_block(any_route, 4).at == (4,)


def test_names_survive_a_process() -> None:
    some = [names.VALID, names.LOCK("q1", 2), names.ACTIVE(3).next, names.choice(names.PARTS("q1")), spelled("x")]
    for name in some:
        again = pickle.loads(pickle.dumps(name))
        assert (again, again.family, again.at, again.form) == (name, name.family, name.at, name.form)


def test_families_are_told_apart() -> None:
    """No two families of one kind are written alike, and every one of them says what it means."""
    written = [(f.kind, f.pattern) for f in families()]
    assert len(set(written)) == len(written) > 150
    assert all(f.meaning and f.key.isupper() for f in families())
    assert Form.NEXT.value == "{}'"


def test_a_process_that_has_made_no_name_reads_names() -> None:
    sent = [names.LOCK("q1", 2), names.VALID, names.choice(names.STUCK("a")), names.LOCK("q1", 2).next, names.NONE]
    code = "import pickle, sys; print([x.family.key for x in pickle.loads(sys.stdin.buffer.read())])"
    read = subprocess.run([sys.executable, "-c", code], input=pickle.dumps(sent), capture_output=True, check=True)
    assert read.stdout.decode().strip() == "['LOCK', 'VALID', 'STUCK', 'LOCK', '']"
