"""`python -m interlock.checker LAYOUT FOLDER`: needs Python's standard library and PyYAML alone."""

import sys
from pathlib import Path

from interlock.checker.check import report

if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("python -m interlock.checker LAYOUT FOLDER")
    sys.exit(report(Path(sys.argv[1]), Path(sys.argv[2])))
