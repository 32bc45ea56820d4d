"""Pages for people: the report of a layout, and the player of a run."""

from interlock.emit.report.page import report_html
from interlock.emit.report.player import BadTrace, player_html

__all__ = ["BadTrace", "player_html", "report_html"]
