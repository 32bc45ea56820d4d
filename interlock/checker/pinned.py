"""The file of pins beside a layout, and the addresses in the mapping program of the certificate."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from interlock.checker.reading import loaded
from interlock.verify import Rejected, need

AT = re.compile(r"^\s*(\w+) AT %([IQ])X(\d+\.[0-7]) : BOOL;", re.MULTILINE)
"""A variable of the mapping program and its address."""
MADE_FROM = "(* pins "
"""What a mapping program says that was made from pins."""


def compare(layout: Path, name: str, program: bytes | None) -> tuple[str, str]:
    """What was found equal, and what was not compared, in words; both empty where there are neither pins nor a program
    that was made from some.  name, program: of the mapping program, None if the certificate does not tie it.
    Raises Rejected for a channel that lies elsewhere, and OSError."""
    file = layout.with_suffix(".pins")
    text = None if program is None else program.decode()
    if not file.exists():
        lost = text is not None and MADE_FROM in text
        return "", f"the pins from which {name} was made ({file} is not there)" if lost else ""
    if text is None:
        return "", f"{file} (the certificate ties no {name})"
    channels, reserved = _read(file)
    at = {variable: f"{kind}{place}" for variable, kind, place in AT.findall(text)}
    for variable, address in at.items():
        pinned = channels.get(variable, reserved.get(variable, address))
        need(pinned == address, f"{name} has {variable} at {address}, and {file} has it at {pinned}")
    taken = {address: variable for variable, address in at.items()}
    for variable, address in {**channels, **reserved}.items():
        other = taken.get(address, variable)
        need(other == variable, f"{name} has {other} at {address}, which {file} keeps for {variable}")
    kept = sum(variable in channels for variable in at)
    return f"{name} has {kept} channels where {file.name} has them, and nothing where it keeps others", ""


def _read(file: Path) -> tuple[Mapping[str, str], Mapping[str, str]]:
    """Addresses by variable: of what there is, and of what is gone."""
    try:
        body = loaded(file.read_bytes().decode("utf-8-sig"))
    except yaml.YAMLError as e:
        raise Rejected(f"{file} is no YAML, or none with one meaning") from e
    need(isinstance(body, dict), f"{file} is no file of pins")
    return dict(_addresses(body.get("channels"))), dict(_addresses(body.get("reserved")))


def _addresses(found: Any) -> Iterator[tuple[str, str]]:
    for elements in (found or {}).values():
        for variables in elements.values():
            for variable, address in variables.items():
                yield str(variable), str(address)
