"""A second, brute-force opinion on a table.  Shares no code with the derivation, nor its notion of traversals."""

from interlock.audit.recheck import Finding, audit

__all__ = ["Finding", "audit"]
