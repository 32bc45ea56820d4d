"""The screens of `interlock check`: `python -m tests.screens` writes what it shows now of every code's trigger
(`diagnostics/`) and of mistakes as newcomers make them (`mistakes/`).

Look at each changed screen before committing it.
"""

from __future__ import annotations

import re
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDER = HERE / "diagnostics"
MISTAKES = HERE / "mistakes"


def screen(path: Path) -> str:
    """What `interlock check` prints of a file, called in its folder, but for the time that it took."""
    import os

    from click.testing import CliRunner

    from interlock.cli.check import command

    before = os.getcwd()
    os.chdir(path.parent)
    try:
        shown = CliRunner().invoke(command, [path.name], catch_exceptions=False).stdout
        return re.sub(r", \d+\.\d s$", "", shown, flags=re.MULTILINE)
    finally:
        os.chdir(before)


if __name__ == "__main__":
    for path in sorted([*FOLDER.glob("*.yaml"), *MISTAKES.glob("*.yaml")]):
        path.with_suffix(".txt").write_text(screen(path), encoding="utf-8")
