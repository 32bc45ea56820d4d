"""The scalars of the layout language: names, numbers, choices, each with its check and its JSON Schema.

Raises PydanticCustomError with a kind that `schema` turns into a diagnostic.
"""

from __future__ import annotations

import math
import re
from typing import Annotated

from pydantic import AfterValidator, BeforeValidator, Field, WithJsonSchema
from pydantic_core import PydanticCustomError

NAME = re.compile(r"[A-Za-z0-9]+([_/-][A-Za-z0-9]+)*")
MAX_NAME = 14
MAX_LENGTH_M = 100_000.0
_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)")


def _name(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("shape", "a name is expected")
    if not NAME.fullmatch(value):
        raise PydanticCustomError(
            "name", "'{v}' cannot be a name: use letters, digits and single _ - / between them", {"v": value}
        )
    if len(value) > MAX_NAME:
        raise PydanticCustomError("name", "'{v}' is longer than {n} characters", {"v": value, "n": MAX_NAME})
    return value


def number(text: str) -> float:
    """A finite number in plain decimal notation; raises PydanticCustomError otherwise."""
    if not _NUMBER.fullmatch(text):
        raise PydanticCustomError("number", "'{v}' is not a number", {"v": text})
    return float(text)


def _length(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a length in metres is expected")
    x = number(value)
    if not math.isfinite(x) or not 0 < x <= MAX_LENGTH_M:
        raise PydanticCustomError("range", "{v} m is not a possible length", {"v": value})
    return x


def _seconds(value: object) -> object:
    x = _amount(value)
    if x == 0:
        raise PydanticCustomError("range", "{v} is out of range (0 to 86400)", {"v": value})
    return x


def _amount(value: object) -> float:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value)
    if not math.isfinite(x) or not 0 <= x <= 86_400:
        raise PydanticCustomError("range", "{v} is out of range (0 to 86400)", {"v": value})
    return x


def _permille(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    return number(value)


def _speed(value: object) -> int:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value)
    if x != round(x) or not 5 <= x <= 400:
        raise PydanticCustomError("range", "{v} is no speed (whole km/h, 5 to 400)", {"v": value})
    return round(x)


def _text(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("shape", "a text is expected")
    return value


def _some_text(value: str) -> str:
    if not value.strip():
        raise PydanticCustomError("reason", "the reason is empty")
    return value


def version(value: object) -> object:
    """The version of the language."""
    if value != "1":
        raise PydanticCustomError("version", "version {v} is not supported", {"v": str(value)})
    return 1


def choice(kind: str, known: tuple[str, ...]) -> BeforeValidator:
    """One of some words."""

    def check(value: object) -> object:
        if not isinstance(value, str):
            raise PydanticCustomError("shape", "a text is expected")
        if value not in known:
            raise PydanticCustomError("choice", "'{v}' is not a {k}", {"v": value, "k": kind, "known": list(known)})
        return value

    return BeforeValidator(check)


# JSON Schema sees what a YAML reader makes of a scalar: a name may look like a number, a text like anything
_TEXT_SCHEMA = {"type": ["string", "number", "boolean", "null"]}
_PLAIN = NAME.pattern.replace("(", "(?:")
_NAME_SCHEMA = {"type": ["string", "integer"], "pattern": f"^{_PLAIN}$", "maxLength": MAX_NAME}
_ENDS = "start|end|toe|normal|reverse|1a|1b|2a|2b|outer|inner"
_END_SCHEMA = {"type": ["string", "integer"], "pattern": rf"^{_PLAIN}(?:\.(?:{_ENDS}))?$"}
_LONG = r"(?:\d+(?:\.\d*)?|\.\d+)"

_ITEM_SCHEMA = {"type": ["string", "integer"], "pattern": rf"^{_PLAIN}(?: +\+?{_LONG})?$"}
_APPROACH_SCHEMA = {"type": "string", "pattern": rf"^{_PLAIN} +\+?{_LONG}$"}
PATTERNS = {
    str(_NAME_SCHEMA["pattern"]): "name",
    str(_END_SCHEMA["pattern"]): "end",
    str(_ITEM_SCHEMA["pattern"]): "`NAME LENGTH`, or a boundary or buffer",
    str(_APPROACH_SCHEMA["pattern"]): "`NAME LENGTH`",
}
"""What texts of these patterns are, in words."""

Name = Annotated[str, BeforeValidator(_name), WithJsonSchema(_NAME_SCHEMA)]
Text = Annotated[str, BeforeValidator(_text), WithJsonSchema(_TEXT_SCHEMA)]
Reason = Annotated[
    str, BeforeValidator(_text), AfterValidator(_some_text), WithJsonSchema({**_TEXT_SCHEMA, "minLength": 1})
]
Item = Annotated[str, BeforeValidator(_text), WithJsonSchema(_ITEM_SCHEMA)]
Approach = Annotated[str, BeforeValidator(_text), WithJsonSchema(_APPROACH_SCHEMA)]
Metres = Annotated[str, BeforeValidator(_text), WithJsonSchema({"type": "number", "minimum": 0, "maximum": 2000})]
Permille = Annotated[float, BeforeValidator(_permille), WithJsonSchema({"type": "number"})]
Length = Annotated[
    float,
    BeforeValidator(_length),
    WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": MAX_LENGTH_M}),
]
Seconds = Annotated[
    float,
    BeforeValidator(_seconds),
    WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": 86400}),
]
Amount = Annotated[float, BeforeValidator(_amount), WithJsonSchema({"type": "number", "minimum": 0, "maximum": 86400})]
Speed = Annotated[int, BeforeValidator(_speed), WithJsonSchema({"type": "integer", "minimum": 5, "maximum": 400})]
End = Annotated[str, BeforeValidator(_text), WithJsonSchema(_END_SCHEMA)]
Pair = Annotated[list[End], Field(min_length=2, max_length=2)]


def _yes_no(value: object) -> object:
    if value not in ("yes", "no", "true", "false"):
        raise PydanticCustomError("choice", "'{v}' is neither yes nor no", {"v": str(value), "known": ["yes", "no"]})
    return value in ("yes", "true")


YesNo = Annotated[bool, BeforeValidator(_yes_no), WithJsonSchema({"enum": [True, False, "yes", "no", "true", "false"]})]


def _trains(value: object) -> object:
    """A number of trains."""
    if not isinstance(value, str) or not re.fullmatch(r"\d{1,4}", value) or not 1 <= int(value) <= 99:
        fix = "write how many trains may be there at once, for instance 4"
        raise PydanticCustomError("range", "{v} is no number of trains (1 to 99)", {"v": value, "fix": fix})
    return int(value)


def _level(value: object) -> int:
    """Tracks above or below the longest run."""
    text = str(value).strip()
    if not re.fullmatch(r"[+-]?\d{1,3}", text):
        fix = "write how many tracks above (or, with a minus, below) the longest run it lies: 1, -2"
        raise PydanticCustomError("number", "{v} is not a whole number", {"v": repr(text), "fix": fix})
    return int(text)


Trains = Annotated[int, BeforeValidator(_trains), WithJsonSchema({"type": "integer", "minimum": 1, "maximum": 99})]
Level = Annotated[int, BeforeValidator(_level), WithJsonSchema({"type": "integer", "minimum": -999, "maximum": 999})]
