"""Work beside work: what becomes of tasks."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import wait
from contextlib import contextmanager
from functools import partial
from multiprocessing.connection import Connection
from pathlib import Path
from types import FrameType

import pytest

from interlock.exceptions import Ended
from interlock.proof.engines.pool import Begun, apart, processes, run


@pytest.mark.parametrize("jobs", [1, 2, 4])
def test_results_stand_in_the_order_of_the_tasks_and_each_is_told_once(jobs: int) -> None:
    told: list[int] = []

    def task(n: int) -> int:
        time.sleep(0.002 * (n % 3))
        return n * n

    assert run([partial(task, n) for n in range(20)], jobs, told.append) == [n * n for n in range(20)]
    assert sorted(told) == list(range(20))
    assert run([], jobs) == []


@pytest.mark.parametrize("jobs", [1, 3])
def test_what_a_task_raises_is_raised(jobs: int) -> None:
    def task(n: int) -> int:
        if n == 5:
            raise ValueError("five")
        return n

    with pytest.raises(ValueError, match="five"):
        run([partial(task, n) for n in range(9)], jobs)


def test_a_process_that_is_killed_is_noticed() -> None:
    """With what it had begun nobody is left who could do it."""
    own = os.getpid()

    def task(n: int) -> int:
        if os.getpid() != own:
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(0.05)
        return n

    with pytest.raises(RuntimeError, match="has ended before"):
        run([partial(task, n) for n in range(6)], 2)


@contextmanager
def within(seconds: int) -> Iterator[None]:
    """What hangs raises TimeoutError."""

    def late(number: int, frame: FrameType | None) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("beside", [1, 3])
def test_a_process_that_is_killed_while_it_tells_its_answer_is_noticed(beside: int) -> None:
    """The rest of the answer never comes: nobody waits for it."""
    own, told = os.getpid(), list[int]()

    def task(n: int) -> bytes:
        if os.getpid() == own:
            time.sleep(1.5)  # the pipe is full, and nobody reads it
            return b""
        if told:
            time.sleep(60)
        told.append(n)
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGKILL)).start()
        return bytes(1 << 24)

    tasks = [partial(task, n) for n in range(2 * beside + 1)]
    with within(20), pytest.raises(RuntimeError, match="has ended before"), Begun(tasks, beside) as begun:
        time.sleep(0.2)  # every process takes a task, and then another
        begun.results()


def _half(self: Connection, told: bytes) -> None:
    """In the place of what writes to a pipe: the process is killed when it has told the half of it."""
    os.write(self.fileno(), told[: len(told) // 2])
    os.kill(os.getpid(), signal.SIGKILL)


def _told_by_half(n: int) -> bytes:
    """The first call is answered by half, the second is long at its work."""
    if n == 0:
        Connection._send = _half  # type: ignore[attr-defined]
    elif n == 1:
        time.sleep(60)
    return bytes(1 << 16)


def _apart(method: str, jobs: int) -> None:
    with pytest.raises(Ended, match="SIGKILL"), processes(jobs, method) as pool:
        asked = [pool.submit(_told_by_half, n) for n in range(5)]
        wait(asked)
        assert all(isinstance(x.exception(), Ended) for x in asked[:1] + asked[2:]), "with it all that is not done ends"
        asked[0].result()
    with pytest.raises(Ended):
        apart(_told_by_half, [(n,) for n in range(5)], jobs)
    os._exit(0)


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
@pytest.mark.parametrize("jobs", [1, 2])
def test_a_process_that_is_killed_while_it_answers_a_call_ends_all_of_them(method: str, jobs: int) -> None:
    """As the system does when memory runs out: who reads the answer waited for its other half for ever."""
    running = multiprocessing.get_context("fork").Process(target=_apart, args=(method, jobs))
    running.start()
    running.join(40)
    code = running.exitcode
    running.kill()
    assert code == 0, "it hangs" if code is None else code


KILLED = """
import os, signal, sys
from interlock.cli import main, prove

def prove_file(path, limits):
    if path.endswith("fig2_1.yaml"):
        os.kill(os.getpid(), signal.SIGKILL)

prove.prove_file = prove_file
if __name__ == "__main__":
    sys.argv = ["interlock", "prove", "layouts/fig2_1.yaml", "layouts/fig2_2.yaml", "-j", "2", *sys.argv[1:]]
    main.main()
