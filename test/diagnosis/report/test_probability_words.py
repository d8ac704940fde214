"""Probabilities in whole percents and plain words."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.report.probability_words import percents, probability_words


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
