"""What a name of a variable is: a family, and the elements and numbers at which it stands.

Families are in `names.py`, and so are the names of this module for whoever makes or reads names.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from enum import Enum, StrEnum
from importlib import import_module
from string import digits

from interlock.model.portable import joined, portable

Part = str | int


class Kind(StrEnum):
    """What a variable belongs to."""

    NOTHING = "nothing"
    RESTART = "restart"
    REQUESTS = "requests"
    STARTS = "starts"
    SECTION = "section"
    SIGNAL = "signal"
    OVERLAP = "overlap"
    MACHINE = "point"
    ROUTE = "route"
    LINE = "line"
    ZONE = "zone"
    CONDITION = "condition"
    BUFFER = "buffer"


class Form(Enum):
    """What is made of another name, and its text."""

    NEXT = "{}'"
    """The value one step later."""
    CHOICE = "?{}"
    """The world chooses that it happens."""
    COVERED = "cov.{}"
    """A history variable: since the timer's input rose, what its clock looks at has held."""
    COMPUTED = "N_{}"
    """Where the text of a program computes the next value, before all are committed at once."""
    EACH = "#{}"
    """The variable of any route: what stands for one of them in what is said of all alike."""
    VALUE = "#{}="
    """That a variable has the number of any route."""
    BLOCK = "{}#"
    """One of the two former, of some route of an equivalence class."""
    COPY = "{}~"
    """The same variable of a second controller."""


class Owner(str):
    """An element of the railway to which variables belong; its text is that of a group of equations."""

    __slots__ = ("id", "kind")

    kind: Kind
    id: str
    """Its name in the layout."""

    @staticmethod
    def of(kind: Kind, element: str) -> Owner:
        """The element of a kind and a name."""
        owner = Owner(f"{kind} {element}" if element else kind)
        owner.kind, owner.id = kind, element
        return owner

    def __reduce__(self) -> tuple[Callable[..., Owner], tuple[object, ...]]:
        return Owner.of, (self.kind, self.id)


class Name(str):
    """The name of a variable.  Made by families, and by the properties of other names; never from text."""

    __slots__ = ("_computed", "_copy", "_next", "_owner", "at", "base", "family", "form")

    family: Family
    at: tuple[Part, ...]
    form: Form | None
    base: Name
    """The name of which this one is made; itself if of none."""
    _next: Name | None
    _owner: Owner | None
    _copy: Name | None
    _computed: Name | None

    @staticmethod
    def _made(
        text: str, family: Family, at: tuple[Part, ...], form: Form | None = None, of: Name | None = None
    ) -> Name:
        name = Name(text)
        name.family, name.at, name.form, name.base = family, at, form, name if of is None else of
        name._next = name._copy = name._computed = name._owner = None
        return name

    def __reduce__(self) -> tuple[Callable[..., Name], tuple[object, ...]]:
        if self.form is not None:
            return _of_form, (self.form, self.base)
        return (_again, (self.family.key, self.at)) if self.family.key else (spelled, (str(self),))

    @property
    def next(self) -> Name:
        """The name of its value one step later."""
        found = self._next
        if found is None:
            found = self._next = _of_form(Form.NEXT, self)
        return found

    @property
    def copy(self) -> Name:
        """The name of the same variable of a second controller."""
        found = self._copy
        if found is None:
            found = self._copy = _of_form(Form.COPY, self)
        return found

    @property
    def indexed(self) -> bool:
        """It stands for a variable of any route."""
        return self.form is Form.EACH or self.form is Form.VALUE

    @property
    def primed(self) -> bool:
        """It is a value one step later."""
        return self.form is Form.NEXT

    @property
    def owner(self) -> Owner | None:
        """The element to which it belongs, if to one."""
        found = self._owner
        if found is None:
            found = self._owner = self.family.owner(self.at)
        return found

    @property
    def number(self) -> int:
        """The number of the route to which it belongs."""
        assert self.family.kind is Kind.ROUTE
        return int(self.at[0])

    @property
    def head(self) -> str:
        """How names of its family and form begin, with numbers and positions that stand before the element's name."""
        return self.family.head(self.at) if self.form is None else self.form.value.format(self.base.head)

    @property
    def stem(self) -> str:
        """What of its text stands before the first underscore, or dot: by this the library of shapes sorts facts."""
        return self.split("_" if "_" in self else ".")[0] + ("'" if self.primed else "")

    @property
    def sort(self) -> str:
        """The same without numbers: what a table of mutants counts by."""
        return self.head.rstrip(digits)


