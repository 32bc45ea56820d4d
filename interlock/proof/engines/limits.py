"""How a proof is looked for: engine, processes, time, and what is remembered from one run to the next."""

from __future__ import annotations

from dataclasses import field

from interlock.dataclass import dataclass
from interlock.proof.engines.cache import Cache


@dataclass(frozen=True)
class Limits:
    """How long to try, and with what."""

    query_ms: int = 20_000
    engine: str = "minisat"
    jobs: int = 1
    search_depth: int = 16
    search_s: float = 60.0
    cache: Cache = field(default_factory=Cache)
