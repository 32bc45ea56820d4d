"""Names of variables: what a variable means, and what it belongs to.

A name has a *family*, what it means, and the elements and numbers *at* which it stands: `LOCK("q1", 2)` is the lock of
section q1 for its second way.  Its text (`L_q1_2`) is made here and nowhere else, and nobody takes it apart: whoever
wants to know to what a name belongs reads its fields.  A name is its own text, printed and sorted as any other.

Names of the controller are portable (letters, digits, single underscores; at most 24 characters); those of the world
and of the proof have dots and layout names as they are, but for spaces.  Names are made of others, too: see `Form`.
"""

from __future__ import annotations

from functools import partial

from interlock.logic.naming import NONE as NONE
from interlock.logic.naming import Family as Family
from interlock.logic.naming import Form as Form
from interlock.logic.naming import Kind as Kind
from interlock.logic.naming import Made as Made
from interlock.logic.naming import Name as Name
from interlock.logic.naming import Owner as Owner
from interlock.logic.naming import Part as Part
from interlock.logic.naming import choice as choice
from interlock.logic.naming import computed as computed
from interlock.logic.naming import covered as covered
from interlock.logic.naming import each as each
from interlock.logic.naming import each_value as each_value
from interlock.logic.naming import known_as
from interlock.logic.naming import of_block as of_block
from interlock.logic.naming import spelled as spelled
from interlock.logic.naming import use as use

_section = partial(Family, Kind.SECTION, portable=True)
_signal = partial(Family, Kind.SIGNAL, portable=True)
_overlap = partial(Family, Kind.OVERLAP, portable=True)
_machine = partial(Family, Kind.MACHINE, portable=True)
_route = partial(Family, Kind.ROUTE, portable=True)
_line = partial(Family, Kind.LINE, portable=True)
_zone = partial(Family, Kind.ZONE, portable=True)

# --- the controller: what there is once ----------------------------------------------------------


def _single(text: str, meaning: str, kind: Kind = Kind.NOTHING) -> Name:
    return Name._made(text, Family(kind, text, meaning, portable=True), ())


VALID = _single("VALID", "all input devices healthy")
REQUEST = _single("REQ", "the number that an operator asks for")
LOCAL_REQUEST = _single("LREQ", "the number that an operator on the spot asks for")
REQUEST_FRESH = _single("RQZ", "REQ read 0 in the last scan", Kind.REQUESTS)
LOCAL_FRESH = _single("LRQZ", "LREQ read 0 in the last scan", Kind.REQUESTS)
REQUEST_SEEN = _single("YRQ", "REQ is seen")
LOCAL_SEEN = _single("YLRQ", "LREQ is seen")
RELEASE_ALL = _single("RELALL", "operator: release all clear sections")
POWERED = _single("PWR", "the controller has run a scan since power-up", Kind.RESTART)
RESTART_RUNS = _single("RSTI", "the restart delay runs", Kind.RESTART)
RESTART_OVER = _single("RST", "the restart delay is over")
GAP_RUNS = _single("SGI", "no machine starts", Kind.STARTS)
GAP_OVER = _single("SGT", "the gap since the last start is over")
STARTED = _single("SG", "a machine started in the last scan", Kind.STARTS)

# --- the controller: sections and their ways -----------------------------------------------------

