"""The scalars of the layout language: names, numbers, choices, each with its check and its JSON Schema.

Raises PydanticCustomError with a kind that `schema` turns into a diagnostic.
"""

from __future__ import annotations

import math
import re
import unicodedata
from typing import Annotated

from pydantic import AfterValidator, BeforeValidator, Field, WithJsonSchema
from pydantic_core import PydanticCustomError

from interlock.frontend.signs import DIRECTIONS, parted
from interlock.model.portable import OWN_ENDING, portable

_UNSEEN = "\u115f\u1160\u3164\uffa0"  # letters to Unicode, and drawn as nothing
_NO_XML = "\ufffe\uffff"  # beside control characters
_WORD = rf"[^\W_{_UNSEEN}]+#?"
NAME = re.compile(rf"{_WORD}([ _/-]{_WORD})*")
"""Letters and digits of any script, a `#` after them, and single signs or spaces between."""
LONGEST_FOLDER = 60
"""Signs of a layout's own name: a file system takes 255 bytes, of which a sign may need four."""
NO_FOLDER = frozenset(
    (
        "CON",
        "PRN",
        "AUX",
        "NUL",
        *(f"{port}{sign}" for port in ("COM", "LPT") for sign in "123456789\u00b9\u00b2\u00b3"),
    )
)
"""Names of devices of Windows, which has no folder or file of such a name."""
MAX_LENGTH_M = 100_000.0
STEEPEST = 1000  # permille: no track is steeper than 1 in 1
FASTEST = 400  # km/h
LONGEST_HOLD_S = 3600
ADDRESS = re.compile(r"([IQ])([0-9]{1,4})\.([0-7])")
"""I or Q, byte, bit."""
_NUMBER = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)")
"""In ASCII digits: nobody is to think of a digit of another script as a letter, nor the other way round."""


