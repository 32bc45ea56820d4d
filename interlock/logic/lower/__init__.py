"""From the table to the controller: the only place where control logic is invented.

`routes` (request, locking, signal, cancellation), `sections` (locks, three-point check, release), `overlaps` and
`points` (commands, detection) each add their equations to a `Draft`; `build` fixes the order.
"""

from interlock.logic.lower.build import lower

__all__ = ["lower"]