CLEAR = _section("CLR_{}", "reported clear")
HEALTHY = _section("SH_{}", "its detector is healthy")
RELEASE_BY_HAND = _section("REL_{}", "operator: release it")
BLOCKED = _section("BLK_{}", "operator: it is blocked")
OCCUPIED = _section("OCC_{}", "counts as occupied")
FREE = _section("FREE_{}", "not locked by anybody")
ENTERED = _section("NU_{}_{}", "a train comes in at one of its ends")
CLEAR_RUNS = _section("RTI_{}", "reported clear, so that the release delay runs")
LONG_CLEAR = _section("RT_{}", "clear for the release delay")
ARRIVED = _section("AR_{}", "a train has arrived wholly")
LEAVES = _section("EX_{}", "a train leaves over a boundary, or has passed on")
RELEASED_BEHIND = _section("BT_{}", "released behind the train")
WITHDRAWN = _section("CA_{}", "the lock before it was withdrawn")
RELEASED_BY_HAND = _section("HR_{}", "released by hand")
RELEASED_AFTER_RESTART = _section("SR_{}", "released after a restart")
RELEASED = _section("RLS_{}", "released")
RESTART_LOCK = _section("K_{}", "restart lock")
TRAIN_LOCK = _section("M_{}", "locked for a train movement")
FIRM = _section("F_{}", "firmly locked")
USED = _section("U_{}", "used by a train")
PASSED = _section("P_{}", "the train went on")
ALONE_RUNS = _section("OAI_{}", "used, occupied, and nothing ahead of it is")
AT_ONCE = _section("AO_{}", "read occupied at once with what is ahead of it")
SEEN_ALONE = _section("OA_{}", "occupied alone for longer than detectors take")
REAR_CLEARED = _section("RC_{}", "used, and seen that it was by a movement")
STALE = _section("D_{}", "detection is not relied on")
FAULTY = _section("FA_{}", "alarm: its detector is faulty")
FAULT_SHOWN = _section("YF_{}", "alarm: its detector is faulty")
LOCKED_SHOWN = _section("YL_{}", "indication: locked")
LOCK = _section("L_{}_{}", "locked for one of its ways")
WAY_AVAILABLE = _section("WA_{}_{}", "a way could be locked")
WAY_FREE = _section("WF_{}_{}", "a way is free for a route")
WAY_DETECTED = _section("WD_{}_{}", "a way's points lie, and nothing is foul of it")
WAY_LIES = _section("WL_{}_{}", "a way lies and is clear")
WAY_IN_ORDER = _section("WP_{}_{}", "proceed may be shown over a way")
WAY_GRANTED = _section("GW_{}_{}", "a way is granted to a route")
BERTH_GRANTED = _section("GB_{}_{}", "a way is granted to a route that ends in it")
WHY_NOT_FREE = _section("XS_{}", "word: by whom it is locked")
WHY_NOT_CLEAR = _section("XC_{}", "word: why it does not count as clear")
WHY_WAY_HELD = _section("XA_{}_{}", "word: why a way could not be locked")
WHY_WAY_NOT_FREE = _section("XF_{}_{}", "word: why a way is not free for a route")

# --- the controller: signals and their overlaps --------------------------------------------------

CANCEL = _signal("CAN_{}", "operator: cancel the route from it")
STOP_LAMP = _signal("RL_{}", "its stop lamp is intact")
CLEAR_LAMP = _signal("GL_{}", "its clear lamp is intact, or not lit")
CAUTION_LAMP = _signal("CL_{}", "its caution lamp is intact, or not lit")
IDENTIFIER_LAMP = _signal("NL_{}", "its identifier lamp is intact, or not lit")
SECOND_LAMP = _signal("UL_{}", "its second yellow lamp is intact, or not lit")
SPEED_LAMP = _signal("VL_{}", "its speed indicator is intact, or not lit")
APPROACH_CLEAR = _signal("AC_{}", "no train is on its way to it")
APPROACH_RUNS = _signal("ATI_{}", "at stop, and a train may still come")
APPROACH_OVER = _signal("AT_{}", "the delay of approach locking is over")
CANCELLED = _signal("CD_{}", "the route from it is cancelled")
CANCELLING = _signal("X_{}", "a route from it is being cancelled")
SHOWS_CLEAR = _signal("C_{}", "it shows clear")
CLEAR_ASPECT = _signal("YP_{}", "lit: clear")
CAUTION_ASPECT = _signal("YY_{}", "lit: caution")
SECOND_YELLOW = _signal("YU_{}", "lit: the second of two yellows")
ROUTE_INDICATOR = _signal("YB_{}", "lit: the route indicator")
CALL_ASPECT = _signal("YO_{}", "lit: call-on")
IDENTIFIER_ASPECT = _signal("YI_{}", "lit: identifier")
SHUNT_ASPECT = _signal("YW_{}", "lit: shunt")
STOP_ASPECT = _signal("YS_{}", "lit: stop")
SPEED_ASPECT = _signal("YV{1}_{0}", "lit: a speed")
DISTANT_CLEAR = _signal("YD_{}", "lit at a distant: clear")
DISTANT_CAUTION = _signal("YC_{}", "lit at a distant: caution")
OVERLAP = _overlap("V_{}_{}", "an overlap of the signal is held")
OVERLAP_FREE = _overlap("OF_{}_{}", "an overlap of the signal may be held")
WHY_OVERLAP_NOT_FREE = _overlap("XO_{}_{}", "word: why an overlap of the signal may not be held")
OVERLAP_GRANTED = _overlap("GO_{}_{}", "an overlap of the signal is granted")
OVERLAP_FIRM = _overlap("VF_{}", "the signal's overlap is firmly held")
OVERLAP_SWINGS = _overlap("VS_{}", "the signal's overlap swings")
OVERLAP_LIES = _overlap("OL_{}", "the signal's overlap lies and is clear")
OVERLAP_OVER = _overlap("OR_{}", "the signal's overlap is not needed any more")
STANDING_RUNS = _overlap("OTI_{}", "the train before the signal is wholly in its section")
STANDING = _overlap("OT_{}", "the train before the signal stands")
SWINGS_TO = _overlap("SW{1}_{2}", "the signal's overlap swings to one of its alternatives")

