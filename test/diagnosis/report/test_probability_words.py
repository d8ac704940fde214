"""Probabilities in whole percents and plain words."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis
from cocorosim_ros.diagnosis.report.probability_words import (
    meaning_words,
    percents,
    probability_words,
    told_probabilities,
)

Example = Callable[[str], Diagnosis]


def plain(told: dict[str, float]) -> str:
    """The words, with usual spaces."""
    return probability_words(told).replace("\u00a0", " ")


def test_words_are_those_of_a_workshop() -> None:
    """Most probable first, members of a set joined by "and", and nothing of what rounds to no percent."""
    told = {"linear_drag": 0.9, "linear_drag + tether": 0.062, "something else": 0.036, "nothing": 0.002}
    assert plain(told) == "90 % linear drag, 6 % linear drag and tether, 4 % something else"
    assert plain({"nothing": 0.7, "something else": 0.3}) == "70 % nothing, 30 % something else"
    told = {"tether + something else": 0.6, "something else": 0.4, "nothing": 0.0}
    assert plain(told) == "60 % tether and something else, 40 % something else"


def test_of_many_sets_the_most_probable_are_told() -> None:
    """Four and nothing, the others as one number; six are many, five are not."""
    many = {"tether": 0.3, "linear_drag": 0.2, "wind": 0.15, "something else": 0.13, "imu_bias": 0.12, "nothing": 0.1}
    assert plain(many) == (
        "30 % tether, 20 % linear drag, 15 % wind, 13 % something else, 10 % nothing, "
        "12 % other such sets, each less probable"
    )
    del many["imu_bias"]
    few = {name: share / 0.88 for name, share in many.items()}
    assert plain(few) == "34 % tether, 23 % linear drag, 17 % wind, 15 % something else, 11 % nothing"


def told(found: Diagnosis) -> str:
    """The line of a diagnosis, with usual spaces."""
    return told_probabilities(found).replace("\u00a0", " ")


@pytest.mark.parametrize("verdict", ["consistent", "recalibrate", "insufficient"])
def test_silence_is_not_called_something_else(example: Example, verdict: str) -> None:
    """Where nothing is named: what would not show, what nearly has a name, and nothing; in all 100 %."""
    line = told(example(verdict))
    assert "% that something is missing which these recordings would not show" in line
    assert "% that nothing is missing" in line and "something else" not in line
    assert sum(map(int, re.findall(r"(\d+) %", line))) == 100
    compared = replace(example(verdict), against=Comparison(("good",), (), ()))
    assert "that something differs which" in told(compared) and "that nothing differs" in told(compared)
    assert meaning_words(compared) == ""


def test_what_has_no_name_is_there_all_the_same(example: Example) -> None:
    """A mismatch without a name is not hidden: the recordings show it."""
    assert told(example("nameless")).startswith("50 % that something is missing that has no name")
    short_of = replace(example("recalibrate"), verdict="mismatch", beyond_floor=("depth",))
    assert told(short_of) == "50 % that something is missing that has no name, 50 % that nothing is missing"


def test_each_name_has_its_own_probability(example: Example) -> None:
    """Beside that of the sets that hold it; streams are told apart, and what is meant is said."""
    found = example("mismatch")
    (munk,) = found.effects
    sure = replace(munk, ambiguous_with=())
    names = ("linear_drag", "thruster_lag", "battery_sag", "tether", "pose_lever")
    doubtful = [replace(sure, id=name, because=("It may be chance.",), tier="suspected") for name in names]
    late = [
        replace(sure, id="sensor_latency", topic=topic, because=("No.",), tier="suspected") for topic in ("pose", "imu")
    ]
    line = told(replace(found, effects=(sure, *doubtful, *late)))
    own, together = line.split("; taken together ")
    assert own.startswith("added mass 98 %, linear drag 50 %") and "each whatever is there beside it" in own
    assert "sensor latency of pose 50 %, sensor latency of stream of the inertial sensor 50 %" in own
    assert "leave it no more than even odds" in own
    assert "% added mass and more" in together and "% something else" not in together
    assert "And more:" in meaning_words(replace(found, effects=(sure, *doubtful)))
    alone = told(replace(found, effects=(sure,)))
    assert alone.startswith("added mass 98 %; taken together 98 % added mass, ")
    assert "And more:" not in meaning_words(replace(found, effects=(sure,)))


def test_nothing_is_certain() -> None:
    """What rounds to a hundred is told as less than certain."""
    assert plain({"tether": 0.9961, "something else": 0.0029, "nothing": 0.001}) == "over 99 % tether"


@pytest.mark.parametrize(
    ("shares", "whole"),
    [
        ([1 / 3, 1 / 3, 1 / 3], [34, 33, 33]),
        ([0.475, 0.475, 0.05], [48, 47, 5]),
        ([0.992, 0.004, 0.004], [99, 1, 0]),
        ([1.0], [100]),
    ],
)
def test_percents_by_hand(shares: list[float], whole: list[int]) -> None:
    """Largest remainders; of equal ones the first."""
    assert percents(shares) == whole


def test_percents_add_up_and_are_near() -> None:
    """Any shares: 100 in all, each within one of its own."""
    rng = np.random.default_rng(1)
    for count in range(1, 9):
        for shares in rng.dirichlet(np.full(count, 0.4), 50):
            whole = percents(shares.tolist())
            assert sum(whole) == 100
            assert np.abs(np.array(whole) - 100.0 * shares).max() <= 1.0
