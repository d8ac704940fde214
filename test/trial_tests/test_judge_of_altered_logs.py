"""What counts as seen, as out of sight and as the same thing where altered logs are judged."""

from __future__ import annotations

import random
from typing import Any

import pytest
from trial.against import _of_probabilities, by_kind, judged
from trial.draws import WHOLE, Draw, way_of

NONE: dict[str, Any] = {"effects": [], "recalibrated": [], "not_shown_by_this_recording": []}


def test_silence_counts_as_blind_only_below_the_size_that_is_told() -> None:
    """A diagnosis that would name an offset from 0.2 rad on is blind to 0.1 and silent about 0.3."""
    seen = {"compass_distortion": {"offset": 0.2, "sin": 0.01}, "sensor_latency:imu": {"latency": 0.1}}
    told = NONE | {"against_seen_from": seen}
    assert judged(told, way_of("heading", -0.1))["outcome"] == "cannot be seen"
    assert judged(told, way_of("heading", 0.3))["outcome"] == "silent"
    assert judged(told, way_of("compass", 0.1))["outcome"] == "silent"
    assert judged(told, way_of("delay:imu", 0.3))["outcome"] == "silent"
    assert judged(told, way_of("delay:pressure", 0.3))["outcome"] == "silent"
    assert judged(NONE, way_of("heading", 0.1))["outcome"] == "silent"
    listed = told | {"not_shown_by_this_recording": ["compass_distortion"]}  # not at medium size, but more was put in
    assert judged(listed, way_of("heading", 0.3))["outcome"] == "silent"
    assert judged(told | {"against_seen_from": {"compass_distortion": {}}}, way_of("heading", 0.3))["outcome"] == (
        "cannot be seen"
    )
    gain = NONE | {"against_seen_from": {"thruster_gain:down": {"down": 0.5}}}
    assert judged(gain, way_of("gain:2", 0.4, "down"))["outcome"] == "cannot be seen"
    assert judged(gain, way_of("gain:2", 0.6, "down"))["outcome"] == "silent"
    assert judged(gain, way_of("gain:2", -0.5, "down"))["outcome"] == "silent"
    assert judged(gain, way_of("gain:1", -0.2, "right"))["outcome"] == "silent"


def test_late_commands_stand_for_late_poses_only_where_that_is_said() -> None:
    """With poses alone the two are one thing; a diagnosis that knows has the one as the other's rival."""
    late = Draw("delay:pose", 0.1, 0.1, both=False, poses_alone=True).drawn(random.Random(1))
    delay = {"delay": {"value": 0.11, "ci95": [0.11, 0.11], "unit": "s"}}
    effect: dict[str, Any] = {"id": "command_delay", "parameters": delay, "ambiguous_with": []}
    found = NONE | {"effects": [effect]}
    assert judged(found, late)["outcome"] == "something else"
    effect["ambiguous_with"] = [{"id": "sensor_latency", "nats_behind": 0.5}]
    assert judged(found, late)["outcome"] == "right"
    assert judged(found, late)["beside"] == []
    other = Draw("delay:pose", 0.1, 0.1, both=False).drawn(random.Random(1))
    assert judged(found, other)["outcome"] == "something else"
    delay["delay"] = {"value": 0.3, "ci95": [0.3, 0.3], "unit": "s"}
    assert judged(found, late)["outcome"] == "something else"


def test_how_probable_names_are_called_is_held_against_how_often_they_are_right() -> None:
    """A lag of the right size beside a drag that nobody altered: one of two is right, told with 0.9 and 0.6."""
    effects = [
        {"id": "sensor_latency", "topic": "pose", "probability": 0.9,
         "parameters": {"latency": {"value": 0.1, "ci95": [0.09, 0.11], "unit": "s"}}},
        {"id": "linear_drag", "probability": 0.6, "parameters": {"surge": {"value": 1.0, "ci95": [0.5, 1.5]}}},
    ]  # fmt: skip
    row = judged(NONE | {"effects": effects}, way_of("delay:pose", 0.1))
    assert row["believed"] == [(0.9, True), (0.6, False)]
    line = " ".join(_of_probabilities(row["believed"]))
    assert "2 differences" in line and "1, 50 %" in line and "75 % on average" in line
    brier = (0.1**2 + 0.6**2) / 2
    assert float(line.split("Brier score ")[1].rstrip("). ")) == pytest.approx(brier, abs=1e-3)
    assert _of_probabilities([]) == []


def test_a_doubt_about_the_right_thruster_is_no_silence() -> None:
    """It is said that the thrust of one may differ and that the recordings cannot tell; of the other nothing."""
    doubt = NONE | {"against_in_doubt": ["thruster_gain:left", "thruster_gain:down"]}
    assert judged(doubt, way_of("gain:0", -0.2))["outcome"] == "cannot be seen"
    assert judged(doubt, way_of("gain:1", -0.2))["outcome"] == "silent"
    assert judged(doubt, way_of("gain:2", -0.2, "down"))["outcome"] == "cannot be seen"
    assert judged(doubt, way_of("gain:0", -0.2, "ahead"))["outcome"] == "silent"


def test_thrust_by_the_square_of_the_command() -> None:
    """Commands logged at half their size hide four times the thrust of what is logged."""
    weak = Draw("gain:0", -0.5, -0.5, both=False, thruster="propeller", square=True).drawn(random.Random(1))
    assert (weak.effect, weak.parameter, weak.change) == ("thruster_gain", "propeller", 4.0)
    gain = NONE | {"against_seen_from": {"thruster_gain:propeller": {"propeller": 2.9}}}
    assert judged(gain, weak)["outcome"] == "silent"
    gain["against_seen_from"]["thruster_gain:propeller"]["propeller"] = 3.1
    assert judged(gain, weak)["outcome"] == "cannot be seen"


def test_the_gain_of_a_single_thruster_is_a_number_of_the_platform() -> None:
    """A ship with one propeller has no other thrust that could have moved."""
    weak = Draw("gain:0", -0.2, -0.2, both=False, thruster=WHOLE, square=True).drawn(random.Random(1))
    moved: dict[str, Any] = {"parameter": WHOLE, "value": 1.57, "ci95": [1.5, 1.65]}
    assert judged(NONE | {"recalibrated": [moved]}, weak) == {
        "outcome": "right", "beside": [], "named": [WHOLE], "believed": [],
    }  # fmt: skip
    moved |= {"value": 0.9, "ci95": [0.8, 1.0]}
    assert judged(NONE | {"recalibrated": [moved]}, weak)["outcome"] == "something else"
    other = Draw("scale", 0.1, 0.1, both=False).drawn(random.Random(1))
    assert judged(NONE | {"recalibrated": [moved]}, other)["beside"] == [WHOLE]


def test_outcomes_are_told_by_kind_of_alteration() -> None:
    """Each kind in a line, without the controls."""
    rows = [
        {"way": way, "outcome": outcome}
        for way, outcome in (
            ("gain_0_-0.2", "right"), ("gain_2_-0.4", "cannot be seen"), ("control", "right"), ("axis_1", "right"),
            ("gain_1_-0.1", "right"),
        )
    ]  # fmt: skip
    assert by_kind(rows)[2:] == ["| axis | 1 | 1 | 0 | 0 | 0 | 0 |", "| gain | 3 | 2 | 1 | 0 | 0 | 0 |", ""]
