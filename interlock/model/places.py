"""Places from which a train may come to a signal, as a value: a row of the table holds them, and knows nothing of how
they are found.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.dataclass import dataclass
from interlock.model.elements import SectionId


@dataclass(frozen=True, slots=True)
class Approach:
    """A place from which a train may come to a signal.

    section: where it may be, None for a place without detection.  further: the ways through that section towards the
    signal, by number, each with what lies before it; a train comes over a way only while it is locked for it.
    unseen: a train may be on its way beyond the section, where nothing detects it.
    """

    section: SectionId | None
    further: tuple[tuple[int, Approach], ...] = ()
    unseen: bool = False

    def sections(self) -> Iterator[SectionId]:
        """Every section of the approach, the nearest first."""
        if self.section is not None:
            yield self.section
        for _, x in self.further:
            yield from x.sections()

    @property
    def blind(self) -> bool:
        """Somewhere a train may be on its way unseen."""
        return self.section is None or self.unseen or any(x.blind for _, x in self.further)
