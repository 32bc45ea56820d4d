"""The direction token of a line beyond a boundary (R12): this interlocking has it, or the neighbour, or nobody.

Per boundary: BH the token is here; BG it is given, until the neighbour says that he has it; BY it is not given; BN
since it was last taken the neighbour has told that he does not give it: the change is complete, the next may begin.
After a restart the token is not here: the neighbour gives it, or the special manual change brings it back.  Each word
of the telegram has a wire or bit of its own that may always read 0: that it is not given is told, not missed.
"""

from __future__ import annotations

from interlock.logic import names, rules
from interlock.logic.controller import Input, Join, Output, Term
from interlock.logic.expr import Expr, conj, disj, neg, var
from interlock.logic.lower.draft import Draft
from interlock.logic.symbols import BlockSymbols
from interlock.model.elements import BlockKind, NodeId
from interlock.table.rows import RouteRow


def tokens(d: Draft) -> dict[NodeId, BlockSymbols]:
    """The names of each boundary with a direction token."""
    out = {}
    for b in d.layout.track.boundaries:
        if b.block is BlockKind.TOKEN:
            out[b.node] = _token(b.node)
    return out


def _token(b: NodeId) -> BlockSymbols:
    return BlockSymbols(
        asks=names.NEIGHBOUR_ASKS(b),
        gives=names.NEIGHBOUR_GIVES(b),
        keeps=names.NEIGHBOUR_KEEPS(b),
        has=names.NEIGHBOUR_HAS(b),
        clear=names.LINE_CLEAR(b),
        manual=names.TAKE_BY_HAND(b),
        have=names.TOKEN_HERE(b),
        give=names.TOKEN_GIVEN(b),
        seen=names.CHANGE_SEEN(b),
        timer=names.MANUAL_OVER(b),
        tells={
            "asks": names.TELLS_ASKS(b),
            "gives": names.TELLS_GIVES(b),
            "keeps": names.TELLS_KEEPS(b),
            "has": names.TELLS_HAS(b),
        },
    )


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
    return disj(d.sections.lock(*t.key) for t in d.table.locks if t.exit == b)


def change(d: Draft) -> None:
    """When the token is taken and given."""
    valid = Term(var(names.VALID), "inputs valid")
    for b, x in tokens(d).items():
        absent = [Term(neg(var(x.have)), "not here"), Term(neg(var(x.give)), "not given away")]
        manual = [
            valid,
            Term(var(x.manual), "operator"),
            Term(var(names.RESTART_OVER), "restart delay over"),
            *absent,
            Term(neg(var(x.gives)), "neighbour does not give it"),
            Term(neg(var(x.has)), "neighbour has it not"),
        ]
        d.wire(
            names.MANUAL_RUNS(b),
            Join.ALL,
            manual,
            f"line {b}",
            f"direction at {b}: special manual change ({rules.LINE_BEYOND})",
        )
    for b, x in tokens(d).items():
        d.timer(
            x.timer,
            names.MANUAL_RUNS(b),
            d.layout.principles.token_delay_s,
            f"{b}: special manual change ({rules.LINE_BEYOND})",
        )
    for b, x in tokens(d).items():
        take = [
            valid,
            Term(var(names.RESTART_OVER), "restart delay over"),
            Term(var(x.gives), "given"),
            Term(neg(var(x.have)), "not here"),
            Term(neg(var(x.give)), "not given away"),
        ]
        d.wire(
            names.TOKEN_TAKEN(b), Join.ALL, take, f"line {b}", f"the direction at {b} is taken ({rules.LINE_BEYOND})"
        )
        give = [
            valid,
            Term(var(x.asks), "asked for"),
            Term(var(x.have), "here"),
            Term(var(x.seen), "change complete", f"the neighbour at {b} no longer gives it"),
            Term(var(x.clear), "line clear", f"the line beyond {b} is clear"),
            Term(neg(_locked_out(d, b)), "no departure", f"nothing is locked towards {b}"),
            Term(neg(var(x.manual)), "not by hand", "the operator does not hold the special manual change"),
        ]
        d.wire(
            names.TOKEN_GOES(b),
            Join.ALL,
            give,
            f"line {b}",
            f"the direction at {b} is given to the neighbour ({rules.LINE_BEYOND})",
        )


def _taken_back(x: BlockSymbols) -> Expr:
    """The operator holds the special manual change while the direction is given, and the neighbour has not taken it:
    from then on he is told that it is given no more, and the agreed time begins."""
    by_hand = (var(names.VALID), var(names.RESTART_OVER), var(x.manual))
    return conj((*by_hand, var(x.give), neg(var(x.gives)), neg(var(x.has))))


def terms(d: Draft, r: RouteRow) -> list[Term]:
    """The direction is ours, where the route leaves over a boundary with a token."""
    if r.conditions.token is None:
        return []
    return [
        Term(
            var(tokens(d)[r.conditions.token.boundary].have),
            "direction ours",
            r.conditions.token.because.text,
            r.conditions.token.because.rule,
        )
    ]


def keep(d: Draft) -> None:
    """Next values, and what is told to the neighbour."""
    for b, x in tokens(d).items():
        group = f"line {b}"
        d.kept(
            x.have,
            False,
            f"the direction at {b} is ours",
            Join.ALL,
            (
                Term(disj((var(x.have), var(names.TOKEN_TAKEN(b)), var(x.timer))), "held or taken"),
                Term(neg(var(names.TOKEN_GOES(b))), "not given"),
            ),
            group,
        )
        arrived = conj((var(names.VALID), var(x.has)))
        d.kept(
            x.give,
            False,
            f"the direction at {b} is given",
            Join.ALL,
            (
                Term(disj((var(x.give), var(names.TOKEN_GOES(b)))), "held or given"),
                Term(neg(arrived), "not arrived", "until the neighbour has it"),
                Term(neg(_taken_back(x)), "not taken back", "until the operator takes it back by hand"),
            ),
            group,
        )
        kept = neg(disj((var(x.give), var(names.TOKEN_GOES(b)))))
        d.kept(
            names.TOKEN_KEPT(b),
            False,
            f"the direction at {b} is not given",
            Join.ANY,
            (Term(kept, "kept"), Term(arrived, "arrived")),
            group,
        )
        off = conj((var(names.VALID), var(names.RESTART_OVER), var(x.keeps)))
        d.kept(
            x.seen,
            False,
            f"the neighbour at {b} told that he does not give the direction",
            Join.ALL,
            (Term(disj((var(x.seen), off)), "held or seen"), Term(neg(var(names.TOKEN_TAKEN(b))), "not taken")),
            group,
        )
        asks = conj((_locked_out(d, b), neg(var(x.have))))
        d.outputs.append(Output(names.TELLS_ASKS(b), asks, False, f"to the neighbour at {b}: direction asked for"))
        d.outputs.append(Output(names.TELLS_GIVES(b), var(x.give), False, f"to the neighbour at {b}: direction given"))
        d.outputs.append(
            Output(
                names.TELLS_KEEPS(b), var(names.TOKEN_KEPT(b)), False, f"to the neighbour at {b}: direction not given"
            )
        )
        d.outputs.append(Output(names.TELLS_HAS(b), var(x.have), False, f"to the neighbour at {b}: direction is here"))
