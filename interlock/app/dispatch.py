"""Commands to a layout: are there plans, which states lead nowhere, what becomes of the trains on the controller."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace
from pathlib import Path

from interlock.app.check import Checked, derive_file
from interlock.app.dispatching import Coming, Ground, Outcome
from interlock.app.replay import GONE, BadPlan, Plan, PlanTrain, Replay, Replayed, from_text
from interlock.dataclass import dataclass
from interlock.diag import Diagnostic, Sink
from interlock.diag.suggest import did_you_mean
from interlock.dispatch import Dispatcher
from interlock.dispatch.commands import BadOrder, errand
from interlock.dispatch.language import beside, load
from interlock.dispatch.orders import Derivation, Derived, read_alike
from interlock.dispatch.plan.errands import OUTSIDE, Errand, NoVoyage, TooManyPlaces
from interlock.dispatch.plan.explore import Explored, TooManyStates, explore
from interlock.dispatch.plan.problem import Built, Draft, Move, build, in_the_way
from interlock.dispatch.plan.railway import Journey, Railway
from interlock.dispatch.plan.search import Answer, Planner, Verdict
from interlock.dispatch.policy import Policy
from interlock.logic.lower import lower
from interlock.model.elements import Position
from interlock.model.layout import Layout
from interlock.proof.system.loop import closed_loop


@dataclass(frozen=True)
class Deadlock:
    """A way into a deadlock, and what became of it on the controller."""

    story: tuple[str, ...]
    shown: str


@dataclass(frozen=True)
class Timings:
    """Runs of the commands with trains that come at other times, with the rule of the dispatcher or without it."""

    outcomes: Sequence[Outcome] = ()
    rule: bool = True

    @property
    def stuck(self) -> int:
        """Runs in which a train stands for ever."""
        return sum(bool(o.stuck) for o in self.outcomes)


@dataclass(frozen=True)
class InTheWay:
    """With what it was planned.  faults: machines that are not detected, and sections reported occupied; blocked:
    sections that the dispatch file closes, with which plans are replayed and run, too."""

    faults: tuple[str, ...] = ()
    blocked: tuple[str, ...] = ()


@dataclass(frozen=True)
class Given:
    """The orders of a dispatch file, and which of them each train has."""

    derived: tuple[Derived, ...] = ()
    by_train: Mapping[str, Derived] = field(default_factory=dict)

    @property
    def left(self) -> tuple[str, ...]:
        """The orders that no train has: there are more of them than trains."""
        return tuple(d.name for d in self.derived if d not in self.by_train.values())


@dataclass
class Dispatched:
    """What was found, or the problems of layout and commands."""

    checked: Checked
    diagnostics: tuple[Diagnostic, ...] = ()
    errands: tuple[Errand, ...] = ()
    answer: Answer | None = None
    plan: Plan | None = None
    replayed: Replayed | None = None
    caught: tuple[str, ...] = ()
    others: Verdict = Verdict.PLAN
    """Whether all that are not caught can go on while those that are stay where they are."""
    explored: Explored | None = None
    deadlock: Deadlock | None = None
    """The shortest one without the rule, where all states were explored and there is one."""
    timings: Timings = field(default_factory=Timings)
    given: Given = field(default_factory=Given)
    in_the_way: InTheWay = field(default_factory=InTheWay)
    texts: dict[str, str] = field(default_factory=dict)

    @property
    def ok(self) -> bool:
        """All commands made sense."""
        return not self.diagnostics


class Setting:
    """A layout's railway with the errands of some commands."""

    def __init__(self, railway: Railway, errands: Sequence[Errand], obstacles: frozenset[object] = frozenset()) -> None:
        self.railway, self.errands = railway, tuple(errands)
        self.journeys: list[Journey] = [railway.draft(e) for e in errands]
        self.obstacles = obstacles
        self.built: Built = self._built(())

    def _built(self, caught: Collection[str]) -> Built:
        """The problem of all trains; those that are caught stay where they are."""
        drafts: list[Draft] = []
        for k, (e, j) in enumerate(zip(self.errands, self.journeys, strict=True)):
            if e.train in caught:
                drafts.append(self.railway.still(e.train, j.start, e.start[-1][1] == OUTSIDE))
            else:
                drafts.append(j.nodes([x.train for x in self.errands[:k] if x.start == e.start]))
        if self.obstacles:
            drafts.append(in_the_way(self.obstacles))
        return build(drafts, self.railway.held.zones)

    @staticmethod
    def named(things: Collection[object]) -> tuple[str, ...]:
        """The machines and sections of what is in the way."""
        return tuple(sorted({str(x[1]) for x in things if isinstance(x, tuple)}))

    def caught(self, answer: Answer) -> tuple[tuple[str, ...], Verdict]:
        """All trains that no plan takes on, one reason after the other, and whether the others can all go on."""
        found: list[str] = []
        built = self.built
        while answer.verdict is Verdict.NONE:
            pairs = zip(self.errands, built.problem.nodes, strict=False)
            new = [e.train for e, bits in pairs if any(b & answer.caught for b in bits) and e.train not in found]
            if not new:
                break
            found += new
            built = self._built(found)
            answer = Planner(built.problem).solve(built.start)
        return tuple(e.train for e in self.errands if e.train in found), answer.verdict

    def routes(self, moves: Sequence[Move]) -> tuple[tuple[str, str], ...]:
        """Moves as train and route."""
        found: list[tuple[str, str]] = []
        for m in moves:
            steps = self.journeys[m.train].steps
            place = next(p for p, b in self.built.bits[m.train].items() if b == m.source)
            found += [(self.errands[m.train].train, r.id) for r in steps[place][int(m.label)].routes]  # type: ignore[index]
        return tuple(found)

    def plan(self, digest: str, moves: Sequence[Move]) -> Plan:
        """Moves as a plan that can be replayed."""
        routes = self.routes(moves)
        trains = []
        for e in self.errands:
            own = [r for t, r in routes if t == e.train]
            last = self.railway.table.route[own[-1]] if own else None  # type: ignore[index]
            here = str(e.start[-1][0])
            stays = (self.railway.approach.get(here) or f"outside.{here}") if e.start[-1][1] == OUTSIDE else here
            ends = (
                stays if last is None else GONE if last.path.exit_kind == "boundary" else str(last.path.section_ids[-1])
            )
            outside = e.start[0][1] == OUTSIDE
            start = here if outside else tuple((str(s), n) for s, n in e.start)
            trains.append(PlanTrain(e.train, e.length_m, start, ends))
        return Plan(digest, tuple(trains), routes)

    def story(self, moves: Sequence[Move]) -> tuple[str, ...]:
        """Moves to a deadlock in words, and what keeps each train there."""
        p, state = self.built.problem, self.built.start
        said = []
        for m in moves:
            state = state & ~m.source | m.target
            *most, last = [route for _, route in self.routes((m,))]
            over = f"{', '.join(most)} and {last}" if most else last
            comes = "leaves" if m.target & p.gone else f"stands in {p.label[m.target]}"
            said.append(f"{p.trains[m.train]} runs over {over} and {comes}.")
        names = [*p.trains[: len(self.errands)], " and ".join(self.named(self.obstacles))]
        for k, here in enumerate(p.at(state)):
            if here & p.home:
                continue
            for m in p.moves[here]:
                block = m.blocked
                for there, behind in m.followed:
                    block |= there | behind if state & there and state & behind else 0
                who = [names[u] for u, bits in enumerate(p.nodes) if u != k and sum(bits) & state & block]
                route = self.routes((m,))[0][1]
                what = f"is blocked by {' and '.join(who)}" if who else "leads into a full zone"
                said.append(f"{p.trains[k]} in {p.label[here]} cannot go on: {route} {what}.")
        return tuple(said)

    def shown(self, replay: Replay, digest: str, moves: Sequence[Move]) -> str:
        """What the controller says to every route that a train of a deadlock could still take."""
        p, state = self.built.problem, self.built.start
        for m in moves:
            state = state & ~m.source | m.target
        there = self.plan(digest, moves)
        onward = self.routes([m for b in p.at(state) for m in p.moves[b]])
        tried = [replace(there, moves=(*there.moves, x)) for x in onward]
        done = replay.check([there, *tried])
        if done[0].wrong:
            return f"the controller does not come there: {done[0].wrong}"
        granted = [f"{r} for {t}" for (t, r), x in zip(onward, done[1:], strict=True) if not x.wrong]
        if granted:
            return f"yet the controller grants {', '.join(granted)}"
        return f"On the controller with its plant, too: it is brought there, and refuses {_all(len(onward))}."


