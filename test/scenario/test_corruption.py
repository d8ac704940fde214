"""Corruption in scenario files: what is read, and the sentences for mistakes."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.scenario.parts.corruption import longest_delay
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario

DURATION = "duration: 10 s"
ScenarioFile = Callable[..., Path]
Complaint = Callable[..., str]


def with_corruption(*entries: str) -> tuple[str, str]:
    """The replacement that adds corruptions to the good scenario."""
    return DURATION, DURATION + "\ncorruption:\n" + "\n".join(f"  - {{{entry}}}" for entry in entries)


def test_numbers_are_read_in_si(scenario_file: ScenarioFile) -> None:
    """2 deg are 2 pi / 180 rad, 20 % are 0.2; robots are kept."""
    scenario = load_scenario(
        scenario_file(
            with_corruption(
                "channel: compass, kind: noise, sd: 2 deg, robots: [lily_02]",
                "channel: radio, kind: loss, probability: 20 %",
                "channel: radio, kind: delay, ticks: 3",
                "channel: radio, kind: delay, ticks: 4",
            )
        )
    )
    first, second = scenario.corruption[:2]
    assert first.numbers["sd"] == pytest.approx(math.radians(2.0))
    assert first.robots == ("lily_02",)
    assert second.numbers == {"probability": 0.2}
    assert second.robots is None
    assert longest_delay(scenario.corruption) == 7


def test_it_survives_writing_and_reading(scenario_file: ScenarioFile) -> None:
    """A scenario with corruption, blue-light delivery, light and instant radio is the same after YAML and back."""
    extra = "\nradio: {latency: none}\nblue_light: {delivery: from_nearest}\nlight: {background: 3 lx}"
    path = scenario_file(
        with_corruption(
            "channel: neighbour_range, kind: range_factor, least: 0.8, most: 1",
            "channel: gyro, kind: quantisation, step: 0.1 deg/s",
            "channel: blue_light, kind: rate_limit, ticks: 2, robots: [lily_01]",
        ),
        ("seed: 3", "seed: 3" + extra),
    )
    scenario = load_scenario(path)
    assert parse_scenario(scenario.to_yaml(), "again") == scenario
    assert (scenario.radio.latency, scenario.blue_light.delivery, scenario.light.background) == (
        "none",
        "from_nearest",
        3.0,
    )


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ("kind: noise, sd: 2 deg", "lacks 'channel'"),
        ("channel: compas, kind: noise, sd: 2 deg", "did you mean 'compass'"),
        ("channel: compass, kind: loss, probability: 0.1", "corruption"),
        ("channel: compass, kind: noise, sd: 2 m", "angle"),
        ("channel: compass, kind: noise", "lacks 'sd'"),
        ("channel: compass, kind: noise, sd: -2 deg", "must not be negative"),
        ("channel: compass, kind: quantisation, step: 0 deg", "greater than zero"),
        ("channel: radio, kind: loss, probability: 1.5", "from 0 to 1"),
        ("channel: radio, kind: delay, ticks: 0.5", "whole number"),
        ("channel: neighbour_range, kind: range_factor, least: 1, most: 0.8", "greater than 'most'"),
        ("channel: radio, kind: loss, probability: 0.1, robots: [lily_09]", "name of no robot"),
        ("channel: radio, kind: loss, probability: 0.1, colour: blue", "not a known key"),
    ],
)
def test_mistakes_get_a_sentence(complaint: Complaint, entry: str, words: str) -> None:
    """Each names the file, the line and what is wrong."""
    sentence = complaint(with_corruption(entry))
    assert words in sentence
    assert sentence.startswith("x.yaml line ")
    assert "\n" not in sentence
