"""Lists of the cabinets' inputs and outputs, for those who wire them and those who import tags."""

from interlock.emit.io.lists import channels_csv, equipment_csv, names_csv, tags_xlsx, words_csv

__all__ = ["channels_csv", "equipment_csv", "names_csv", "tags_xlsx", "words_csv"]