# --- the controller: machines --------------------------------------------------------------------

CONTACT = _machine("D{1}_{0}", "input: lies so")
MOVE_BY_HAND = _machine("M{1}_{0}", "operator: move it")
LOOKED_AT = _machine("TC_{}", "operator: it has been looked at after it was trailed")
DETECTED = _machine("Q{1}_{0}", "detected in a position")
MOVABLE = _machine("MOV_{}", "free to move")
OTHERS_SHUT = _machine("OSH_{}", "the other doors of its air lock are proved shut")
POINT_AVAILABLE = _machine("AV{1}_{0}", "can be demanded in a position")
WHY_HELD = _machine("XM_{}", "word: why it may not move")
TOUCHED = _machine("TG_{}", "a grant touches it")
DEMANDED = _machine("GP{1}_{0}", "a grant needs it in a position")
MOVED_BY_HAND = _machine("MA{1}_{0}", "moved by hand")
COMMAND_HELD = _machine("HD{1}_{0}", "the command stays")
COMMAND = _machine("C{1}_{0}", "commanded to a position")
DRIVE = _machine("Y{1}_{0}", "output: driven to a position")
SUPERVISED = _machine("STI_{}", "not where it was commanded")
LATE = _machine("ST_{}", "time-out")
NOT_DETECTED = _machine("AL_{}", "alarm: not detected")
LATE_SHOWN = _machine("YA_{}", "alarm: not detected in time")
WAS_DETECTED = _machine("TH{1}_{0}", "was detected in a position, and not commanded anew since")
TRAILED = _machine("TR_{}", "was trailed")
TRAILED_SHOWN = _machine("YT_{}", "alarm: was trailed")
STARTS = _machine("ZT_{}", "starts")
WAITS = _machine("ZW_{}", "it or one before it waits for its start")
MAY_RUN = _machine("Z_{}", "may run")
MAY_START = _machine("ZS_{}", "could start now")
KEPT_OFF = _machine("ZO_{}", "its drive is kept off")

# --- the controller: routes ----------------------------------------------------------------------

AUTOMATIC = _route("AUTO_R{}", "operator: works automatically")
ASKED = _route("RQ_R{}", "asked for")
GRANTED = _route("G_R{}", "granted")
LOCKS = _route("LK_R{}", "becomes locked")
CONDITIONS = _route("CO_R{}", "conditions of proceed")
STAYS = _route("KP_R{}", "stays set")
OPENS = _route("PR_R{}", "proceed")
CONDITION_LOST = _route("LS_R{}", "a condition was lost")
UNHINDERED = _route("UH_R{}", "nothing in its way is blocked or was trailed")
PASSING = _route("PA_R{}", "open for the movement that passes")
ACTIVE = _route("A_R{}", "set")
LOCKED = _route("B_R{}", "locked")
WANTED = _route("W_R{}", "proceed wanted")
SHOWING = _route("S_R{}", "proceed")
SHOWN = _route("H_R{}", "has been open")
STATUS = _route("YX_R{}", "word: free, set, open, being cancelled, what it waits for, why it is refused")
WHAT_IT_DOES = _route("XW_R{}", "word: what it does while it is set and its signal is at stop")
HOLDS_ADDED = _route("AH_R{}", "holds what the author added to it")
HOLD_RUNS = _route("AHI_R{}", "holds what was added to it, and is not under way any more")
HOLD_BEGUN = _route("AHE_R{}", "holds what was added to it, and has not been under way since")
HOLD_OVER = _route("AHT_R{}", "has held what was added to it for so long")

# --- the controller: lines, conditions, zones ----------------------------------------------------

