"""Messages show what they quote in a length that a person reads."""

from __future__ import annotations

from pathlib import Path

import pytest

from interlock.app.check import check_file
from interlock.diag import Diagnostic, Place, Severity, render
from interlock.diag.shortened import LONGEST, WHOLE, shortened

LAYOUT = Path("layouts/fig2_2.yaml").read_text("utf-8")
WRONG = {
    "signal": ("from: C", "from: {}"),
    "name": ("name: fig2_2", "name: {}"),
    "profile": ("profile: mine", "profile: {}"),
    "number": ("boundaries:", "principles: {{line_speed_kmh: {}}}\nboundaries:"),
    "approach": ("SA 200", "{}"),
    "via": ("signals:", "voyages: {{V: {{from: X1, to: C, via: [{}]}}}}\nsignals:"),
    "lint": ("signals:", "allow: [{{lint: {}, at: [X1], reason: r}}]\nsignals:"),
    "flank": ("signals:", "waive: [{{flank: {}, reason: r}}]\nsignals:"),
    "version": ("interlock: 1", "interlock: {}"),
    "line": ("signals:", "{}\nsignals:"),
}


@pytest.mark.parametrize("name", ["x" * 100_000, "x " * 50_000 + "y", "轨" * 100_000], ids=["word", "words", "chinese"])
@pytest.mark.parametrize("where", WRONG)
def test_a_name_of_a_hundred_thousand_signs_is_not_printed_whole(where: str, name: str, tmp_path: Path) -> None:
    old, new = WRONG[where]
    assert old in LAYOUT
    path = tmp_path / "long.yaml"
    path.write_text(LAYOUT.replace(old, new.format(name), 1), "utf-8")
    found = check_file(str(path))
    assert not found.ok
    for d in found.diagnostics:
        assert len(d.message) < 2 * WHOLE and len(d.fix) < 2 * WHOLE and all(len(p.note) < 2 * WHOLE for p in d.also)
    assert all(len(form(found.diagnostics, found.source.texts)) < 40_000 for form in (render.full, render.concise))


def test_both_ends_are_shown_and_how_many_signs_there_are() -> None:
    long = "a" * 100 + "b" * 1000 + "c" * 100
    quoted = " ".join(["of"] * WHOLE)
    shown = f"{'a' * 60}…{'c' * 60} (1200 signs)"
    assert shortened(f"there is no section {long} here") == f"there is no section {shown} here"
    told = shortened(f"profile: '{quoted}' is not a profile")
    assert told.startswith("profile: 'of of") and told.endswith(f"({len(quoted)} signs)' is not a profile")
    assert len(told) < LONGEST and shortened(f"no section {quoted}").endswith(f"({len(quoted) + 11} signs)")
    d = Diagnostic("IL2004", Severity.ERROR, f"no {long} here", None, f"write `{long}` so", None, (Place(None, long),))
    assert (d.message, d.fix) == (f"no {shown} here", shortened(f"write `{long}` so")) and d.also[0].note == shown


def test_what_is_not_longer_than_a_path_is_shown_as_it_is() -> None:
    for text in ("", "a" * LONGEST, f"'{'a b ' * 1000}' stands there", " ".join(["word"] * 1000)):
        assert shortened(text) == text
