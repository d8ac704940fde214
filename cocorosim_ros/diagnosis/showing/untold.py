"""Errors of readings that these recordings cannot tell, in words: no other reading shows what they depend on."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from cocorosim_ros.diagnosis.catalogue.law_words import READING_WORDS, regressor_words
from cocorosim_ros.diagnosis.catalogue.sensor_laws import SENSOR_LAWS_OF
from cocorosim_ros.diagnosis.catalogue.shown_by import is_shown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.track import Track


def untold_errors(tracks: Sequence[Track], unrecorded: Collection[str] = ()) -> tuple[str, ...]:
    """A sentence for each reading whose error in proportion to some states cannot be told, and for which robots.

    unrecorded: kinds of readings that are none, such as a height that a map fixes.
    """
    missing: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for robot, numbers in tracks_by_robot(tracks).items():
        present = [tracks[number].timeline.kinds for number in numbers]
        for reading in (name for name in SENSOR_LAWS_OF if name not in unrecorded):
            having = [kinds for kinds in present if reading in kinds]
            states = _hidden(reading, having) if having else ()
            if states:
                missing.setdefault((reading, states), []).append(robot)
    return tuple(_sentence(reading, states, robots) for (reading, states), robots in missing.items())


def _hidden(reading: str, recordings: Sequence[frozenset[str]]) -> tuple[str, ...]:
    """States that laws of a reading depend on and that no other reading of any of these recordings shows."""
    states = dict.fromkeys(factor.name for product in SENSOR_LAWS_OF[reading] for factor in product.factors)
    return tuple(state for state in states if not any(is_shown(state, (reading,), kinds) for kinds in recordings))


def _sentence(reading: str, states: tuple[str, ...], robots: Sequence[str]) -> str:
    words = ", ".join(regressor_words(state) for state in states)
    return (
        f"Whether {READING_WORDS[reading]} of {', '.join(robots)} errs in proportion to {words} cannot be told, "
        "because no other reading shows it."
    )
