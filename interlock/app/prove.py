"""Prove a layout's controller, and that the text that would be emitted equals it; or find that it was proved before."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from interlock.app import kept
from interlock.app.check import Checked, audited, derive_file, second_opinion
from interlock.app.proved import Proved
from interlock.proof.engines.limits import Limits
from interlock.proof.engines.pool import Begun
from interlock.proof.induction.verdict import Progress, quiet


def prove_file(path: str, limits: Limits | None = None, progress: Progress = quiet) -> Proved:
    """Check a file and prove its controller and the text that would be emitted."""
    began = time.monotonic()
    progress("deriving", 0, 0)
    proved = prove_derived(derive_file(path), limits, progress, keep=False)[0]
    return replace(proved, seconds=time.monotonic() - began)


def prove_derived(
    derived: Checked, limits: Limits | None, progress: Progress, dialects: Sequence[str] = (), keep: bool = True
) -> tuple[Proved, dict[str, bytes]]:
    """The proof of a layout, and its texts: the portable one, the runtime, and what other dialects are asked for; each
    is read back and compared, and given back if `keep`.  The audit, the texts and the proof are done beside each other.
    """
    if not derived.ok or derived.layout is None or derived.table is None:
        return Proved(derived), {}
    layout, table, limits = derived.layout, derived.table, limits or Limits()
    with Begun([partial(second_opinion, derived)], min(limits.jobs - 1, 1)) as audit:
        name = ""
        if limits.cache.folder is not None and not keep:
            name = kept.name(limits, layout, table)
            good = kept.look(limits.cache, name)
            if good is not None:
                checked = audited(derived, audit.results()[0])
                return Proved(checked, *(good if checked.ok else ())), {}
        from interlock.app.making import Wanted, make  # the solvers, which a kept proof does without

        wanted = Wanted(limits, progress, dialects, keep)
        proved, files = make(derived, layout, table, lambda: audit.results()[0], wanted)
    if name:
        kept.keep(limits.cache, name, proved)
    return proved, files
