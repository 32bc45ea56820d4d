"""The plant's state variables by name."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator

from interlock.logic.expr import Expr, var
from interlock.model.elements import Position, SectionId, SignalId

OUTSIDE = "outside"


def o(s: str) -> Expr:
    """A train stands in a section (or approach section)."""
    return var(f"o.{s}")


def came(s: str, j: str) -> Expr:
    """The train in s came in at j."""
    return var(f"in.{s}.{j}")


def across(j: str, s: str) -> Expr:
    """A train stands across j on its way out of s."""
    return var(f"x.{j}.{s}")


def rests(s: str) -> Expr:
    """The train in s has not been called since the restart."""
    return var(f"rest.{s}")


def was_called(s: str) -> Expr:
    """What has stood in s since the restart has been called by a signal, and has not left wholly."""
    return var(f"called.{s}")


def parted(s: str) -> Expr:
    """The rear part of a train that parted has been left in s; it stands there until it is moved under local rules."""
    return var(f"part.{s}")


def shunting(s: str) -> Expr:
    """The train in s moves as a shunting movement."""
    return var(f"sh.{s}")


def running(s: str) -> Expr:
    """The train in s has not yet come to a stand since it came in."""
    return var(f"run.{s}")


def overran(g: str, s: str) -> Expr:
    """What stands in s has overrun signal g."""
    return var(f"over.{g}.{s}")


def overrunning(
    names: Iterable[str], signals: Container[str], sections: Container[str]
) -> Iterator[tuple[SignalId, SectionId]]:
    """Signal and section of those of some names that tell of an overrun."""
    for head, *words in (name.split(".") for name in names):
        for n in range(1, len(words)) if head == "over" else ():
            g, s = ".".join(words[:n]), ".".join(words[n:])
            if g in signals and s in sections:
                yield SignalId(g), SectionId(s)


def accepted(g: str, shunt: bool = False) -> Expr:
    """A train has accepted the proceed of g, or a shunting movement its shunt aspect."""
    return var(f"{'gos' if shunt else 'go'}.{g}")


def lies(m: str, x: Position) -> Expr:
    """The machine really lies so."""
    return var(f"at.{m}.{x}")


def image(s: str) -> Expr:
    """The section was reported occupied in the last scan."""
    return var(f"img.{s}")


def lamp(g: str, shunt: bool = False) -> Expr:
    """Proceed (or the shunt aspect) was shown in the scan before the last."""
    return var(f"{'lamps' if shunt else 'lamp'}.{g}")


def old_command(m: str, x: Position) -> Expr:
    """The command of the scan before the last."""
    return var(f"cmd.{m}.{x}")


def has_token(b: str, what: str) -> Expr:
    """The neighbour beyond a boundary: `has` the direction, `gives` it, or has seen it not given (`fresh`)."""
    return var(f"token.{what}.{b}")


def telegram(b: str, what: str) -> Expr:
    """The last telegram from the neighbour: `has` or `gives`."""
    return var(f"tel.{what}.{b}")


def seen_by(b: str, what: str) -> Expr:
    """The last telegram that reached the neighbour: we have (`has`) or give (`gives`) the direction."""
    return var(f"saw.{what}.{b}")


def line(b: str, way: str) -> Expr:
    """A train is on the line beyond a boundary, going `out` or coming `in`."""
    return var(f"line.{way}.{b}")
