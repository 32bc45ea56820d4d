"""Every PLCopen file, the ladder's among them, against the schema of TC6 2.01.

python -m tests.campaigns.plcopen_schema --xsd FILE [LAYOUT ...]

FILE: tc6_xml_v201.xsd of PLCopen, as it stands in plcopen/ of beremiz/beremiz; it is read from where you have it, and
no part of this repository.  Without layouts: all that are shipped.  Each file is what `interlock compile` delivers,
with its mapping program, and each is also read with a word of the schema misspelt, which must not fit.  Exit code 1:
a file that does not fit, or a misspelt one that does.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from interlock.logic.cabinet import allocate
from interlock.st.delivery import write_delivery
from interlock.st.dialects import BY_NAME
from tests.campaigns.foreign import against_schema
from tests.layouts import SHIPPED, built

DIALECTS = ("codesys", "plcopen", "ladder")


def checked(xsd: str, name: str) -> list[tuple[str, str]]:
    """By dialect: why a layout's file does not fit; nothing when it does."""
    layout, _, controller = built(name)
    allocation = allocate(layout, controller)
    found = []
    for dialect in DIALECTS:
        (text,) = write_delivery(controller, allocation, BY_NAME[dialect], ["interlock"]).values()
        why = against_schema(xsd, text)
        if not why and not against_schema(xsd, text.replace("<interface>", "<interfaces/><interface>", 1)):
            why = "a misspelt file fits too: this is not the schema"
        found.append((dialect, why))
    return found


def main() -> None:
    """Print a row for each file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--xsd", type=Path, required=True)
    parser.add_argument("layouts", nargs="*", default=SHIPPED)
    given = parser.parse_args()
    rows = [(name, dialect, why) for name in given.layouts for dialect, why in checked(str(given.xsd), name)]
    print("| layout | dialect | against the schema |\n|---|---|---|")
    for name, dialect, why in rows:
        print(f"| {name} | {dialect} | {why or 'fits'} |")
    wrong = sum(bool(why) for _, _, why in rows)
    print(f"\n{len(rows) - wrong} of {len(rows)} files fit.")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
