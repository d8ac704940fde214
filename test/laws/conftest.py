"""The referee of the laws: Newton's law in world axes, solved by scipy to twelve digits."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest


@pytest.fixture(scope="session")
def newton(lily: SimpleNamespace) -> Callable[..., Any]:
    """Function of (row, fractions, seconds): Lily's state (8,) after `seconds` at constant commands.

    `row` and the result are x, y, z, yaw, surge, sway, heave, yaw rate. In between, velocities are those of
    the world: m V' = F - k |V| V, I r' = N - Cr |r| r, without any term of a turning frame.
    """
    from scipy.integrate import solve_ivp

    def rate(force: Any) -> Callable[..., Any]:
        left, right, up = force

        def of(_: float, s: Any) -> Any:
            yaw, velocity, turn = s[3], s[4:7], s[7]
            drag = lily.drag * math.sqrt(velocity @ velocity)
            thrust = np.array([(left + right) * math.cos(yaw), (left + right) * math.sin(yaw), up])
            torque = lily.lever * (right - left) - lily.yaw_drag * abs(turn) * turn
            return np.concatenate([velocity, [turn], (thrust - drag * velocity) / lily.mass, [torque / lily.inertia]])

        return of

    def turned(row: Any, angle: float) -> Any:
        cosine, sine = math.cos(angle), math.sin(angle)
        result = np.array(row[:8])
        result[4] = row[4] * cosine - row[5] * sine
        result[5] = row[4] * sine + row[5] * cosine
        return result

    def solve(row: Any, fractions: Any, seconds: float) -> Any:
        force = np.asarray(fractions) * [lily.thrust, lily.thrust, lily.pump]
        done = solve_ivp(rate(force), (0.0, seconds), turned(row, row[3]), method="DOP853", rtol=1e-12, atol=1e-14)
        return turned(done.y[:, -1], -done.y[3, -1])

    return solve
