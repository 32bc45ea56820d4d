"""What is claimed, one class of hazard a file, and the invariants that make the claims inductive.

Nothing here may import the table, the derivation or the lowering: a claim speaks of the layout, of the plant and
of the controller's symbols.
"""

from interlock.proof.claims.catalogue import CLAIMS, claims
from interlock.proof.claims.kinds import Claim, Facts, Invariant
from interlock.proof.claims.strengthening import strengthening

__all__ = ["CLAIMS", "Claim", "Facts", "Invariant", "claims", "strengthening"]
