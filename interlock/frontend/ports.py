"""Ports (one end of something) and the outcome of joining them."""

from __future__ import annotations

from dataclasses import field

from interlock.dataclass import dataclass
from interlock.diag import Span
from interlock.model.elements import Blades, Boundary, Buffer, Crossing, Edge, Point


@dataclass(frozen=True, order=True)
class Port:
    """One end of something: `kind` is track, point, crossing, boundary or buffer."""

    kind: str
    name: str
    end: str = ""

    def __str__(self) -> str:
        return f"{self.name}.{self.end}" if self.end else self.name


@dataclass
class Wiring:
    """The outcome: graph parts, the place where each section was first named, and foreseen names."""

    edges: list[Edge] = field(default_factory=list)
    points: list[Point] = field(default_factory=list)
    blades: list[Blades] = field(default_factory=list)
    crossings: list[Crossing] = field(default_factory=list)
    boundaries: list[Boundary] = field(default_factory=list)
    buffers: list[Buffer] = field(default_factory=list)
    sections: dict[str, Span] = field(default_factory=dict)
    approaches: dict[str, Span] = field(default_factory=dict)
