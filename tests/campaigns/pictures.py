"""Pictures of the panel's page in Debian's Chromium: the steps after a restart, the ends of a route, a refused one,
a fault (on a phone, too), the connection lost.

python -m tests.campaigns.pictures [-o interlock/docs/panel]
"""

from __future__ import annotations

import argparse
import signal
import tempfile
from pathlib import Path
from typing import Any

from tests.browsers import browser
from tests.pages import Server, click, opened, press, release_all

SHORT = "\nprinciples: {restart_delay_s: 228}\n"


def taken(page: Any, given: Path, name: str) -> None:
    """A picture of the page; says where the sentences below the plan did not fit."""
    said = page.locator("#said")
    fits = said.evaluate("e => e.scrollHeight <= e.clientHeight")
    page.screenshot(path=given / f"{name}.png")
    print(f"{name}: {'whole' if fits else 'CLIPPED'}: {said.inner_text()}")


def fault(page: Any) -> None:
    """The train stands before its signal; points that nobody has commanded lose their detection, with a reminder."""
    page.wait_for_selector("#section-s6 .track.occupied", state="attached")
    click(page, "#point-P4 .reach")
    press(page, "Fail: detection lost")
    page.wait_for_selector("#point-P4.late", state="attached")
    page.locator("[data-mark=note]").fill("being looked at")
    page.keyboard.press("Enter")
    page.wait_for_selector(".note.reminder")


def main() -> None:
    """Heishan: from the restart to a train that has a route over the section that another route needs."""
    parser = argparse.ArgumentParser()
    parser.add_argument("-o", "--output", type=Path, default=Path("interlock/docs/panel"))
    given = parser.parse_args().output
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "heishan.yaml"
        path.write_text(Path("layouts/heishan.yaml").read_text("utf-8") + SHORT, "utf-8")
        one = Server(path)
        try:
            with browser() as found:
                page, _ = opened(found, one.url)
                page.set_viewport_size({"width": 1280, "height": 760})
                page.select_option("#speed select", "10")
                page.wait_for_selector("#restart button:enabled")
                taken(page, given, "restart")
                release_all(page)
                page.wait_for_selector("#restart", state="hidden")
                click(page, "#boundary-W .reach")
                press(page, "A train comes in here")
                click(page, "#signal-XB .reach")
                page.wait_for_selector("#hint:not(:empty)")
                taken(page, given, "entry")
                click(page, "#signal-XI7 .reach")
                page.wait_for_selector("#signal-XB.clear")
                click(page, "#signal-XB .reach")
                click(page, "#buffer-XC1 .reach")
                page.wait_for_selector("#said:has-text('is refused')")
                taken(page, given, "refused")
                fault(page)
                taken(page, given, "fault")
                page.set_viewport_size({"width": 390, "height": 800})
                press(page, "fit")
                taken(page, given, "phone")
                page.set_viewport_size({"width": 1280, "height": 760})
                one.end(signal.SIGKILL)
                page.wait_for_selector("body.stale")
                taken(page, given, "lost")
        finally:
            if one.process.poll() is None:
                one.end()


if __name__ == "__main__":
    main()
