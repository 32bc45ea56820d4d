"""The second checker: accepts what belongs together, refuses what was forged, with the sentence that says why."""

from __future__ import annotations

import hashlib
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from interlock.app.init import yard
from interlock.checker.check import agree, check, report
from interlock.checker.claims import unsaid
from interlock.checker.formula import Formula, _clauses, clauses, every, leaf, no, some
from interlock.checker.reading import loaded
from interlock.checker.specification import shipped
from interlock.checker.written import written
from interlock.verify import Rejected
from tests.certified import accepted, certified, forge_proof, signed
from tests.written import told

FIG = Path("layouts/fig2_2.yaml")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The certificate of a small layout, and all that it names, as they should be."""
    top = tmp_path_factory.mktemp("made")
    (top / "layouts").mkdir()
    shutil.copy(FIG, top / "layouts")
    certified(top / "layouts" / FIG.name, top)
    return top


@pytest.fixture
def copy(made: Path, tmp_path: Path) -> Path:
    """A copy of it, to be forged."""
    shutil.copytree(made, tmp_path / "copy")
    return tmp_path / "copy"


def files(top: Path) -> tuple[Path, Path, Path]:
    """Layout, certificate and text."""
    return top / "layouts/fig2_2.yaml", top / "proofs/fig2_2", top / "generated/fig2_2/st/iec/fig2_2.st"


def refused(top: Path) -> str:
    """Why, after the digests were made to agree again; the certificate by itself is still accepted."""
    layout, folder, _ = files(top)
    signed(folder)
    assert accepted(folder), "forged so badly that the refutations alone show it"
    with pytest.raises(Rejected) as found:
        check(layout, folder)
    return str(found.value)


def edit(file: Path, before: str, after: str) -> None:
    text = file.read_text("utf-8")
    assert text.count(before) >= 1, before
    file.write_text(text.replace(before, after, 1), encoding="utf-8")


def test_what_belongs_together_is_accepted(made: Path, capsys: pytest.CaptureFixture[str]) -> None:
    layout, folder, _ = files(made)
    found = check(layout, folder)
    assert "146 equations, 56 initial values, 9 timers" in found.compared[1]
    assert report(layout, folder) == (3 if found.left else 0), "what was not compared is no success"
    assert ("VERIFIED" in capsys.readouterr().out) is not bool(found.left)


def test_a_name_that_no_folder_can_bear_is_refused_as_that(copy: Path) -> None:
    layout, folder, _ = files(copy)
    edit(layout, "name: fig2_2", "name: fig2/2")
    with pytest.raises(Rejected, match="the name fig2/2 has a /"):
        check(layout, folder)
    edit(layout, "name: fig2/2", f"name: {'f' * 61}")
    with pytest.raises(Rejected, match="its name has more than 60 signs"):
        check(layout, folder)


OWN_TIMER = """FUNCTION_BLOCK TON
VAR_INPUT IN : BOOL; PT : TIME; END_VAR
VAR_OUTPUT Q : BOOL; END_VAR
  Q := IN;
