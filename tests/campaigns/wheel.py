"""The wheel, as somebody has it who has no repository: `python -m tests.campaigns.wheel`.

It is built from a copy of the sources, installed into a folder of its own, and every command is run from an empty
folder with nothing of the repository in reach.  The dependencies are those of the Python that runs this.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

from interlock.cli.main import VERBS

TOP = Path(__file__).resolve().parents[2]
SOURCES = ("interlock", "pyproject.toml", "README.md", "LICENSE")


def build(folder: Path) -> Path:
    """The wheel of these sources, built in a folder without leaving anything beside them."""
    copy = folder / "sources"
    copy.mkdir()
    for name in SOURCES:
        if (TOP / name).is_dir():
            shutil.copytree(TOP / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(TOP / name, copy / name)
    _pip("wheel", "--no-deps", "--no-build-isolation", "-w", str(folder), str(copy))
    (wheel,) = folder.glob("interlock-*.whl")
    return wheel


def contents(wheel: Path) -> set[str]:
    """The files of the package in a wheel."""
    with zipfile.ZipFile(wheel) as file:
        return {n for n in file.namelist() if n.startswith("interlock/")}


def packaged() -> set[str]:
    """The files of the package in the repository: whatever is read at run time lies among the modules."""
    files = (p for p in (TOP / "interlock").rglob("*") if p.is_file() and "__pycache__" not in p.parts)
    return {str(p.relative_to(TOP)) for p in files}


def _pip(*args: str) -> None:
    command = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q", *args]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"pip {args[0]}: {done.stdout}{done.stderr}")


COMMANDS: tuple[tuple[int, str], ...] = (
    (0, "init -o s.yaml"),
    (0, "check s.yaml"),
    (0, "compile s.yaml --dialect codesys"),
    (0, "compile s.yaml --dialect codesys --check"),
    (0, "compile s.yaml"),
    (1, "prove wrong_waiver.yaml"),
    (0, "commission s.yaml --route X2-X3"),
    (0, "certify s.yaml"),
    (0, "verify proofs/starter"),
    (0, "verify s.yaml proofs/starter"),
    (0, "export s.yaml -o s.aig"),
    (0, "pin s.yaml"),
    (0, "draw s.yaml"),
    (1, "draw s.yaml -o s.yaml"),
    (0, "play counterexamples/wrong_waiver-T-FLANK.itf.json -o played.html"),
    (0, "why s.yaml X2-X3"),
    (0, "diff s.yaml s.yaml"),
    (0, "explain"),
    (0, "explain IL4001"),
    (0, "explain R5"),
    (0, "explain T-COLLISION"),
    (0, "explain A-SCAN"),
    (0, "explain release_delay_s"),
    (0, "mutate s.yaml --family 'initial RQZ'"),
    (0, "schema"),
    (0, "schema --of table"),
    (0, "schema --of pins"),
    (0, "schema --of keys"),
    (0, "availability s.yaml"),
    (0, "dispatch s.yaml 1:W>E --plan plan.json"),
    (1, "blocks s.yaml"),
    (1, "schedule s.yaml"),
    (0, "simulate heishan.yaml --hours 1 -o ."),
    (0, "record heishan-0.log --report report"),
    (0, "play heishan-0.log --layout heishan.yaml"),
    (2, "run s.yaml --modbus nowhere"),
)
"""Exit codes and commands; together they are every verb."""


def try_out(wheel: Path, folder: Path) -> list[str]:
    """Install a wheel and run every command; what went wrong."""
    site, empty = folder / "site", folder / "empty"
    _pip("install", "--no-deps", "--target", str(site), str(wheel))
    empty.mkdir()
    for name in ("refuted/wrong_waiver.yaml", "heishan.yaml", "heishan.dispatch"):
        shutil.copy(TOP / "layouts" / name, empty)
    env = {**os.environ, "PYTHONPATH": str(site), "PYTHONSAFEPATH": "1"}

    def run(*args: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, *args], cwd=empty, env=env, capture_output=True, text=True, check=False)

    where = run("-c", "import interlock; print(interlock.__file__)").stdout.strip()
    if not where.startswith(str(site)):
        return [f"another interlock is run: {where}"]
    wrong = []
    for code, line in COMMANDS:
        done = run("-m", "interlock", *shlex.split(line))
        if done.returncode != code or "Traceback" in done.stderr:
            wrong.append(f"interlock {line}: {done.returncode}, not {code}\n{done.stdout[-500:]}{done.stderr[-500:]}")
    alone = run(str(site / "interlock/verify.py"), "proofs/starter")
    if alone.returncode:
        wrong.append(f"verify.py alone: {alone.stdout}{alone.stderr}")
    library = "import interlock as i; t = i.derive(i.load('s.yaml')); print(len(t.routes))"
    if run("-c", library).stdout.strip() != "10":
        wrong.append("the library does not derive the starter")
    missing = set(VERBS) - {line.split()[0] for _, line in COMMANDS}
    return [*wrong, *(f"{verb} was not run" for verb in sorted(missing))]


def main() -> None:
    """Say what went wrong; the exit code tells whether anything did."""
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        wheel = build(Path(name))
        wrong = [f"{n} is not in the wheel" for n in sorted(packaged() - contents(wheel))]
        wrong += try_out(wheel, Path(name))
    print("\n".join(wrong) or f"{wheel.name}: {len(COMMANDS)} commands, {time.monotonic() - began:.0f} s")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
