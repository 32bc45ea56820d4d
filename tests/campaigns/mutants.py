"""The mutation campaign as a table: `python -m tests.campaigns.mutants > proofs/mutants.md`."""

from __future__ import annotations

import argparse
import sys
from concurrent.futures import ProcessPoolExecutor

from interlock.app.check import check_file
from interlock.proof.engines.limits import Limits
from interlock.proof.mutation.movements import Fate, Outcome, run_mutants
from interlock.proof.mutation.weakenings import KINDS
from tests.campaigns.origin import origin

LAYOUTS = (
    "layouts/fig2_3_split.yaml",
    "tests/layouts_for_tests/flank_point.yaml",
    "layouts/junction.yaml",
    "layouts/passing_loop.yaml",
    "tests/layouts_for_tests/shunt_yard.yaml",
    "tests/layouts_for_tests/devices.yaml",
    "tests/layouts_for_tests/overlaps.yaml",
    "tests/layouts_for_tests/foul_joint.yaml",
    "tests/layouts_for_tests/driven.yaml",
)
# where kinds have their mutants that have none on the others
MORE = {
    "layouts/heishan.yaml": ("zone-not-checked", "zone-miscounted"),
    "layouts/pit_bottom.yaml": ("fault-ignored",),
    "layouts/flank_lab.yaml": ("flank-space-not-checked", "swing-before-train", "swing-at-once"),
    "tests/layouts_for_tests/closing.yaml": (
        "closes-late",
        "stays-open",
        "open-while-released",
        "passing-not-supervised",
    ),
    "tests/layouts_for_tests/token.yaml": tuple(k.name for k in KINDS if k.name.startswith("direction-")),
    "tests/layouts_for_tests/swing.yaml": tuple(k.name for k in KINDS if k.name.startswith("swing-")),
    "tests/layouts_for_tests/overlap_flank.yaml": ("overlap-flank-not-held",),
    "tests/layouts_for_tests/indicator.yaml": ("route-not-indicated",),
    "tests/layouts_for_tests/two_before.yaml": ("approach-not-asked",),
    "tests/layouts_for_tests/berth_before.yaml": ("arrived-unseen", "arrived-running", "order-not-asked"),
    "tests/layouts_for_tests/speeds.yaml": ("speed-too-high", "speed-not-shown"),
    "tests/layouts_for_tests/bare_signal.yaml": ("excluded-offered",),
    "tests/layouts_for_tests/trap_beyond.yaml": ("trap-entered",),
    "tests/layouts_for_tests/no_calling_on.yaml": ("entrance-left-by",),
    "tests/layouts_for_tests/boards.yaml": ("board-passed",),
    "tests/layouts_for_tests/identifier.yaml": tuple(k.name for k in KINDS if k.name.startswith("identifier-")),
    "tests/layouts_for_tests/entry_speeds.yaml": ("entry-speed-forgotten",),
    "tests/layouts_for_tests/overlap_inside.yaml": ("overlap-inside", "entry-speed-forgotten", "overlap-not-held"),
    "tests/layouts_for_tests/clear_beyond.yaml": ("added-not-clear",),
    "tests/layouts_for_tests/called_on.yaml": ("added-to-called-on-forgotten",),
    "tests/layouts_for_tests/air_lock_doors.yaml": ("door-beside-open", "doors-at-once"),
    "tests/layouts_for_tests/overlap_past_signals.yaml": (
        "overlap-beside",
        "overlap-let-go",
        "overlap-under-train",
        "overlap-free-of-one",
    ),
    "tests/layouts_for_tests/overlap_past_both_ways.yaml": (
        "overlap-beside",
        "overlap-let-go",
        "overlap-under-train",
        "overlap-free-of-one",
    ),
    "tests/layouts_for_tests/held_apart.yaml": tuple(k.name for k in KINDS if k.name.startswith(("held-", "hold-"))),
    "tests/layouts_for_tests/added.yaml": ("declared-not-excluded", "added-point-not-detected", "added-let-go"),
}

FATES = (Fate.KILLED, Fate.STRICT, Fate.REDUNDANT)
"""The columns of the table; those of mutated texts are no fate of a mutated controller."""


def one_kind(path: str, kind: str, sample: int, seconds: float) -> list[Outcome]:
    """The mutants of one kind on one layout."""
    checked = check_file(path)
    assert checked.layout is not None and checked.table is not None
    limits = Limits(search_depth=20, search_s=seconds)
    return list(run_mutants(checked.layout, checked.table, sample, limits, only=(kind,)))


def main() -> int:
    """Run the campaign and print the table; 1 where a kind has no mutant, so that nothing is shown of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sample", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=40.0)
    parser.add_argument("-j", "--jobs", type=int, default=2)
    args = parser.parse_args()
    jobs = [(path, kind.name, args.sample, args.seconds) for kind in KINDS for path in LAYOUTS]
    jobs += [(path, kind, args.sample, args.seconds) for path, kinds in MORE.items() for kind in kinds]
    found: dict[str, list[tuple[str, Outcome]]] = {k.name: [] for k in KINDS}
    with ProcessPoolExecutor(args.jobs) as pool:
        for (path, kind, *_), outcomes in zip(jobs, pool.map(one_kind, *zip(*jobs, strict=True)), strict=True):
            name = path.split("/")[-1].removesuffix(".yaml")
            found[kind] += [(name, o) for o in outcomes]
            print(".", end="", file=sys.stderr, flush=True)
    print("# Mutants\n")
    print(
        f"`python -m tests.campaigns.mutants --sample {args.sample} --seconds {args.seconds:g}` "
        f"{origin()}.  Layouts: {', '.join(p.split('/')[-1] for p in (*LAYOUTS, *MORE))}; "
        f"of each kind up to {args.sample} evenly spread places on each.\n"
    )
    print(
        "*Movement*: a claim fails, and a run from the restart to harm was found.  *Strict*: a claim no longer "
        "follows, but no run was found in 20 scans and the time given.  *Redundant*: every claim is still proved.\n"
    )
    print("| kind | weakening | movement | strict | redundant | claims that fail (first found first) | example |")
    print("|---|---|---|---|---|---|---|")
    for kind in KINDS:
        outcomes = found[kind.name]
        counts = [sum(o.fate is f for _, o in outcomes) for f in FATES]
        claims: dict[str, int] = {}
        for _, o in outcomes:
            for c in o.claims[:1] if o.fate is Fate.KILLED else o.claims[:2]:
                claims[c] = claims.get(c, 0) + 1
        example = next((f"{n}: {o.place}" for n, o in outcomes if o.fate is Fate.KILLED), "")
        example = example or next((f"{n}: {o.place}" for n, o in outcomes), "")
        print(f"| {kind.name} | {kind.text} | {' | '.join(map(str, counts))} | {', '.join(claims)} | {example} |")
    every = [o.fate for outcomes in found.values() for _, o in outcomes]
    total = [every.count(f) for f in FATES]
    print(
        f"\n{len(every)} mutants: {total[0]} killed by a train movement, {total[1]} killed without a movement found, "
        f"{total[2]} shown redundant, {len(every) - sum(total)} survived."
    )
    without = [k.name for k in KINDS if not found[k.name]]
    if without:
        print(f"no layout of the list has a mutant of these kinds: {', '.join(without)}", file=sys.stderr)
    return 1 if without else 0


if __name__ == "__main__":
    sys.exit(main())
