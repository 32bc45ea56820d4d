"""The plant's state variables by name."""

from __future__ import annotations

from interlock.logic import names
from interlock.logic.expr import Expr, var
from interlock.model.elements import Position

OUTSIDE = "outside"


def o(s: str) -> Expr:
    """A train stands in a section (or approach section)."""
    return var(names.STANDS(s))


def came(s: str, j: str) -> Expr:
    """The train in s came in at j."""
    return var(names.CAME(s, j))


def across(j: str, s: str) -> Expr:
    """A train stands across j on its way out of s."""
    return var(names.ACROSS(j, s))


def rests(s: str) -> Expr:
    """The train in s has not been called since the restart."""
    return var(names.RESTS(s))


def was_called(s: str) -> Expr:
    """What has stood in s since the restart has been called by a signal, and has not left wholly."""
    return var(names.WAS_CALLED(s))


def parted(s: str) -> Expr:
    """The rear part of a train that parted has been left in s; it stands there until it is moved under local rules."""
    return var(names.PARTED(s))


def shunting(s: str) -> Expr:
    """The train in s moves as a shunting movement."""
    return var(names.SHUNTING(s))


def running(s: str) -> Expr:
    """The train in s has not yet come to a stand since it came in."""
    return var(names.RUNNING(s))


def slow(s: str, kmh: int) -> Expr:
    """The train in s was called at no more than a speed."""
    return var(names.SLOW(s, kmh))


def fast(g: str, kmh: int) -> Expr:
    """The train before g, once it has accepted it, may have seen that more than a speed is permitted."""
    return var(names.FAST(g, kmh))


def overran(g: str, s: str) -> Expr:
    """What stands in s has overrun signal g."""
    return var(names.OVERRAN(g, s))


def accepted(g: str, shunt: bool = False) -> Expr:
    """A train has accepted the proceed aspect of g, or a shunting movement its shunt aspect."""
    return var(names.accepted(g, shunt))


def lies(m: str, x: Position) -> Expr:
    """The machine really lies so."""
    return var(names.LIES(m, x))


def image(s: str) -> Expr:
    """The section was reported occupied in the last scan."""
    return var(names.IMAGE(s))


def lamp(g: str, shunt: bool = False) -> Expr:
    """Proceed (or the shunt aspect) was shown in the scan before the last."""
    return var(names.seen(g, shunt))


def old_command(m: str, x: Position) -> Expr:
    """The command of the scan before the last."""
    return var(names.OLD_COMMAND(m, x))


def has_token(b: str, what: str) -> Expr:
    """The neighbour beyond a boundary: `has` the direction, `gives` it, or has seen it not given (`fresh`)."""
    return var(names.NEIGHBOUR_TOKEN(b, what))


def telegram(b: str, what: str) -> Expr:
    """The last telegram from the neighbour: `has` or `gives`."""
    return var(names.TELEGRAM(b, what))


def seen_by(b: str, what: str) -> Expr:
    """The last telegram that reached the neighbour: we have (`has`) or give (`gives`) the direction."""
    return var(names.SEEN_BY(b, what))


def line(b: str, way: str) -> Expr:
    """A train is on the line beyond a boundary, going `out` or coming `in`."""
    return var(names.ON_LINE(b, way))