def _name(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("shape", "a name is expected")
    if not NAME.fullmatch(value):
        raise PydanticCustomError("name", "{said}", {"v": value, "said": no_name(value), "fix": name_fix(value)})
    return value


def _folder_name(value: object) -> object:
    """A name that is that of a folder and of files, too."""
    if isinstance(value, str) and NAME.fullmatch(value) and "/" in value:
        said = f"'{value}' cannot be the layout's name: its outputs lie in a folder of that name, so it has no /"
        fix = f"write `{value.replace('/', '-')}`; `title` takes any text"
        raise PydanticCustomError("name", "{said}", {"v": value, "said": said, "fix": fix})
    if isinstance(value, str) and value.upper() in NO_FOLDER:
        said = (
            f"'{value}' cannot be the layout's name: its outputs lie in a folder of that name, and to Windows it is "
            "a device"
        )
        fix = f"write another one, as `{value}_1`; `title` takes any text"
        raise PydanticCustomError("name", "{said}", {"v": value, "said": said, "fix": fix})
    if isinstance(value, str) and len(value) > LONGEST_FOLDER and NAME.fullmatch(value):
        said = (
            f"'{value[:20]}…' cannot be the layout's name: it has {len(value)} signs, and its outputs lie in a folder "
            f"of that name, so it has {LONGEST_FOLDER} at most"
        )
        fix = "write a shorter one; `title` takes any text"
        raise PydanticCustomError("name", "{said}", {"v": value, "said": said, "fix": fix})
    if isinstance(value, str) and NAME.fullmatch(value) and (own := OWN_ENDING.search(portable(value))):
        said = (
            f"'{value}' cannot be the layout's name: `IL_{portable(value)}` would be its block, and one of a layout "
            f"`{portable(value)[: own.start()]}`, too, in PLC text"
        )
        fix = f"write another one, as `{value}_1`; `title` takes any text"
        raise PydanticCustomError("name", "{said}", {"v": value, "said": said, "fix": fix})
    return _name(value)


def no_name(text: str) -> str:
    """Why a text cannot be a name."""
    if not text.strip():
        return "the name is missing"
    why = _unseen(text) or "use letters, digits and single spaces or _ - / between them"
    return f"'{text}' cannot be a name: {why}"


def _unseen(text: str) -> str:
    """What a name has in it that nobody sees; empty where it has nothing of that kind."""
    for sign in text:
        if sign != " " and (sign in _UNSEEN or unicodedata.category(sign) in ("Zs", "Zl", "Zp", "Cc", "Cf")):
            called = "tab" if sign == "\t" else unicodedata.name(sign, f"U+{ord(sign):04X}").lower()
            return f"it has a {called} in it"
    if text != text.strip():
        return "it begins or ends with a space"
    return "two spaces stand beside each other" if "  " in text else ""


def _seen(text: str) -> str:
    """A text with plain single spaces for those of other kinds, and without what nobody sees."""
    kept = (s for s in text if s.isspace() or (s not in _UNSEEN and unicodedata.category(s) not in ("Cc", "Cf")))
    return " ".join("".join(kept).split())


def name_fix(text: str) -> str:
    """How a name could be written: composed, without curly quotes, with `_` for what cannot stand in it."""
    if not text.strip():
        return "write the name after the colon"
    if _unseen(text) and NAME.fullmatch(_seen(text)):
        return f"write `{_seen(text)}`" + (", with plain single spaces" if " " in _seen(text) else "")
    composed = unicodedata.normalize("NFC", text)
    bare = composed.strip("\u201c\u201d\u2018\u2019\u300c\u300d")
    if bare != text and NAME.fullmatch(bare):
        return f"write `{bare}`, " + ("in composed letters" if bare == composed else "without the curly quotes")
    parts = parted(composed)
    if parts and all(map(NAME.fullmatch, parts)):
        if len(parts) == 2 and "。" in text and parts[1] in _ENDS.split("|"):
            return f"write `{'.'.join(parts)}`, with an ASCII point"
        return f"write `{', '.join(parts)}`, with ASCII commas" + ("" if "。" not in text else " between names")
    near = re.sub(r"[^\w /-]+", "_", _seen(bare)).strip("_-/ ")
    if NAME.fullmatch(near):
        return f"write it like `{near}`"
    return "letters and digits of any script, single spaces or _ - / between them, # after them; `title` takes any text"


def item_parts(text: str) -> tuple[str, str]:
    """The name and the length that an item of a track states, `Gleis 3 850`: the last word, where it is a number."""
    name, *length = text.strip().rsplit(None, 1) or [""]
    return (name, length[0]) if length and number_text(length[0]) else (text.strip(), "")


def length_behind(text: str, name: str) -> str:
    """The length that follows a name without a space between, `q1400`, `q1(400)`, `q1:400`; empty where none does."""
    rest = text[len(name) :].strip("()[]:=@ ") if text.startswith(name) and text != name else ""
    return rest if number_text(rest) else ""


def number(text: str, wanted: str = "") -> float:
    """A finite number in plain decimal notation, of a quantity if one is `wanted`; raises PydanticCustomError
    otherwise."""
    if not _NUMBER.fullmatch(text):
        fix = number_fix(text, wanted) or QUANTITIES.get(wanted, "")
        context = {"v": text, "cause": slip_of(text)} | ({"fix": fix} if fix else {})
        raise PydanticCustomError("number", "'{v}' is not a number", context)
    return float(text)


_UNITS = {
    "m": (1.0, "lengths are metres"),
    "km": (1000.0, "lengths are metres"),
    "cm": (0.01, "lengths are metres"),
    "ft": (0.3048, "lengths are metres"),
    "s": (1.0, "times are seconds"),
    "sec": (1.0, "times are seconds"),
    "min": (60.0, "times are seconds"),
    "h": (3600.0, "times are seconds"),
    "km/h": (1.0, "speeds are km/h"),
    "kmh": (1.0, "speeds are km/h"),
    "kph": (1.0, "speeds are km/h"),
    "m/s": (3.6, "speeds are km/h"),
    "mph": (1.609344, "speeds are km/h"),
    "m/s2": (1.0, "braking is m/s^2"),
}
_UNITS |= {
    **dict.fromkeys(("米",), _UNITS["m"]),
    **dict.fromkeys(("公里", "千米"), _UNITS["km"]),
    **dict.fromkeys(("厘米",), _UNITS["cm"]),
    **dict.fromkeys(("秒", "秒钟"), _UNITS["s"]),
    **dict.fromkeys(("分", "分钟"), _UNITS["min"]),
    **dict.fromkeys(("时", "小时"), _UNITS["h"]),
    **dict.fromkeys(("公里/小时", "公里/时", "千米/小时", "千米/时"), _UNITS["km/h"]),
    **dict.fromkeys(("米/秒",), _UNITS["m/s"]),
}
_WITH_UNIT = re.compile(r"([+-]?[0-9]+(?:[.,][0-9]+)?)\s*([A-Za-z/]+2?|[\u4e00-\u9fff/]+)")
QUANTITIES = {
    "metres": "write metres as a plain decimal number, for instance 350 or 12.5",
    "seconds": "write seconds as a plain decimal number, for instance 30",
    "km/h": "write km/h as a plain decimal number, for instance 25",
}
"""How a number of each is written."""


def _with_unit(text: str, wanted: str = "") -> tuple[float, str] | None:
    """A number with a unit, in the unit of the language, and the words for that; None for others, and where another
    quantity is `wanted`.  `20 km` is a speed where one is wanted."""
    found = _WITH_UNIT.fullmatch(unicodedata.normalize("NFKC", text))
    unit = found[2].lower() if found is not None else ""
    if found is None or unit not in _UNITS:
        return None
    factor, what = _UNITS["km/h" if wanted == "km/h" and _UNITS[unit] == _UNITS["km"] else unit]
    return (float(found[1].replace(",", ".")) * factor, what) if what.endswith(wanted) else None


def number_text(text: str) -> bool:
    """Whether a text is a number in plain decimal notation."""
    return _NUMBER.fullmatch(text) is not None


def slip_of(text: str) -> str:
    """What kind of slip makes a number unreadable, so that many of them are told once; empty if it is its own."""
    if re.fullmatch(r"[+-]?\d+,\d+", text):
        return "a decimal comma"
    found = _WITH_UNIT.fullmatch(unicodedata.normalize("NFKC", text))
    return f"the unit {found[2].lower()}" if found and found[2].lower() in _UNITS else ""


def number_fix(text: str, wanted: str = "") -> str:
    """How a number with a comma, a unit or digits of another script is written, of a quantity if one is `wanted`; empty
    where nobody can tell."""
    plain = "".join(str(unicodedata.digit(c, c)) for c in unicodedata.normalize("NFKC", text))
    if plain != text and _NUMBER.fullmatch(plain):
        return f"write {plain}, in ASCII digits"
    if re.fullmatch(r"[1-9]\d{0,2}(,\d{3})+", text):
        plain = text.replace(",", "")
        return f"write {plain}, without the comma" + (
            f", or {text.replace(',', '.')} if the comma divides decimals" if text.count(",") == 1 else ""
        )
    if slip_of(text) == "a decimal comma":
        return f"write {text.replace(',', '.')}: decimals follow a point"
    found = _with_unit(text, wanted)
    return f"write {found[0]:.10g}: {found[1]}, without the unit" if found is not None else ""


def _length(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a length in metres is expected")
    x = number(value, "metres")
    if not math.isfinite(x) or not 0 < x <= MAX_LENGTH_M:
        raise PydanticCustomError("range", "{v} m is not a possible length", {"v": value})
    return x


KILOMETRE = re.compile(r"([0-9]{1,4})\+([0-9]{3}(?:\.[0-9]{1,3})?)")
"""`12+345.6`: kilometres, and three digits of metres with decimals."""


def position(text: str) -> float:
    """Metres of a position along the line; raises PydanticCustomError otherwise."""
    found = KILOMETRE.fullmatch(text)
    if found is None:
        fix = "write kilometres, a plus, and three digits of metres: 12+345.6 is 12,345.6 m"
        raise PydanticCustomError("number", "'{v}' is not a position along the line", {"v": text, "fix": fix})
    return round(1000 * int(found[1]) + float(found[2]), 3)


def written_km(metres: float) -> str:
    """A position as it is written."""
    whole, rest = divmod(round(metres * 1000), 1_000_000)
    text = f"{rest / 1000:07.3f}".rstrip("0").rstrip(".")
    return f"{whole}+{text}"


def _position(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a position along the line is expected")
    return position(value)


WIDE = 1_000_000  # pixels of a plan


def _coordinate(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a coordinate is expected")
    x = number(value)
    if not abs(x) <= WIDE:
        raise PydanticCustomError("range", "{v} is no place on a plan", {"v": value})
    return x


def _seconds(value: object) -> object:
    return _amount(value, zero=False)


def _amount(value: object, zero: bool = True) -> float:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value)
    if not math.isfinite(x) or not 0 <= x <= 86_400 or (x == 0 and not zero):
        least = "0" if zero else "above 0,"
        fix = "write a number, 0 or more" if zero else "write a number above 0"
        if x > 86_400:
            fix = "write a number of at most 86400; a time is in seconds, and a day has so many"
        raise PydanticCustomError("range", "{v} is out of range ({l} to 86400)", {"v": value, "l": least, "fix": fix})
    return x


def _hold(value: object) -> float:
    """Seconds for which something is held longer."""
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value, "seconds")
    if not 0 <= x <= LONGEST_HOLD_S:
        fix = f"write seconds, 0 to {LONGEST_HOLD_S}; 30 are usual"
        raise PydanticCustomError(
            "range", "{v} s is no time to hold points (0 to {m} s)", {"v": value, "m": LONGEST_HOLD_S, "fix": fix}
        )
    return x


def _permille(value: object) -> float:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value)
    if not -STEEPEST <= x <= STEEPEST:
        fix = f"give permille from -{STEEPEST} to {STEEPEST}, negative where the track rises towards the signal"
        raise PydanticCustomError("range", "{v} permille is no gradient", {"v": value, "fix": fix})
    return x


def _speed(value: object) -> int:
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    kmh = _kmh(value)
    fix = "write whole km/h, from 5 to 400" + (f": {math.floor(kmh)}" if kmh else "")
    if not number_text(value):
        advice = number_fix(value, "km/h")
        advice = advice if kmh == math.floor(kmh) and advice else fix
        context = {"v": value, "cause": slip_of(value), "fix": advice}
        raise PydanticCustomError("number", "'{v}' is not a number", context)
    x = number(value)
    if x != round(x) or not 5 <= x <= 400:
        raise PydanticCustomError("range", "{v} is no speed (whole km/h, 5 to 400)", {"v": value, "fix": fix})
    return round(x)


def _towards(value: object) -> float:
    """A speed for which something is made, with decimals if need be."""
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value, "km/h")
    if not 0 < x <= FASTEST:
        fix = f"write km/h, above 0 and at most {FASTEST}"
        raise PydanticCustomError(
            "range", "{v} is no speed (above 0, to {m} km/h)", {"v": value, "m": FASTEST, "fix": fix}
        )
    return x


