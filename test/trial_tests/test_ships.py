"""The measures of the two model ships: a model foretells itself, and where a wind blows to."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest


def test_shares_by_hand() -> None:
    """The truth itself gives 1, its mean gives 0, an error of half the spread three quarters."""
    from trial.ships import shares_of

    seen = np.array([[0.0, 0.0], [2.0, 2.0], [4.0, 4.0]])
    assert shares_of([seen], [np.array([[0.0, 2.0], [2.0, 2.0], [4.0, 2.0]])]) == (1.0, 0.0)
    assert shares_of([seen[:, :1]], [1.0 + 0.5 * seen[:, :1]]) == (0.75,)


def test_a_simulation_from_its_own_start() -> None:
    """A tanker that coasts slows down by its drag by the closed form u0 / (1 + k u0 t / m)."""
    from trial.ships import simulated

    from cocorosim_ros.scenario.parts.platform import load_platform

    tanker, moments = load_platform("kvlcc2_hsva"), np.arange(0.0, 40.0, 0.5)
    log = SimpleNamespace(command_time=np.zeros(1), command=np.zeros((1, 2)))
    found = simulated(tanker, [1.0, 0.0, 0.0], moments, log)
    expected = 1.0 / (1.0 + tanker.drag * moments / tanker.mass)
    np.testing.assert_allclose(found[:, 0], expected, rtol=1e-7)
    assert not found[:, 1:].any()


def test_where_the_wind_blows_to(tmp_path: Path) -> None:
    """2 m/s from the west (270 deg from north) blow to the east; a diagnosis 10 deg beside that is told so."""
    from trial.ships import WINDY, anemometer, ship_lines, wind

    path = tmp_path / "log.csv"
    path.write_text("a\n" + "\n".join(",".join(["0"] * 11 + ["2", repr(math.radians(270.0))]) for _ in range(3)))
    assert anemometer([path]) == pytest.approx(2.0 + 0.0j)
    air = 1.5 * np.exp(1j * np.radians(10.0))
    numbers = {"x": {"value": air.real, "unit": "m/s"}, "y": {"value": air.imag, "unit": "m/s"}}
    said = {"effects": [{"id": "wind", "parameters": numbers}]}
    found, silent = wind(said, [path]), wind({"effects": []}, [path])
    assert found == pytest.approx({"anemometer": 2.0, "named": 1.5, "beside": 10.0})
    assert "1.50 m/s, 10 deg beside" in ship_lines({WINDY: found})[0]
    assert "no wind is named, but nothing" in ship_lines({WINDY: silent})[0]
