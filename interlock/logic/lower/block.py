"""The direction token of a line beyond a boundary (R12): this interlocking has it, or the neighbour, or nobody.

Per boundary: BH the token is here; BG it is given, until the neighbour says that he has it; BY it is not given; BN
since it was last taken the neighbour has told that he does not give it: the change is complete, the next may begin.
After a restart the token is not here: the neighbour gives it, or the special manual change brings it back.  Each word
of the telegram has a wire or bit of its own that may always read 0: that it is not given is told, not missed.
"""

from __future__ import annotations

from interlock.logic.controller import BlockSymbols, Input, Join, Output, Term
from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.model.elements import BlockKind, NodeId
from interlock.model.portable import portable
from interlock.table.rows import RouteRow


def tokens(d: Draft) -> dict[NodeId, BlockSymbols]:
    """The names of each boundary with a direction token."""
    out = {}
    for b in d.layout.boundaries:
        if b.block is BlockKind.TOKEN:
            prefixes = ("NR", "NG", "NN", "NH", "LC", "TKN", "BH", "BG", "BN", "BT")
            words = {"asks": "YTA", "gives": "YTG", "keeps": "YTN", "has": "YTH"}
            tells = {word: f"{p}_{portable(b.node)}" for word, p in words.items()}
            out[b.node] = BlockSymbols(*(f"{p}_{portable(b.node)}" for p in prefixes), tells=tells)
    return out


def inputs(d: Draft) -> None:
    """The neighbour's telegram, the line's detection, the operator's special manual change."""
    for b, x in tokens(d).items():
        d.inputs.append(Input(x.asks, f"neighbour at {b} asks for the direction"))
        d.inputs.append(Input(x.gives, f"neighbour at {b} gives the direction"))
        d.inputs.append(Input(x.keeps, f"neighbour at {b} does not give the direction"))
        d.inputs.append(Input(x.has, f"neighbour at {b} has the direction"))
        d.inputs.append(Input(x.clear, f"the whole line beyond {b} reported clear"))
        d.inputs.append(Input(x.manual, f"operator: take the direction at {b} (agreed by telephone; hold)"))


def _locked_out(d: Draft, b: NodeId) -> Expr:
    """Something is locked towards the boundary."""
    return disj(d.lock(*t.key) for t in d.table.locks if t.exit == b)


def change(d: Draft) -> None:
    """When the token is taken and given."""
    valid = Term(var("VALID"), "inputs valid")
    for b, x in tokens(d).items():
        absent = [Term(neg(var(x.have)), "not here"), Term(neg(var(x.give)), "not given away")]
        manual = [
            valid,
            Term(var(x.manual), "operator"),
            Term(var("RST"), "restart delay over"),
            *absent,
            Term(neg(var(x.gives)), "neighbour does not give it"),
            Term(neg(var(x.has)), "neighbour has it not"),
        ]
        d.wire(f"BTI_{portable(b)}", Join.ALL, manual, f"line {b}", f"direction at {b}: special manual change (R12)")
    for b, x in tokens(d).items():
        d.timer(x.timer, f"BTI_{portable(b)}", d.layout.principles.token_delay_s, f"{b}: special manual change (R12)")
    for b, x in tokens(d).items():
        take = [
            valid,
            Term(var("RST"), "restart delay over"),
            Term(var(x.gives), "given"),
            Term(neg(var(x.have)), "not here"),
            Term(neg(var(x.give)), "not given away"),
        ]
        d.wire(f"BK_{portable(b)}", Join.ALL, take, f"line {b}", f"the direction at {b} is taken (R12)")
        give = [
            valid,
            Term(var(x.asks), "asked for"),
            Term(var(x.have), "here"),
            Term(var(x.seen), "change complete", f"the neighbour at {b} no longer gives it"),
            Term(var(x.clear), "line clear", f"the line beyond {b} is clear"),
            Term(neg(_locked_out(d, b)), "no departure", f"nothing is locked towards {b}"),
        ]
        d.wire(
            f"BV_{portable(b)}", Join.ALL, give, f"line {b}", f"the direction at {b} is given to the neighbour (R12)"
        )


def terms(d: Draft, r: RouteRow) -> list[Term]:
    """The direction is ours, where the route leaves over a boundary with a token."""
    if r.token is None:
        return []
    return [Term(var(tokens(d)[r.token.boundary].have), "direction ours", r.token.because.text)]


def keep(d: Draft) -> None:
    """Next values, and what is told to the neighbour."""
    for b, x in tokens(d).items():
        n, group = portable(b), f"line {b}"
        d.kept(
            x.have,
            False,
            f"the direction at {b} is ours",
            Join.ALL,
            (
                Term(disj((var(x.have), var(f"BK_{n}"), var(x.timer))), "held or taken"),
                Term(neg(var(f"BV_{n}")), "not given"),
            ),
            group,
        )
        arrived = conj((var("VALID"), var(x.has)))
        d.kept(
            x.give,
            False,
            f"the direction at {b} is given",
            Join.ALL,
            (
                Term(disj((var(x.give), var(f"BV_{n}"))), "held or given"),
                Term(neg(arrived), "not arrived", "until the neighbour has it"),
            ),
            group,
        )
        kept = neg(disj((var(x.give), var(f"BV_{n}"))))
        d.kept(
            f"BY_{n}",
            False,
            f"the direction at {b} is not given",
            Join.ANY,
            (Term(kept, "kept"), Term(arrived, "arrived")),
            group,
        )
        off = conj((var("VALID"), var("RST"), var(x.keeps)))
        d.kept(
            x.seen,
            False,
            f"the neighbour at {b} told that he does not give the direction",
            Join.ALL,
            (Term(disj((var(x.seen), off)), "held or seen"), Term(neg(var(f"BK_{n}")), "not taken")),
            group,
        )
        asks = conj((_locked_out(d, b), neg(var(x.have))))
        d.outputs.append(Output(f"YTA_{n}", asks, False, f"to the neighbour at {b}: direction asked for"))
        d.outputs.append(Output(f"YTG_{n}", var(x.give), False, f"to the neighbour at {b}: direction given"))
        d.outputs.append(Output(f"YTN_{n}", var(f"BY_{n}"), False, f"to the neighbour at {b}: direction not given"))
        d.outputs.append(Output(f"YTH_{n}", var(x.have), False, f"to the neighbour at {b}: direction is here"))
