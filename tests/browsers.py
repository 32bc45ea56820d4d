"""Debian's Chromium, driven by Playwright: started once for a module of tests, a fresh context for every page."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--disable-background-networking"]
FLAGS += ["--disable-component-update", "--disable-sync", "--no-first-run"]


def crowding() -> float:
    """How many times as long a thread of this test may take as on a computer that does nothing else: it, and what else
    wants a processor now, for each processor there is (Linux; what this process has started is not counted)."""
    found: dict[int, tuple[str, int]] = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):  # it has ended
            state, parent, *_ = stat.read_text("utf-8", "replace").rpartition(")")[2].split()
            found[int(stat.parent.name)] = (state, int(parent))
    own = {os.getpid()}
    while more := {pid for pid, (_, parent) in found.items() if parent in own} - own:
        own |= more
    others = sum(state == "R" for pid, (state, _) in found.items() if pid not in own)
    return max(1.0, (1 + others) / (os.cpu_count() or 1))


@contextmanager
def browser() -> Iterator[Any]:
    """Chromium without a window."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as p:
        found = p.chromium.launch(executable_path=BROWSER, args=FLAGS)
        yield found
        found.close()


@contextmanager
def shown(found: Any, path: Path) -> Iterator[Any]:
    """A file as a page, and at the end the certainty that it logged no error and asked for nothing from anywhere."""
    context = found.new_context(viewport={"width": 1500, "height": 1000})
    page = context.new_page()
    wrong: list[str] = []
    page.on("console", lambda m: wrong.append(m.text) if m.type == "error" else None)
    page.on("pageerror", lambda e: wrong.append(str(e)))
    page.on("request", lambda r: wrong.append(r.url) if not r.url.startswith("file:") else None)
    page.goto(path.resolve().as_uri())
    yield page
    context.close()
    assert wrong == []
