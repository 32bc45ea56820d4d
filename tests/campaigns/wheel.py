"""The wheel, as somebody has it who has no repository: `python -m tests.campaigns.wheel`.

It is built from a copy of the sources, installed into a folder of its own, and every command is run from an empty
folder with nothing of the repository in reach.  The dependencies are those of the Python that runs this; with
`--lowest` they are the lowest versions that pyproject.toml allows, of all extras but `dev`, in an environment that is
made for it, and what needs an extra is run, too.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import tomllib
import zipfile
from collections.abc import Callable
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


def lowest() -> list[str]:
    """The lowest version that is allowed of each dependency, and of what each extra but `dev` needs."""
    project = tomllib.loads((TOP / "pyproject.toml").read_text("utf-8"))["project"]
    extras = project["optional-dependencies"]
    wanted = [*project["dependencies"], *(x for n, those in extras.items() if n != "dev" for x in those)]
    found = [re.fullmatch(r"([\w.-]+)>=([\w.]+)", x) for x in wanted]
    assert all(found), f"write each as NAME>=VERSION: {wanted}"
    return sorted(f"{m[1]}=={m[2]}" for m in found if m)


def oldest(folder: Path) -> str:
    """A Python of its own, with the lowest versions; where it is."""
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
    python = str(folder / ("Scripts" if os.name == "nt" else "bin") / "python")
    _pip("install", *lowest(), python=python)
    return python


def _pip(*args: str, python: str = sys.executable) -> None:
    command = [python, "-m", "pip", "--disable-pip-version-check", "-q", *args]
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

MORE: tuple[tuple[int, str], ...] = (
    (0, "compile s.yaml --dialect c99 --dialect all -o all"),
    (0, "prove s.yaml --engine cvc5"),
    (0, "prove s.yaml --engine z3 -j 2"),
    (0, "mutate s.yaml --family 'initial RQZ' --shard 1/2 -j 2"),
    (0, "simulate heishan.yaml --hours 1 --steady --optimum 5"),
    (0, "record heishan-0.log --parquet heishan.parquet"),
    (0, "record heishan-0.log --sql 'select count(*) from events'"),
    (0, "schedule swap.json"),
    (1, "simulate heishan.yaml --hours 1 --shifts 2 --dask 127.0.0.1:9"),
)
"""The same of what needs an extra."""

Runs = Callable[..., subprocess.CompletedProcess[str]]

HEARD = """
import sys, time, websockets.sync.client
for _ in range(300):
    try:
        with websockets.sync.client.connect(f"ws://127.0.0.1:{sys.argv[1]}/talk") as ws:
            ws.send('{"name": "Ann"}')
            sys.exit(0 if ws.recv(5).startswith("{") else 1)
    except OSError:
        time.sleep(0.1)
sys.exit(2)
"""
"""A browser that hears the panel's first word."""


def _free() -> int:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return int(s.getsockname()[1])


def running(python: str, empty: Path, env: dict[str, str], run: Runs) -> list[str]:
    """Run the starter with a panel and an operator's place, and on a substation on Modbus; what went wrong."""
    port, wrong = _free(), []
    panel = ["run", "s.yaml", "--panel", "--port", str(port), "--operator-modbus", str(_free())]
    began = subprocess.Popen([python, "-m", "interlock", *panel], cwd=empty, env=env, stderr=subprocess.PIPE, text=True)
    heard = run("-c", HEARD, str(port))
    began.send_signal(signal.SIGTERM)
    said = began.communicate()[1]
    if heard.returncode or "Traceback" in said:
        wrong.append(f"the panel: {heard.returncode}, {heard.stderr[-500:]}{said[-500:]}")
    port = _free()
    serve = [python, str(TOP / "tests/substation.py"), str(port), "60", "0"]
    substation = subprocess.Popen(serve, stdout=subprocess.PIPE, text=True)
    assert substation.stdout is not None
    substation.stdout.readline()
    done = run("-m", "interlock", "run", "s.yaml", "--modbus", f"127.0.0.1:{port}", "--cycles", "20")
    substation.kill()
    if done.returncode or "stopped" not in done.stdout:
        wrong.append(f"run --modbus: {done.returncode}, {done.stdout[-500:]}{done.stderr[-500:]}")
    return wrong


def try_out(wheel: Path, folder: Path, python: str = sys.executable, extras: bool = False) -> list[str]:
    """Install a wheel and run every command, `extras`: also what needs one; what went wrong."""
    site, empty = folder / "site", folder / "empty"
    _pip("install", "--no-deps", "--target", str(site), str(wheel))
    empty.mkdir()
    for name in ("refuted/wrong_waiver.yaml", "heishan.yaml", "heishan.dispatch"):
        shutil.copy(TOP / "layouts" / name, empty)
    shutil.copy(TOP / "tests/schedules/swap.json", empty)
    env = {**os.environ, "PYTHONPATH": str(site), "PYTHONSAFEPATH": "1"}

    def run(*args: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([python, *args], cwd=empty, env=env, capture_output=True, text=True, check=False)

    where = run("-c", "import interlock; print(interlock.__file__)").stdout.strip()
    if not where.startswith(str(site)):
        return [f"another interlock is run: {where}"]
    wrong = []
    for code, line in (*COMMANDS, *(MORE if extras else ())):
        done = run("-m", "interlock", *shlex.split(line))
        if done.returncode != code or "Traceback" in done.stderr:
            wrong.append(f"interlock {line}: {done.returncode}, not {code}\n{done.stdout[-500:]}{done.stderr[-500:]}")
    wrong += running(python, empty, env, run) if extras else []
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
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lowest", action="store_true", help="with the lowest versions that pyproject.toml allows")
    given = parser.parse_args()
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as name:
        wheel = build(Path(name))
        wrong = [f"{n} is not in the wheel" for n in sorted(packaged() - contents(wheel))]
        python = oldest(Path(name) / "oldest") if given.lowest else sys.executable
        wrong += try_out(wheel, Path(name), python, given.lowest)
    with_ = f" with {', '.join(lowest())}" if given.lowest else ""
    count = len(COMMANDS) + (len(MORE) + 2 if given.lowest else 0)
    print("\n".join(wrong) or f"{wheel.name}: {count} commands{with_}, {time.monotonic() - began:.0f} s")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