def _kmh(text: str) -> float:
    """The km/h that a text means with decimals or a unit of speed, if they are a speed that can be stated; else 0."""
    amount = text.replace(",", ".")
    found = (float(amount), "") if number_text(amount) else _with_unit(text, "km/h")
    kmh = round(found[0], 6) if found is not None else 0.0
    return kmh if 5 <= kmh <= 400 else 0.0


def _text(value: object) -> object:
    if not isinstance(value, str):
        raise PydanticCustomError("shape", "a text is expected")
    found = next((s for s in value if _not_held(s)), "")
    if found:
        said = f"the text has the character U+{ord(found):04X} in it, which not every output can hold"
        fix = "leave it out; a text may have tabs and several lines"
        if found in DIRECTIONS:
            said = f"the text has the character U+{ord(found):04X} in it: what follows is shown in another direction"
            fix = "leave it out; letters that are written from right to left need none"
        raise PydanticCustomError("sign", "{said}", {"said": said, "fix": fix})
    return value


def _not_held(sign: str) -> bool:
    """Whether plans, tables or PLC texts lose a character, are broken by it, or show others than they have."""
    return sign in _NO_XML or sign in DIRECTIONS or (sign not in "\n\t" and unicodedata.category(sign) in ("Cc", "Cs"))


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
# patterns of JSON Schema know no classes of letters, nor all of them signs beyond U+FFFF: what is no letter is listed,
# by blocks; marks and rare symbols pass
_LETTER = (
    r"[^\u0000-\u002F\u003A-\u0040\u005B-\u0060\u007B-\u00A9\u00AB-\u00B1\u00B4\u00B6-\u00B8\u00BB\u00BF\u00D7"
    r"\u00F7\u02C2-\u02C5\u02D2-\u02DF\u02E5-\u02EB\u02ED\u02EF-\u02FF\u0300-\u036F\u115F\u1160\u1680\u180E"
    r"\u2000-\u206F\u207A-\u207E\u208A-\u208E\u20A0-\u20FF\u2103-\u2106\u2108\u2109\u2116-\u2118\u2190-\u245F"
    r"\u249C-\u24B5\u2500-\u2775\u2794-\u2BFF\u2E00-\u2E2E\u2E30-\u3004\u3008-\u3020\u3030\u303D-\u3040"
    r"\u3099-\u309C\u30A0\u30FB\u3164\uE000-\uF8FF\uFE00-\uFE6F\uFEFF-\uFF0F\uFF1A-\uFF20\uFF3B-\uFF40"
    r"\uFF5B-\uFF65\uFFA0\uFFE0-\uFFFF]"
)
_PLAIN = f"{_LETTER}+#?(?:[ _/-]{_LETTER}+#?)*"
_NAME_SCHEMA = {"type": ["string", "integer"], "pattern": f"^{_PLAIN}$"}
_FOLDER_SCHEMA = {"type": ["string", "integer"], "maxLength": LONGEST_FOLDER, "pattern": f"^{_PLAIN.replace('/', '')}$"}
_ENDS = "start|end|toe|normal|reverse|1a|1b|2a|2b|outer|inner"
_END_SCHEMA = {"type": ["string", "integer"], "pattern": rf"^{_PLAIN}(?:\.(?:{_ENDS}))?$"}
_LONG = r"(?:\d+(?:\.\d*)?|\.\d+)"