END_FUNCTION_BLOCK
"""
"""A delay that is over at once: a compiler takes it for the timer."""
BESIDE = """FUNCTION_BLOCK BESIDE
VAR_IN_OUT INP : IL_fig2_2_I; END_VAR
END_FUNCTION_BLOCK
"""

EDITS = {
    "an output": ("YP_X1 := D.S_R1 OR D.S_R2;", "YP_X1 := D.S_R1;", "YP_X1"),
    "outputs swapped": ("YN_P1 := D.CN_P1 AND", "YN_P1 := D.CR_P1 AND", "YN_P1"),
    "a next value": ("D.N_K_DP := D.K_DP", "D.N_K_DP := NOT D.K_DP", "K_DP"),
    "a wire": ("OCC_DP := NOT INP.CLR_DP", "OCC_DP := INP.CLR_DP", "OCC_DP"),
    "an initial value": ("K_DP : BOOL := TRUE; (* DP: restart", "K_DP : BOOL := FALSE; (* DP: restart", "K_DP"),
    "the start of an output": ("YS_X1 : BOOL := TRUE", "YS_X1 : BOOL := FALSE", "YS_X1"),
    "the start of an input": ("VALID : BOOL := FALSE", "VALID : BOOL := TRUE", "valid before they are read"),
    "the start of a word": ("YX_R1 : INT := 0", "YX_R1 : INT := 1", "YX_R1 does not begin with 0"),
    "a word that says open at stop": ("IF D.N_S_R1 THEN OUTP.YX_R1", "IF D.N_A_R1 THEN OUTP.YX_R1", "says open"),
    "a preset": (
        "(IN := D.RTI_DP, PT := T#3s)",
        "(IN := D.RTI_DP, PT := T#1ms)",
        "RT_DP has 1 ms in the text, 3000 ms",
    ),
    "a timer for two sections": (
        "  TON_RT_SB(IN := D.RTI_SB, PT := T#3s);\n  D.RT_SB := TON_RT_SB.Q;",
        "  TON_RT_SA(IN := D.RTI_SB, PT := T#3s);\n  D.RT_SB := TON_RT_SA.Q;",
        "TON_RT_SA is called twice",
    ),
    "a timer called twice": (
        "  D.RT_SB := TON_RT_SB.Q;",
        "  D.RT_SB := TON_RT_SB.Q;\n  TON_RT_SB(IN := D.RTI_SA, PT := T#3s);",
        "TON_RT_SB is called twice",
    ),
    "the input of a timer": ("IN := D.ATI_X1,", "IN := D.ATI_X2,", "AT_X1 waits for ATI_X2"),
    "a structure that is not handed": ("B01(INP := INP, D := D)", "B01(INP := INP)", "without one of its structures"),
    "another structure": ("B01(INP := INP, D := D)", "B01(INP := OUTP, D := D)", "B01 is handed something else"),
    "a structure of another type": ("  INP : IL_fig2_2_I;", "  INP : IL_fig2_2_Q;", "no structure of that name"),
    "a structure of one's own": (
        "VAR_IN_OUT\n  INP : IL_fig2_2_I;\n  D : IL_fig2_2_D;\nEND_VAR\nVAR\n",
        "VAR_IN_OUT\n  INP : IL_fig2_2_I;\nEND_VAR\nVAR\n  D : IL_fig2_2_D;\n",
        "B01 is called without one of its structures",
    ),
    "a group that keeps a structure of its own": (
        "  OUTP : IL_fig2_2_Q;\n  D : IL_fig2_2_D;\nEND_VAR\nVAR\n  B01",
        "  OUTP : IL_fig2_2_Q;\nEND_VAR\nVAR\n  D : IL_fig2_2_D;\n  B01",
        "G01 is called without one of its structures, or with another",
    ),
    "a structure beside those that are known": (
        "FUNCTION_BLOCK",
        "TYPE OTHER :\nSTRUCT\n  ZZ : BOOL;\nEND_STRUCT;\nEND_TYPE\nFUNCTION_BLOCK",
        "the structures are not those of the main block",
    ),
    "a member in two structures": ("  YS_X1 : BOOL", "  RSTI : BOOL", "a member of one name"),
    "a member twice": ("  YS_X1 : BOOL", "  YP_X1 : BOOL", "declares YP_X1 twice"),
    "an input that is written": ("  D.RSTI := D.PWR;", "  D.RSTI := D.PWR;\n  INP.VALID := TRUE;", "which is an input"),
    "a block called twice": ("  T01(D := D);", "  T01(D := D);\n  T01(D := D);", "T01"),
    "a block not called": ("  T01(D := D);\n", "", "D.RT_DP is read before it is computed"),
    "another instance of a block": ("T01 : IL_fig2_2_T01;", "T01 : IL_fig2_2_B02;", "T01 is called without"),
    "the last block not called": ("  Y01(OUTP := OUTP, D := D);\n", "", "Y01 of IL_fig2_2_G01 is never called"),
    "blocks in another order": (
        "  T01(D := D);\n  B02(INP := INP, D := D);",
        "  B02(INP := INP, D := D);\n  T01(D := D);",
        "is no state",
    ),
    "state committed too early": (
        "  B03(INP := INP, D := D);",
        "  S01(D := D);\n  B03(INP := INP, D := D);",
        "read before it is computed",
    ),
    "a statement twice": (
        "OUTP.YN_P1 := D.CN_P1 AND NOT D.ZO_P1;",
        "OUTP.YN_P1 := D.CN_P1 AND NOT D.ZO_P1; OUTP.YN_P1 := FALSE;",
        "YN_P1 is written twice",
    ),
    "a statement that is not known": (
        "OUTP.YN_P1 := D.CN_P1 AND NOT D.ZO_P1;",
        "IF INP.VALID THEN OUTP.YN_P1 := TRUE; END_IF;",
        "expected",
    ),
    "an output by cases": (
        "OUTP.YN_P1 := D.CN_P1 AND NOT D.ZO_P1;",
        "IF D.CN_P1 AND NOT D.ZO_P1 THEN OUTP.YN_P1 := 1; ELSE OUTP.YN_P1 := 0; END_IF;",
        "is no word",
    ),
    "a statement left out": ("OUTP.YN_P1 := D.CN_P1 AND NOT D.ZO_P1;", "", "YN_P1 is never written"),
    "an output that is read": ("OUTP.YR_P1 := D.CR_P1 AND NOT D.ZO_P1;", "OUTP.YR_P1 := OUTP.YA_P1;", "is no state"),
    "a timer of its own": ("FUNCTION_BLOCK", f"{OWN_TIMER}FUNCTION_BLOCK", "the text defines TON itself"),
    "the same in small letters": ("FUNCTION_BLOCK", f"{OWN_TIMER.lower()}FUNCTION_BLOCK", "expected"),
    "a block beside": ("FUNCTION_BLOCK", f"{BESIDE}FUNCTION_BLOCK", "used by nobody"),
    "parameters": ("FUNCTION_BLOCK", f"{OWN_TIMER.replace('TON', 'TOFF')}FUNCTION_BLOCK", "expected"),
    "a variable called as a type": ("  T_1 : BOOL;", "  TON : BOOL;", "the text defines TON itself"),
    "NOT before a number": (
        "INP.VALID AND (INP.REQ = 0);",
        "NOT (NOT INP.VALID OR NOT INP.REQ = 0);",
        "a number",
    ),
    "a comment that a tool obeys": (
        "D.RSTI := D.PWR;",
        "D.RSTI := D.PWR; (*~ (OPC:1:visible) ~*)",
        "is not known here",
    ),
    "one with a blank before": ("D.RSTI := D.PWR;", "D.RSTI := D.PWR; (* @END_DECLARATION *)", "is not known here"),
    "a comment that an editor shows as something else": (
        "D.RSTI := D.PWR;",
        "D.RSTI := D.PWR; (* \u202e *)",
        "is not known here",
    ),
    "one with a letter that no text of ours has": ("D.RSTI := D.PWR;", "D.RSTI := D.PWR; (* é *)", "is not known here"),
    "one with a form feed": ("D.RSTI := D.PWR;", "D.RSTI := D.PWR; (* \f *)", "is not known here"),
    "a comment within a comment": ("D.RSTI := D.PWR;", "D.RSTI := D.PWR; (* (* *)", "is not known here"),
    "a line that only some compilers end": ("D.RSTI := D.PWR;", "D.RSTI :=\u2028D.PWR;", "is not known here"),
    "a number that C takes for octal": ("(INP.REQ = 0)", "(INP.REQ = 00)", "is not known here"),
    "a duration that no compiler takes": ("T#3s", "T#1s2s", "malformed duration T#1s2s"),
}


@pytest.mark.parametrize("which", EDITS)
def test_an_edit_of_the_text_is_refused_by_name(copy: Path, which: str) -> None:
    before, after, why = EDITS[which]
    edit(files(copy)[2], before, after)
    assert why in refused(copy)


def test_one_changed_output_equation(copy: Path) -> None:
    """An alarm, of which no claim but an indication's speaks: with the written system changed accordingly."""
    edit(files(copy)[2], "YP_X3 := D.S_R4;", "YP_X3 := D.S_R4 AND D.F_DP;")
    assert refused(copy) == "the text computes the next value of YP_X3 otherwise than the written system"


