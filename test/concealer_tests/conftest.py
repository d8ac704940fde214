"""Makes the Concealer importable, and hands out runs of its physics."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FOLDER = str(Path(__file__).resolve().parents[1])
if FOLDER not in sys.path:
    sys.path.append(FOLDER)


@pytest.fixture(scope="session")
def run() -> Callable[..., Any]:
    """Function of (command (3,) or (ticks, 3), seconds, places, start by place): trajectory (rows, ROW) of one robot.

    `places` maps names of layout.py to values; the tank is wide and 50 m deep, the start 10 m deep at rest.
    """
    from concealer import layout as at
    from concealer.physics import replay, still

    def make(command: Any, seconds: float, start: Any = (), **places: float) -> Any:
        p = at.nominal_robot()[None]
        p[0, [at.HALF_X, at.HALF_Y, at.FLOOR, at.DURATION]] = 100.0, 100.0, -50.0, seconds
        for name, value in places.items():
            p[0, getattr(at, name.upper())] = value
        s = np.zeros((1, at.STATE))
        s[0, at.Z] = -10.0
        for place, value in dict(start).items():
            s[0, place] = value
        ticks = round(seconds / at.TICK)
        commands = np.zeros((ticks, 1, 3))
        commands[:, 0] = command
        return replay(p, s, commands, still(1, ticks), 0)[:, 0]

    return make


@pytest.fixture(scope="session")
def numbers() -> dict[str, Any]:
    """The registered prior with recordings of a minute."""
    from concealer import prior

    return prior.load() | {"duration": 60.0}


@pytest.fixture(scope="session")
def trial(tmp_path_factory: pytest.TempPathFactory, numbers: dict[str, Any]) -> Path:
    """A sealed trial of four short recordings."""
    from concealer.conceal import conceal
    from concealer.prior import Wish

    out = tmp_path_factory.mktemp("trial") / "t"
    assert list(conceal(out, numbers, 7, range(4), Wish())) == ["r0000", "r0001", "r0002", "r0003"]
    return out
