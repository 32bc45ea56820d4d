"""Syntax tree of the Structured Text subset: what is emitted and what is read back.

No loops, no pointers, no enumerations: BOOL, INT and TIME scalars, function blocks, TON, assignments, calls and IF.
"""

from __future__ import annotations

from dataclasses import field
from functools import cached_property
from typing import TypeVar, dataclass_transform

from interlock.dataclass import dataclass

_T = TypeVar("_T")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def node(cls: type[_T]) -> type[_T]:
    """A node, which nobody changes: the type checker sees to it.  A large text has a million of them, and a class that
    sees to it itself takes three times as long to make one."""
    return dataclass(slots=True, unsafe_hash=True)(cls)


@node
class Name:
    """A variable, or an output of an instance: `x` or `inst.x`."""

    parts: tuple[str, ...]

    def __str__(self) -> str:
        parts = self.parts
        return parts[0] if len(parts) == 1 else ".".join(parts)


@node
class Bool:
    """TRUE or FALSE."""

    value: bool


@node
class Int:
    """An integer literal."""

    value: int


@node
class Time:
    """A time literal in milliseconds."""

    ms: int


@node
class Not:
    """NOT x."""

    arg: Expression


@node
class Nary:
    """AND, OR or XOR of two or more; `notes` stand beside the operands as comments."""

    op: str
    args: tuple[Expression, ...]
    notes: tuple[str, ...] = field(default=(), compare=False)


@node
class Compare:
    """A comparison of two integers."""

    op: str
    left: Expression
    right: Expression


Expression = Name | Bool | Int | Time | Not | Nary | Compare


@node
class Assign:
    """target := value."""

    target: Name
    value: Expression
    note: str = field(default="", compare=False)


@node
class Call:
    """instance(param := value, ...)."""

    instance: str
    params: tuple[tuple[str, Expression], ...]
    note: str = field(default="", compare=False)


@node
class If:
    """IF condition THEN ... ELSIF condition THEN ... ELSE ... END_IF; `elsif`: conditions, and what is done then."""

    condition: Expression
    then: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] = ()
    elsif: tuple[tuple[Expression, tuple[Statement, ...]], ...] = ()

    @property
    def arms(self) -> tuple[tuple[Expression, tuple[Statement, ...]], ...]:
        """Every condition in order, and what is done when it is the first that holds."""
        return ((self.condition, self.then), *self.elsif)


Statement = Assign | Call | If


@node
class Declaration:
    """One variable: name, type, initial value, comment, and in a program its address."""

    name: str
    type: str
    initial: Expression | None = None
    note: str = field(default="", compare=False)
    address: str = ""

    @property
    def begins_as_typed(self) -> bool:
        """Whether the value with which it begins, where there is one, is a value of its type."""
        return self.initial is None or type(self.initial) is {"BOOL": Bool, "INT": Int}.get(self.type)


HEADLINE = 100
"""Characters of a block's note where it stands on one line."""


@dataclass(frozen=True)
class Block:
    """A function block, a program, or a structure whose members are its locals (`kind`).

    handed: structures that lie elsewhere (VAR_IN_OUT)."""

    name: str
    inputs: tuple[Declaration, ...]
    outputs: tuple[Declaration, ...]
    locals: tuple[Declaration, ...]
    body: tuple[Statement, ...]
    note: str = field(default="", compare=False)
    kind: str = "FUNCTION_BLOCK"
    handed: tuple[Declaration, ...] = ()

    @cached_property
    def input_names(self) -> frozenset[str]:
        """Names of the inputs."""
        return frozenset(d.name for d in self.inputs)

    @cached_property
    def output_names(self) -> frozenset[str]:
        """Names of the outputs."""
        return frozenset(d.name for d in self.outputs)


@node
class Task:
    """A CONFIGURATION with one resource, in which one task runs an instance of a program at an interval in ms.

    interval_ms 0: the program is run as often as the controller can, and nothing is named but task and program.
    startup: the variable of the program that whatever begins after a restart sets, where a tool keeps variables.
    """

    configuration: str
    resource: str
    name: str
    interval_ms: int
    instance: str
    program: str
    startup: str = ""


@node
class Unit:
    """A file: function blocks, callees first; the last one is the interlocking.  `task`: what runs a program.  `index`:
    lines that say in which block what belongs to an element stands."""

    blocks: tuple[Block, ...]
    task: Task | None = field(default=None, kw_only=True)
    header: tuple[str, ...] = field(default=(), compare=False)
    index: tuple[str, ...] = field(default=(), compare=False, kw_only=True)
