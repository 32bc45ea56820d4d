"""Pictures of the panel's page in Debian's Chromium: the steps after a restart, a refused route, the connection lost.

python -m tests.campaigns.pictures [-o interlock/docs/panel]
"""

from __future__ import annotations

import argparse
import signal
import tempfile
from pathlib import Path
from typing import Any

from tests.browsers import browser
from tests.test_panel_browser import Server, click, opened, press

SHORT = "\nprinciples: {restart_delay_s: 228}\n"


def taken(page: Any, given: Path, name: str) -> None:
    """A picture of the page; says where the sentences below the plan did not fit."""
    said = page.locator("#said")
    fits = said.evaluate("e => e.scrollHeight <= e.clientHeight")
    page.screenshot(path=given / f"{name}.png")
    print(f"{name}: {'whole' if fits else 'CLIPPED'}: {said.inner_text()}")


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
                press(page, "Release all clear sections")
                page.wait_for_selector("#restart", state="hidden")
                click(page, "#boundary-W .reach")
                press(page, "A train comes in here")
                click(page, "#signal-XB .reach")
                click(page, "#signal-XI7 .reach")
                page.wait_for_selector("#signal-XB.clear")
                click(page, "#signal-XB .reach")
                click(page, "#buffer-XC1 .reach")
                page.wait_for_selector("#said:has-text('is refused')")
                taken(page, given, "refused")
                one.end(signal.SIGKILL)
                page.wait_for_selector("body.stale")
                taken(page, given, "lost")
        finally:
            if one.process.poll() is None:
                one.end()


if __name__ == "__main__":
    main()