def test_a_preset_that_only_the_written_system_has(copy: Path) -> None:
    edit(files(copy)[1] / "system.txt", "timer RT_DP RTI_DP 3000", "timer RT_DP RTI_DP 9000")
    assert "RT_DP has 3000 ms in the text, 9000 ms as written" in refused(copy)


def test_a_table_of_words_that_lies(copy: Path) -> None:
    """What the display shows for a code: changed alone, and with the list of outputs that names it."""
    table, listed = (copy / "generated/fig2_2" / x for x in ("io/words.csv", "manifest.json"))
    before = hashlib.sha256(table.read_bytes()).hexdigest()
    edit(table, ",10008,section DP is occupied,", ",10008,section DP is blocked,")
    assert "io/words.csv is not the file that the manifest of outputs names" in refused(copy)
    edit(listed, before, hashlib.sha256(table.read_bytes()).hexdigest())
    assert "10008 is published as 'section DP is blocked'" in refused(copy)


def test_which_text_was_read_is_told(copy: Path) -> None:
    """A certificate may name a text that is none of those which are loaded into a controller."""
    layout, folder, text = files(copy)
    assert str(text.resolve()) in check(layout, folder).compared[-2]
    aside = copy / "aside/fig2_2/st/iec/fig2_2.st"
    aside.parent.mkdir(parents=True)
    shutil.copy(text, aside)
    edit(folder / "manifest.json", "../../generated/fig2_2/st/iec/fig2_2.st", "../../aside/fig2_2/st/iec/fig2_2.st")
    edit(text, "YP_X1 := D.S_R1 OR D.S_R2;", "YP_X1 := TRUE;")
    signed(folder)
    said = check(layout, folder).compared[-2]
    assert str(aside.resolve()) in said


