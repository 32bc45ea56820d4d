"""The record: what happened, event by event, so that nobody can change it unnoticed and no crash loses it.

`log` writes and reads it, `tables` makes Parquet of it and answers SQL (extra `record`).  It knows nothing of railways:
an event is a time, a kind, and what its writer says of it.
"""

from interlock.record.log import Chain, Log, LogExists, Problem, Recorded, read, read_file

__all__ = ["Chain", "Log", "LogExists", "Problem", "Recorded", "read", "read_file"]
