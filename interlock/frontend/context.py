"""What the resolving passes share: the typed file, its tree (for places) and the sink."""

from __future__ import annotations

from interlock.dataclass import dataclass
from interlock.diag import Element, Sink, Span
from interlock.diag.suggest import Suggestion
from interlock.frontend.schema import LayoutFile
from interlock.frontend.shapes import span_of
from interlock.frontend.yaml_tree import Node


@dataclass(frozen=True)
class Context:
    """One layout file on its way to a `Layout`."""

    file: LayoutFile
    root: Node
    sink: Sink

    def at(self, *path: str | int) -> Span:
        """The place of a value in the source."""
        return span_of(self.root, path)

    def at_key(self, *path: str | int) -> Span:
        """The place of a key in the source."""
        return span_of(self.root, path, key=True)

    def stated(self, principle: str) -> tuple[str, ...]:
        """Where a principle is stated, or could be."""
        if getattr(self.file.principles, principle) is not None:
            return "principles", principle
        return ("principles",) if "principles" in self.file.model_fields_set else ("name",)

    def add(
        self,
        code: str,
        message: str,
        span: Span,
        fix: str | Suggestion = "",
        *,
        about: Element | None = None,
        cause: str = "",
        note: str = "",
    ) -> None:
        """Report a problem; see `Sink.add`."""
        self.sink.add(code, message, span, fix, about=about, cause=cause, note=note)