def test_another_layouts_certificate(made: Path) -> None:
    with pytest.raises(Rejected, match="of another layout"):
        check(Path("layouts/fig2_1.yaml"), files(made)[1])


def test_a_wrong_controller_with_its_own_correct_certificate_beside_the_shipped_text(
    copy: Path, tmp_path: Path
) -> None:
    """X1 asks for nothing beyond the layout's rules; a controller of a layout that is like it but for one signal is
    proved, and its certificate is signed for this layout and this text."""
    layout, folder, _ = files(copy)
    other = tmp_path / "other" / "fig2_2.yaml"
    other.parent.mkdir()
    other.write_text(
        layout.read_text("utf-8").replace("profile: mine", "profile: mine\nprinciples: {release_delay_s: 5}")
    )
    foreign = certified(other, other.parent)
    for name in ("system.txt", "proof.txt.xz", "needed.txt"):
        shutil.copy(foreign / name, folder / name)
    assert "RT_DP has 3000 ms in the text, 5000 ms as written" in refused(copy)


def lines(top: Path) -> tuple[Path, list[str]]:
    file = files(top)[1] / "system.txt"
    return file, file.read_text("utf-8").splitlines()


def proved_again(top: Path, told: list[str]) -> None:
    """The written system with other lines, and a proof of what it then says: by a forger who proves what he writes."""
    folder = files(top)[1]
    (folder / "system.txt").write_text("\n".join(told) + "\n", encoding="utf-8")
    forge_proof(folder)


def test_all_claims_T(copy: Path) -> None:
    _, told = lines(copy)
    proved_again(copy, [" ".join([*x.split(" ")[:3], "T"]) if x.startswith("claim ") else x for x in told])
    assert "lacks what the specification asks" in refused(copy)


def test_no_claims_at_all(copy: Path) -> None:
    _, told = lines(copy)
    proved_again(copy, [x for x in told if not x.startswith("claim ")])
    assert "lacks what the specification asks" in refused(copy)


def test_an_assumption_F(copy: Path) -> None:
    """Nothing can happen, so that everything is proved: written as two clauses, which the prover can use."""
    _, told = lines(copy)
    at = next(n for n, x in enumerate(told) if x.startswith("asm A-TON"))
    proved_again(copy, [*told[:at], "asm A-CONTACT (& VALID !VALID)", *told[at:]])
    assert "the assumption A-CONTACT says more than the specification: FALSE" in refused(copy)


def test_an_assumption_of_an_input(copy: Path) -> None:
    """Under a name that the specification has not."""
    _, told = lines(copy)
    at = next(n for n, x in enumerate(told) if x.startswith("asm A-TON"))
    proved_again(copy, [*told[:at], "asm A-WATCHFUL !CAN_X1", *told[at:]])
    assert refused(copy) == "A-WATCHFUL is assumed, which the specification has not"


def test_an_assumption_dropped_from_the_list(copy: Path) -> None:
    """It is still assumed, but whoever reads the list does not learn of it."""
    _, told = lines(copy)
    proved_again(copy, [x for x in told if not x.startswith("assumed A-ONE-FALSE")])
    assert refused(copy) == "A-ONE-FALSE is assumed, but not in the list of assumptions"