NEIGHBOUR_ASKS = _line("NR_{}", "the neighbour asks for the direction")
NEIGHBOUR_GIVES = _line("NG_{}", "the neighbour gives the direction")
NEIGHBOUR_KEEPS = _line("NN_{}", "the neighbour does not give the direction")
NEIGHBOUR_HAS = _line("NH_{}", "the neighbour has the direction")
LINE_CLEAR = _line("LC_{}", "the whole line is reported clear")
TAKE_BY_HAND = _line("TKN_{}", "operator: take the direction, as agreed")
TOKEN_HERE = _line("BH_{}", "the direction is ours")
TOKEN_GIVEN = _line("BG_{}", "the direction is given")
CHANGE_SEEN = _line("BN_{}", "the neighbour told that he does not give the direction")
MANUAL_OVER = _line("BT_{}", "the hand has been held long enough")
MANUAL_RUNS = _line("BTI_{}", "special manual change")
TOKEN_TAKEN = _line("BK_{}", "the direction is taken")
TOKEN_GOES = _line("BV_{}", "the direction is given to the neighbour")
TOKEN_KEPT = _line("BY_{}", "the direction is not given")
TELLS_ASKS = _line("YTA_{}", "to the neighbour: direction asked for")
TELLS_GIVES = _line("YTG_{}", "to the neighbour: direction given")
TELLS_KEEPS = _line("YTN_{}", "to the neighbour: direction not given")
TELLS_HAS = _line("YTH_{}", "to the neighbour: direction is here")
CONDITION = Family(Kind.CONDITION, "E_{}", "an external condition holds", portable=True)
ZONE_FULL = _zone("ZF_{}", "the zone is full")
ZONE_FULL_SHOWN = _zone("YZ_{}", "indication: the zone is full")
ZONE_BUSY = _zone("ZB{1}_{2}", "one of its sections counts")
ZONE_COUNT = _zone("ZN{1}_{2}_{3}", "so many of its first sections count")

# --- the world: state ----------------------------------------------------------------------------

STANDS = Family(Kind.SECTION, "o.{}", "a train stands in the section")
CAME = Family(Kind.SECTION, "in.{}.{}", "the train in the section came in at an end")
ACROSS = Family(Kind.SECTION, "x.{}.{}", "a train stands across an end, going out of the section", place=1)
RESTS = Family(Kind.SECTION, "rest.{}", "the train in the section has not been called since the restart")
WAS_CALLED = Family(Kind.SECTION, "called.{}", "what has stood there since the restart has been called")
PARTED = Family(Kind.SECTION, "part.{}", "the rear part of a train that parted has been left there")
SHUNTING = Family(Kind.SECTION, "sh.{}", "the train in the section shunts")
RUNNING = Family(Kind.SECTION, "run.{}", "the train in the section has not come to a stand")
IMAGE = Family(Kind.SECTION, "img.{}", "the section was reported occupied")
SLOW = Family(Kind.SECTION, "slow.{1}.{0}", "the train in the section was called at no more than a speed")
OVERRAN = Family(Kind.SECTION, "over.{}.{}", "what stands in the section has overrun a signal", place=1)
ACCEPTED = Family(Kind.SIGNAL, "go.{}", "a train has accepted proceed")
SHUNT_ACCEPTED = Family(Kind.SIGNAL, "gos.{}", "a shunting movement has accepted the shunt aspect")
SEEN = Family(Kind.SIGNAL, "lamp.{}", "proceed was shown one scan ago")
SHUNT_SEEN = Family(Kind.SIGNAL, "lamps.{}", "the shunt aspect was shown one scan ago")
FAST = Family(Kind.SIGNAL, "fast.{1}.{0}", "the train before it may have seen that more than a speed is permitted")
LIES = Family(Kind.MACHINE, "at.{}.{}", "the machine really lies so")
OLD_COMMAND = Family(Kind.MACHINE, "cmd.{}.{}", "the command of the scan before the last")
TURNS_SINCE = Family(Kind.MACHINE, "turns.{}.{}", "it turns since before a train came to a signal", place=1)
NEIGHBOUR_TOKEN = Family(Kind.LINE, "token.{1}.{0}", "the neighbour and the direction: has, gives, fresh")
TELEGRAM = Family(Kind.LINE, "tel.{1}.{0}", "the last telegram from the neighbour")
SEEN_BY = Family(Kind.LINE, "saw.{1}.{0}", "the last telegram that reached the neighbour")
ON_LINE = Family(Kind.LINE, "line.{1}.{0}", "a train is on the line, going out or coming in")

# --- the world: clocks ---------------------------------------------------------------------------

STOP_LONG = Family(Kind.SIGNAL, "long.stop.{}", "stop has been shown for as long as a train needs to stand")
STAND_LONG = Family(Kind.SIGNAL, "long.stand.{}", "the train before the signal has had time to come to a stand")
AGREED_LONG = Family(Kind.LINE, "long.agreed.{}", "the hand is held as long as agreed")

