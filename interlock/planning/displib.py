"""Files of DISPLIB, the public library of train dispatching problems: problems are read, solutions are written.

Raises `BadFile` with the place in the file, also for a number that is too large for a solver (2**40).
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from interlock.exceptions import Whole
from interlock.planning.problem import Delay, Event, Operation, Plan, Problem, Use, planned

MOST = 2**40
"""The greatest number that is read: times of solvers are 64 bits wide, and costs are products of them."""

OPERATION = ("start_lb", "start_ub", "min_duration", "resources", "successors")
COMPONENT = ("type", "train", "operation", "coeff", "increment", "threshold")


class BadFile(Whole, ValueError):
    """A file that is no such problem or solution; says where and why."""

    def __init__(self, place: str, why: str) -> None:
        super().__init__(f"{place}: {why}" if place else why)
        self.place = place


def read(path: Path) -> Problem:
    """The problem in a file.  Raises `BadFile`, `OSError`."""
    return decoded(path.read_bytes())


def decoded(data: bytes) -> Problem:
    """The problem in the bytes of a file.  Raises `BadFile`."""
    return parse(_json(data))


def _json(data: bytes) -> Any:
    try:
        return json.loads(data.decode("utf-8"), parse_constant=_constant)
    except UnicodeDecodeError as error:
        raise BadFile(f"byte {error.start}", "this is no UTF-8") from None
    except json.JSONDecodeError as error:
        raise BadFile(f"line {error.lineno}, column {error.colno}", f"this is no JSON: {error.msg}") from None
    except BadFile:
        raise
    except ValueError:
        raise BadFile("", "this has a number in it of more digits than are read") from None
    except RecursionError:
        raise BadFile("", "this is nested too deeply") from None


def _constant(text: str) -> None:
    raise BadFile("", f"{text} is no number of JSON")


def _object(place: str, value: Any, keys: Sequence[str]) -> Mapping[str, Any]:
    if not isinstance(value, dict):
        raise BadFile(place, "an object is expected")
    for key in value:
        if key not in keys:
            raise BadFile(place, f"there is no key {key!r}; there are {', '.join(keys)}")
    return value


def _list(place: str, value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise BadFile(place, "a list is expected")
    return value


def _number(place: str, value: Any, least: int = -MOST) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise BadFile(place, f"a whole number is expected, not {json.dumps(value)[:40]}")
    if not least <= value <= MOST:
        raise BadFile(place, f"{str(value)[:20]} is not between {least} and {MOST}")
    return value


def parse(data: Any) -> Problem:
    """The problem in a JSON value.  Raises `BadFile`."""
    top = _object("the file", data, ("trains", "objective"))
    for key in ("trains", "objective"):
        if key not in top:
            raise BadFile("the file", f"the key {key!r} is missing")
    trains = tuple(_train(f"trains[{k}]", t) for k, t in enumerate(_list("trains", top["trains"])))
    delays = [_delay(f"objective[{k}]", d, trains) for k, d in enumerate(_list("objective", top["objective"]))]
    return Problem(trains, tuple(delays))


def _train(place: str, value: Any) -> tuple[Operation, ...]:
    given = _list(place, value)
    operations = tuple(_operation(f"{place}[{k}]", k, len(given), o) for k, o in enumerate(given))
    for what, found in (
        ("begin", set(range(len(given))) - {s for o in operations for s in o.following}),
        ("end", {k for k, o in enumerate(operations) if not o.following}),
    ):
        if len(found) != 1:
            said = f"operations {', '.join(map(str, sorted(found)[:5]))} do" if found else "no operation does"
            raise BadFile(place, f"one operation must {what} the train; {said}")
    return operations


def _operation(place: str, index: int, count: int, value: Any) -> Operation:
    o = _object(place, value, OPERATION)
    if "successors" not in o:
        raise BadFile(place, "the key 'successors' is missing")
    following = []
    for k, s in enumerate(_list(f"{place}.successors", o["successors"])):
        number = _number(f"{place}.successors[{k}]", s)
        if not index < number < count:
            raise BadFile(f"{place}.successors[{k}]", f"{number} is no later operation of the train")
        following.append(number)
    earliest = _number(f"{place}.start_lb", o.get("start_lb", 0), 0)
    latest = None if "start_ub" not in o else _number(f"{place}.start_ub", o["start_ub"], 0)
    if latest is not None and latest < earliest:
        raise BadFile(f"{place}.start_ub", f"{latest} comes before start_lb, {earliest}")
    uses = [_use(f"{place}.resources[{k}]", u) for k, u in enumerate(_list(place, o.get("resources", [])))]
    duration = _number(f"{place}.min_duration", o.get("min_duration", 0), 0)
    return Operation(duration, tuple(dict.fromkeys(following)), tuple(uses), earliest, latest)


def _use(place: str, value: Any) -> Use:
    u = _object(place, value, ("resource", "release_time"))
    if not isinstance(u.get("resource"), str):
        raise BadFile(f"{place}.resource", "a name is expected")
    return Use(u["resource"], _number(f"{place}.release_time", u.get("release_time", 0), 0))


def _delay(place: str, value: Any, trains: Sequence[Sequence[Operation]]) -> Delay:
    d = _object(place, value, COMPONENT)
    if d.get("type") != "op_delay":
        raise BadFile(f"{place}.type", "'op_delay' is expected")
    for key in ("train", "operation"):
        if key not in d:
            raise BadFile(place, f"the key {key!r} is missing")
    train = _number(f"{place}.train", d["train"])
    if not 0 <= train < len(trains):
        raise BadFile(f"{place}.train", f"there is no train {train}")
    operation = _number(f"{place}.operation", d["operation"])
    if not 0 <= operation < len(trains[train]):
        raise BadFile(f"{place}.operation", f"train {train} has no operation {operation}")
    rate, once = (_number(f"{place}.{k}", d.get(k, 0), 0) for k in ("coeff", "increment"))
    return Delay(train, operation, _number(f"{place}.threshold", d.get("threshold", 0)), rate, once)


def write(plan: Plan) -> str:
    """A solution's text."""
    events = [{"time": e.time, "train": e.train, "operation": e.operation} for e in plan.events]
    return json.dumps({"objective_value": plan.cost, "events": events}) + "\n"


def read_solution(path: Path, problem: Problem) -> Plan:
    """The plan in a solution's file, with the cost that it has; what it says of its cost is not looked at.

    Raises `BadFile`, `OSError`.  Whether it keeps the rules is asked of `verify.faults`."""
    top = _object("the file", _json(path.read_bytes()), ("objective_value", "events"))
    events = []
    for k, value in enumerate(_list("events", top.get("events"))):
        e = _object(f"events[{k}]", value, ("time", "train", "operation"))
        events.append(Event(*(_number(f"events[{k}].{x}", e.get(x)) for x in ("time", "train", "operation"))))
    return planned(problem, events)
