"""The track plan: placed from topology alone, drawn as SVG."""

from interlock.emit.drawing.canvas import Drawing
from interlock.emit.drawing.place import place
from interlock.emit.drawing.sheets import folded, sheets
from interlock.emit.drawing.svg import opening, plan_svg

__all__ = ["Drawing", "folded", "opening", "place", "plan_svg", "sheets"]
