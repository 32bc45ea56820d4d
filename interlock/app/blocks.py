"""The lengths of block sections: a layout, the dispatch file beside it, and what the formulas say of both."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from interlock.app.check import Checked, derive_file
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Sink
from interlock.dispatch.blocks import Block, Braking, Length, advice, blocks, braking, lengths
from interlock.dispatch.language import Orders, beside, load


@dataclass(frozen=True)
class Blocks:
    """What was found, or the problems of layout and dispatch file."""

    checked: Checked
    orders: Orders | None
    diagnostics: tuple[Diagnostic, ...]
    blocks: tuple[Block, ...] = ()
    lengths: tuple[Length, ...] = ()
    braking: Braking | None = None
    advice: tuple[str, ...] = ()
    texts: Mapping[str, str] = field(default_factory=dict)
    """That of a dispatch file with problems."""

    @property
    def ok(self) -> bool:
        """Both files could be read."""
        return self.braking is not None

    @property
    def sources(self) -> Mapping[str, str]:
        """The texts, by file, for rendering diagnostics."""
        own = self.texts if self.orders is None else {self.orders.name: self.orders.text}
        return {**self.checked.source.texts, **own}

    @property
    def findings(self) -> bool:
        """A place that cannot keep up, or a section of a wrong length."""
        return any(not b.feasible for b in self.blocks) or any(x.grade.startswith("too") for x in self.lengths)


def block_lengths(path: str, dispatch: str | None, rounding: str | None) -> Blocks:
    """Calculate; `dispatch`: the dispatch file, by default the one beside the layout."""
    checked = derive_file(path)
    if not checked.ok or checked.layout is None:
        return Blocks(checked, None, checked.diagnostics)
    sink, texts = Sink(), dict[str, str]()
    orders = load(dispatch or beside(path), checked.layout, sink, texts)
    if orders is None:
        return Blocks(checked, None, sink.diagnostics, texts=texts)
    traffic = orders.file.traffic
    if traffic is None:
        sink.add("IL6003", "the file says nothing of the traffic", orders.root.span, "add the key `traffic`")
        return Blocks(checked, orders, sink.diagnostics)
    found = blocks(traffic, rounding)
    return Blocks(
        checked,
        orders,
        (),
        found,
        lengths(checked.layout, traffic, found),
        braking(checked.layout),
        advice(checked.layout, traffic, found),
    )
