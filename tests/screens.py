"""The screen of every diagnostic: `python -m tests.screens` writes what `interlock check` shows now.

Look at each changed screen before committing it.
"""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "diagnostics"


def screen(name: str) -> str:
    """What `interlock check NAME` prints in the folder of the triggers."""
    import os

    from click.testing import CliRunner

    from interlock.cli.check import command

    before = os.getcwd()
    os.chdir(FOLDER)
    try:
        return CliRunner().invoke(command, [name], catch_exceptions=False).output
    finally:
        os.chdir(before)


if __name__ == "__main__":
    for path in sorted(FOLDER.glob("*.yaml")):
        path.with_suffix(".txt").write_text(screen(path.name), encoding="utf-8")
