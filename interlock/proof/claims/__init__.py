"""What is claimed, one class of hazard a file, and the invariants that make the claims inductive.

Nothing here may import the table, the derivation or the lowering: a claim speaks of the layout, of the plant and
of the controller's symbols.

**Theorem.**  What an invariant says is believed only as far as base and step show it: one that is wrong costs a proof
and never makes one, and what follows from invariants that are kept holds in every reachable state.  So only the claims
have to be read as what they say; the invariants are a way to prove them.  (Manna and Pnueli, *Temporal Verification of
Reactive Systems*, 1995: strengthening.)
"""

from interlock.proof.claims.catalogue import CLAIMS, claims
from interlock.proof.claims.kinds import Claim, Facts, Invariant
from interlock.proof.claims.strengthening import strengthening

__all__ = ["CLAIMS", "Claim", "Facts", "Invariant", "claims", "strengthening"]
