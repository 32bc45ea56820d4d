"""Point telegrams: bytes that their tag does not tell apart, machines with a gap between starts.  IL3046, IL3047."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout

TOLD_APART = 4
"""Bytes that a tag of two bits tells apart."""
IN_A_BYTE = 3
"""Points in a tagged byte."""


def check_telegram(ctx: Context, layout: Layout) -> None:
    """What a telegram of the points that are driven cannot do."""
    form, still = layout.hardware.telegram, {*layout.machines.device, *layout.machines.by_hand}
    driven = [m for m in layout.machines if m not in still]
    if form is TelegramForm.NONE or not driven:
        return
    count = -(-len(driven) // IN_A_BYTE)
    if form is TelegramForm.TAGGED and count > TOLD_APART:
        ctx.add(
            "IL3046",
            f"a tagged telegram for {len(driven)} machines has {count} bytes, and its tag of two bits tells "
            f"{TOLD_APART} apart: bytes 1 and {TOLD_APART + 1} have the same tag, and pass when they are exchanged",
            ctx.at_key("telegram"),
            f"let a telegram command {TOLD_APART * IN_A_BYTE} machines at most, or see to it that bytes come in order "
            "on their way",
        )
    gap = layout.principles.point_start_gap_s
    if gap > 0:
        ctx.add(
            "IL3047",
            f"machines start one after the other, {gap:g} s apart, so that `YN_` and `YR_` are on only until a machine "
            f"has arrived: SEND, wired from these, is not READY while any machine rests",
            ctx.at_key("telegram"),
            "wire `CN_` of each machine from `YN_ OR (DN_ AND NOT YR_)`, and `CR_` from `YR_ OR (DR_ AND NOT YN_)`; or "
            "state `principles: {point_start_gap_s: 0}`, where whoever receives telegrams starts one after the other",
        )
