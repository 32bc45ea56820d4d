"""Two foreign compilers of Structured Text, and the programs that they make of a text and its mapping program.

MATIEC (repository sm1820/matiec; `iec2c`, then gcc) and STruC++ (repository Autonomy-Logic/STruCpp; then g++).  Their
folders are given, built as their own instructions say.
"""

from __future__ import annotations

import shutil
import subprocess
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tests.foreign.wiring import Segment, Wiring

HERE = Path(__file__).parent
UNOPTIMIZED = "-O0"
"""Five times as fast to build as -O1, at 20,000 lines of text."""


class Refused(Exception):
    """A text that a compiler does not take, or a program that does not run to its end; the message is the tool's."""


def _run(command: Sequence[str | Path], folder: Path) -> None:
    done = subprocess.run([str(x) for x in command], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Refused(f"{Path(command[0]).name}: {(done.stderr or done.stdout).strip()[:2000]}")


def _wiring_h(wiring: Wiring, names: Mapping[str, str]) -> str:
    written = " ".join(f"X({k}, {n.upper()}, {t})" for k, (n, t) in enumerate(wiring.written))
    read = " ".join(f"X({k}, {n.upper()})" for k, n in enumerate(wiring.read))
    words = " ".join(f"X({k}, {n.upper()})" for k, n in enumerate(wiring.words))
    numbers = {
        "IMAGE_I": wiring.image_i,
        "IMAGE_Q": wiring.image_q,
        "WRITTEN_COUNT": len(wiring.written),
        "READ_COUNT": len(wiring.read),
        "WORD_COUNT": len(wiring.words),
    }
    listed = {"WRITTEN(X)": written, "READ(X)": read, "WORDS(X)": words}
    defined = {**{n: str(k) for n, k in numbers.items()}, **names, **listed}
    return "".join(f"#define {name} {value}\n" for name, value in defined.items())


@dataclass(frozen=True)
class Compiler(ABC):
    """A compiler in the folder in which it was built."""

    folder: Path
    name = ""

    @property
    def commit(self) -> str:
        """What it was built from."""
        command = ["git", "-C", str(self.folder), "rev-parse", "HEAD"]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()

    @abstractmethod
    def build(self, source: str, wiring: Wiring, folder: Path) -> Path:
        """The program of a text with its mapping program, made in a folder that is empty.  Raises `Refused`."""


class Matiec(Compiler):
    """MATIEC: ST to C."""

    name = "MATIEC"

    def build(self, source: str, wiring: Wiring, folder: Path) -> Path:
        """See `Compiler`."""
        task = wiring.task
        (folder / "program.st").write_text(source, encoding="ascii")
        _run([self.folder / "iec2c", "-I", self.folder / "lib", "-T", folder, "program.st"], folder)
        names = {
            "PROGRAM_TYPE": task.program.upper(),
            "PROGRAM_INSTANCE": f"{task.resource}__{task.instance}".upper(),
        }
        (folder / "wiring.h").write_text(_wiring_h(wiring, names), encoding="ascii")
        shutil.copy(HERE / "host_matiec.c", folder)
        units = [f"{task.configuration}.c", f"{task.resource}.c", "host_matiec.c"]
        where: list[str | Path] = ["-I", self.folder / "lib" / "C", "-I", folder, "-I", HERE]
        _run(["gcc", UNOPTIMIZED, "-w", *where, *units, "-o", "program"], folder)
        return folder / "program"


class StrucPp(Compiler):
    """STruC++: ST to C++."""

    name = "STruC++"

    def build(self, source: str, wiring: Wiring, folder: Path) -> Path:
        """See `Compiler`."""
        task = wiring.task
        (folder / "program.st").write_text(source, encoding="ascii")
        _run(["node", self.folder / "dist" / "node" / "cli.js", "program.st", "-o", "program.cpp"], folder)
        names = {
            "CONFIGURATION_TYPE": f"Configuration_{task.configuration.upper()}",
            "PROGRAM_INSTANCE": task.instance.upper(),
        }
        (folder / "wiring.h").write_text(_wiring_h(wiring, names), encoding="ascii")
        shutil.copy(HERE / "host_strucpp.cpp", folder)
        where: list[str | Path] = ["-I", self.folder / "src" / "runtime" / "include", "-I", folder, "-I", HERE]
        units = [*sorted(x.name for x in folder.glob("program*.cpp")), "host_strucpp.cpp"]
        _run(["g++", "-std=c++17", UNOPTIMIZED, "-w", *where, *units, "-o", "program"], folder)
        return folder / "program"


def answers(program: Path, segments: Sequence[Segment]) -> list[bytes]:
    """What a program gives to each segment; every power-on is a process of its own.  Raises `Refused`."""
    found = []
    for s in segments:
        asked = s.start_ms.to_bytes(8, "little") + bytes(s.given)
        done = subprocess.run([str(program)], input=asked, capture_output=True, check=False)
        if done.returncode:
            raise Refused(f"the program ended with {done.returncode}: {done.stderr[:300]!r}")
        found.append(done.stdout)
    return found
