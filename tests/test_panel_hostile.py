"""Whatever a browser sends, the controller works on and everybody else is told what there is."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

import pytest
from starlette.websockets import WebSocketDisconnect

from interlock.app.run import Ready
from interlock.panel.asking import ASKED, SWITCHED
from interlock.panel.browsers import sent
from interlock.panel.desk import DEFECT, Desk
from interlock.panel.entry import ALARMS, FLAGS, LARGEST, LONGEST, NOT_KNOWN, NUMBERS, TEXTS, NotKnown, cleaned, line
from interlock.panel.operating import Person
from interlock.panel.recorder import Recorder
from interlock.panel.server import WAITING, Access
from interlock.record.log import Chain, read
from tests.panels import QUICK, Browser, panel, unproved

HALF = "\\ud83d"
"""Half a surrogate, as JSON has it."""

HUGE = "1" + 400 * "0"


@pytest.fixture(scope="module")
def ready() -> Ready:
    return unproved(Path("layouts/heishan.yaml").read_text("utf-8") + QUICK)


@pytest.fixture(scope="module")
def recorded(ready: Ready, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Desk, Any]]:
    """A panel with its record, which one may work and one may look at."""
    recorder = Recorder(tmp_path_factory.mktemp("record") / "x.log", ready)
    with panel(ready, Access("work", "see"), recorder=recorder) as found:
        yield found


def works_on(desk: Desk, browser: Any) -> None:
    """Cycles go on, and somebody who comes sees everything, without half a surrogate."""
    assert desk.broken == "" and desk._thread.is_alive()
    with browser(name="fresh", token="see") as b:
        assert b.rest["still"]["plan"] and b.state
        before, end = desk._last, time.monotonic() + 10
        while desk._last is before or desk._last.inputs == {}:
            assert time.monotonic() < end and desk.broken == ""
            time.sleep(0.01)
        b.hear()
        b.ws.send_text('{"do":"why","route":"none","re":1}')
        b.until(lambda: b.answers)
        assert b.answers[0]["why"] == [["there is no route none", []]]
        json.dumps([b.rest, b.state, b.events], ensure_ascii=False).encode()


@pytest.mark.parametrize("token", ["work", "see"])
@pytest.mark.parametrize(
    "text",
    [
        '{"do":"{"}',
        '{"do":"{do.x}"}',
        '{"do":"{0}","route":"{route}"}',
        f'{{"do":"{HALF}"}}',
        '{"do":"set","route":"a","heard":' + HUGE + ',"after":0}',
        '{"do":"set","route":"a","heard":NaN,"after":-Infinity}',
        '{"do":"set","route":' + 300 * "[" + 300 * "]" + "}",
        '{"do":["a"]}',
        '{"do":{"a":1}}',
        '{"do":true}',
        '{"do":"speed","times":true}',
        '{"do":"speed","times":[1]}',
        '{"do":"power","on":[]}',
        '{"do":"acknowledge","alarms":5}',
        '{"do":"acknowledge","alarms":[["a"]]}',
        '{"do":"put","section":"s2","towards":"","metres":' + HUGE + "}",
        '{"do":"put","section":"s2","towards":"","metres":true}',
        '{"do":"turn","machine":"none","to":"N"}',
        '{"do":"looked"}',
        f'{{"do":"set","route":"{HALF}"}}',
        f'{{"do":"train","name":"{HALF}","section":"s2"}}',
        f'{{"do":"voyage","name":"{HALF}:W>E"}}',
        "{}",
    ],
)
def test_a_message_is_refused_and_the_controller_works_on(recorded: tuple[Desk, Any], token: str, text: str) -> None:
    desk, browser = recorded
    with browser(name="tester", token=token) as b:
        b.ws.send_text(text[:-1] + (',"re":1}' if len(text) > 2 else '"re":1}'))
        b.until(lambda: b.answers or desk.broken)
        assert b.answers and not b.answers[0]["ok"] and b.answers[0]["why"][0][0]
        assert DEFECT not in b.answers[0]["why"][0][0]
    works_on(desk, browser)


@pytest.mark.parametrize("token", ["work", "see"])
@pytest.mark.parametrize("name", ["\ud800", ["a"], {"a": 1}, 3, None, "a\nb\u202e", 3000 * "x"])
def test_a_name_is_cleaned_where_it_comes_in(recorded: tuple[Desk, Any], token: str, name: Any) -> None:
    desk, browser = recorded
    with browser(name=name, token=token) as b:
        b.events.clear()
        b.ws.send_text('{"do":"set","route":"nowhere","re":1}')
        b.until(lambda: [e for e in b.events if e["kind"] == "refusal"])
        who = [e["who"] for e in b.events if e["kind"] == "refusal"][-1]
        assert who == (line(name) if isinstance(name, str) else "operator") and len(who) <= 80 and who.isprintable()
    works_on(desk, browser)


@pytest.mark.parametrize("re", ["NaN", f'"{HALF}"', 300 * "[" + 300 * "]", HUGE, "{}", "null"])
def test_the_mark_of_a_command_may_be_anything(recorded: tuple[Desk, Any], re: str) -> None:
    desk, browser = recorded
    with browser(name="tester", token="work") as b:
        b.ws.send_text('{"do":"set","route":"nowhere","re":' + re + "}")
        b.until(lambda: b.answers)
        json.dumps(b.answers, ensure_ascii=False).encode()
    works_on(desk, browser)


def test_what_is_no_message_ends_the_talk_alone(recorded: tuple[Desk, Any]) -> None:
    desk, browser = recorded
    for data in (b"{}", b"\xff", b""):
        with browser(name="tester", token="work") as b:
            b.ws.send_bytes(data)
            with pytest.raises(WebSocketDisconnect):
                for _ in range(1000):
                    b.hear()
    with browser(name="tester", token="\ud800") as b:
        assert b.refused == "this token is none of this panel's"
    assert not Access().admits("[", None) and not Access("work").admits("127.0.0.1", "http://[")
    works_on(desk, browser)


def test_a_reminder_with_half_a_surrogate_locks_nobody_out(ready: Ready) -> None:
    with panel(ready, Access("work", "see")) as (desk, browser):
        with browser(name="tester", token="work") as b:
            b.ws.send_text(f'{{"do":"remind","at":"s:s2","text":"a\\u0000{HALF}\\u202eb","re":1}}')
            b.until(lambda: b.answers)
            assert b.answers[0]["ok"]
            b.until(lambda: b.rest["reminders"])
            assert b.rest["reminders"]["s:s2"][:2] == ["a \ufffdb", "tester"]
        works_on(desk, browser)


@pytest.mark.parametrize(
    "command", [{"do": "remind", "at": "s:s2", "text": "mind"}, {"do": "block", "section": "s3", "on": True}]
)
def test_nothing_stands_that_the_record_has_not_taken(
    ready: Ready, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: dict[str, Any]
) -> None:
    recorder = Recorder(tmp_path / "x.log", ready)
    desk = Desk(ready, recorder=recorder)
    before, answers = desk.operating.stands, list[dict[str, Any]]()
    with monkeypatch.context() as patch:
        patch.setattr(recorder, "_put", lambda kind, **fields: [][0])
        desk.ask(Person("tester", True), command, answers.append)
        desk._commands()
    assert desk.operating.stands == recorder.standing == before
    assert not answers[0]["ok"] and answers[0]["why"][0][0].startswith(f"{DEFECT}: IndexError")
    desk.ask(Person("tester", True), command, answers.append)
    desk._commands()
    assert answers[1]["ok"] and desk.operating.stands == recorder.standing != before
    recorder.close()


def test_a_defect_of_ours_is_told_and_the_cycles_go_on(ready: Ready, monkeypatch: pytest.MonkeyPatch) -> None:
    with panel(ready, Access("work", "see")) as (desk, browser):
        with browser(name="tester", token="work") as b:
            monkeypatch.setattr(desk.operating.buttons, "stop", lambda: {}["\ud800"])
            assert not b.ask("stop")["ok"]
            b.until(lambda: [e for e in b.events if e["text"].startswith(f"{DEFECT}: KeyError")])
            json.dumps(b.events, ensure_ascii=False).encode()
        works_on(desk, browser)


def test_nobody_who_has_gone_ends_the_cycles(ready: Ready) -> None:
    desk = Desk(ready)
    desk.ask(Person("tester", True), {"do": "lamp test"}, lambda answer: [][0])
    desk._commands()


def test_half_a_surrogate_of_our_own_is_sent_and_recorded_as_a_question_mark() -> None:
    """As in the name of a file that is no text."""
    assert sent({"a": "x\udcff中"}) == '{"a":"x?中"}'
    written = Chain().line(0, "note", {"text": "x\udcff中"})
    assert [e["text"] for e in read(written).events] == ["x?中"]


def test_who_asks_without_end_does_not_hold_up_the_cycle(ready: Ready) -> None:
    desk, count = Desk(ready), list[int]()

    def again(_: object) -> None:
        count.append(1)
        assert len(count) < 10
        desk.ask(Person("tester", False), {"do": "stop"}, again)

    again(None)
    desk._commands()
    assert len(count) == 2
    desk._commands()
    assert len(count) == 3


def test_a_browser_has_a_number_of_commands_that_wait_and_may_still_put_all_signals_to_stop(ready: Ready) -> None:
    """Whoever sent without end filled the queue, and others waited behind him."""
    with panel(ready) as (desk, browser), browser(name="first") as b, browser(name="second") as other:
        carried_out, desk._commands = desk._commands, lambda: None  # type: ignore[method-assign]
        for _ in range(WAITING + 10):
            b.ws.send_json({"do": "why", "route": "none", "re": 1})
        b.until(lambda: len(b.answers) == 10)
        assert all("50 commands of this browser wait" in a["why"][0][0] for a in b.answers)
        b.ws.send_json({"do": "stop", "re": 2})
        other.ws.send_json({"do": "why", "route": "none", "re": 3})
        desk._commands = carried_out  # type: ignore[method-assign]
        b.until(lambda: len(b.answers) == WAITING + 11)
        assert b.answers[10] == {"re": 2, "ok": True}, "before all that waited"
        other.until(lambda: other.answers)
        assert b.ask("why", route="none")["why"] == [["there is no route none", []]], "nothing waits any more"


def test_what_is_called_otherwise_is_not_asked_for(ready: Ready) -> None:
    """`swing 1  A` was asked for of the signal `1 A`, and then told as no command."""
    desk, answers = Desk(ready), list[dict[str, Any]]()
    typed: list[str] = []
    desk.operating.operator.type = lambda line: typed.append(line) or ()  # type: ignore[method-assign,func-returns-value]
    desk.ask(Person("tester", True), {"do": "swing", "signal": "1  A"}, answers.append)
    desk._commands()
    assert answers[0]["why"] == [["the overlap of 1  A cannot swing", []]] and not typed


@pytest.mark.parametrize(
    ("given", "found"),
    [
        ({"do": " set\n", "x": [1], "route": None}, {"do": "set"}),
        ({"on": 1, "go": False}, {"on": True, "go": False}),
        ({"metres": 40, "times": 2.5}, {"metres": 40, "times": 2.5}),
        ({"alarms": [["a", "b\ud800"]]}, {"alarms": [("a", "b\ufffd")]}),
    ],
)
def test_fields_are_of_their_kinds(given: dict[str, Any], found: dict[str, Any]) -> None:
    assert cleaned(given) == found


@pytest.mark.parametrize(
    "given",
    [
        *({key: value} for key in sorted(TEXTS) for value in (1, True, [], {}, (LONGEST + 1) * "x")),
        *({key: value} for key in sorted(NUMBERS) for value in (True, "1", [], float("nan"), 2.0 * LARGEST, 10**400)),
        *({key: value} for key in sorted(FLAGS) for value in (2, "1", [], 1.0)),
        *({ALARMS: value} for value in (None, 1, "ab", {}, ["ab"], [["a"]], [["a", 1]])),
    ],
)
def test_fields_of_other_kinds_are_no_command(given: dict[str, Any]) -> None:
    with pytest.raises(NotKnown, match=NOT_KNOWN):
        cleaned(given)


class Noise:
    """Commands that nobody would write: known and unknown fields, with what is right, wrong, or in no order at all."""

    def __init__(self, seed: int, still: dict[str, Any], elements: list[str]) -> None:
        self.rng = Random(seed)
        self.does = [*ASKED, *SWITCHED, "acknowledge", "lamp test"]
        self.keys = [*sorted(TEXTS - {"do"}), *sorted(NUMBERS), *sorted(FLAGS), ALARMS, "re", "x", "", "do.x", "\ud800"]
        self.right: dict[str, list[Any]] = {
            "route": [r["id"] for r in still["routes"]],
            "signal": list(still["signals"]),
            "section": list(still["sections"]),
            "machine": list(still["machines"]),
            "boundary": list(still["boundaries"]),
            "to": ["N", "R"],
            "name": [*still["sections"], *still["stations"], "12", "12:W>E"],
            "towards": [t for found in still["stands"].values() for t in found],
            "train": ["T1", "T2", "T3", "x"],
            "at": elements,
            "kind": ["section", "machine", "lamp", "condition", "station"],
            "text": ["mind"],
            "metres": [5, 40, 1000],
            "times": [1, 2, 60],
        } | {flag: [True, False] for flag in FLAGS}

    def text(self) -> str:
        """A text of strange signs."""
        signs = ["{", "}", "{do.x}", "%s", "\0", "\n", "\x7f", "\x85", "\u2028", "\u202e", "\ufeff", "\uffff", "\ud83d"]
        signs += ["\udc00", "\U0001f682", "é", "e\u0301", "中", " ", "=", ":", ">", "+", "/", "..", '"', "\\", "a", "1"]
        return "".join(self.rng.choices(signs, k=self.rng.choice((0, 1, 2, 5, 30, 300))))

    def value(self, depth: int = 0) -> Any:
        """Any value of JSON."""
        numbers = [0, 1, -1, 0.5, 1e308, -1e308, 10**18, 10**400, float("nan"), float("inf"), -float("inf")]
        match self.rng.randrange(7 if depth < 3 else 5):
            case 0:
                return self.rng.choice((None, True, False))
            case 1:
                return self.rng.choice(numbers)
            case 2:
                return self.rng.choice(sorted(TEXTS))
            case 3 | 4:
                return self.text()
            case 5:
                return [self.value(depth + 1) for _ in range(self.rng.randrange(4))]
            case _:
                return {self.text()[:9]: self.value(depth + 1) for _ in range(self.rng.randrange(3))}

    def message(self) -> str:
        """A message that is an object."""
        c: dict[str, Any] = {"do": self.rng.choice(self.does) if self.rng.random() < 0.8 else self.value()}
        for key in self.rng.sample(self.keys, self.rng.randrange(8)):
            c[key] = self.value()
        share = self.rng.choice((0.0, 0.5, 0.9, 1.0))
        c |= {key: self.rng.choice(found) for key, found in self.right.items() if self.rng.random() < share}
        if self.rng.random() < share:
            c = {key: value for key, value in c.items() if key not in ("heard", "after", ALARMS)}
        return json.dumps(c, ensure_ascii=self.rng.random() < 0.99 or "\\ud" in json.dumps(c))


@pytest.mark.parametrize("token", ["see", "work"])
@pytest.mark.parametrize("seed", range(2))
def test_noise_breaks_nothing(recorded: tuple[Desk, Any], token: str, seed: int) -> None:
    desk, browser = recorded
    noise = Noise(seed, desk.browsers.still, sorted(desk.picture.dark()))
    for _ in range(4):
        name = noise.value()
        with browser(name=name, token=token) as b:
            shower(b, noise, 100)
            assert not [e["text"] for e in b.events if DEFECT in e["text"]]
        with browser(name="tester", token="work") as b:
            assert b.ask("power", on=True)["ok"] and b.ask("speed", times=1)["ok"]
        works_on(desk, browser)


def shower(b: Browser, noise: Noise, count: int) -> None:
    """So many messages, and an answer to each."""
    done = 0
    while done < count:
        text = noise.message()
        if len(text) <= 4096:
            b.ws.send_text(text)
            done += 1
    b.until(lambda: len(b.answers) == count)
    b.ws.send_text('{"do":"set","route":"nowhere","re":1}')
    b.until(lambda: len(b.answers) > count)
