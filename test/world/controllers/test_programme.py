"""A table of commands, row by row."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.world.controllers.programme import SETTINGS
from cocorosim_ros.world.controllers.request import DIRECT, FRACTIONS

Make = Callable[..., Any]
SHARES = {"actuator_1_ahead": 1.0, "actuator_1_turn": -1.0, "actuator_2_ahead": 1.0, "actuator_2_turn": 1.0,
          "actuator_3_rise": 1.0}  # fmt: skip
ROWS = {"row_1_time": 4.0, "row_1_ahead": 0.8, "row_3_time": 2.0, "row_3_ahead": 0.5, "row_3_turn": 0.7,
        "row_4_time": 4.0, "row_4_rise": -0.6}  # fmt: skip


def settings(**others: float) -> list[float]:
    """Its settings in order; what is not given is 0."""
    given = {**SHARES, **ROWS, **others}
    return [given.get(name, 0.0) for name in SETTINGS]


@pytest.mark.parametrize(
    ("time", "ramps", "fractions"),
    [
        (0.0, 0.0, (0.8, 0.8, 0.0)),
        (3.5, 0.0, (0.8, 0.8, 0.0)),
        (4.0, 0.0, (-0.2, 1.0, 0.0)),  # 0.5 -+ 0.7, cut to 1; row 2 lasts no time
        (6.0, 0.0, (0.0, 0.0, -0.6)),
        (10.0, 0.0, (0.8, 0.8, 0.0)),  # 4 + 2 + 4: from the beginning
        (24.5, 0.0, (-0.2, 1.0, 0.0)),  # 2 * 10 + 4.5
        (2.0, 1.0, (0.3, 1.0, 0.0)),  # halfway: ahead 0.65, turn 0.35
        (8.0, 1.0, (0.4, 0.4, -0.3)),  # halfway from the last row to the first
    ],
)
def test_rows(decide_once: Make, time: float, ramps: float, fractions: tuple[float, ...]) -> None:
    """Each row holds for its time, rows of no time are left out, the table begins again, ramps are straight lines."""
    request = decide_once("programme", settings(ramps=ramps), time=time)
    assert request[DIRECT] == 1.0
    assert request[FRACTIONS : FRACTIONS + 3].tolist() == pytest.approx(list(fractions), abs=1e-5)


def test_an_empty_table_is_rest(decide_once: Make) -> None:
    """Without rows all actuators are off."""
    request = decide_once("programme", [0.0] * len(SETTINGS), time=3.0)
    assert request[DIRECT] == 1.0 and not request[FRACTIONS : FRACTIONS + 8].any()
