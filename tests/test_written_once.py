"""In the midst of a scan others may look: what they can see of a text has been written once, or not yet."""

from __future__ import annotations

import re

import pytest

from interlock.emit.c99.runtime import runtime_c
from interlock.emit.python.runtime import runtime_py
from interlock.logic.expr import var
from interlock.logic.names import spelled
from interlock.proof.equivalence.c_text import compare_c
from interlock.proof.equivalence.python_text import compare_runtime
from interlock.proof.equivalence.structured_text import compare_dialect, kept
from interlock.st.delivery import write_st
from interlock.st.dialects import BY_NAME
from interlock.st.meaning import BadText, Execution, Symbols, Term
from interlock.st.parser import parse_unit
from tests.layouts import built

WRITTEN = {"an output": "YP_X1", "a state": "K_DP", "a wire": "OCC_DP", "a word": "YX_R1"}


def in_words(text: str, name: str) -> str:
    """Written with another value just before; a word before the IF that says it."""
    value = "1" if name.startswith("YX") else "TRUE"
    own = re.search(rf'^ *(IF .*?THEN )?((?:\S+\.)?"?{name}"?) := ', text, re.MULTILINE)
    assert own is not None
    return f"{text[: own.start()]}  {own[2]} := {value};\n{text[own.start() :]}"


def in_instructions(text: str, name: str) -> str:
    """Written as the first thing that its block does."""
    load, store = ("L     1", "T") if name.startswith("YX") else ("SET", "=")
    own = re.search(rf"^ *[=T] +(\S+\.{name});", text, re.MULTILINE)
    assert own is not None
    at = text.index("NETWORK\n", text.rindex("BEGIN\n", 0, own.start()))
    return f"{text[:at]}NETWORK\n      {load};\n      {store}     {own[1]};\n{text[at:]}"


def in_a_drawing(text: str, name: str) -> str:
    """A rung above the first."""
    own = re.search(rf"<variable>([A-Z]+\d*\.{name})</variable></coil>", text)
    assert own is not None
    at = text.rindex("<LD>", 0, own.start()) + len("<LD>")
    joined = '<connectionPointIn><connection refLocalId="{}"/></connectionPointIn>'
    place = '<position x="0" y="0"/>'
    rung = f'<leftPowerRail localId="9001">{place}<connectionPointOut formalParameter=""/></leftPowerRail>'
    rung += (
        f'<coil localId="9002">{place}{joined.format(9001)}<connectionPointOut/><variable>{own[1]}</variable></coil>'
    )
    rung += f'<rightPowerRail localId="9003">{place}{joined.format(9002)}</rightPowerRail>'
    return text[:at] + rung + text[at:]


@pytest.mark.parametrize("dialect", BY_NAME)
@pytest.mark.parametrize("what", WRITTEN)
def test_what_a_text_writes_twice_in_a_scan_is_refused(dialect: str, what: str) -> None:
    """At the end of the scan all is as it should be; until then a signal shows proceed."""
    controller, name = built("fig2_2")[2], WRITTEN[what]
    files = write_st(controller, BY_NAME[dialect], [])
    assert compare_dialect(controller, BY_NAME[dialect], files).proved
    edit = (
        in_instructions if dialect == "awl" else in_a_drawing if dialect == "ladder" and what != "a word" else in_words
    )
    for file, text in files.items():
        if re.search(rf"\.{name} :=|[=T] +\S+\.{name};|\.{name}</variable></coil>", text):
            (wrong,) = compare_dialect(controller, BY_NAME[dialect], {**files, file: edit(text, name)}).differences
            assert "twice" in wrong.text and name in wrong.text
            return
    raise AssertionError(f"{name} is not written")


@pytest.mark.parametrize("dialect", ["scl1500", "scl300"])
def test_nor_may_another_block_write_it_before(dialect: str) -> None:
    """In a data block everybody can write."""
    controller = built("fig2_2")[2]
    ((file, text),) = write_st(controller, BY_NAME[dialect], []).items()
    at = re.search(r'FUNCTION "IL_fig2_2_B01".*?\nBEGIN\n', text, re.DOTALL)
    assert at is not None
    forged = f'{text[: at.end()]}  "IL_fig2_2_Q".YP_X1 := TRUE;\n{text[at.end() :]}'
    (wrong,) = compare_dialect(controller, BY_NAME[dialect], {file: forged}).differences
    assert "YP_X1 is written twice" in wrong.text


@pytest.mark.parametrize("name", [*WRITTEN.values(), "now"])
def test_nor_may_the_runtime_in_c(name: str) -> None:
    controller = built("fig2_2")[2]
    files = runtime_c(controller, [])
    own = re.search(rf"^  (?:if .*\n    )?((?:(?!now)[\w]+\.)?{name}) =", files["fig2_2.c"], re.MULTILINE)
    assert own is not None
    value = {"YX_R1": "1", "now": "next"}.get(name, "true")
    at = own.start() if name != "now" else files["fig2_2.c"].rindex("  report();")
    text = f"{files['fig2_2.c'][:at]}  {own[1]} = {value};\n{files['fig2_2.c'][at:]}"
    (wrong,) = compare_c(controller, {**files, "fig2_2.c": text}).differences
    assert "twice" in wrong.text


def test_the_runtime_in_python_keeps_its_state_once_and_then_returns_its_outputs() -> None:
    """Nothing else of it can be seen by others."""
    controller = built("fig2_2")[2]
    text = runtime_py(controller, [])
    whole = re.search(r"        self\.state = dict\(zip\(.*?\n        \)\)\)\)\n", text, re.DOTALL)
    assert whole is not None and compare_runtime(controller, text).proved
    assert not compare_runtime(controller, text.replace(whole[0], whole[0] * 2)).proved
    assert not compare_runtime(
        controller, text.replace(whole[0], "        self.state['K_DP'] = True\n" + whole[0])
    ).proved


def run(body: str) -> dict[str, Term]:
    text = f"FUNCTION_BLOCK M\nVAR_INPUT c : BOOL; END_VAR\nVAR_OUTPUT o : BOOL; END_VAR\n{body}\nEND_FUNCTION_BLOCK\n"
    found: Execution[Term] = Execution(parse_unit(text), Symbols(), kept)
    found.main.forget()
    return found.scan({"c": var(spelled("c"))})


@pytest.mark.parametrize(
    "body",
    [
        "o := c; o := c;",
        "o := c; IF c THEN o := FALSE; END_IF;",
        "IF c THEN o := FALSE; END_IF; o := c;",
        "IF c THEN o := FALSE; o := TRUE; END_IF;",
        "IF c THEN o := FALSE; ELSE o := c; o := TRUE; END_IF;",
        "IF c THEN IF c THEN o := FALSE; END_IF; o := TRUE; END_IF;",
        "IF c THEN o := TRUE; IF c THEN o := FALSE; END_IF; END_IF;",
    ],
)
def test_arms_of_an_if_write_once_each_and_nothing_that_was_written(body: str) -> None:
    with pytest.raises(BadText, match="twice"):
        run(body)
    for good in ("o := c;", "IF c THEN o := TRUE; ELSIF c THEN o := c; ELSE IF c THEN o := c; END_IF; END_IF;"):
        run(good)
