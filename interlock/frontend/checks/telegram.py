"""Point telegrams: what their check does not see, machines with a gap between starts.  IL3046, IL3047."""

from __future__ import annotations

from interlock.frontend.context import Context
from interlock.model.elements import TelegramForm
from interlock.model.layout import Layout

TOLD_APART = 4
"""Bytes that a tag of two bits tells apart."""
IN_A_BYTE = 3
"""Points in a tagged byte."""
IN_A_PLAIN_BYTE = 4
"""Points in a byte without a tag."""


def check_telegram(ctx: Context, layout: Layout) -> None:
    """What a telegram of the points that are driven cannot do."""
    form, still = layout.hardware.telegram, {*layout.machines.device, *layout.machines.by_hand}
    driven = [m for m in layout.machines if m not in still]
    if form is TelegramForm.NONE or not driven:
        return
    unseen = _tagged(len(driven)) if form is TelegramForm.TAGGED else _plain(len(driven))
    if unseen is not None:
        ctx.add("IL3046", unseen[0], ctx.at_key("telegram"), unseen[1])
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


def _tagged(count: int) -> tuple[str, str] | None:
    """What the check of a tagged telegram for so many machines does not see, and what to do; None: nothing of it."""
    size = -(-count // IN_A_BYTE)
    if size <= TOLD_APART:
        return None
    whole = count >= (TOLD_APART + 1) * IN_A_BYTE  # byte 5 has no place that is unused
    pair = "bytes 1 and 5 have the same tag, and pass" if whole else "bytes 5 and 6, the check byte, can pass"
    return (
        f"a tagged telegram for {count} machines has {size} bytes before its check byte, and its tag of two bits tells "
        f"{TOLD_APART} apart: {pair} when they are exchanged",
        f"let a telegram command {TOLD_APART * IN_A_BYTE} machines at most, or see to it that bytes come in order "
        "on their way",
    )


def _plain(count: int) -> tuple[str, str] | None:
    """What passes a plain telegram's check whatever it commands: bytes exchanged, and more where no place is unused."""
    ways = []
    if count >= 2 * IN_A_PLAIN_BYTE:
        ways.append("bytes 1 and 2 exchanged")
    if count % IN_A_PLAIN_BYTE == 0:
        ways += ["the bits of each byte in reverse order", "each byte rotated by two bits"]
    if count % (2 * IN_A_PLAIN_BYTE) == IN_A_PLAIN_BYTE:
        ways.append("every bit inverted")
    if not ways:
        return None
    said = f"{', '.join(ways[:-1])} or {ways[-1]}" if len(ways) > 1 else ways[0]
    full = ", which leaves no place unused," if count % IN_A_PLAIN_BYTE == 0 else ""
    return (
        f"a plain telegram for {count} machines{full} passes its check with {said}, and commands other positions then",
        "state `telegram: tagged`; or use a line that checks whole telegrams, and try each machine by itself",
    )
