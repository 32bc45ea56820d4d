"""Lists of the cabinets' inputs and outputs, for those who wire them and those who import tags."""

from interlock.emit.io.lists import (
    CROSS_REFERENCE,
    channels_csv,
    cross_reference_csv,
    equipment_csv,
    names_csv,
    tags_xlsx,
    words_csv,
)

__all__ = [
    "CROSS_REFERENCE",
    "channels_csv",
    "cross_reference_csv",
    "equipment_csv",
    "names_csv",
    "tags_xlsx",
    "words_csv",
]
