"""The rules of docs/rules/ by name, for what is said of a variable where no cell of the table tells its rule.

A cell has its own, in its `Because`: where one stands behind a term or a variable, the rule is taken from there.  Each
name is the title of the rule's page.
"""

KINDS_OF_ROUTES = "R2"
PROCEED = "R3"
OVERLAPS = "R4"
FLANK_PROTECTION = "R5"
HOSTILE_ROUTES = "R6"
APPROACH_LOCKING = "R8"
SECTIONAL_RELEASE = "R9"
POINTS = "R10"
SIGNALS = "R11"
LINE_BEYOND = "R12"
LEVEL_CROSSINGS = "R13"
ONE_TRAIN_ONE_ROUTE = "R14"
LOSS_OF_SHUNT = "R15"
RESTART = "R16"
EXTERNAL_CONDITIONS = "R17"
