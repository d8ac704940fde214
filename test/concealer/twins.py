"""Entries of the table that a recording cannot tell from what was hidden in it.

Two laws pull differently along the track; what the second leaves unexplained, with the platform's own parameters
refitted, shows against the water's random force by half the integral of its square over that force's spectral
density at low frequency, 2 T rms^2, in nats. Below 3 nats the second law is as right an answer as the first.
"""

from __future__ import annotations

import numpy as np

from concealer import layout as at
from concealer.fluid import current
from concealer.layout import FloatArray
from concealer.scene import Secret

TOO_FEW = 3.0  # nats
EVERY = 5  # rows: 0.1 s
CALMEST, SHORTEST = 0.001, 2.0  # of full thrust, s: cameras and clocks hide as much in water without random forces


def remainder(force: FloatArray, *regressors: FloatArray) -> FloatArray:
    """(n,) what a least-squares fit of the regressors leaves of a force."""
    base = np.stack(regressors, axis=1)
    return np.asarray(force - base @ np.linalg.lstsq(base, force, rcond=None)[0])


def nats(left: FloatArray, noise: float, correlation: float) -> float:
    """Evidence (n rows of EVERY * ROW_TIME) that a force which is left unexplained gives [N]."""
    rms, time = max(noise, CALMEST) * at.FULL_THRUST, max(correlation, SHORTEST if noise < CALMEST else 0.0)
    return float(0.5 * np.sum(left**2) * EVERY * at.ROW_TIME / (2.0 * time * rms**2))


def _curved_drag(rows: FloatArray, commands: FloatArray, force: FloatArray) -> FloatArray:
    """What linear drag, quadratic drag and a gain of the thrust leave of a surge force."""
    u = rows[:, at.U]
    speed = np.sqrt(np.sum(rows[:, [at.U, at.V, at.W]] ** 2, axis=1))
    return remainder(force, u, speed * u, commands[:, :2].sum(axis=1))


def _drag_against(p: FloatArray, rows: FloatArray, water: FloatArray, other: FloatArray) -> FloatArray:
    """(2n,) difference of the drag [N, world] under two velocities of the water (n, 2)."""
    out = []
    cos, sin = np.cos(rows[:, at.YAW]), np.sin(rows[:, at.YAW])
    ground = np.stack([cos * rows[:, at.U] - sin * rows[:, at.V], sin * rows[:, at.U] + cos * rows[:, at.V]], axis=1)
    for flow in (water, other):
        through = ground - flow
        speed = np.sqrt(np.sum(through**2, axis=1) + rows[:, at.W] ** 2)
        out.append(-p[at.DRAG] * speed[:, None] * through)
    return np.asarray((out[0] - out[1]).ravel())


def twins(
    secret: Secret, p: FloatArray, rows: FloatArray, commands: FloatArray, water: tuple[float, float]
) -> list[str]:
    """Names for a secret of a robot: numbers, trajectory (rows, ROW), commands (ticks, 3), noise and its time."""
    some = rows[:-1:EVERY]
    u = some[:, at.U]
    left: dict[str, FloatArray] = {}
    if p[at.POWER_THREE_HALVES]:
        left["linear_drag"] = _curved_drag(some, commands, p[at.POWER_THREE_HALVES] * np.sqrt(np.abs(u)) * u)
    if p[at.CUBIC]:
        left["linear_drag"] = _curved_drag(some, commands, p[at.CUBIC] * u**3)
    if secret.id == "sheared_current":
        flow = np.array([current(p, row, 0.0) for row in some])
        left["steady_current"] = _drag_against(p, some, flow, np.broadcast_to(flow.mean(axis=0), flow.shape))
    return [name for name, force in left.items() if nats(force, *water) < TOO_FEW]
