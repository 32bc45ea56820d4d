"""Scans as bytes: what a program reads and writes, where each variable stands, and where two answers differ."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from interlock.logic.cabinet import Allocation, Channel
from interlock.logic.controller import Controller
from interlock.st.ast import Task
from interlock.st.program import io_task


@dataclass(frozen=True)
class Wiring:
    """A program with its configuration: its wires (heartbeats among them), what the operator's place writes and reads.

    A scan's inputs: milliseconds since the scan before (4 bytes), the image of %I, and two bytes for each variable that
    is written.  Its outputs: the image of %Q, a byte for each variable that is read, and two for each word of a route.
    Numbers begin with their low byte.
    """

    task: Task
    wires: tuple[Channel, ...]
    written: tuple[tuple[str, str], ...]
    """Name and type, BOOL or INT."""
    read: tuple[str, ...]
    words: tuple[str, ...] = ()

    @staticmethod
    def of(controller: Controller, allocation: Allocation, words: Sequence[str] = ()) -> Wiring:
        """The mapping program of a controller; `words`: those that are compared."""
        types = {i.name: "INT" if i.size else "BOOL" for i in controller.inputs}
        written = tuple((n, types[n]) for n in allocation.written)
        return Wiring(io_task(controller), allocation.wires, written, allocation.read, tuple(words))

    def _bytes(self, direction: str) -> int:
        return max((c.byte for c in self.wires if c.direction == direction), default=0) + 1

    @cached_property
    def image_i(self) -> int:
        """Bytes of the image of %I."""
        return self._bytes("I")

    @cached_property
    def image_q(self) -> int:
        """Bytes of the image of %Q."""
        return self._bytes("Q")

    @property
    def outputs(self) -> int:
        """Outputs that are compared in each scan."""
        return sum(c.direction == "Q" for c in self.wires) + len(self.read) + len(self.words)

    def given(self, values: Mapping[str, int], dt_ms: int) -> bytes:
        """One scan's inputs."""
        numbers = b"".join(values[n].to_bytes(2, "little", signed=True) for n, _ in self.written)
        return dt_ms.to_bytes(4, "little") + self._image("I", values) + numbers

    def told(self, values: Mapping[str, int]) -> bytes:
        """One scan's outputs."""
        words = b"".join(values[n].to_bytes(2, "little") for n in self.words)
        return self._image("Q", values) + bytes(int(values[n]) for n in self.read) + words

    def _image(self, direction: str, values: Mapping[str, int]) -> bytes:
        image = bytearray(self.image_i if direction == "I" else self.image_q)
        for c in self.wires:
            if c.direction == direction and values[c.variable]:
                image[c.byte] |= 1 << c.bit
        return bytes(image)

    @property
    def length(self) -> int:
        """Bytes of one scan's outputs."""
        return self.image_q + len(self.read) + 2 * len(self.words)

    def names(self, a: bytes, b: bytes) -> tuple[str, ...]:
        """The outputs in which two scans differ."""
        wires = [c for c in self.wires if c.direction == "Q" and (a[c.byte] ^ b[c.byte]) >> c.bit & 1]
        told = [n for k, n in enumerate(self.read, self.image_q) if a[k] != b[k]]
        first = self.image_q + len(self.read)
        words = [n for k, n in enumerate(self.words) if any(a[i] != b[i] for i in (first + 2 * k, first + 2 * k + 1))]
        return (*(f"{c.variable} at {c.located}" for c in wires), *told, *words)


@dataclass
class Segment:
    """From one power-on to the next: the clock's milliseconds at power-on, the scans' inputs and outputs."""

    start_ms: int
    given: bytearray = field(default_factory=bytearray)
    told: bytearray = field(default_factory=bytearray)
    scans: int = 0


@dataclass(frozen=True)
class Difference:
    """A scan in which a compiled program gives other outputs."""

    segment: int
    scan: int
    outputs: tuple[str, ...]

    def __str__(self) -> str:
        more = f" and {len(self.outputs) - 3} more" if len(self.outputs) > 3 else ""
        return f"power-on {self.segment}, scan {self.scan}: {', '.join(self.outputs[:3])}{more}"


def differences(wiring: Wiring, segments: Sequence[Segment], answers: Sequence[bytes]) -> list[Difference]:
    """Every scan in which an answer differs from what was recorded.  Raises ValueError where an answer has not as many
    scans as it was asked for."""
    found = []
    for s, (segment, answer) in enumerate(zip(segments, answers, strict=True), 1):
        if len(answer) != len(segment.told):
            raise ValueError(f"power-on {s}: {len(answer)} bytes, not {len(segment.told)}")
        if answer == segment.told:
            continue
        for k in range(segment.scans):
            at = slice(k * wiring.length, (k + 1) * wiring.length)
            a, b = bytes(segment.told[at]), answer[at]
            if a != b:
                found.append(Difference(s, k + 1, wiring.names(a, b) or ("a spare bit of %Q",)))
    return found


def changed(wiring: Wiring, segments: Sequence[Segment]) -> int:
    """How many outputs have had both values."""
    ones = bytearray(wiring.length)
    zeros = bytearray(wiring.length)
    for s in segments:
        for k, x in enumerate(s.told):
            ones[k % wiring.length] |= x
            zeros[k % wiring.length] |= ~x & 0xFF
    both = bytes(a & b for a, b in zip(ones, zeros, strict=True))
    return len(wiring.names(both, bytes(wiring.length)))


def digest(segments: Sequence[Segment]) -> str:
    """SHA-256 of inputs, outputs and clocks, power-on by power-on."""
    total = hashlib.sha256()
    for s in segments:
        for part in (s.start_ms.to_bytes(8, "little"), s.scans.to_bytes(8, "little"), s.given, s.told):
            total.update(part)
    return total.hexdigest()
