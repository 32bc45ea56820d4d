"""What rests on somebody's word is asked for twice on the panel's page (in Debian's Chromium)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.pages import TAPPED, asked, closing_pages, fresh, opened, serving, until
from tests.panels import unproved

pytestmark = pytest.mark.external

SENT = "sent.filter(m => m.do).map(m => m.do)"


def test_what_rests_on_a_promise_needs_a_second_button_elsewhere(chromium: Any) -> None:
    """Each was one click, and Enter pressed again is none of the second."""
    text = Path("layouts/heishan.yaml").read_text("utf-8")
    with serving(unproved(text)) as (desk, url), closing_pages(chromium) as b:
        page, wrong = opened(b, url, TAPPED)
        fresh(page)
        page.evaluate("window.deaf = true, setInterval(() => tell({}), 200)")
        name = page.evaluate("sent.find(m => 'name' in m).name")

        def says(changes: dict[str, Any], *told: str) -> None:
            events = [
                {"n": 9, "time": "2026-01-31T06:00:00", "rules": [], "at": [], "reasons": [], "kind": "operation",
                 "who": who, "text": "block section s9"} for who in told
            ]  # fmt: skip
            waits = [k[2:] for k, v in changes.items() if k[0] == "s" and v[2]]
            tell = "([c, events, restart]) => tell({c, events, sys: {...SYS, restart}})"
            page.evaluate(tell, [changes, events, waits])

        def first(element: str, button: str, question: str) -> None:
            page.locator(element).first.focus()
            if page.locator(f"{element}.chosen").count() == 0:
                page.keyboard.press("Enter")
            if button:
                page.locator(f"#acts button:not(.settling):text-is({button!r})").focus()
                page.keyboard.press("Enter")
            page.wait_for_selector(f"#said:has-text({question!r}):not(:has(.settling))")
            page.keyboard.press("Enter")
            page.keyboard.press("Space")
            assert page.evaluate(SENT) == before, "Enter is none of it"

        locked, blocked = [0, ["1"], 0, 0, 0, None, 0, 0, []], [0, [], 0, 1, 0, None, 0, 0, []]
        restart = [0, [], 1, 0, 0, None, 0, 0, []]
        before: list[str] = []
        release = "Release by hand", "Has somebody made sure that section s9 is clear"
        says({"s:s9": locked})
        first("#section-s9", *release)
        page.wait_for_selector("#said:empty", state="attached")  # it is there for some seconds
        first("#section-s9", *release)
        says({"s:s9": [1, *locked[1:]]})
        page.wait_for_selector("#said:empty", state="attached")  # what it was about has changed
        assert page.evaluate(SENT) == before
        says({"s:s9": locked})
        for element, button, question, yes, do in (
            ("#section-s9", *release, "It is clear: release it", "release"),
            ("#point-P4", "It was looked at, and lies well", "Has somebody looked at points P4", "They lie well",
             "looked"),
            ("#release", "", "Does everything stand that ran", "It is so: release all that is clear", "release all"),
            ("#section-s9", "Free it again", "Section s9 was blocked by another", "All have left: free it", "block"),
        ):  # fmt: skip
            section = {"block": blocked, "release all": restart}.get(do, locked)
            says({"s:s9": section, "m:P4": ["N", "", 0, 0, 1, ""]}, "another")

            def both(again: tuple[str, ...] = (element, button, question), yes: str = yes) -> None:
                before[:] = page.evaluate(SENT)
                first(*again)
                page.keyboard.press("Tab")  # the next there is, from the question on
                assert page.evaluate("document.activeElement.textContent") == yes
                page.keyboard.press("Enter")

            asked(page, both)
            until(page, f"{SENT}.at(-1) === {do!r}")
            page.wait_for_selector("#said:not(:has-text('somebody'))")
            page.keyboard.press("Escape")
        says({"s:s9": blocked}, name)
        page.locator("#section-s9").focus()
        page.keyboard.press("Enter")
        count = len(page.evaluate(SENT))
        page.wait_for_selector("#acts button:not(.settling):text-is('Free it again')")
        asked(page, lambda: page.locator("#acts button:text-is('Free it again')").click())
        until(page, f"{SENT}.length > {count}")
        assert desk.broken == "" and wrong == []