"""


@pytest.mark.parametrize("form", ["text", "json"])
def test_a_proof_whose_process_is_killed_is_no_proof_and_no_defect(form: str, tmp_path: Path) -> None:
    (tmp_path / "killed.py").write_text(KILLED, "utf-8")
    more = ["--format", "json"] if form == "json" else []
    command = [sys.executable, str(tmp_path / "killed.py"), *more]
    environment = {**os.environ, "PYTHONPATH": str(Path.cwd())}
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment, check=False)
    said = done.stdout if form == "json" else done.stderr
    assert done.returncode == 3 and "SIGKILL, as when memory runs out: try fewer jobs" in said, done
    assert "PROVED" not in done.stdout and "defect" not in said and "Traceback" not in done.stderr


def _raised(n: int) -> int:
    if n == 1:
        raise ValueError("one")
    if n == 2:
        raise LookupError(lambda: n)
    return n * n


def test_what_a_call_raises_is_raised_and_the_others_go_on() -> None:
    told: list[int] = []
    with within(30), processes(2) as pool:
        asked = [pool.submit(_raised, n) for n in range(5)]
        assert [x.result() for x in asked if asked.index(x) not in (1, 2)] == [0, 9, 16]
        with pytest.raises(ValueError, match="one"):
            asked[1].result()
        with pytest.raises(RuntimeError, match="LookupError"):
            asked[2].result()
    assert apart(_raised, [(n,) for n in range(3, 9)], 2, told.append) == [n * n for n in range(3, 9)]
    assert sorted(told) == [*range(6)]
    with pytest.raises(ValueError, match="one"):
        apart(_raised, [(0,), (1,), (3,)], 2)
    with pytest.raises(RuntimeError, match="closed"):
        pool.submit(_raised, 0)


def test_what_ends_the_block_ends_the_calls_at_once() -> None:
    with within(20), pytest.raises(KeyError), processes(2) as pool:
        late = [pool.submit(time.sleep, 60) for _ in range(5)]
        time.sleep(0.5)
        raise KeyError
    assert all(x.done() for x in late) and not multiprocessing.active_children()


@pytest.mark.parametrize("code", [0, 1])
def test_a_process_that_ends_in_the_midst_of_a_task_is_noticed_at_once(code: int) -> None:
    """Its task is lost, whatever the others are still at, and whatever it says of itself."""

    def task(n: int) -> int:
        if n == 0:
            os._exit(code)
        time.sleep(60)
        return n

    for others in (0, 1):
        tasks = [partial(task, n) for n in range(1 + others)]
        with within(20), pytest.raises(RuntimeError, match="has ended before"), Begun(tasks, 1 + others) as begun:
            time.sleep(0.3)  # each has taken a task
            begun.results()


def test_a_process_goes_on_while_nobody_takes_its_answers() -> None:
    """Large ones too: its owner looks at them when its own task is done."""
    own = os.getpid()

    def task(n: int) -> tuple[bool, bytes]:
        if os.getpid() == own:
            time.sleep(1)
        return os.getpid() == own, bytes(1 << 20)

    with within(60), Begun([partial(task, n) for n in range(8)], 1) as begun:
        found = begun.results()
    assert sum(mine for mine, _ in found) <= 2 and all(answer == bytes(1 << 20) for _, answer in found)


def test_an_answer_that_cannot_be_told_is_raised() -> None:
    with within(20), pytest.raises(Exception, match="pickle"), Begun([lambda: lambda: 0], 1) as begun:
        time.sleep(0.3)
        begun.results()


def test_what_a_process_has_done_counts_when_it_has_ended_before_it_is_asked() -> None:
    with within(20), Begun([partial(pow, n, 2) for n in range(5)], 2) as begun:
        time.sleep(0.5)
        assert begun.results() == [0, 1, 4, 9, 16]
        with pytest.raises(RuntimeError):
            begun.results()


def test_processes_end_when_their_owner_is_gone() -> None:
    """Nobody hears the answer, so that the next task is not worth doing."""
    heard, alive = os.pipe()

    def task(n: int) -> bytes:
        if n:
            time.sleep(60)
        return bytes(1 << 20)

    def owner() -> None:
        Begun([partial(task, n) for n in range(2)], 1)
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGKILL)

    process = multiprocessing.get_context("fork").Process(target=owner)
    process.start()
    os.close(alive)
    with within(20):
        process.join()
        assert os.read(heard, 1) == b""  # what is begun holds the other end
    os.close(heard)