# --- the world: events, and what it chooses ------------------------------------------------------

HEAD = Family(Kind.SECTION, "head.{}.{}", "a head goes over an end, out of the section", place=1)
TAIL = Family(Kind.SECTION, "tail.{}.{}", "a tail goes over an end, out of the section", place=1)
SHUNTS = Family(Kind.SECTION, "shunts.{}.{}", "a shunting movement goes over an end", place=1)
OVERRUNS = Family(Kind.SECTION, "overruns.{}.{}.{}", "a train that overruns a signal goes over an end", place=2)
FAILS = Family(Kind.SIGNAL, "fails.{}", "a train fails to stop before it")
APPEARS = Family(Kind.SECTION, "appear.{}", "a train comes to a boundary")
PARTS = Family(Kind.SECTION, "parts.{}", "the train parts, and its rear stays")
STAYS_BEHIND = Family(Kind.SECTION, "stay.{}", "vehicles stay behind")
TURNS = Family(Kind.SECTION, "turn.{}.{}.{}", "the train in the section changes direction, from an end to another")
THROUGH = Family(Kind.BUFFER, "through.{}", "a train runs through a buffer")
ACCEPTS = Family(Kind.SIGNAL, "accept.{}", "a driver accepts proceed")
SHUNT_ACCEPTS = Family(Kind.SIGNAL, "accepts.{}", "a driver accepts the shunt aspect")
REFUSES = Family(Kind.SIGNAL, "refuse.{}", "the train before it stops after all")
STUCK = Family(Kind.SIGNAL, "stuck.{}", "it goes on showing proceed")
SHUNT_STUCK = Family(Kind.SIGNAL, "stucks.{}", "it goes on showing the shunt aspect")
MACHINE_STARTS = Family(Kind.MACHINE, "start.{}.{}", "it starts to leave a position")
MACHINE_ARRIVES = Family(Kind.MACHINE, "arrive.{}.{}", "it arrives in a position")
RUN_THROUGH = Family(Kind.MACHINE, "trails.{}", "a vehicle runs through it")
TOKEN_MOVES = Family(Kind.LINE, "neighbour.{1}.{0}", "the neighbour takes, gives, loses the direction, by hand as well")
SENDS = Family(Kind.LINE, "sends.{}", "the neighbour sends a train")
TELEGRAM_COMES = Family(Kind.LINE, "telegram.{}", "a telegram comes from the neighbour")
TELEGRAM_REACHES = Family(Kind.LINE, "tells.{}", "a telegram reaches the neighbour")
LINE_ARRIVED = Family(Kind.LINE, "arrived.{}", "the train on the line has arrived")
LINE_LAST = Family(Kind.LINE, "last.{}", "no further train is on the line")

# --- what the proof remembers, and counts --------------------------------------------------------

BEEN = Family(Kind.SECTION, "been.{}", "a train has come in since it was locked firmly", history=True)
SHUT = Family(Kind.ROUTE, "shut.R{}", "it has closed, or was hindered, and nobody has just asked again", history=True)
OVERFULL = Family(Kind.ZONE, "zone.{}", "a train is called into a zone that is full")
ZONE_SUM = Family(Kind.ZONE, "zone.{}.{}.{}", "so many of the first that count in a zone are there")


def accepted(g: str, shunt: bool = False) -> Name:
    """A train has accepted the proceed aspect of a signal, or a shunting movement its shunt aspect."""
    return (SHUNT_ACCEPTED if shunt else ACCEPTED)(g)


def accepts(g: str, shunt: bool = False) -> Name:
    """The event in which it does."""
    return (SHUNT_ACCEPTS if shunt else ACCEPTS)(g)


def seen(g: str, shunt: bool = False) -> Name:
    """Proceed of a signal, or its shunt aspect, was shown one scan ago."""
    return (SHUNT_SEEN if shunt else SEEN)(g)


def outside(node: str) -> str:
    """Where a train stands that is about to come in at a boundary without approach section."""
    return f"outside.{node}"


_FAMILIES = {key: x for key, x in globals().items() if isinstance(x, Family)}
_FAMILIES |= {key: x.family for key, x in globals().items() if isinstance(x, Name) and x is not NONE}
known_as(_FAMILIES)


def families() -> tuple[Family, ...]:
    """All families of variables."""
    return tuple(_FAMILIES.values())
