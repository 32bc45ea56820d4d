"""The layout language: keys, shapes, types and meanings.

One definition for validation (`validate`), JSON Schema and language page (`published`).
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, WithJsonSchema

from interlock.diag.codes import LINTS
from interlock.frontend.keys import Part, key
from interlock.frontend.principles import PrinciplesSpec
from interlock.frontend.scalars import (
    XY,
    Approach,
    Count,
    End,
    FolderName,
    Hold,
    Item,
    Kilometre,
    Kmh,
    Length,
    Level,
    Metres,
    Name,
    Pair,
    Permille,
    Reason,
    Seconds,
    Speed,
    Text,
    Trains,
    Within,
    YesNo,
    choice,
    number,
    version,
)
from interlock.model.elements import BlockKind, Hand, HealthBy, SignalKind, TelegramForm, Work
from interlock.model.overlap import overlap_length
from interlock.model.principles import PROFILES
from interlock.model.target import CPUS


def place() -> Any:
    """The key `xy`."""
    text = "its place on the plan, to the right and downwards, in pixels; without it, what is found"
    return key(text, None)


SUPERVISION = (
    "seconds after which a machine that is commanded and not detected raises an alarm; without it, the principle "
    "`point_supervision_s`"
)


class BoundarySpec(Part):
    """Where trains come in or leave."""

    approach: Approach | None = key(
        "the approach section outside, in rear of the entry signal: `NAME LENGTH`; without it, none",
        None,
    )
    trains: Annotated[Literal["both", "in", "out"], choice("direction", ("both", "in", "out"))] = key(
        "which way trains pass, seen from outside", "both"
    )
    label: Text = key("where the line leads, for plans and forms", "")
    block: Annotated[Literal["none", "semi-automatic", "automatic", "token"], choice("block", tuple(BlockKind))] = key(
        "how trains are kept apart on the line beyond (R12): with `semi-automatic` and `automatic` departures need the "
        "block free and the direction ours, an input from the block; with `token` this interlocking exchanges the "
        "direction with the neighbour",
        "none",
    )
    button: Text = key("the button that ends departure routes here, as national forms print it", "")
    indicator: YesNo = key("departures this way light a route indicator at their signal (R11; output `YB_`)", False)
    xy: XY | None = place()


class PointSpec(Part):
    """A set of points; each end names what it is joined to."""

    section: Name = key("the section in which it lies")
    toe: End | None = key("what the toe is joined to; without it, what names this end", None)
    normal: End | None = key("what the normal leg is joined to; without it, what names this end", None)
    reverse: End | None = key("what the reverse leg is joined to; without it, what names this end", None)
    machine: Name | None = key("the machine, where one works two ends; without it, a machine of its own name", None)
    legs: Length | None = key("metres of each of the three legs; without it, the principle `leg_m`", None)
    fouling: Length | None = key("metres to the fouling point; without it, the principle `fouling_m`", None)
    km: Kilometre | None = key(
        "position of its blades along the line; tracks that are joined to it begin or end a leg's length from there; "
        "without it, none is stated",
        None,
    )
    speed: Speed | None = key("km/h permitted over the reverse leg; without it, none is stated (R11)", None)
    hand: Annotated[Literal["left", "right"] | None, choice("side", tuple(Hand))] = key(
        "the side to which the reverse leg lies, seen from the toe; printed in national forms (L and R, letters of "
        "routes from the left); without it, they print normal and reverse",
        None,
    )
    work: Annotated[Literal["motor", "hand"], choice("kind of work", tuple(Work))] = key(
        "`hand`: worked on the spot once its key is released; the key locks it in normal", "motor"
    )
    xy: XY | None = place()
    supervision: Seconds | None = key(SUPERVISION, None)


class DerailerSpec(Part):
    """A derailer between two ends; on is its normal position, off its reverse one."""

    section: Name = key("the section in which it lies")
    outer: End | None = key(
        "the side on which vehicles stand that must not run off; without it, what names this end", None
    )
    inner: End | None = key("the side that it protects; without it, what names this end", None)
    machine: Name | None = key("the machine, where one works points, too; without it, a machine of its own name", None)
    legs: Length | None = key("metres of track to either side; without it, the principle `leg_m`", None)
    xy: XY | None = place()
    supervision: Seconds | None = key(SUPERVISION, None)


class SlipSpec(Part):
    """A slip: a diamond whose arms are also joined by slip rails."""

    section: Name = key("the section in which it lies")
    arms: list[Pair] = key(
        "two pairs of ends, joined to `1a`, `1b` and `2a`, `2b`; the slip rails join 1a to 2b and 2a to 1b",
        least=2,
        most=2,
    )
    single: Annotated[Literal["1a-2b", "2a-1b"] | None, choice("pair of ends", ("1a-2b", "2a-1b"))] = key(
        "of a single slip: the only pair that slip rails join; without it, the slip is double", None
    )
    machines: list[Name] = key(
        "its machines: of two of a double slip the first chooses between `1a` and `2a` (`blades: near`: between `1b` "
        "and `2b`), the second between the others; of two of a `single` slip the first has the blades at its `a` end "
        "and chooses between `1b` and `2b`, as the table of slips has it; one, for a slip that has only one, lays all "
        "blades for the straight ways (normal) or for the slips (reverse); without it, `NAMEa` and `NAMEb`",
        [],
        most=2,
    )
    blades: Annotated[Literal["far", "near"], choice("place of blades", ("far", "near"))] = key(
        "of a double slip with two machines, whether machine names follow the ends between which a machine chooses "
        "(`far`: the blades of `NAMEa` lie at `1b` and `2b`), or the ends at which its blades lie (`near`: at `1a` and "
        "`2a`, so that it chooses between `1b` and `2b`)",
        "far",
    )
    legs: Length | None = key("metres of each leg; without it, the principle `leg_m`", None)
    fouling: Length | None = key("metres to the fouling point; without it, the principle `fouling_m`", None)
    xy: XY | None = place()
    supervision: Seconds | None = key(SUPERVISION, None)


class DeviceSpec(Part):
    """A level crossing, or a bridge, door or hoist, closed and locked for every movement over its sections."""

    over: list[Name] = key("the sections over which no train runs unless it is closed", least=1)
    text: Text = key("what it is, for plans and forms", "")
    supervision: Seconds | None = key(SUPERVISION, None)


class InterlockSpec(DeviceSpec):
    """A bridge, a hoist or another device, or a door, closed and locked for every movement over its sections; a door is
    said to be open then."""

    kind: Annotated[Literal["device", "door"] | None, choice("kind", ("device", "door"))] = key(
        "whether it is told as closed or, a `door`, as open while trains may pass; without it, `door` where it is one "
        "of an air lock, else `device`",
        None,
    )
    air_lock: Name | None = key(
        "the air lock whose door it is: of its doors never more than one is open; without it, none",
        None,
    )


class ArmSpec(Part):
    """One arm of a diamond crossing."""

    section: Name = key("the section of the arm")
    ends: Pair = key("what the arm's two ends are joined to: `1a`, `1b` of the first arm, `2a`, `2b` of the second")


class CrossingSpec(Part):
    """A diamond crossing of two arms."""

    arms: list[ArmSpec] = key("its two arms", least=2, most=2)
    legs: Length | None = key("metres of each of the four legs; without it, the principle `leg_m`", None)
    xy: XY | None = place()


_KINDS, _ROUTE_KINDS = (*SignalKind, "board", "limit"), ("main", "shunt", "call-on")


class SignalSpec(Part):
    """A signal at the joint between two sections, read by movements that go into the second."""

    from_: Name = key("the section in rear of it, or, for an entry signal, the boundary", name="from")
    into: Name = key("the section into which it leads")
    at: Name | None = key("a point next to the joint; without it, the sections meet in one joint only", None)
    km: Kilometre | None = key("position of its joint along the line; without it, what the track says", None)
    kind: Annotated[Literal["main", "shunt", "combined", "board", "limit"], choice("kind of signal", _KINDS)] = key(
        "for trains, for shunting movements, or for both; `board`: a stop board, where routes end and none begins; "
        "`limit`: a limit-of-shunt board, where shunt routes end, and which trains pass",
        "main",
    )
    xy: XY | None = place()
    stops_trains: YesNo = key("a shunt signal at which train routes end, too; none begins there", False)
    release: Seconds | None = key(
        "seconds for which its routes are held after a cancellation while the approach is occupied (R8); without it, "
        "the principles `approach_release_s` and `shunt_release_s`",
        None,
    )
    identifier: YesNo = key(
        "a main or combined signal that a longer route can pass: it then shows an identifier light (German Kennlicht) "
        "instead of stop or proceed, and means nothing to the train",
        False,
    )
    call_on: YesNo = key(
        "a main or combined signal that can call a train on over sections that are reported occupied", False
    )


class DistantSpec(Part):
    """A distant or repeating signal: clear only while its main signal shows clear."""

    of: Name = key("the main signal that it announces")


class HealthSpec(Part):
    """How a substation is seen to be well; while one is not, all inputs count as lost."""

    by: Annotated[HealthBy, choice("sign of health", tuple(HealthBy))] = key(
        "`heartbeat`: an input that it changes by itself; `diagnosis`: an input that is 1 while the master of the bus "
        "finds it well (PROFINET, a Modbus gateway); `both`",
        HealthBy.HEARTBEAT,
    )
    within: Within = key("seconds in which the heartbeat must change, 0.2 to 1", 1.0)


class SectionSpec(Part):
    """More about a section."""

    speed: Speed | None = key("km/h permitted in it; without it, none is stated (R11)", None)
    lane: Annotated[Literal["level", "inclined"], choice("lane", ("level", "inclined"))] = key(
        "kind of line in a mine; an `inclined` one goes first among voyages, and wagons run away over it, "
        "against `one_way` too: what lies beyond it protects no flank (R5)",
        "level",
    )
    detected: YesNo = key("no: a siding without detection, which always counts as occupied", True)
    berth: YesNo = key(
        "no: shunting movements come into it only when it is clear, and lock it for themselves alone (R2); without it, "
        "vehicles may stand in it where it is plain and left only on a signal",
        True,
    )
    one_way: Annotated[Literal["forward", "backward"] | None, choice("direction", ("forward", "backward"))] = key(
        "the only way in which trains run, along the track as it is written; without it, both", None
    )


class ConditionSpec(Part):
    """A named input from outside that routes require."""

    text: Text = key("what it says, for plans and forms", "")
    over: list[Name] = key(
        "routes over one of these sections require it, and so do routes whose overlap leads over one", []
    )
    signals: list[Name] = key("routes from one of these signals require it", [])
    exits: list[Name] = key("routes that leave over one of these boundaries require it", [])


class ZoneSpec(Part):
    """Sections in which no more than so many trains may be."""

    sections: list[Name] = key("routes lead into them only while there is room")
    trains: Trains = key("how many trains may be there at once")


class OverlapWaySpec(Part):
    """Alternatives of an overlap over some sections, with values of their own; a short one may lie inside them (R4)."""

    over: list[Name] = key("all of these sections; of several entries that fit, the first counts", least=1)
    length: Metres | None = key("their length in metres; without it, what `entry_speed` and `falling` say", None)
    falling: Permille = key("permille by which the track falls to the signal, or rises (-); not beside `length`", 0.0)
    entry_speed: Speed | None = key(
        "km/h: no train is shown more while one of them is held for it; without it, their length limits no speed", None
    )

    def metres(self) -> float:
        """The length; raises PydanticCustomError when it is no number."""
        return number(self.length) if self.length is not None else overlap_length(self.entry_speed or 0.0, self.falling)


class OverlapSpec(Part):
    """The overlap beyond a main signal inside the layout: `length`, or `speed` and `falling`, or `successive`."""

    length: Metres | None = key("metres, 0 for no overlap; without it, what `speed` or `successive` says", None)
    speed: Kmh | None = key(
        "km/h towards the signal, from which the length follows; without it, what `length` or `successive` says", None
    )
    falling: Permille = key("permille by which the track falls to the signal, or rises (-); not beside `length`", 0.0)
    successive: YesNo = key(
        "a successive route (延续进路): as far as the next main signal, a boundary or the end", False
    )
    swing: YesNo = key(
        "another alternative may take its place while a route leads to the signal, no train close; not where machines "
        "start one after the other (`point_start_gap_s`, profile `cn`)",
        False,
    )
    entry_speed: Speed | None = key(
        "km/h: no train to the signal is shown more; where nothing else says the length, it follows from this; without "
        "it, the overlap limits no speed",
        None,
    )
    release: Seconds | None = key(
        "seconds for which the section before the signal must have been occupied until the overlap is released, and "
        "vehicles are shunted towards the train (R2); without it, the principle `overlap_release_s`",
        None,
    )
    release_by_length: YesNo = key(
        "released after the time to run through the section before it at half its (or entry) speed, and to stop",
        False,
    )
    not_over: list[End] = key("sections, and legs of points (`P.reverse`), over none of which an alternative leads", [])
    ways: list[OverlapWaySpec] = key("alternatives over certain sections, with values of their own", [])

    def metres(self) -> float:
        """The length, infinite for a successive route; raises PydanticCustomError when a number is malformed."""
        if self.successive:
            return float("inf")
        if self.length is not None:
            return number(self.length)
        return overlap_length(self.speed or self.entry_speed or 0.0, self.falling)


class ChoiceSpec(Part):
    """Routes: all that fit what is given."""

    from_: Name | None = key("the signal at which they begin; without it, any", None, name="from")
    to: Name | None = key("the signal, boundary, buffer or last section where they end; without it, any", None)
    via: list[Name] = key("sections over which they lead", [])
    not_via: list[Name] = key("sections over none of which they lead", [])
    kind: Annotated[Literal["main", "shunt", "call-on"] | None, choice("kind of route", _ROUTE_KINDS)] = key(
        "train routes (`main`), call-on routes among them; shunt routes; call-on routes alone; without it, all", None
    )


class ExcludeSpec(ChoiceSpec):
    """Routes that shall not be: all that fit what is given."""

    reason: Reason = key("why they shall not be; not empty")


class HostileSpec(Part):
    """Routes that must not be set together, though nothing in the layout tells."""

    one: ChoiceSpec = key("routes, each of them hostile to each of `other`")
    other: ChoiceSpec = key("the other routes; they may be the same ones")
    reason: Reason = key("why they are hostile; not empty")


class DemandSpec(Part):
    """A point or device that routes lock, or a section that must be clear, though nothing in the layout tells."""

    point: Name | None = key("a point, derailer, half of a slip, level crossing, interlock; without it, `clear`", None)
    lies: Annotated[Literal["normal", "reverse"] | None, choice("position", ("normal", "reverse"))] = key(
        "its position, detected and locked; a level crossing is open to its road in `normal`; without it, `clear`", None
    )
    clear: Name | None = key("a section, clear while the signal shows proceed; without it, `point` and `lies`", None)
    routes: ChoiceSpec = key("the routes that demand it")
    hold: Hold = key(
        "seconds for which the routes hold what was added to them after they would let it go; not with `clear`",
        0.0,
    )
    reason: Reason = key("why they do; not empty")


class RouteSpec(Part):
    """One derived route."""

    from_: Name = key("the signal at which it begins", name="from")
    to: Name = key("the signal, boundary or buffer where it ends, or its last section")
    via: list[Name] = key("sections over which it leads, where several routes join the two ends", [])


class NamedSpec(RouteSpec):
    """A name for one derived route."""

    kind: Annotated[Literal["main", "shunt", "call-on"] | None, choice("kind of route", _ROUTE_KINDS)] = key(
        "whether the train, shunt or call-on route is meant; without it, the train route where there is one", None
    )
    listed: YesNo = key("no: it exists, is controlled and proved as any, and printed tables only count it", True)


class VoyageSpec(RouteSpec):
    """A chain of routes that one command opens, each for the train that stands before it (by `interlock run`; the
    controller knows nothing of it)."""

    kind: Annotated[Literal["main", "shunt"], choice("kind of route", ("main", "shunt"))] = key(
        "a chain of train routes, or of shunt routes", "main"
    )
    order: Annotated[Literal["near", "far"] | None, choice("order", ("near", "far"))] = key(
        "`near`: one route after the other; `far`: all of them from the far end while the train stands before the "
        "first; without it, `far` for shunt routes",
        None,
    )
    direction: Annotated[Literal["forward", "reverse"], choice("direction", ("forward", "reverse"))] = key(
        "`reverse`: against the main direction of transport", "forward"
    )


class WaiverSpec(Part):
    """Flank protection given up on purpose."""

    flank: Text = key("the leg of a point: `point.normal` or `point.reverse`")
    reason: Reason | None = key(
        "why a vehicle can never roll from there; not empty; without it, the waiver is refused", None
    )


class AllowSpec(Part):
    """Usual practice departed from on purpose: which warning is not to be given, at which elements, and why."""

    lint: Annotated[str, choice("warning of usual practice", LINTS), WithJsonSchema({"enum": list(LINTS)})] = key(
        "code of the warning"
    )
    at: list[Name] = key(
        "the elements at which it is not to be given: sections, signals, boundaries, points, zones; or the principle",
        least=1,
    )
    reason: Reason = key("why it is meant so here; not empty")


class TargetSpec(Part):
    """The controller for which the text is meant: its sizes are estimated as for an S7-300 or S7-1500, and compared."""

    cpu: Annotated[str | None, choice("CPU", tuple(CPUS)), WithJsonSchema({"enum": list(CPUS)})] = key(
        "a CPU whose limits are known; without it, only the limits that stand beside it", None
    )
    blocks: Count | None = key("function blocks at most; without it, those of the CPU", None)
    block_kb: Count | None = key("1,024 bytes that a block may have at most; without it, those of the CPU", None)
    memory_kb: Count | None = key("1,024 bytes of work memory; without it, those of the CPU", None)


class TitleBlockSpec(Part):
    """The title block of printed forms; the station's name is the layout's `title`."""

    company: Text = key("who has the forms made", "")
    author: Text = key("who made them", "")
    number: Text = key("the number of the drawing", "")
    revision: Text = key("the revision", "")
    date: Text = key("the date, as it shall be printed; without it, none: forms never bear the day of the run", "")


class LayoutFile(Part):
    """A track layout for interlock."""

    interlock: Annotated[int, BeforeValidator(version), WithJsonSchema({"const": 1})] = key("version of the language")
    name: FolderName = key("the layout's name: folder of its outputs, name of its PLC block")
    title: Text = key("free text, printed on plans and forms", "")
    profile: Annotated[str, choice("profile", tuple(PROFILES)), WithJsonSchema({"enum": list(PROFILES)})] = key(
        "a named set of principles", "generic"
    )
    principles: PrinciplesSpec = key("single knobs of the profile, overridden", PrinciplesSpec())
    boundaries: dict[Name, BoundarySpec] = key("where trains come in or leave", {})
    buffers: list[Name] = key("names of track ends", [])
    traps: list[Name] = key("track ends into which no route leads: sand drags, trap sidings", [])
    tracks: dict[Name, list[Item]] = key(
        "sections in order along a track, each with its length in metres: `[W, q1 400, q2 300]`; a boundary, a buffer, "
        "or an end of something else (`west.end`) may stand first or last",
        {},
    )
    points: dict[Name, PointSpec] = key("sets of points", {})
    crossings: dict[Name, CrossingSpec] = key("diamond crossings", {})
    slips: dict[Name, SlipSpec] = key("single and double slips", {})
    derailers: dict[Name, DerailerSpec] = key("derailers", {})
    level_crossings: dict[Name, DeviceSpec] = key("level crossings, closed and locked for every movement", {})
    interlocks: dict[Name, InterlockSpec] = key("the same for a bridge, a door, a hoist", {})
    signals: dict[Name, SignalSpec] = key("signals, each at the joint between two sections", {})
    distants: dict[Name, DistantSpec] = key("distant and repeating signals", {})
    sections: dict[Name, SectionSpec] = key("more about single sections", {})
    conditions: dict[Name, ConditionSpec] = key("inputs from outside that routes require", {})
    zones: dict[Name, ZoneSpec] = key("sections in which no more than so many trains may be", {})
    routes: dict[Name, NamedSpec] = key("names for derived routes", {})
    voyages: dict[Name, VoyageSpec] = key("route sequences: chains of routes that one command opens", {})
    automatic: list[RouteSpec] = key("train routes that an operator's switch sets again after every train", [])
    exclude: list[ExcludeSpec] = key("derived routes that shall not be", [])
    hostile: list[HostileSpec] = key("routes that are hostile (conflicting) beyond what the layout tells", [])
    demand: list[DemandSpec] = key("points that routes lock beyond what the layout tells", [])
    overlaps: dict[Name, OverlapSpec] = key(
        "overlaps beyond main signals inside the layout; without it, the principle `overlap_m`", {}
    )
    waive: list[WaiverSpec] = key("flank protection given up on purpose", [])
    allow: list[AllowSpec] = key("warnings of usual practice that are not to be given; one too many is a warning", [])
    substations: dict[Name, list[Name]] = key(
        "cabinets, each with the elements wired to it; one list may be empty and takes the rest; without it, one "
        "cabinet for all",
        {},
    )
    health: dict[Name, HealthSpec] = key(
        "how each substation is seen to be well; without it, by a heartbeat that changes at least once a second", {}
    )
    drawing: dict[Name, Level] = key(
        "on the plan the track with this section lies so many tracks above (or, negative, below) the longest run; wins "
        "over what would be found",
        {},
    )
    telegram: Annotated[TelegramForm, choice("telegram", tuple(TelegramForm))] = key(
        "point commands go out as telegrams of document C; bytes of `tagged` bear their number modulo 4",
        TelegramForm.NONE,
    )
    target: TargetSpec = key(
        "the controller; a diagnostic says whether the text that is written may fit into it", TargetSpec()
    )
    title_block: TitleBlockSpec = key("the title block of printed forms", TitleBlockSpec())
    addresses: dict[Text, Text] = key(
        "PLC variables with their addresses, where these are not given in order: `CLR_q1: I4.0`", {}
    )
