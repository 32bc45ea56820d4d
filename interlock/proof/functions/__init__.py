"""Functions: what the controller must do, where claims say what it must never do.

A controller that refuses every route is safe, and most small defects make one a little less useful, not less safe.  So
each rule is said from its other side too: a route is refused, a signal stays at stop, a section stays locked, a delay
does not run only for a reason that the rule names.  They are written from the rules over layout, inputs and states, as
claims are (F-WORD alone over wires too, since words name conditions of the controller), and proved by induction in the
same way; `interlock mutate` and the tests ask them, `prove` does not.

**Theorem.**  Each of these is a safety property too, though it tells what must happen: it says of every single step
what it does, so that a finite run is enough to refute it and an induction over steps to prove it.  (Lamport, 1977;
Alpern and Schneider, 1985.)  Where a claim says that something happens only if a condition holds, and a function that
it fails to happen only if the condition does not, the two together leave the controller no choice.
"""

from __future__ import annotations

from collections.abc import Iterator

from interlock.logic.controller import Controller
from interlock.logic.expr import TRUE, Expr
from interlock.proof.claims import Facts
from interlock.proof.functions.delays import delays, start
from interlock.proof.functions.overlaps import overlaps
from interlock.proof.functions.points import points
from interlock.proof.functions.routes import routes
from interlock.proof.functions.said import words
from interlock.proof.functions.sections import sections
from interlock.proof.functions.words import Words

FUNCTIONS: dict[str, str] = {
    "F-DELAY": "Each delay counts exactly while what it waits for holds (R4, R8, R9, R10, R12, R16).",
    "F-START": "When the restart delay is over no route is set or remembered, and nothing is cancelled, granted as "
    "overlap, trailed or given to a neighbour.",
    "F-GRANT": "A route that is newly asked for by hand is refused exactly for a reason that R6 names; "
    "a shunting movement locks its berth as it comes in, unless somebody has.",
    "F-LOCK": "A route is locked as soon as its ways and its overlap lie and are clear, and not before (R3).",
    "F-OPEN": "A signal whose route is locked and wanted stays at stop only for a reason that R3 names; "
    "one whose route is not locked yet stays at stop.",
    "F-CLEAR": "A main signal that is open shows clear wherever R11 allows it, and two yellows only where it asks for "
    "them.",
    "F-SPEED": "A main signal shows the speed of the path for which it is open (R11).",
    "F-WANT": "A signal is wanted from when its route is set until it is cancelled, something in its way is blocked or "
    "was trailed or, once it has been open, a condition is lost; then again when it is asked for while that is not so "
    "(R14); one that calls on until inputs are lost, too, and never again (R2, R16).",
    "F-PASSING": "A signal stays open until the whole movement has passed, unless a condition is lost, where the "
    "layout has it so, and nowhere else; none does that calls on (R2, R3).",
    "F-ADDED": "A route holds what the author has added to it exactly from its grant until its train is wholly in its "
    "last section, or has left; where it holds it longer, until these seconds are over, whatever others lock meanwhile "
    "(R5, R6).",
    "F-SHOWN": "A route remembers that its signal has been open, from then on and only from then on (R8).",
    "F-CANCEL": "A cancelled route is given up as soon as R8 permits, and until then it goes on being cancelled; "
    "otherwise only a train ends a route.",
    "F-USED": "A section counts as used exactly when the three-point check sees a train come in (R9).",
    "F-PASSED": "A train has gone on from a section exactly when it is seen to come into the next one, and what came "
    "in behind a signal counts as a movement exactly when R9 says so.",
    "F-STALE": "Detection is not relied on exactly where inputs were lost, or a train called on, while locked (R9).",
    "F-FIRM": "A section is firmly locked exactly when a route over it has been locked (R3).",
    "F-MODE": "A section is locked for a train exactly from when a train route is set over it until it is released, or "
    "a train has arrived, wholly (R2).",
    "F-RELEASE": "A section is released exactly when R8, R9 or R16 has it released; and nothing of it is remembered.",
    "F-TRAILED": "A point that is driven counts as trailed exactly when it loses its detection without a new command, "
    "or has not got it again when lost inputs come back, until looked at; what was detected until the restart delay is "
    "over does not count (R10).",
    "F-POINT": "A machine is commanded exactly by a route, by hand where R10 permits it, or by what opens or closes by "
    "itself; a command stays until the other is given.",
    "F-OFF": "The drive of a point is kept off from when a section of it is blocked until it is commanded while none "
    "is and all are clear; not while it is moved by hand, nor before it has come to lie where an overlap swings over "
    "it (R10).",
    "F-TURN": "Where machines start one after the other: one starts exactly when it waits and could start (valid "
    "inputs, its sections clear and not blocked, not trailed, its drive not kept off), none before it does, and the "
    "gap since the last start is over; and runs until it is there, commanded anew or kept off (R10).",
    "F-OVERLAP": "An overlap is held exactly until no route leads to its signal or the train before it stands, and it "
    "is clear (R4).",
    "F-SWING": "An overlap swings to another alternative when that is asked for and R4 permits it.",
    "F-ZONE": "A zone is told to be full exactly while as many of its sections count as trains may be in it (R17).",
    "F-TOKEN": "The direction is taken, given and kept exactly as R12 says.",
    "F-WORD": "What is said of a route is so: open exactly while its signal shows proceed for it; being cancelled "
    "wherever it is set and its signal cancelled; free only where a request would set it; refused only where it is "
    "not set, and by a condition that does not hold.",
}


def functions(f: Facts, c: Controller) -> list[tuple[str, str, Expr]]:
    """Function, place and what is required of a step of a controller."""
    w = Words(f)
    out: list[tuple[str, str, Expr]] = []
    parts: tuple[Iterator[tuple[str, str, Expr]], ...] = (
        delays(w),
        routes(w),
        sections(w),
        points(w),
        overlaps(w),
        words(w, c),
    )
    for part in parts:
        out += [x for x in part if x[2] is not TRUE]
    return out


def function_start(f: Facts) -> Expr:
    """F-START, of the state when the restart delay is over."""
    return start(Words(f))
