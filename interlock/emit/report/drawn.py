"""Whether a plan that came with a trace is a drawing and nothing else: traces and records come by mail, and a page that
plays one is opened in a browser.

A drawing is well-formed, has the elements and attributes that our plans have and no others, and loads nothing.  It has
no comments, declarations and CDATA sections either: a page, which is no XML, reads them otherwise.
"""

from __future__ import annotations

import re
from xml.etree import ElementTree

_SVG = "{http://www.w3.org/2000/svg}"
_ELEMENTS = frozenset(f"{_SVG}{x}" for x in ("svg", "title", "style", "g", "path", "rect", "circle", "text", "tspan"))
_NAMES = frozenset(("id", "class", "role"))
_ATTRIBUTES = frozenset(
    ("x", "y", "dx", "cx", "cy", "r", "d", "width", "height", "viewBox", "fill", "style", "font-weight", "transform")
)
_NEVER = re.compile(r"<[!?]")
_DATA = re.compile(r"data-[a-z]+")
_LOADS = re.compile(r"[@\\]|(?<!:not)(?<!rotate)(?<!translate)\(")
"""What may load something, or stand for what does: rules that begin with @, disguised signs, and functions."""


def is_drawing(plan: str) -> bool:
    """Whether a text is a drawing of which nothing runs, and which loads nothing."""
    if _NEVER.search(plan):
        return False
    try:
        root = ElementTree.fromstring(plan)
    except (ElementTree.ParseError, ValueError, RecursionError):
        return False
    return root.tag == f"{_SVG}svg" and all(map(_is_ours, root.iter()))


def _is_ours(element: ElementTree.Element) -> bool:
    """Whether an element is one that a plan has."""
    if element.tag not in _ELEMENTS or (element.tag == f"{_SVG}style" and _LOADS.search(element.text or "")):
        return False
    return all(
        k in _NAMES or _DATA.fullmatch(k) or (k in _ATTRIBUTES and not _LOADS.search(v))
        for k, v in element.attrib.items()
    )