_KM = r"\d{1,4}\+\d{3}(?:\.\d{1,3})?"
_KM_SCHEMA = {"type": "string", "pattern": f"^{_KM}$"}
_ITEM_SCHEMA = {"type": ["string", "integer"], "pattern": rf"^(?:{_PLAIN}(?: +\+?{_LONG}|\.(?:{_ENDS}))?|{_KM})$"}
_APPROACH_SCHEMA = {"type": "string", "pattern": rf"^{_PLAIN} +\+?{_LONG}$"}
PATTERNS = {
    str(_NAME_SCHEMA["pattern"]): "name",
    str(_FOLDER_SCHEMA["pattern"]): "name without `/`",
    str(_END_SCHEMA["pattern"]): "end",
    str(_ITEM_SCHEMA["pattern"]): "`NAME LENGTH`, or a boundary, a buffer, an end, a position, or a name between two",
    str(_KM_SCHEMA["pattern"]): "`KM+METRES`",
    str(_APPROACH_SCHEMA["pattern"]): "`NAME LENGTH`",
}
"""What texts of these patterns are, in words."""

Name = Annotated[str, BeforeValidator(_name), WithJsonSchema(_NAME_SCHEMA)]
FolderName = Annotated[str, BeforeValidator(_folder_name), WithJsonSchema(_FOLDER_SCHEMA)]
Text = Annotated[str, BeforeValidator(_text), WithJsonSchema(_TEXT_SCHEMA)]
Reason = Annotated[
    str, BeforeValidator(_text), AfterValidator(_some_text), WithJsonSchema({**_TEXT_SCHEMA, "minLength": 1})
]
Item = Annotated[str, BeforeValidator(_text), WithJsonSchema(_ITEM_SCHEMA)]
Approach = Annotated[str, BeforeValidator(_text), WithJsonSchema(_APPROACH_SCHEMA)]
Metres = Annotated[str, BeforeValidator(_text), WithJsonSchema({"type": "number", "minimum": 0, "maximum": 2000})]
Permille = Annotated[
    float, BeforeValidator(_permille), WithJsonSchema({"type": "number", "minimum": -STEEPEST, "maximum": STEEPEST})
]
Length = Annotated[
    float,
    BeforeValidator(_length),
    WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": MAX_LENGTH_M}),
]
Coordinate = Annotated[
    float, BeforeValidator(_coordinate), WithJsonSchema({"type": "number", "minimum": -WIDE, "maximum": WIDE})
]
Kilometre = Annotated[float, BeforeValidator(_position), WithJsonSchema(_KM_SCHEMA)]
XY = Annotated[list[Coordinate], Field(min_length=2, max_length=2)]
Seconds = Annotated[
    float,
    BeforeValidator(_seconds),
    WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": 86400}),
]
Amount = Annotated[float, BeforeValidator(_amount), WithJsonSchema({"type": "number", "minimum": 0, "maximum": 86400})]
Hold = Annotated[
    float, BeforeValidator(_hold), WithJsonSchema({"type": "number", "minimum": 0, "maximum": LONGEST_HOLD_S})
]
Speed = Annotated[int, BeforeValidator(_speed), WithJsonSchema({"type": "integer", "minimum": 5, "maximum": 400})]
Kmh = Annotated[
    float, BeforeValidator(_towards), WithJsonSchema({"type": "number", "exclusiveMinimum": 0, "maximum": FASTEST})
]
End = Annotated[str, BeforeValidator(_text), WithJsonSchema(_END_SCHEMA)]
Pair = Annotated[list[End], Field(min_length=2, max_length=2)]


