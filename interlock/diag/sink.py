"""Where a phase puts what it finds, so that the reader sees every problem at once, and each of them once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field

from interlock.dataclass import dataclass
from interlock.diag.codes import severity_of
from interlock.diag.diagnostic import Diagnostic, Element, Place, Severity, Span
from interlock.diag.suggest import Suggestion


@dataclass
class _Cause:
    """What was found with one cause: each place once, with the sentence and the advice that were given there."""

    found: dict[tuple[Span | None, Element | None, str], tuple[str, str | Suggestion]] = field(default_factory=dict)


class Sink:
    """Collects diagnostics, so that a phase can report everything that it finds.

    `locate`: where an element stands in the source, once somebody knows.
    `allowed`: warnings that are not wanted, by code and name of the element; those that would have come are `spared`.
    """

    def __init__(self) -> None:
        self._causes: dict[tuple[str, str], _Cause] = {}
        self.locate: Callable[[Element], Span] | None = None
        self.allowed: frozenset[tuple[str, str]] = frozenset()
        self.spared: set[tuple[str, str]] = set()
        self.has_errors = False
        """Whether anything found so far forbids going on."""

    def add(
        self,
        code: str,
        message: str,
        span: Span | None = None,
        fix: str | Suggestion = "",
        *,
        about: Element | None = None,
        cause: str = "",
        note: str = "",
    ) -> None:
        """Record one problem at a place, or about an element.  The severity belongs to the code, so that it cannot
        vary by place.

        Problems with one code and `cause` are one diagnostic with several places; where no cause is given, the message
        is.  `note` says of this place what a message about another one leaves out.
        """
        if about is not None and (code, str(about.name)) in self.allowed:
            self.spared.add((code, str(about.name)))
            return
        of = self._causes.setdefault((code, cause or message), _Cause())
        of.found.setdefault((span, about, note), (message, fix))
        self.has_errors = self.has_errors or severity_of(code) is Severity.ERROR

    def has(self, *codes: str) -> bool:
        """Whether a code, or one that begins so, was reported."""
        return any(code.startswith(codes) for code, _ in self._causes)

    def gave(self, code: str, about: Element) -> bool:
        """Whether a code was reported about an element."""
        return any(about == x for (c, _), of in self._causes.items() if c == code for _, x, _ in of.found)

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Everything found so far, in the order of the source text; what has one cause, once."""
        return tuple(sorted((self._one(code, c) for (code, _), c in self._causes.items()), key=Diagnostic.order))

    def _one(self, code: str, cause: _Cause) -> Diagnostic:
        placed = [(self._span(span, about), about, note, said) for (span, about, note), said in cause.found.items()]
        placed.sort(key=lambda x: (x[0] is not None, x[0] or _NOWHERE))
        span, about, note, (message, fix) = placed[0]
        also = dict.fromkeys(Place(s, n) for s, _, n, _ in placed[1:] if (s, n) != (span, note))
        return Diagnostic(code, severity_of(code), message, span, fix, about, tuple(also))

    def _span(self, span: Span | None, about: Element | None) -> Span | None:
        return self.locate(about) if span is None and about is not None and self.locate is not None else span


_NOWHERE = Span("", 0, 0)
