"""The picture of a refused route in the panel's page, in Debian's Chromium.

python -m tests.campaigns.pictures [-o interlock/docs/panel]
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

from tests.test_panel_browser import Server, browser, click, opened, press

SHORT = "\nprinciples: {restart_delay_s: 228}\n"


def main() -> None:
    """Heishan: a train has a route over the section that another route needs."""
    parser = argparse.ArgumentParser()
    parser.add_argument("-o", "--output", type=Path, default=Path("interlock/docs/panel"))
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "heishan.yaml"
        path.write_text(Path("layouts/heishan.yaml").read_text("utf-8") + SHORT, "utf-8")
        one = Server(path)
        try:
            with browser() as found:
                page, _ = opened(found, one.url)
                page.set_viewport_size({"width": 1280, "height": 560})
                page.select_option("#speed select", "10")
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
                said = page.locator("#said")
                fits = said.evaluate("e => e.scrollHeight <= e.clientHeight")
                page.screenshot(path=given.output / "refused.png")
                print(f"{'whole' if fits else 'CLIPPED'}: {said.inner_text()}")
        finally:
            one.end()


if __name__ == "__main__":
    main()
