"""What gives commands to the interlocking: it sees indications and writes operator inputs, and can do no harm.

No claim, no equation and no byte of a proof depends on anything here; contracts in pyproject.toml see to it.
"""

from interlock.dispatch.dispatcher import Dispatcher

__all__ = ["Dispatcher"]