def test_a_weaker_claim_under_the_old_sentence(copy: Path) -> None:
    _, told = lines(copy)
    before = "claim S-CLEAR X1:1 (| !(& YP_X1' at.P1.N') (& CLR_DP RT_DP))"
    assert before in told
    proved_again(copy, [x.replace("(& CLR_DP RT_DP)", "CLR_DP BLK_DP") if x == before else x for x in told])
    assert "the claim S-CLEAR lacks what the specification asks: (CLR_DP or not YP_X1' or not at.P1.N')" in refused(
        copy
    )


def test_a_claim_under_another_sentence(copy: Path) -> None:
    _, told = lines(copy)
    proved_again(copy, [x.replace("No train comes", "Hardly a train comes") for x in told])
    assert refused(copy) == "T-COLLISION has another sentence than the specification's"


def test_an_invariant_assumed_instead_of_proved(copy: Path) -> None:
    _, told = lines(copy)
    at = next(n for n, x in enumerate(told) if x.startswith("asm A-TON"))
    invariant = next(x for x in told if x.startswith("inv S-LIES:1:P1 "))
    rest = [x for x in told if x != invariant]
    proved_again(copy, [*rest[:at], f"asm A-CONTACT {invariant.split(' ', 3)[3]}", *rest[at:]])
    assert "the assumption A-CONTACT says more than the specification" in refused(copy)


def test_a_larger_layout_is_verified_with_its_certificate(tmp_path: Path) -> None:
    layout = Path("layouts/junction.yaml")
    found = check(layout, certified(layout, tmp_path))
    assert "as specified" in found.compared[2]
    assert "A-OVERRUN" in found.compared[4], "conditions of the world's moves are listed, too"
    assert found.left == (), "everything was compared"


