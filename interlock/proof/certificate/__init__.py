"""Proof by small obligations: one goal, the few facts that it needs, proved once for each shape.

`facts` says what may be used, `shapes` how equal obligations are told,
`engine` how a goal is decided, `refute` how a shape gets its refutation, `bundle` what is written for
`interlock verify`.
"""

from interlock.proof.certificate.engine import LocalProof, prove_locally

__all__ = ["LocalProof", "prove_locally"]
