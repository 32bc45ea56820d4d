"""Make the library of shapes that ships with the package: `python -m tests.campaigns.shape_library [LAYOUT ...]`.

Every shape that the certificates of at least two of the layouts use is kept (default: the shipped ones, a line of
stations and a yard): what railways have in common, not what one of them has alone.  What no longer occurs is dropped.
With `--anew` the shapes that ship now are not looked at: what they say in many facts may be said in fewer.  The layouts
are done on as many processes as `-j` says.
"""

from __future__ import annotations

import argparse
import lzma
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

from interlock.app.check import check_file
from interlock.app.init import line, yard
from interlock.logic.lower import lower
from interlock.proof.certificate.engine import prove_locally
from interlock.proof.certificate.facts import FactBase
from interlock.proof.certificate.library import SHIPPED, Library
from interlock.proof.certificate.shapes import Shape
from interlock.proof.claims import Facts, claims, strengthening
from interlock.proof.prover import start_claim
from interlock.proof.system.transition import System


def used(path: str, anew: bool) -> tuple[str, list[tuple[Shape, str]], int, float]:
    """The shapes of a layout's certificate with how to find them again, how many were new, and the seconds."""
    checked = check_file(path)
    assert checked.layout is not None and checked.table is not None, path
    system = System(checked.layout, lower(checked.layout, checked.table))
    facts = Facts(system)
    base = FactBase(system, strengthening(facts), claims(facts), start_claim(system))
    began = time.perf_counter()
    proof = prove_locally(base, Library() if anew else Library.shipped())
    assert not proof.open, (path, proof.open[0])
    found = list({(o.shape.number, o.hint): (o.shape, o.hint) for o in proof.obligations}.values())
    return path, found, proof.solved, time.perf_counter() - began


def main() -> None:
    """Write the library."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("layouts", nargs="*")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--anew", action="store_true")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("line6", line(6)), ("yard4", yard(4))):
            Path(folder, f"{name}.yaml").write_text(text)
        layouts = given.layouts or sorted(map(str, [*Path("layouts").glob("*.yaml"), *Path(folder).glob("*.yaml")]))
        write(layouts, given.j, given.anew)


def write(layouts: list[str], jobs: int, anew: bool) -> None:
    """The library of what the layouts use."""
    library = Library()
    every: dict[int, tuple[Shape, set[str]]] = {}
    where: dict[int, set[str]] = {}
    with ProcessPoolExecutor(jobs) as pool:
        for path, found, new, seconds in pool.map(partial(used, anew=anew), layouts):
            for shape, hint in found:
                mine = library.add(shape)
                every.setdefault(id(mine), (mine, set()))[1].add(hint)
                where.setdefault(id(mine), set()).add(path)
            print(f"{path}: {len({s.number for s, _ in found})} shapes, {new} of them new, {seconds:.1f} s", flush=True)
    kept = {k: x for k, x in every.items() if len(where[k]) > 1}
    data = lzma.compress(library.text(list(kept.values())).encode(), preset=9 | lzma.PRESET_EXTREME)
    SHIPPED.write_bytes(data)
    goals = len({s.goal for s, _ in kept.values()})
    print(f"{SHIPPED.name}: {len(kept)} of {len(every)} shapes, of {goals} goals, {len(data) / 2**20:.2f} MiB")


if __name__ == "__main__":
    main()