class Family:
    """Variables of one meaning: how they are written, and what they belong to.

    pattern: their text, with `{}` or `{0}` for what they stand at.  kind, place: what they belong to, and which of the
    parts of `at` it is.  portable: layout names are written as identifiers.  history: the proof remembers it of a run.
    """

    __slots__ = ("_each", "_head", "history", "key", "kind", "meaning", "pattern", "place", "portable")

    def __init__(
        self, kind: Kind, pattern: str, meaning: str, place: int = 0, portable: bool = False, history: bool = False
    ) -> None:
        self.key = ""
        self._each: dict[bool, Name] = {}
        self.kind = kind
        self.pattern = pattern
        self.meaning = meaning
        self.place = place
        self.portable = portable
        self.history = history
        self._head = pattern.split("_" if portable else ".")[0]

    def __repr__(self) -> str:
        return f"<{self.pattern}: {self.meaning}>"

    def __reduce__(self) -> tuple[Callable[[str], Family], tuple[str]]:
        return _family, (self.key,)

    def __call__(self, *at: Part) -> Name:
        """The name of the variable at some element."""
        found = _names[self].get(at)
        if found is None:
            parts = [x if isinstance(x, int) else portable(x) if self.portable else joined(x) for x in at]
            found = _names[self][at] = Name._made(self.pattern.format(*parts), self, at)
        return found

    def each(self, primed: bool) -> Name:
        """A route's variable without its route, before or after a step."""
        found = self._each.get(primed)
        if found is None:
            text = Form.EACH.value.format(self.pattern + ("'" if primed else ""))
            found = self._each[primed] = Name._made(text, self, (), Form.EACH)
        return found

    def owner(self, at: tuple[Part, ...]) -> Owner | None:
        """The element to which the variable at some parts belongs."""
        if self.kind is Kind.NOTHING:
            return None
        return Owner.of(self.kind, str(at[self.place]) if at else "")

    def head(self, at: tuple[Part, ...]) -> str:
        """How the text of a name begins."""
        return self._head.format(*at)


# names that were made, by family and parts: a table of the piece of work that makes them (see `expr.interning`)
Made = defaultdict[Family, dict[tuple[Part, ...], Name]]
_names: Made


def use(made: Made) -> None:
    """Keep the names that are made from now on in a table."""
    global _names
    _names = made


use(defaultdict(dict))


def each(name: Name) -> Name:
    """A route's variable without its route."""
    return name.family.each(name.primed)


def each_value(name: Name) -> Name:
    """A variable that has the numbers of routes for values, without its value."""
    return _of_form(Form.VALUE, name)


def of_block(name: Name, number: int) -> Name:
    """A route's variable, of some route of an equivalence class."""
    return Name._made(f"{number}{Form.BLOCK.value.format(name)}", name.family, (number,), Form.BLOCK, name)


def _of_form(form: Form, name: Name) -> Name:
    name = spelled(name)
    return Name._made(form.value.format(name), name.family, name.at, form, name)


def choice(name: Name) -> Name:
    """The world chooses that something happens, or how long something lasts."""
    return _of_form(Form.CHOICE, name)


def computed(name: Name) -> Name:
    """Where the text of a program computes the next value of a state variable."""
    name = spelled(name)
    found = name._computed
    if found is None:
        found = name._computed = _of_form(Form.COMPUTED, name)
    return found


def covered(timer: Name) -> Name:
    """The history variable of a timer: since its input rose, what its clock looks at has held."""
    return _of_form(Form.COVERED, timer)


_SPELLED = Family(Kind.NOTHING, "{}", "a name of which nothing but the text is known")


def spelled(text: str) -> Name:
    """A name as it is read from a text; one that has fields is given back as it is."""
    return text if isinstance(text, Name) else Name._made(text, _SPELLED, (text,))


NONE = spelled("")
"""What has no name."""


_families: Mapping[str, Family]


def known_as(families: Mapping[str, Family]) -> None:
    """Give each family the key under which another process finds it again."""
    global _families
    _families = families
    for key, family in families.items():
        family.key = key


known_as({})


def _found(key: str) -> Family:
    if not _families:  # in a new process nobody may have asked for one yet
        import_module("interlock.logic.names")
    return _families[key]


def _family(key: str) -> Family:
    return _found(key) if key else _SPELLED


def _again(key: str, at: tuple[Part, ...]) -> Name:
    return _found(key)(*at)
