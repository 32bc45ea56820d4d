"""Logs as tables: Parquet for whoever keeps them, SQL through DuckDB for whoever asks (extra `record`).

A table has a row for each event: `log` (the name of the log), `n`, `t`, `kind`, and a column for each field that any
event has; a field `log` is in the column `log_`.  Fields that are lists or objects are their JSON text, and so are
numbers of a field that has whole ones of more than 64 bits.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from interlock.diag.extras import install
from interlock.exceptions import Whole
from interlock.record.log import Event

if TYPE_CHECKING:
    import pyarrow as pa

LARGEST = 1 << 63
"""Whole numbers from here on have no column of their own."""

FIXED = ("log", "n", "t", "kind")


class NoTables(Whole):
    """The extra `record` is not installed; says how to get it."""

    def __init__(self) -> None:
        super().__init__(f"Parquet and SQL need the extra `record`: {install('record')}")


class BadQuery(Exception):
    """DuckDB does not understand a query; its message."""


def table(logs: Mapping[str, Sequence[Event]]) -> pa.Table:
    """One table of all events of some logs, by the name of each log.  Raises `NoTables`."""
    try:
        import pyarrow as pa
    except ImportError:
        raise NoTables from None
    taken = {k for events in logs.values() for e in events for k in e}
    own = next(n for k in count(1) if (n := "log" + "_" * k) not in taken)
    rows = [
        {"log": name, **{own if k == "log" else k: _plain(v) for k, v in e.items()}}
        for name, events in logs.items()
        for e in events
    ]
    names = [*FIXED, *sorted({k for r in rows for k in r} - set(FIXED))]
    columns = {n: _column([r.get(n) for r in rows]) for n in names}
    return pa.table({n: pa.array(c, type=_type(pa, n, c)) for n, c in columns.items()})


def write_parquet(path: Path, logs: Mapping[str, Sequence[Event]]) -> int:
    """Write the table as Parquet; the number of its rows.  Raises `NoTables`, `OSError`."""
    made = table(logs)
    import pyarrow.parquet as pq

    pq.write_table(made, path, compression="zstd")
    return int(made.num_rows)


def query(sql: str, logs: Mapping[str, Sequence[Event]]) -> tuple[list[str], list[tuple[Any, ...]]]:
    """What a query of the table `events` gives: names of columns, and rows.  Raises `NoTables`, `BadQuery`.

    The query sees this table and nothing else: no file, no network.
    """
    try:
        import duckdb
    except ImportError:
        raise NoTables from None
    made = table(logs)
    with duckdb.connect(":memory:") as base:
        base.register("events", made)
        base.execute("SET enable_external_access = false")
        try:
            found = base.execute(sql)
            if found is None:
                raise BadQuery("there is no query: write one, as SELECT kind, count(*) FROM events GROUP BY kind")
            names = [str(d[0]) for d in found.description or ()]
            return names, found.fetchall()
        except duckdb.Error as error:
            raise BadQuery(str(error)) from None


def _plain(value: Any) -> Any:
    return json.dumps(value, ensure_ascii=False, sort_keys=True) if isinstance(value, list | dict) else value


def _column(values: list[Any]) -> list[Any]:
    """Values of one kind: numbers stay numbers where all are, else everything is text."""
    kinds = {type(v) for v in values if v is not None}
    if any(isinstance(v, int) and not -LARGEST <= v < LARGEST for v in values):
        kinds = {object}
    if kinds <= {int} or kinds <= {bool} or kinds <= {str}:
        return values
    if kinds <= {int, float}:
        return [None if v is None else float(v) for v in values]
    return [None if v is None else v if isinstance(v, str) else json.dumps(v) for v in values]


def _type(pa: Any, name: str, values: list[Any]) -> Any:
    if name in ("n", "t"):
        return pa.int64()
    first = next((v for v in values if v is not None), "")
    return {int: pa.int64(), float: pa.float64(), bool: pa.bool_()}.get(type(first), pa.string())
