"""Words for numbers of the platform: no keys of files, no underscores, no dots."""

from __future__ import annotations

import pytest

from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.restraint import Restrained


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("drag", "drag"),
        ("yaw_torque_gain", "yaw torque gain"),
        ("linear_drag.yaw", "yaw of linear drag"),
        ("added_mass.sway_minus_surge", "sway minus surge of added mass"),
        ("actuators.rudder.acceleration", "acceleration of rudder"),
    ],
)
def test_numbers_in_words(name: str, words: str) -> None:
    """By hand."""
    assert parameter_words(name) == words


def test_numbers_that_are_held_are_said_in_words() -> None:
    """With errors in degrees, each with its unit."""
    base = None
    row = HeldOut(0.0543, 0.1, 0.175, 0.05, "rad")
    steady = Restrained(base, ("yaw_torque_gain", "linear_drag.yaw"), (("heading", row),))  # type: ignore[arg-type]
    assert steady.sentences == (
        "With yaw torque gain, yaw of linear drag fitted, the heading of unseen data was foretold worse than by the "
        "platform as given: it erred by 10.0\u00b0 instead of 3.11\u00b0; they are kept as the file gives them.",
    )
