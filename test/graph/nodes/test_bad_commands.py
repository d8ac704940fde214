"""What a controller must not do: it is said on the terminal and on /diagnostics, and the run goes on or ends."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from rosbags.highlevel import AnyReader

Starter = Callable[..., Any]
Counts = Callable[[Path], dict[str, int]]
Diagnostics = Callable[[Path], list[tuple[str, str]]]


def test_unusable_commands_are_named_and_the_run_goes_on(
    begin: Starter, paced: Starter, counts: Counts, diagnostics: Diagnostics
) -> None:
    """NaN, beyond 1, unknown and missing actuators, stamps from the past and the future: each has its sentence."""
    orders = ["nan", "beyond", "unknown", "partial", "uneven", "past", "future", "good"]
    run, bag = begin(2, len(orders), "lily_02")
    controller = paced(run, "lily_02")
    controller.say(*orders)
    assert run.finish() == 0, run.output
    said = [words for name, words in diagnostics(bag) if name == "cocorosim: lily_02"]
    for words in (
        "'left' is not a number or not given, so it is off",
        "'left' is 1.7, beyond -1..1, and is cut",
        "an entry 'warp'",
        "'buoyancy' is not a number or not given, so it is off",
        "3 names for 1 entries",
        "a command from the past is not used",
        "a command from the future is not used",
    ):
        assert [sentence for sentence in said if words in sentence], f"{words} is not in {said}"
        assert words in run.output
    found = counts(bag)
    assert found["/lily_02/thruster_command"] == len(orders) + 2, "what is not used is recorded all the same"
    assert found["/lily_01/thruster_command"] == found["/lily_02/pose"] == found["/shoal_statistics"] == len(orders)


@pytest.mark.parametrize("moment", ["before the start", "midway"])
def test_two_controllers_of_one_robot_end_the_run(begin: Starter, paced: Starter, counts: Counts, moment: str) -> None:
    """Nobody knows whom to obey: status 1, one sentence, and a bag that is whole."""
    external = ("lily_02",) if moment == "midway" else ("lily_01", "lily_02")  # nobody comes for lily_01
    run, bag = begin(2, 50, *external)
    first = paced(run, "lily_02")
    if moment == "midway":
        first.say("good", "good")
        first.wait_for("answered good 0.5")
    second = paced(run, "lily_02")
    if moment == "midway":
        second.wait_for("ready")
        second.say("all")  # before the first goes on, or the run may be over before it has read this
        first.say("all")
    assert run.finish() == 1, run.output
    assert run.output.count("cocorosim: lily_02 has ") == 1, run.output
    ends = ["2 controllers, so the run ends"] + ["two controllers command it"] * (moment == "midway")
    assert any(words in run.output for words in ends), run.output
    assert "/clock" in counts(bag)


def test_two_controllers_of_a_free_running_robot_are_complained_of(begin: Starter, paced: Starter) -> None:
    """At a rate, one may command as often as it likes; a second one is named, and the run goes on."""
    run, _ = begin(1, 100_000, "lily_01", options=("--rate", 10))
    first = paced(run, "lily_01")
    first.say("twice", "twice", "all")
    first.wait_for("answered", times=3)
    assert "lily_01" not in run.output.partition("export")[2]
    paced(run, "lily_01").say("all")
    run.wait_for("lily_01: it has more than one controller and obeys whichever spoke last")
    first.wait_for("answered", times=first.output.count("answered") + 5)
    run.interrupt()
    assert run.finish() == 130, run.output


@pytest.mark.parametrize("options", [(), ("--rate", 10)], ids=["lock-step", "by the clock"])
def test_commands_without_a_stamp_answer_the_tick_that_waits(
    begin: Starter, paced: Starter, counts: Counts, options: tuple[Any, ...]
) -> None:
    """As `ros2 topic pub` sends them, and more often than ticks come: the robot obeys, nothing is complained of."""
    ticks = 8
    run, bag = begin(1, ticks, "lily_01", options=options)
    paced(run, "lily_01").say(*["unstamped"] * ticks)
    assert run.finish() == 0, run.output
    assert "lily_01" not in run.output.partition("export")[2]
    assert counts(bag)["/lily_01/thruster_command"] == 2 * ticks
    with AnyReader([bag]) as reader:
        commands = [each for each in reader.connections if each.topic == "/lily_01/thruster_command"]
        logged = [at for _, at, _ in reader.messages(commands)]
    assert logged[-1] > 0, "they are in the recording when they came, not all at its beginning"
    assert set(logged) <= {tick * 500_000_000 for tick in range(ticks)}
