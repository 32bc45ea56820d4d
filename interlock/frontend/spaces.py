"""Names with spaces where a space also divides a section from its length: `Gleis 3 850`.

The last word is the length.  A comma forgotten, a length left out, or a space between thousands would otherwise become
part of a name, or a name part of a length: what can be read in two ways is refused.
Output: a section and its metres, or IL1012, IL1013, IL1014, IL1016, IL1021.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from pydantic_core import PydanticCustomError

from interlock.dataclass import dataclass
from interlock.diag import Span
from interlock.frontend.context import Context
from interlock.frontend.scalars import (
    MAX_LENGTH_M,
    NAME,
    item_parts,
    name_fix,
    no_name,
    number,
    number_fix,
    number_text,
    slip_of,
)
from interlock.frontend.schema import LayoutFile

_ITEM = re.compile(r"(.*\S)\s+(\S+)")
_DIVIDED = re.compile("[;；，、]")
_TO_999 = re.compile(r"[1-9]\d{0,2}")
_THREE = re.compile(r"\d{3}(\.\d*)?")


def section_and_length(ctx: Context, text: str, span: Span, example: str = "q1") -> tuple[str, float] | None:
    """'q1 400' as section and metres; reports IL1012, IL1013, IL1014, IL1016.  `example`: a name for a fix."""
    words, match = text.split(), _ITEM.fullmatch(text.strip())
    unit = "".join(words[-2:]) if len(words) > 2 and number_text(words[-2]) and not number_text(words[-1]) else ""
    shape = len(words) == 2 or (words and (number_text(words[-1]) or slip_of(words[-1])))
    if match is None or not shape or (len(words) > 2 and _DIVIDED.search(text)):
        fix = f"write `section length`, for instance `{example} 400`"
        if len(words) == 1 and number_text(words[0]):
            fix = f"name the section before its length, for instance `{example} {words[0]}`"
        if unit and slip_of(unit):
            name, text_ = " ".join(words[:-2]), " ".join(words[-2:])
            fix = number_fix(text_).replace("write ", f"write `{name} ", 1).replace(":", "`:", 1)
            said = f"the length of {name}, '{text_}', is not a number"
            ctx.add("IL1013", said, span, fix, cause=slip_of(unit), note=text)
        elif _DIVIDED.search(text):
            fix = f"write `{', '.join(part.strip() for part in _DIVIDED.split(text))}`"
            ctx.add("IL1012", f"'{text}': what follows one another is divided by commas", span, fix)
        else:
            said = f"'{text}': " if words else "nothing is written: "
            ctx.add("IL1012", f"{said}a section and its length are expected here", span, fix)
        return None
    name, length = match.groups()
    if not NAME.fullmatch(name):
        ctx.add("IL1016", no_name(name), span, name_fix(name))
        return None
    try:
        metres = number(length)
    except PydanticCustomError:
        fix = number_fix(length) or "write metres as a plain decimal number, for instance 350 or 12.5"
        if number_text(name) and NAME.fullmatch(length):
            fix = f"write `{length} {name}`: the section stands before its length"
        said = f"the length of {name}, '{length}', is not a number"
        ctx.add("IL1013", said, span, fix, cause=slip_of(length), note=text)
        return None
    if not 0 < metres <= MAX_LENGTH_M:
        ctx.add(
            "IL1014", f"{length} m is not a possible length of {name}", span, "give a length above 0 and at most 100 km"
        )
        return None
    return name, metres


@dataclass(frozen=True)
class Spoken:
    """Of what a file speaks: sections elsewhere than in its tracks; boundaries and buffers; the words before the number
    of a section, with the sections that have it (`Gleis 1` and `Gleis 2`)."""

    sections: frozenset[str]
    ends: frozenset[str]
    numbered: Mapping[str, frozenset[str]]
    positions: bool
    """Lengths may follow from positions, so that a name may stand alone in a track."""


def spoken_of(f: LayoutFile, positions: bool) -> Spoken:
    """The names of a file, by what speaks of them."""
    found = {n for g in f.signals.values() for n in (g.from_, g.into)} | f.sections.keys() | f.drawing.keys()
    found |= {x.section for room in (f.points, f.slips, f.derailers) for x in room.values()}
    found |= {arm.section for c in f.crossings.values() for arm in c.arms}
    found |= {n for z in f.zones.values() for n in z.sections} | {n for c in f.conditions.values() for n in c.over}
    found |= {n for room in (f.level_crossings, f.interlocks) for d in room.values() for n in d.over}
    found |= {n for those in f.substations.values() for n in those}
    numbered: dict[str, set[str]] = {}
    for name in (item_parts(x)[0] for items in f.tracks.values() for x in items):
        base, _, number = name.rpartition(" ")
        if base and number.isdigit():
            numbered.setdefault(base, set()).add(name)
    ends = frozenset((*f.boundaries, *f.buffers, *f.traps))
    return Spoken(frozenset(found), ends, {k: frozenset(v) for k, v in numbered.items()}, positions)


def sure(ctx: Context, track: str, i: int, known: Spoken) -> bool:
    """Whether an item of a track can be read in one way alone."""
    text = ctx.file.tracks[track][i]
    if " " not in text:
        return True
    item, span = " ".join(text.split()), ctx.at("tracks", track, i)
    name, metres = item_parts(text)
    if not NAME.fullmatch(name):
        return True  # reported as no name
    if item in known.ends:
        return not (metres and name in known.sections) or _report(ctx, item, span, *_as_end(item, name, metres))
    others = known.numbered.get(name, frozenset()) - {item}
    if metres and NAME.fullmatch(item) and (item in known.sections or others):
        return _report(ctx, item, span, *_no_length(item, name, metres))
    if not metres and (not known.positions or slip_of("".join(item.split()[-2:]))):
        return True  # a name alone, or a length with its unit: reported elsewhere
    if " " in name and name not in known.sections:
        return _report(ctx, item, span, *_unknown(name, metres))
    if _thousands(name, metres) and name.rpartition(" ")[0] in known.sections:
        return _report(ctx, item, span, *_grouped(name, metres))
    return True


def sure_approach(ctx: Context, text: str, span: Span, known: Spoken) -> bool:
    """The same of an approach section and its length."""
    name, metres = item_parts(text)
    sure = not _thousands(name, metres) or name in known.sections
    return sure or _report(ctx, text, span, *_grouped(name, metres))


def _report(ctx: Context, item: str, span: Span, why: str, fix: str) -> bool:
    ctx.add("IL1021", f"'{item}' can be read in two ways: {why}", span, fix, note=item)
    return False


def _thousands(name: str, metres: str) -> bool:
    """Whether a name may end in the thousands of a length: `q1 1 200`."""
    return (
        " " in name and _TO_999.fullmatch(name.rpartition(" ")[2]) is not None and _THREE.fullmatch(metres) is not None
    )


def _as_end(item: str, name: str, metres: str) -> tuple[str, str]:
    why = f"the boundary or buffer {item}, or the section {name} with {metres} m"
    return why, f"write `{name} {float(metres):g}.0` if the section is meant, else rename one of them"


def _no_length(item: str, name: str, metres: str) -> tuple[str, str]:
    why = f"the section {item} without a length, or the section {name} with {metres} m"
    return why, f"write `{item} 100`, with the length of {item}, or `{name} {float(metres):g}.0` if that is its length"


def _grouped(name: str, metres: str) -> tuple[str, str]:
    base, _, thousands = name.rpartition(" ")
    why = f"the section {base} with {thousands}{metres} m, or the section {name} with {metres} m"
    return why, f"write `{base} {thousands}{metres}`, or `{name} 0{metres}` if the section is called {name}"


def _unknown(name: str, metres: str) -> tuple[str, str]:
    """A name with spaces that stands nowhere else."""
    own = f"name it under `sections`, too: `{name}: {{}}`"
    if _thousands(name, metres):
        why, fix = _grouped(name, metres)
        return why, f"{fix.split(', or')[0]}, or {own}"
    words = name.split()
    inner = next((k for k, w in enumerate(words[:-1]) if k and number_text(w)), None)
    if inner is not None:
        first, second = " ".join(words[: inner + 1]), " ".join([*words[inner + 1 :], *([metres] if metres else [])])
        why = f"nothing else speaks of a section {name}; is a comma missing?"
        return why, f"write `{first}, {second}`; if there is a section {name}, {own}"
    why = f"nothing else speaks of a section {name}; is it one name, or does a comma or a length miss?"
    return why, f"divide what follows one another by commas; if there is a section {name}, {own}"
