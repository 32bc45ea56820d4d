"""What a route has locked by `demand` stays held for so many seconds longer (`hold`): beyond the end of a route a train
may still be running when it is wholly in."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from interlock.audit import audit
from interlock.checker import specification
from interlock.checker.check import agree
from interlock.checker.reading import loaded
from interlock.derivation import derive
from interlock.diag import Sink
from interlock.emit.tables.document import table_json
from interlock.frontend import load_text
from interlock.logic.controller import Controller
from interlock.logic.eval import Interpreter
from interlock.logic.expr import neg, var
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.proof.engines.limits import Limits
from interlock.proof.induction.verdict import Verdict
from interlock.proof.prover import prove
from interlock.proof.system.transition import System
from interlock.table.columns import COLUMNS
from interlock.table.rows import InterlockingTable
from interlock.verify import Rejected
from tests.written import told

TEXT = Path("tests/layouts_for_tests/held_longer.yaml").read_text("utf-8")
NO_SEARCH = Limits(search_s=0)
