"""Units of a map that its log makes doubtful are said, and those that are right are not."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.conversion.doubts import like_degrees

Convert = Callable[..., SimpleNamespace]
TIME = np.arange(0.0, 200.0, 0.1)  # s
SWING = 170.0 + 60.0 * np.sin(0.2 * TIME)  # of a compass, degrees
CIRCLE = 9.0 * TIME  # degrees: two turns of a compass in 80 s


@pytest.mark.parametrize(
    ("angles", "told"),
    [
        (SWING, True),
        (CIRCLE % 360.0, True),
        ((CIRCLE + 180.0) % 360.0 - 180.0, True),
        (np.round(60.0 * np.sin(0.6 * TIME)), True),  # passes the first turn, by 3.6 degrees a reading at most
        (np.radians(SWING), False),
        (np.radians(CIRCLE), False),
        (np.radians(CIRCLE) % (2 * np.pi), False),
        (1.5 * TIME, False),  # rad, unwrapped: spins to 300
        (-5.0 * TIME, False),  # rad, unwrapped: spins to -1000
        (150.0 * np.sin(0.02 * TIME), False),  # rad, unwrapped: spins 24 turns either way
        (np.where(np.arange(TIME.size) % 50 == 0, 100.0, np.radians(SWING)), False),  # a faulty reading now and then
        (np.full(3, np.nan), False),
    ],
)
def test_degrees_and_headings_of_vehicles_that_spin(angles: Floats, told: bool) -> None:
    """Wrapped at 360, or beyond the first turn throughout; unwrapped radians begin within it and do not leap."""
    assert like_degrees(angles) is told


MAP = """\
  - files: a.csv
    time: {{column: t, unit: {time}}}
    robot: boat
    streams:
      pose: {{x: {{column: x, unit: m}}, y: {{column: x, unit: m}}, z: {{fixed: 0 m}}, yaw: {yaw}}}
      compass: {{heading: {{column: h, unit: deg}}}}
"""


def log(step: float) -> str:
    """A compass and a place, every `step` of whatever the time is in."""
    rows = [f"{step * row:g},{0.1 * row:g},{angle % 360:.2f}" for row, angle in enumerate(CIRCLE)]
    return "\n".join(["t,x,h", *rows])


@pytest.mark.parametrize("yaw", ["{column: h, unit: rad}", "{column: h, unit: rad, scale: -1, offset: 90 deg}"])
def test_degrees_in_a_map_that_says_radians(convert_csv: Convert, yaw: str) -> None:
    """Said once, for the number that is wrong: as it stands in the log, before scale and offset."""
    found = convert_csv(MAP.format(time="s", yaw=yaw), {"a.csv": log(0.1)}).findings
    assert found == (
        "boat/pose from a.csv: 'yaw' goes from 0 to 359.1 rad, as degrees do; check its 'unit' in the map.",
    )


def test_right_units_are_not_doubted(convert_csv: Convert) -> None:
    """Degrees as degrees; every 10 s as gliders do."""
    assert convert_csv(MAP.format(time="s", yaw="{column: h, unit: deg}"), {"a.csv": log(10)}).findings == ()


def test_milliseconds_in_a_map_that_says_seconds(convert_csv: Convert) -> None:
    """Ten readings a second would be 100 s apart."""
    found = convert_csv(MAP.format(time="s", yaw="{column: h, unit: deg}"), {"a.csv": log(100)}).findings
    assert found == ("Readings of /boat/pose and /boat/compass are 100 s apart; check the unit of 'time' in the map.",)


@pytest.mark.parametrize(
    ("apart", "sentence"),
    [
        (1e-4, "Readings of /boat/pose and /boat/compass are 0.0001 s apart; check the unit of 'time' in the map."),
        (0.0, "All readings of /boat/pose and /boat/compass have one time; check the column of 'time' in the map."),
    ],
)
def test_times_that_no_vehicle_records(convert_csv: Convert, apart: float, sentence: str) -> None:
    """Seconds in a map that says milliseconds and more, and a column that stands still."""
    found = convert_csv(MAP.format(time="s", yaw="{column: h, unit: deg}"), {"a.csv": log(apart)}).findings
    assert sentence in found
