"""Every diagnostic code with its severity and its one-line title.

`interlock explain CODE` prints the page of the same name under docs/codes.  A test keeps this list,
the pages and the triggering layouts in step.
"""

from __future__ import annotations

from interlock.diag.diagnostic import Severity

_E, _W, _I = Severity.ERROR, Severity.WARNING, Severity.INFO

CODES: dict[str, tuple[Severity, str]] = {
    # 1: the file and its shape
    "IL1001": (_E, "the file cannot be read"),
    "IL1002": (_E, "the file is not UTF-8 text"),
    "IL1003": (_E, "the file is too large"),
    "IL1004": (_E, "the YAML is broken"),
    "IL1005": (_E, "a key is given twice"),
    "IL1006": (_E, "anchors and aliases are not part of the layout language"),
    "IL1007": (_E, "the file is empty"),
    "IL1008": (_E, "the file holds more than one document"),
    "IL1009": (_E, "the file is not a layout"),
    "IL1010": (_E, "a required key is missing"),
    "IL1011": (_E, "an unknown key"),
    "IL1012": (_E, "a value of the wrong shape"),
    "IL1013": (_E, "a length or number that is not a number"),
    "IL1014": (_E, "a number out of range"),
    "IL1015": (_E, "an unsupported language version"),
    "IL1016": (_E, "a name that cannot be used"),
    "IL1017": (_E, "an unknown choice"),
    "IL1018": (_E, "the file is nested too deeply"),
    "IL1019": (_E, "YAML tags are not part of the layout language"),
    "IL1020": (_I, "more problems than are shown"),
    # 2: names and references
    "IL2001": (_E, "a reference to something that does not exist"),
    "IL2002": (_E, "a name is used for two things"),
    "IL2003": (_E, "an element has no such end"),
    "IL2004": (_E, "an unknown section"),
    "IL2005": (_E, "an unknown boundary or buffer"),
    "IL2006": (_E, "an unknown signal"),
    "IL2007": (_E, "a named route that does not exist"),
    "IL2008": (_E, "a waiver that waives nothing"),
    "IL2009": (_E, "a waiver without a reason"),
    "IL2010": (_E, "two names become the same PLC name"),
    "IL2011": (_W, "a condition that no route requires"),
    "IL2012": (_W, "an exclusion that fits no route"),
    "IL2013": (_E, "a voyage that no chain of routes makes"),
    "IL2014": (_E, "a substation's elements are not clear"),
    "IL2016": (_E, "a signal that cannot call trains on"),
    "IL2017": (_E, "a direction token where trains run one way"),
    "IL2015": (_E, "an address that cannot be"),
    "IL2019": (_E, "an addition that fits no route"),
    "IL2020": (_E, "a file of pins that is none, or is another layout's"),
    "IL2021": (_E, "a pin that cannot be"),
    "IL2022": (_E, "the layout contradicts a pin"),
    "IL2023": (_W, "channels that are not pinned yet"),
    "IL2018": (_W, "an allowance that allows nothing"),
    # 3: topology and geometry
    "IL3001": (_E, "an element is wired to itself"),
    "IL3002": (_E, "one end is joined twice"),
    "IL3003": (_E, "an end is joined to nothing"),
    "IL3004": (_E, "two elements disagree on how they are joined"),
    "IL3005": (_E, "a signal that stands at no joint"),
    "IL3006": (_E, "the joint of a signal is ambiguous"),
    "IL3007": (_E, "two signals in one place, same direction"),
    "IL3009": (_E, "a section is split into separate pieces"),
    "IL3010": (_E, "a section that no train can reach"),
    "IL3011": (_E, "trains can come in where no signal stands"),
    "IL3012": (_W, "a section that no route uses"),
    "IL3013": (_E, "an approach section is also inside the layout"),
    "IL3014": (_E, "a machine with more than two ends"),
    "IL3015": (_E, "a boundary or buffer is joined wrongly"),
    "IL3016": (_E, "the layout has no signal"),
    "IL3017": (_E, "a track without a section"),
    "IL3018": (_I, "a foul joint"),
    "IL3020": (_E, "a section without detection that is no siding"),
    "IL3022": (_E, "trains in a zone cannot be counted"),
    "IL3023": (_E, "a delay is shorter than the world needs"),
    "IL3024": (_E, "an overlap cannot swing in time"),
    "IL3028": (_E, "positions along the line that contradict each other"),
    "IL3029": (_E, "a length that does not follow from positions"),
    "IL3030": (_E, "coordinates that contradict each other"),
    "IL3027": (_E, "a key of shunt signals at another signal"),
    "IL3026": (_E, "blades of a slip are placed where there is no choice"),
    "IL3025": (_I, "a road that is no berth, for what lies over it"),
    "IL3021": (_I, "an inclined lane without a condition"),
    "IL3019": (_E, "a signal for a direction in which no train runs"),
    # 4: derivation
    "IL4001": (_E, "flank protection is missing"),
    "IL4002": (_E, "a place that stands against its own routes"),
    "IL4003": (_E, "a signal from which no route leads"),
    "IL4004": (_I, "a route of more than three sections"),
    "IL4008": (_E, "a route without room for its overlap"),
    "IL4011": (_E, "an addition that contradicts the route"),
    "IL4012": (_I, "an addition that adds nothing"),
    "IL4010": (_I, "a flank with substitute protection"),
    "IL4009": (_W, "an overlap that was to swing and cannot"),
    "IL4005": (_I, "a path was left out that cannot be run"),
    "IL4006": (_E, "a route that no train can drive"),
    "IL4007": (_E, "the audit disagrees with the derived table"),
    # 5: proof and output
    "IL5001": (_E, "a claim is refuted"),
    "IL5002": (_E, "a claim could not be decided"),
    "IL5003": (_E, "the generated files are not current"),
    "IL5004": (_E, "an output cannot be written"),
    "IL5005": (_E, "an unknown route, column or code"),
    "IL5006": (_E, "nothing is written without a proof"),
    "IL5007": (_E, "a certificate that is not current"),
    "IL5008": (_W, "a plan that shows something otherwise than it lies"),
    "IL5009": (_W, "a program that the target may not hold"),
    "IL5010": (_I, "what a program takes of its target"),
    # 6: dispatch
    "IL6001": (_E, "a file that is no dispatch file of this layout"),
    "IL6002": (_E, "a dispatch file speaks of something that the layout does not have"),
    "IL6003": (_E, "a dispatch file lacks what the command needs"),
    "IL6004": (_E, "a command that makes no sense on this layout"),
    "IL6005": (_E, "a command that no chain of routes carries out"),
    "IL6006": (_E, "a plan that cannot be read, or is for another layout"),
    "IL6007": (_E, "trains that cannot all be carried out"),
    "IL6008": (_E, "a place that no train can leave"),
    "IL6009": (_E, "more trains than standing room"),
    "IL6010": (_E, "a shift that cannot be done"),
    "IL6011": (_E, "an event log that was cut or changed"),
    "IL6012": (_E, "a shift that is not simulated"),
    "IL6013": (_E, "an order for a blocked place"),
    # 7: usual practice, from which a layout may depart: `allow`, with a reason
    "IL7001": (_W, "a signal that looks the wrong way"),
    "IL7002": (_W, "a track between points without a starting signal"),
    "IL7003": (_W, "a route that runs through a whole station"),
    "IL7004": (_W, "a place that no train can reach or leave"),
    "IL7005": (_W, "a length that is hardly meant"),
    "IL7006": (_W, "an approach shorter than the braking distance"),
    "IL7007": (_W, "a signal directly behind points"),
}

LINTS: tuple[str, ...] = tuple(code for code in CODES if code.startswith("IL7"))
"""The warnings of usual practice, which `allow` can take away."""


def severity_of(code: str) -> Severity:
    """The severity of a code; an unregistered code is a programming error (KeyError)."""
    return CODES[code][0]
