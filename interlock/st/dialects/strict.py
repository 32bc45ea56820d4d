"""What an XML file may hold: everything else is refused, for a tool might act on what this reader passed over."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping

from interlock.dataclass import dataclass
from interlock.st.parser import NotInSubset


@dataclass(frozen=True)
class Rule:
    """Attributes and children that an element may have; a child with `*` may come more than once."""

    attributes: str = ""
    children: str = ""
    text: bool = False


DECLARATION = '<?xml version="1.0" encoding="utf-8"?>'


def parse(text: str) -> ElementTree.Element:
    """The root of a file in UTF-8 without a document type; raises `NotInSubset`.

    The characters are decoded already: of a file that names another encoding a tool would read others.
    """
    if not text.startswith(DECLARATION):
        raise NotInSubset("another declaration than of XML 1.0 in UTF-8")
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise NotInSubset("a document type declaration")
    whole = ElementTree.TreeBuilder(insert_comments=True, insert_pis=True)  # a tool may read a text as far as these
    try:
        return ElementTree.fromstring(text, ElementTree.XMLParser(target=whole))
    except ElementTree.ParseError as error:
        raise NotInSubset(str(error)) from None


def expect(e: ElementTree.Element, rules: Mapping[str, Rule]) -> None:
    """Raise `NotInSubset` at the first attribute, element or text below `e` that no rule allows."""
    rule = rules.get(e.tag)
    if rule is None:
        raise NotInSubset(f"element {e.tag}")
    for a in e.attrib:
        if a not in rule.attributes.split():
            raise NotInSubset(f"attribute {a} of {e.tag}")
    if not rule.text and (e.text or "").strip(" \t\r\n"):
        raise NotInSubset(f"text in {e.tag}")
    many = {c.removesuffix("*"): c.endswith("*") for c in rule.children.split()}
    seen = set()
    for child in e:
        if child.tag not in many or (child.tag in seen and not many[child.tag]):
            raise NotInSubset(f"element {child.tag} in {e.tag}")
        if (child.tail or "").strip(" \t\r\n"):
            raise NotInSubset(f"text in {e.tag}")
        seen.add(child.tag)
        expect(child, rules)
