"""The programme of a calibration run, phase by phase."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.world.controllers.request import DIRECT, FRACTIONS

# straight 20 s, turn 12 s, pump 3 s, rest 8 s; 0.9, 0.8, 0.7 of the actuators
SETTINGS = (20.0, 12.0, 3.0, 8.0, 0.9, 0.8, 0.7)
Make = Callable[..., Any]


@pytest.mark.parametrize(
    ("time", "fractions"),
    [
        (0.0, (0.9, 0.9, 0.0)),
        (19.5, (0.9, 0.9, 0.0)),
        (20.0, (0.0, 0.0, 0.0)),
        (27.5, (0.0, 0.0, 0.0)),
        (28.0, (-0.9, -0.9, 0.0)),
        (48.0, (0.0, 0.0, 0.0)),
        (56.0, (-0.8, 0.8, 0.0)),  # 2 * 28
        (76.0, (0.8, -0.8, 0.0)),  # + 20
        (96.0, (0.0, 0.0, -0.7)),  # + 20
        (99.0, (0.0, 0.0, 0.0)),
        (107.0, (0.0, 0.0, 0.7)),  # + 11
        (110.0, (0.0, 0.0, 0.0)),
        (500.0, (0.0, 0.0, 0.0)),
    ],
)
def test_phases(decide_once: Make, time: float, fractions: tuple[float, ...]) -> None:
    """Each phase begins when those before it and their rests are over; after the last all is off."""
    request = decide_once("calibration_programme", SETTINGS, time=time)
    assert request[DIRECT] == 1.0
    assert request[FRACTIONS : FRACTIONS + 3].tolist() == pytest.approx(list(fractions))