def _yes_no(value: object) -> object:
    if value not in ("yes", "no", "true", "false"):
        raise PydanticCustomError("choice", "'{v}' is neither yes nor no", {"v": str(value), "known": ["yes", "no"]})
    return value in ("yes", "true")


YesNo = Annotated[bool, BeforeValidator(_yes_no), WithJsonSchema({"enum": [True, False, "yes", "no", "true", "false"]})]


def _trains(value: object) -> object:
    """A number of trains."""
    if not isinstance(value, str) or not re.fullmatch(r"[0-9]{1,4}", value) or not 1 <= int(value) <= 99:
        fix = "write how many trains may be there at once, for instance 4"
        raise PydanticCustomError("range", "{v} is no number of trains (1 to 99)", {"v": value, "fix": fix})
    return int(value)


def _count(value: object) -> object:
    """A whole number of things, at least one."""
    if not isinstance(value, str) or not re.fullmatch(r"[0-9]{1,6}", value) or not int(value):
        fix = "write a whole number, for instance 64"
        raise PydanticCustomError("range", "{v} is no whole number from 1 to 999999", {"v": value, "fix": fix})
    return int(value)


def _level(value: object) -> int:
    """Tracks above or below the longest run."""
    text = str(value).strip()
    if not re.fullmatch(r"[+-]?[0-9]{1,3}", text):
        fix = "write how many tracks above (or, with a minus, below) the longest run it lies: 1, -2"
        raise PydanticCustomError("number", "{v} is not a whole number", {"v": repr(text), "fix": fix})
    return int(text)


def _within(value: object) -> object:
    """Seconds of a heartbeat: two cycles of 100 ms at least."""
    if not isinstance(value, str):
        raise PydanticCustomError("number", "a number is expected")
    x = number(value, "seconds")
    if not 0.2 <= x <= 1:
        fix = "write seconds, 0.2 to 1; where it takes longer, nobody knows what has happened meanwhile"
        raise PydanticCustomError("range", "{v} s is no time for a heartbeat", {"v": value, "fix": fix})
    return x


Within = Annotated[float, BeforeValidator(_within), WithJsonSchema({"type": "number", "minimum": 0.2, "maximum": 1})]
Trains = Annotated[int, BeforeValidator(_trains), WithJsonSchema({"type": "integer", "minimum": 1, "maximum": 99})]
Count = Annotated[int, BeforeValidator(_count), WithJsonSchema({"type": "integer", "minimum": 1, "maximum": 999_999})]
Level = Annotated[int, BeforeValidator(_level), WithJsonSchema({"type": "integer", "minimum": -999, "maximum": 999})]
