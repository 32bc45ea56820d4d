"""Every small change of a controller, and what becomes of each: a proof that no change can break proves nothing.

`points`: the changes, one at a time, everywhere.  `judge`: which of them a claim refuses, which a train notices, and
which change nothing, each by its own evidence.  The named weakenings of `weakenings` tell what a defect means; these
are there so that no place is forgotten.
"""
