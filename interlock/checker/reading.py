"""YAML as plain text: of its features those alone of which nobody reads two meanings."""

from __future__ import annotations

import re
from typing import Any

import yaml

TURNING = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
"""What turns the direction of the text after it."""
_UNSHOWN = re.compile(rf"[\x85\u2028\u2029{TURNING}]|\r(?![\r\n])")
"""What ends a line to YAML alone, or lets a line be shown otherwise than it is read."""


class _Plain(yaml.BaseLoader):
    """Every scalar as the text that it is; a key stands once, as of two equal ones the last would be believed."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Any, Any]:
        """As the base does.

        Raises yaml.YAMLError where a key stands twice.
        """
        seen: set[str] = set()
        for key, _ in node.value:
            if key.value in seen:
                raise yaml.constructor.ConstructorError(None, None, f"the key {key.value} stands twice", key.start_mark)
            seen.add(key.value)
        return super().construct_mapping(node, deep)

    def compose_node(self, parent: Any, index: Any) -> Any:
        """As the base does.

        Raises yaml.YAMLError for an anchor, an alias or a tag: they let a text say other than it shows.
        """
        event = self.peek_event()  # type: ignore[no-untyped-call]
        if getattr(event, "anchor", None) is not None or getattr(event, "tag", None) is not None:
            raise yaml.composer.ComposerError(None, None, "an anchor, an alias or a tag", event.start_mark)
        return super().compose_node(parent, index)


def loaded(text: str) -> Any:
    """YAML with every scalar as the text that it is.

    Raises yaml.YAMLError where it is none, a key stands twice, or something else stands for what it says.
    """
    if _UNSHOWN.search(text if "\n" in text else text.replace("\r", "\n")) is not None:
        raise yaml.YAMLError("a line of it is shown otherwise than it is read")
    return yaml.load(text, _Plain)
