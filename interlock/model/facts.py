"""What the parts of a layout have in common."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from interlock.dataclass import dataclass


@dataclass(frozen=True, eq=False)
class Facts:
    """Stated facts, and beside them what is found about them once and then remembered."""

    def __getstate__(self) -> dict[str, Any]:
        """The facts alone; what was found about them is found again elsewhere."""
        return {f.name: getattr(self, f.name) for f in fields(self)}
