"""Proof by small obligations: one goal, and the few clauses that show it.

`facts` says what may be used, `clauses` how it is numbered, `refute` how a goal is shown, `engine` what is written of
it, `bundle` all that is written for `interlock verify`.
"""

from interlock.proof.certificate.engine import LocalProof, prove_locally

__all__ = ["LocalProof", "prove_locally"]
