"""The notation of the Chinese interlocking table: headings, legend, points as they lie, signals in their order."""

from __future__ import annotations

from collections.abc import Iterable

from interlock.model.elements import MachineId, PointId, Position
from interlock.table.cells import RouteKind
from interlock.table.national.sheet import Heading

HEADINGS = (
    Heading("Direction", "方向", "Richtung"),
    Heading("Route", "进路", "Fahrstraße"),
    Heading("Alternative", "进路方式", "Variante"),
    Heading("Buttons", "排列进路按下的按钮", "Tasten"),
    Heading("Deciding points", "确定运行方向道岔", "Entscheidungsweichen"),
    Heading("Signal", "信号机名称", "Signal"),
    Heading("Aspect", "信号机显示", "Signalbegriff"),
    Heading("Indicator", "表示器", "Richtungsanzeiger"),
    Heading("Points", "道岔", "Weichen"),
    Heading("Hostile signals", "敌对信号", "Feindliche Signale"),
    Heading("Track sections", "轨道区段", "Gleisabschnitte"),
    Heading("Facing train routes", "迎面进路 列车", "Gegenfahrten Zug"),
    Heading("Facing shunt routes", "迎面进路 调车", "Gegenfahrten Rangieren"),
    Heading("Other", "其他联锁", "Sonstiges"),
    Heading("No.", "进路号码", "Nr."),
)
_ROMAN = {"I": 1, "II": 2, "III": 3, "IV": 4, "V": 5, "VI": 6, "VII": 7, "VIII": 8, "IX": 9, "X": 10}

LEGEND = (
    ("1/3、(1/3)", "道岔定位、反位"),
    ("[1/3]、{1/3}", "防护道岔（检查）、带动道岔（不检查）"),
    ("S5、S5L、S5D", "敌对信号：列车和调车、仅列车、仅调车"),
    ("<1>D1", "1 号道岔定位时敌对；条件管到下一个条件为止"),
    ("敌对信号", "不列道岔位置已排斥的进路，也不列迎面进路栏已列的进路"),
    ("<25>25DG", "25 号道岔定位时检查侵限区段"),
    ("17/9", "通过进路：接车进路 17 和发车进路 9 的全部条件"),
    ("BA", "变更按钮；名称由本程序给出"),
)
OVERLAP = ("保护区段 T，道岔 1", "终端信号机内方的保护区段及其道岔；因保护区段而敌对的进路见 table.csv")
"""Where a layout has overlaps, for which the form has no column."""

NOT_PRINTED = {
    RouteKind.CALL_ON: ("引导进路", "{} 条不列，也不计入敌对信号：教科书的联锁表只列列车和调车进路；见 table.csv"),
    RouteKind.SHUNT: ("变更调车进路", "{} 条不列：调车只列基本进路；见 table.csv"),
}
"""What the form leaves out of a table, with how many there are."""


DEVICE = {"open": "开启", "closed": "关闭", "shut": "关闭"}
"""How a level crossing (道口), a door or another device is, by the word for it."""


def lying(m: PointId | MachineId, x: Position) -> str:
    """Points as they lie: in brackets where reverse."""
    return m if x is Position.NORMAL else f"({m})"


def order(name: str) -> tuple[object, ...]:
    """Signals as they stand from top to bottom: by letter; odd tracks descending, then even tracks ascending."""
    head = name.rstrip("0123456789")
    tail: Iterable[str] | str = name[len(head) :]
    if not tail:
        for k in range(1, len(name)):
            if name[k:] in _ROMAN:
                head, tail = name[:k], str(_ROMAN[name[k:]])
                break
    n = int(str(tail)) if tail else 0
    if name in _ROMAN or name.isdigit():
        n = _ROMAN.get(name, 0) or int(name)
        return ("Z", -n if n % 2 else n)
    if head == "D":
        return (head, n)
    return (head, -n if n % 2 else n)