def test_a_layout_with_something_unknown_is_not_verified(
    made: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("interlock.checker.drawing.KEYS", frozenset({"interlock", "name", "title"}))
    assert report(*files(made)[:2]) == 3
    told = capsys.readouterr().out
    assert "does not read boundaries, points" in told and "VERIFIED" not in told


@pytest.mark.parametrize("timer", ["RST", "AT_X1", "RT_DP", "ST_P1"])
def test_a_delay_that_is_too_short_is_refused(made: Path, timer: str) -> None:
    """Whatever the prover has compared: D-PRESET is T in the written system, and settled here anew."""
    layout, folder, file = files(made)
    system, text = (folder / "system.txt").read_text("utf-8"), file.read_text("utf-8")
    source, preset = written(system).timers[timer]
    shorter = re.sub(rf"(IN := D\.{source}, PT := )T#\w+\)", rf"\1T#{preset - 1}ms)", text)
    written_so = system.replace(f"timer {timer} {source} {preset}", f"timer {timer} {source} {preset - 1}")
    with pytest.raises(Rejected, match="D-PRESET lacks"):
        agree(loaded(layout.read_text("utf-8")), written_so, shorter, shipped())


def test_a_delay_that_no_controller_can_count_is_refused(made: Path) -> None:
    """Of a TIME of 32 bits nothing is left of 2^32 + 1 ms but the one: the signal would be given up at once."""
    layout, folder, file = files(made)
    system, text = (folder / "system.txt").read_text("utf-8"), file.read_text("utf-8")
    body = loaded(layout.read_text("utf-8"))
    source, preset = written(system).timers["AT_X1"]
    for long, counted in ((2**31 - 1, True), (2**31, False), (2**32 + 1, False)):
        longer = re.sub(rf"(IN := D\.{source}, PT := )T#\w+\)", rf"\1T#{long}ms)", text)
        written_so = system.replace(f"timer AT_X1 {source} {preset}", f"timer AT_X1 {source} {long}")
        if counted:
            agree(body, written_so, longer, shipped())
        else:
            with pytest.raises(Rejected, match="D-PRESET lacks"):
                agree(body, written_so, longer, shipped())


def test_a_start_that_says_less_is_refused(copy: Path) -> None:
    _, told = lines(copy)
    proved_again(copy, [x.replace(" K_DP ", " ") if x.startswith("start ") else x for x in told])
    assert "the claim P-START lacks" in refused(copy)


WORLDS = {
    "a train that never comes in": ("def head.C.SC (& o.SC", "def head.C.SC (& F o.SC", "head.C.SC is specified as"),
    "a point that never moves": ("cmd.P1.R) ?start.P1.N)", "cmd.P1.R) F ?start.P1.N)", "start.P1.N is specified as"),
    "points that lie right at the start": ("ini !go.X1", "ini at.P1.N\nini !go.X1", "narrower than specified: at.P1.N"),
}


@pytest.mark.parametrize("which", WORLDS)
def test_a_tamer_world_is_refused(copy: Path, which: str) -> None:
    before, after, why = WORLDS[which]
    _, told = lines(copy)
    text = "\n".join(told)
    assert before in text
    proved_again(copy, text.replace(before, after, 1).splitlines())
    assert why in refused(copy)


def test_verified_is_said_when_all_was_compared(made: Path, capsys: pytest.CaptureFixture[str]) -> None:
    layout, folder, _ = files(made)
    assert report(layout, folder) == 0
    told = capsys.readouterr().out
    assert "VERIFIED" in told and "events and next values of the world" in told


@pytest.mark.parametrize("text", ["name: a\nname: b\n", "points: {1: {toe: a}, 1: {toe: b}}\n"])
def test_a_key_that_stands_twice_is_read_by_nobody(text: str) -> None:
    """Of two equal keys a reader of YAML believes the last; the product refuses such a layout, and so does the second
    reading, in layouts and in the specification."""
    with pytest.raises(yaml.YAMLError, match="stands twice"):
        loaded(text)


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """As in a yard of many tracks: what shows proceed over both arms of its diamonds makes too many clauses."""
    monkeypatch.setattr("interlock.checker.formula.CLAUSES", 150)
    monkeypatch.setattr("interlock.checker.claims.CLAUSES", 150)
    _clauses.cache_clear()
    yield
    _clauses.cache_clear()


def test_a_formula_that_both_have_is_not_taken_apart(few: None) -> None:
    body, system, text = told(yard(8))
    over = [x for id_, _, x in written(system).claims if id_ == "S-HOSTILE"]
    assert any(clauses(x) == {frozenset({x})} for x in over), "one is too large"
    assert "as specified" in agree(body, system, text, shipped()).compared[1]


@pytest.mark.parametrize(("most", "why"), [(4000, ""), (150, "too large to tell")])
def test_a_signal_that_is_left_out_at_a_diamond_is_missed(monkeypatch: pytest.MonkeyPatch, most: int, why: str) -> None:
    """Whether the formula can be taken apart or not."""
    monkeypatch.setattr("interlock.checker.formula.CLAUSES", most)
    monkeypatch.setattr("interlock.checker.claims.CLAUSES", most)
    _clauses.cache_clear()
    body, system, text = told(yard(8))
    shown = "(& (| YP_SE5 YY_SE5) at.Ef2n.N at.Ef2.N at.EM1.R)"
    forged = [x.replace(shown, "F") if x.startswith("claim S-HOSTILE ") else x for x in system.splitlines()]
    assert shown in system
    with pytest.raises(Rejected, match=f"the claim S-HOSTILE lacks what the specification asks.*{why}"):
        agree(body, "\n".join(forged), text, shipped())
    _clauses.cache_clear()


A, B, C, D = map(leaf, "abcd")
SAID: dict[str, tuple[set[Formula], set[Formula], int]] = {
    "the same": ({some((A, B))}, {some((A, B))}, 0),
    "in another nesting": ({some((A, every((B, C))))}, {some((A, B)), some((C, A))}, 0),
    "more": ({some((A, B))}, {A}, 0),
    "less": ({A}, {some((A, B))}, 1),
    "less of two": ({A, B}, {A, some((B, C))}, 1),
    "what only a formula says that both have": (
        {some((A, every((B, C)))), some((A, B, D))},
        {some((A, every((B, C))))},
        0,
    ),
    "nothing": ({A}, set(), 1),
    "what cannot be": ({A, B}, {every(()), no(every(()))}, 0),
}


@pytest.mark.parametrize("which", SAID)
def test_what_is_said_here_and_not_there(which: str) -> None:
    wanted, found, many = SAID[which]
    assert len(unsaid(wanted, found)) == many


def test_a_formula_that_is_too_large_to_compare_is_refused_as_that(monkeypatch: pytest.MonkeyPatch) -> None:
    """Refused, as nobody knows; and told apart from a claim that says something else."""
    monkeypatch.setattr("interlock.checker.formula.CLAUSES", 1)
    monkeypatch.setattr("interlock.checker.claims.CLAUSES", 1)
    _clauses.cache_clear()
    try:
        with pytest.raises(Rejected, match="one has over 1 clauses and is compared as it stands, too large to tell"):
            agree(*told(Path("layouts/junction.yaml").read_text("utf-8")), shipped())
    finally:
        _clauses.cache_clear()
