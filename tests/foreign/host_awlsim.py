"""Runs the emitted STL in Awlsim (repository mbuesch/awlsim): one power-on, scans as `wiring` has them.

python host_awlsim.py FOLDER NAME WIRING, under a Python that has awlsim.  WIRING: JSON with the bytes of both images,
the variables that are written (with their types) and read, and the words.  The clock is that of the recording.

Two things that the simulator does not take are said in another way before it reads the text: the output of a timer is
handed over by its call, where the text reads it as a member; a data block of an instance is called by its number.
"""

import csv
import json
import re
import sys
from pathlib import Path

import awlsim.common  # its rooms read each other: in this order
import awlsim.core
from awlsim.awlcompiler import AwlParser
from awlsim.common.cpuconfig import S7CPUConfig
from awlsim.common.sources import AwlSource
from awlsim.core.main import AwlSim
from awlsim.core.memory import AwlMemoryObject_asScalar, make_AwlMemoryObject_fromScalar
from awlsim.core.offset import make_AwlOffset
from awlsim.core.symbolparser import SymTabParser_CSV

assert awlsim.common and awlsim.core


def taken(text, numbers):
    """The text as the simulator takes it."""
    text = re.sub(r'(CALL  "\w+"), "(\w+)"', lambda m: f"{m[1]}, {numbers[m[2]]}", text)
    text = re.sub(r'  (\w+) : "TON";', r'  \1 : "TON";\n  \1_Q : BOOL;', text)
    text = re.sub(r"CALL  #(\w+) \((.*)\);", r"CALL  #\1 (\2, Q := #\1_Q);", text)
    return re.sub(r"#(\w+)\.Q\b", r"#\1_Q", text)


class Host:
    """A simulated CPU with the program."""

    def __init__(self, folder, name):
        with (folder / f"{name}.sdf").open() as table:
            rows = list(csv.reader(table))
        self.numbers = {r[0]: r[1] for r in rows}
        kinds = [(r[0], r[1], r[1] if r[1].startswith("DB") else r[2]) for r in rows]
        symbols = "".join(";".join(f'"{x}"' for x in (*r, "")) + "\n" for r in kinds)
        self.sim = AwlSim()
        self.sim.reset()
        self.sim.loadSymbolTable(SymTabParser_CSV.parseText(symbols, False, S7CPUConfig.MNEMONICS_EN))
        for part in ("", "_io", "_ob"):
            text = (folder / f"{name}{part}.awl").read_text("ascii")
            parser = AwlParser()
            parser.parseSource(AwlSource(name=f"s{part}", sourceBytes=taken(text, self.numbers).encode()))
            self.sim.load(parser.getParseTree())
        self.sim.build()
        self.cpu = self.sim.getCPU()
        self.ms = 1_000_000
        self.cpu.updateTimestamp = self.stamp
        self.cpu.cycleTimeLimit = 1e9
        operator = next(n for n in self.numbers if n.endswith("_HMI"))
        self.operator = self.cpu.getDB(int(self.numbers[operator].split()[1])).structInstance

    def stamp(self, *_):
        """The recording's clock; half a millisecond more, so that no rounding takes one away."""
        self.cpu.now = (self.ms + 0.5) / 1000

    def write(self, name, value):
        """A variable of the operator's place."""
        width = self.operator._struct.getField(name).bitSize
        self.operator.setFieldDataByName(name, make_AwlMemoryObject_fromScalar(value, width))

    def read(self, name):
        """The same."""
        return AwlMemoryObject_asScalar(self.operator.getFieldDataByName(name))

    def image(self, count):
        """The bytes of %Q."""
        return bytes(AwlMemoryObject_asScalar(self.cpu.outputs.fetch(make_AwlOffset(k, 0), 8)) for k in range(count))


def main():
    """Startup, the scan that forgets what was kept, then what is asked for."""
    host, wiring = Host(Path(sys.argv[1]), sys.argv[2]), json.loads(sys.argv[3])
    asked, out = sys.stdin.buffer, sys.stdout.buffer
    host.ms += int.from_bytes(asked.read(8), "little") % 1_000_000_000
    host.sim.startup()
    host.sim.runCycle()
    host.write("BEAT", 0)  # it only changes; a recording begins with the first scan
    while head := asked.read(4):
        host.ms += int.from_bytes(head, "little")
        for k, byte in enumerate(asked.read(wiring["image_i"])):
            host.cpu.inputs.store(make_AwlOffset(k, 0), make_AwlMemoryObject_fromScalar(byte, 8))
        for name, kind in wiring["written"]:
            value = int.from_bytes(asked.read(2), "little", signed=True)
            host.write(name, value & 0xFFFF if kind == "INT" else value)
        host.sim.runCycle()
        words = b"".join(host.read(n).to_bytes(2, "little") for n in wiring["words"])
        out.write(host.image(wiring["image_q"]) + bytes(host.read(n) for n in wiring["read"]) + words)


if __name__ == "__main__":
    main()
