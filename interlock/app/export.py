"""The system of a layout in the formats of other engines, and its registers for a SCADA."""

from __future__ import annotations

from interlock.app.alarms import listed, possible
from interlock.app.check import Checked, check_file
from interlock.field.operator_place import registers
from interlock.logic.cabinet import allocate
from interlock.logic.expr import interning
from interlock.logic.lower import lower
from interlock.proof.certificate.aiger import aiger
from interlock.proof.claims import Facts, claims
from interlock.proof.system.transition import System


def registers_file(path: str) -> tuple[Checked, bytes | None]:
    """The table of the registers of the operator's place on Modbus; None when the layout has errors."""
    checked = check_file(path)
    if not checked.ok or checked.layout is None or checked.table is None:
        return checked, None
    with interning():
        controller = lower(checked.layout, checked.table)
        alarms = possible(checked.layout, controller, allocate(checked.layout, controller))
        return checked, registers(controller, listed(alarms)).csv().encode()


def aiger_file(path: str) -> tuple[Checked, bytes | None]:
    """The layout's system with all claims as one bad output; None when the layout has errors."""
    checked = check_file(path)
    if not checked.ok or checked.layout is None or checked.table is None:
        return checked, None
    with interning():
        system = System(checked.layout, lower(checked.layout, checked.table))
        return checked, aiger(system, claims(Facts(system)))
