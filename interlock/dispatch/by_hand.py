"""What people have asked a dispatcher for and has not been made yet: seen, and taken back."""

from __future__ import annotations

from collections import deque
from collections.abc import Container

from interlock.dispatch.dispatcher import Dispatcher


def waits(dispatcher: Dispatcher) -> set[int]:
    """The numbers that people have asked for, and that have not been answered."""
    return {*(r.stage.number for r in dispatcher.arbiter.waiting), *dispatcher.other}


def withdraw(dispatcher: Dispatcher, numbers: Container[int]) -> list[int]:
    """Forget what people have asked for by these numbers, as far as that has not been made yet; which."""
    arbiter = dispatcher.arbiter
    found = [r for r in arbiter.waiting if r.stage.number in numbers and r is not arbiter.asked]
    for request in found:
        arbiter.withdraw(request)
    swings = [n for n in dispatcher.other if n in numbers]
    dispatcher.other = deque(n for n in dispatcher.other if n not in numbers)
    return [*(r.stage.number for r in found), *swings]
