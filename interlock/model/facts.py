"""What the parts of a layout have in common."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any


@dataclass(frozen=True, eq=False)
class Facts:
    """Stated facts, and beside them what is found about them once and then remembered."""

    def __getstate__(self) -> dict[str, Any]:
        """The facts alone; what was found about them is found again elsewhere."""
        return {f.name: getattr(self, f.name) for f in fields(self)}
