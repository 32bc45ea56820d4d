"""Work beside work: what processes tell each other."""

from __future__ import annotations

import multiprocessing

import pytest

from interlock.proof.pool import NOTE, Board, run

NOTES = [bytes([n]) * NOTE for n in range(4)]


def test_a_note_is_seen_by_a_process_that_was_begun_before_it_was_written() -> None:
    board = Board()
    fork = multiprocessing.get_context("fork")
    ours, theirs = fork.Pipe()

    def look() -> None:
        theirs.recv()
        first = [n in board for n in NOTES[:3]]
        board.write(NOTES[2])
        theirs.send(first)

    process = fork.Process(target=look)
    process.start()
    board.write(NOTES[0])
    board.write(NOTES[1])
    assert NOTES[1] in board and NOTES[2] not in board
    ours.send(0)
    assert ours.poll(20) and ours.recv() == [True, True, False]
    process.join(20)
    assert [n in board for n in NOTES] == [True, True, True, False]


def test_what_finds_no_room_is_forgotten() -> None:
    board = Board(2)
    for n in NOTES:
        board.write(n)
    assert [n in board for n in NOTES] == [True, True, False, False]
    with pytest.raises(AssertionError):
        board.write(b"short")


def test_results_stand_in_the_order_of_the_tasks() -> None:
    assert run([lambda n=n: n * n for n in range(20)], 2) == [n * n for n in range(20)]  # type: ignore[misc]
