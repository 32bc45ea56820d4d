"""Runs of commands, in this process and in one of its own."""

from __future__ import annotations

import subprocess
import sys

from click.testing import CliRunner, Result

from interlock.cli.main import cli


def run(*args: str) -> Result:
    return CliRunner().invoke(cli, list(args))


def process(*args: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "interlock", *args], capture_output=True, text=True, check=False)
