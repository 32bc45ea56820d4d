"""PLCopen XML (TC6) 2.00, as CODESYS itself writes it.

The form of the task is that of public files that CODESYS exported: an interval as XML Schema has it, beside the
settings that CODESYS reads, and instances that are programs by name.  No CODESYS was at hand.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree

from interlock.st.ast import Task
from interlock.st.dialects.dialect import Dialect
from interlock.st.dialects.plcopen import XHTML, PlcOpen
from interlock.st.dialects.strict import Rule
from interlock.st.parser import NotInSubset
from interlock.st.program import Runs
from interlock.st.structures import structured

_SETTINGS = "http://www.3s-software.com/plcopenxml/tasksettings"
_RULES = {
    "task": Rule("name interval priority", "pouInstance addData"),
    "pouInstance": Rule("name typeName", "documentation"),
    "addData": Rule(children="data"),
    "data": Rule("name handleUnknown", "TaskSettings"),
    "TaskSettings": Rule("KindOfTask Interval IntervalUnit WithinSPSTimeSlicing"),
}


class Codesys(PlcOpen):
    """The project file whose task is told as CODESYS tells it."""

    def __init__(self) -> None:
        super().__init__("0200", True, _RULES)

    def _configurations(self, t: Task) -> list[str]:
        ms = t.interval_ms
        return [
            "    <configurations>",
            f'      <configuration name="{t.configuration}"><resource name="{t.resource}">',
            f'        <task name="{t.name}" interval="PT{ms / 1000:g}S" priority="0">',
            f'          <pouInstance name="{t.program}" typeName="">',
            f'            <documentation><xhtml xmlns="{XHTML}"/></documentation>',
            "          </pouInstance>",
            "          <addData>",
            f'            <data name="{_SETTINGS}" handleUnknown="implementation">',
            f'              <TaskSettings KindOfTask="Cyclic" Interval="t#{ms}ms" IntervalUnit="ms"',
            '                WithinSPSTimeSlicing="true"/>',
            "            </data>",
            "          </addData>",
            "        </task>",
            "      </resource></configuration>",
            "    </configurations>",
        ]

    def _task(self, configuration: ElementTree.Element) -> Task:
        """The one task, which has to be told as it is written here, word for word."""
        resource, task, instance, settings = (
            next(configuration.iter(self._path(x)), None) for x in ("resource", "task", "pouInstance", "TaskSettings")
        )
        if resource is None or task is None or instance is None or settings is None:
            raise NotInSubset("a configuration that is not one task with one program and its settings")
        names = [x.get("name", "") for x in (configuration, resource, task, instance)]
        interval = re.fullmatch(r"t#([0-9]+)ms", settings.get("Interval", ""), re.ASCII)
        if interval is None or not all(re.fullmatch(r"\w+", n, re.ASCII) for n in names):
            raise NotInSubset("a task without an interval in milliseconds, or a name that is not one word")
        found = Task(names[0], names[1], names[2], int(interval[1]), "", names[3])
        (made,) = ElementTree.fromstring(f'<x xmlns="{self.space}">{"".join(self._configurations(found))}</x>')
        if _told(configuration) != _told(made[0]):
            raise NotInSubset("a configuration that is told otherwise than CODESYS tells one task with one program")
        return found


def _told(e: ElementTree.Element) -> tuple[object, ...]:
    """An element with all that stands in it, but for blanks around it."""
    return (e.tag, sorted(e.attrib.items()), (e.text or "").strip(), tuple(map(_told, e)))


_TC6_200 = Codesys()

DIALECT = Dialect(
    "codesys",
    "CODESYS V3 and TwinCAT, PLCopen XML TC6 2.00",
    _TC6_200.write,
    _TC6_200.read,
    runs=Runs.APPLICATION,
    form=structured,
)