def _all(n: int) -> str:
    return "the only route that is left" if n == 1 else f"all {n} routes that are left"


def dispatch(
    path: str,
    commands: Sequence[str],
    *,
    length_m: float = 60.0,
    timings: int = 0,
    gap: int = 5,
    rule: bool = True,
    exploring: bool = False,
    look_ahead: int = 1,
    file: str | None = None,
    policy: str | None = None,
    failed: Sequence[str] = (),
    occupied: Sequence[str] = (),
) -> Dispatched:
    """Carry out commands, or the orders of a dispatch file (by default that beside the layout), one for each train of
    the fleet; `timings`: run them so many times, each train `gap` scans later from run to run.  failed: machines that
    are not detected (`P1`), or do not leave a position (`P1:N`); occupied: sections that are reported so."""
    checked = derive_file(path)
    if not checked.ok or checked.layout is None or checked.table is None:
        return Dispatched(checked, checked.diagnostics)
    layout, table, sink = checked.layout, checked.table, Sink()
    railway = Railway(table, layout)
    given, texts = Given(), dict[str, str]()
    obstacles = _obstacles(layout, failed, occupied, sink)
    if commands:
        setting = _setting(railway, commands, length_m, obstacles, sink)
    else:
        setting, given = _shift(railway, file or beside(path), obstacles, sink, texts)
    if setting is None:
        return Dispatched(checked, sink.diagnostics, texts=texts)
    blocked = setting.named([x for x in setting.obstacles if isinstance(x, tuple) and x[0] == "blocked"])
    found = Dispatched(checked, (), setting.errands, given=given, texts=texts)
    found.in_the_way = InTheWay((*failed, *occupied), blocked)
    controller = lower(layout, table)
    replay = Replay(layout, controller, closed_loop(layout, controller).plant, blocked=blocked)
    found.answer = Planner(setting.built.problem).solve(setting.built.start)
    if found.answer.verdict is Verdict.PLAN:
        found.plan = setting.plan(layout.digest, found.answer.plan)
        (found.replayed,) = replay.check([found.plan])
    found.caught, found.others = setting.caught(found.answer)
    if exploring:
        _explored(found, setting, replay, layout.digest, sink)
    if timings and found.ok:
        ground = Ground(layout, table, controller, blocked)
        runs = [_run(setting.errands, k - timings // 2, gap, commands) for k in range(timings)]
        how = None if policy is None else Policy(policy)

        def make() -> Dispatcher:
            return Dispatcher(ground.railway, controller.symbols, rule=rule, look_ahead=look_ahead, policy=how)

        found.timings = Timings(ground.run(runs, make), rule)
    return found


def _explored(found: Dispatched, setting: Setting, replay: Replay, digest: str, sink: Sink) -> None:
    """All states, and the shortest deadlock without the rule."""
    try:
        found.explored = explore(setting.built.problem, setting.built.start)
    except TooManyStates as error:
        sink.add("IL6007", f"{error}: UNKNOWN which of them lead nowhere", None, "command fewer trains")
        found.diagnostics = sink.diagnostics
        return
    way = found.explored.shortest
    if way is not None:
        found.deadlock = Deadlock(setting.story(way), setting.shown(replay, digest, way))


def _run(errands: Sequence[Errand], k: int, gap: int, voyages: Sequence[str]) -> list[Coming]:
    """The k-th timing: each train so many scans after the one before it, or before it where k is negative."""
    named = [*voyages, *[""] * len(errands)]
    due = [abs(k) * gap * (i if k >= 0 else len(errands) - 1 - i) for i in range(len(errands))]
    return [Coming(e, 0, at, voyage=v) for e, at, v in zip(errands, due, named, strict=False)]


def _obstacles(layout: Layout, failed: Sequence[str], occupied: Sequence[str], sink: Sink) -> frozenset[object]:
    """What stands in the way of plans, as a panel would show it."""
    things: set[object] = set()
    machines = {str(m.machine) for m in layout.pointwork.points}
    for word in failed:
        machine, _, at = word.partition(":")
        if machine not in machines or at not in ("", "N", "R"):
            fix = did_you_mean(machine, machines) if machine not in machines else "write P1, P1:N or P1:R"
            sink.add("IL6004", f"{word}: there is no machine or position of this name", None, fix)
        things |= {("lies", machine, x.other) for x in Position if x != at}
    sections = {str(s.id) for s in layout.track.sections if not s.approach}
    for word in occupied:
        if word not in sections:
            sink.add("IL6004", f"there is no section {word}", None, did_you_mean(word, sections))
        things.add(("section", word))
    return frozenset(things)


def _setting(
    railway: Railway, commands: Sequence[str], length_m: float, obstacles: frozenset[object], sink: Sink
) -> Setting | None:
    errands: list[Errand] = []
    for c in commands:
        try:
            one = errand(railway, c, length_m)[0]
            same = next((e.train for e in errands if read_alike(e.train) == read_alike(one.train)), None)
            if same is not None:
                code, text = ("IL6015", f"{one.train} reads like {same}")
                if one.train == same:
                    code, text = "IL6004", f"{one.train} is commanded twice"
                raise BadOrder(code, text, (), "", _apart(railway, c, one))
            there = next((e for e in errands if _one_place(e, one)), None)
            if there is not None:
                text = f"{one.train} begins in {one.start[-1][0]}, where {there.train} stands"
                raise BadOrder("IL6004", text, fix="begin in another section, or outside")
            railway.draft(one)
            errands.append(one)
        except BadOrder as error:
            sink.add(error.code, f"{c}: {error.text}", None, error.advice)
        except NoVoyage as error:
            sink.add("IL6005", f"{c}: {error}", None, error.fix)
        except TooManyPlaces as error:
            sink.add("IL6005", f"{c}: {error}", None, "name a place on the way")
    return None if sink.has_errors else Setting(railway, errands, obstacles)


def _apart(railway: Railway, command: str, one: Errand) -> str:
    """What to command instead of something that is there already."""
    if all(v.name != command for v in railway.table.voyages):
        return "give each train a number of its own, or one command with both ways: 12:W>q4>E"
    leg, start = one.legs[0], str(one.start[-1][0])
    if one.start[-1][1] != OUTSIDE:
        first = next(v for v in railway.table.voyages if v.name == command).routes[0]
        start += f"/{railway.table.route[first].entry}"
    return (
        "name the voyage once; command another train with a number of its own: "
        f"'12:{start}>{'+'.join((leg.to, *sorted(leg.via)))}'"
    )


def _one_place(a: Errand, b: Errand) -> bool:
    """Two trains would begin in one section of the layout."""
    return not {s for s, n in a.start if n != OUTSIDE}.isdisjoint(s for s, n in b.start if n != OUTSIDE)


def _shift(
    railway: Railway, file: str, obstacles: frozenset[object], sink: Sink, texts: dict[str, str]
) -> tuple[Setting | None, Given]:
    """The fleet of a dispatch file, each train with one order, in turn."""
    orders = load(file, railway.layout, sink, texts, "--orders")
    if orders is None:
        return None, Given()
    derived = Derivation(railway, orders, sink).run()
    if not sink.has_errors and not derived:
        sink.add("IL6003", f"{file} has no orders", orders.root.span, "add `fleet`, `places` and `orders`")
    by_train = _in_turn(list(orders.file.fleet), derived)
    for number in (n for n in orders.file.fleet if derived and n not in by_train):
        fix = "name it in `only` of an order, or leave it out of the fleet"
        sink.add("IL6003", f"no order is for train {number}", orders.at("fleet", number, key=True), fix)
    if sink.has_errors:
        return None, Given(derived)
    errands = [d.journeys[n].errand for n, d in by_train.items()]
    closed = [s.id for s in railway.layout.track.sections if s.id in orders.file.closed]
    lies = railway.held.at_first(key for e in errands for key in e.start)
    obstacles |= {("blocked", s) for s in closed} | railway.held.stay(closed, lies)
    return Setting(railway, errands, obstacles), Given(derived, by_train)


def _in_turn(fleet: Sequence[str], derived: Sequence[Derived]) -> dict[str, Derived]:
    """An order for each train, of those that it may carry out: in turn, and first those that no other train has."""
    found: dict[str, Derived] = {}
    for k, number in enumerate(fleet):
        turn = k % max(1, len(derived))
        may = [d for d in (*derived[turn:], *derived[:turn]) if number in d.journeys]
        if may:
            has = {d.name for d in found.values()}
            found[number] = next((d for d in may if d.name not in has), may[0])
    return found


def replay_file(path: str, plan: str) -> tuple[Checked, tuple[Diagnostic, ...], Replayed | None]:
    """A plan file replayed on a layout."""
    checked, sink = derive_file(path), Sink()
    if not checked.ok or checked.layout is None or checked.table is None:
        return checked, checked.diagnostics, None
    try:
        text = Path(plan).read_text("utf-8")
        controller = lower(checked.layout, checked.table)
        replay = Replay(checked.layout, controller, closed_loop(checked.layout, controller).plant)
        return checked, (), replay.check([from_text(text)])[0]
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or "it is not UTF-8 text"
        sink.add("IL6006", f"{plan}: {why}", None, "name a file that --plan has written")
    except BadPlan as error:
        sink.add("IL6006", f"{plan}: {error}", None, "make it again with --plan")
    return checked, sink.diagnostics, None
