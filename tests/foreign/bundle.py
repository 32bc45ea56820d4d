"""A layout's outputs as `interlock compile` writes them, and the railway in which its runtime is recorded."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from interlock.app.check import derive_file
from interlock.app.prove import prove_derived
from interlock.logic.cabinet import allocate
from interlock.logic.lower import lower
from interlock.model.portable import portable
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import quiet
from tests.foreign.recording import Railway

XML = ("plcopen", "codesys")


@dataclass(frozen=True)
class Bundle:
    """What a proved layout's users get: the portable Structured Text as one text (the interlocking, point telegrams
    where the layout has them, the mapping program), the PLCopen files by name; and the railway."""

    name: str
    routes: int
    source: str
    xml: dict[str, str]
    railway: Railway


def bundle(path: str) -> Bundle:
    """Raises ValueError when the layout is not proved: nothing is written for it then."""
    derived = derive_file(path)
    proved, files = prove_derived(derived, Limits(), quiet, XML)
    layout, table = derived.layout, derived.table
    if not proved.green or layout is None or table is None:
        raise ValueError(f"{path} is not proved")
    texts = {name: data.decode() for name, data in files.items()}
    controller = lower(layout, table)
    routes: dict[str, tuple[int, ...]] = {}
    for r in table.routes:
        routes[str(r.entry)] = (*routes.get(str(r.entry), ()), r.number)
    place = f"st/iec/{portable(layout.name)}"  # as it is called in PLC text
    telegram = texts.get(f"{place}_telegram.st")
    parts = (texts[f"{place}.st"], *((telegram,) if telegram else ()), texts[f"{place}_io.st"])
    return Bundle(
        Path(path).stem,
        len(table.routes),
        "\n".join(parts),
        {name: text for name, text in texts.items() if name.endswith(".xml")},
        Railway(layout, controller, allocate(layout, controller), texts["runtime.py"], routes, controller.words.routes),
    )
