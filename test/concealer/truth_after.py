"""Parameters that only the trajectory defines: the interface's law in place of the one that was hidden."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.optimize import least_squares

from concealer import layout as at
from concealer.drives import emerged, left_in_battery, lost_against
from concealer.fluid import current, tether
from concealer.layout import FloatArray
from concealer.scene import Secret

Parameters = dict[str, float | str]
After = Callable[[FloatArray, FloatArray, FloatArray], Parameters]
EVERY = 25  # rows: twice a second


def _plane(value: FloatArray, *regressors: FloatArray) -> FloatArray:
    """Least-squares coefficients of a constant and the regressors."""
    return np.asarray(np.linalg.lstsq(np.stack([np.ones_like(value), *regressors], axis=1), value, rcond=None)[0])


def _slope(x: FloatArray, y: FloatArray, weight: FloatArray, otherwise: float) -> float:
    """Least-squares slope of the straight line through the origin; `otherwise` if no x counts."""
    felt = float((weight * x * x).sum())
    return float((weight * x * y).sum()) / felt if felt > 0.0 else float(otherwise)


def sheared_current(p: FloatArray, rows: FloatArray, _commands: FloatArray) -> Parameters:
    """The plane through the water's velocity at the places visited; only directions that were hidden."""
    water = np.array([current(p, row, 0.0) for row in rows[::EVERY]])
    x, y, z = rows[::EVERY, : at.Z + 1].T
    found: Parameters = {"x": float(p[at.CURRENT_X]), "y": float(p[at.CURRENT_Y])}
    laws = (
        (at.SHEAR_XY, 0, y, "dx_dy"),
        (at.SHEAR_XZ, 0, z, "dx_dz"),
        (at.SHEAR_YX, 1, x, "dy_dx"),
        (at.SHEAR_YZ, 1, z, "dy_dz"),
    )  # fmt: skip
    for place, axis, along, name in laws:
        found[name] = 0.0
        if p[place] != 0.0:
            constant, slope = _plane(water[:, axis], along)
            found["xy"[axis]], found[name] = float(constant), float(slope)
    return found


def tether_line(p: FloatArray, rows: FloatArray, _commands: FloatArray) -> Parameters:
    """Stiffness and place of the straight spring that pulls most alike along the track."""
    some = rows[::EVERY]
    pull = np.array([tether(p, row) for row in some])
    one, none = np.ones(len(some)), np.zeros(len(some))
    left = np.stack([np.r_[-some[:, at.X], -some[:, at.Y]], np.r_[one, none], np.r_[none, one]], axis=1)
    k, kx, ky = np.linalg.lstsq(left, pull.T.ravel(), rcond=None)[0]
    return {"stiffness": float(k), "x": float(kx / k), "y": float(ky / k)}


def advance_loss(p: FloatArray, rows: FloatArray, commands: FloatArray) -> Parameters:
    """Slope of the straight line through the thrust curve at the run's speeds, weighted by the thrust.

    That at rest if nothing was ever driven under way.
    """
    ticks = rows[: len(commands) * 5 : 5]
    force = commands[:, :2].sum(axis=1)
    a = ticks[:, at.U] * np.sign(force)
    loss = p[at.ADVANCE] * a * (1.0 + p[at.ADVANCE_CURVE] * np.abs(a))
    return {"slope": _slope(a, loss, force**2, p[at.ADVANCE])}


def crashback_loss(p: FloatArray, rows: FloatArray, commands: FloatArray) -> Parameters:
    """Slope of the straight line through what is lost at the speeds against the thrust, weighted by the thrust.

    That at rest if nothing ever went against the thrust.
    """
    ticks = rows[: len(commands) * 5 : 5]
    force = commands[:, :2].sum(axis=1)
    a = -ticks[:, at.U] * np.sign(force)
    loss = np.array([lost_against(p, each) for each in a])
    return {"slope": _slope(a, loss, force**2 * (a > 0.0), p[at.CRASHBACK])}


def thrust_curve(p: FloatArray, _rows: FloatArray, commands: FloatArray) -> Parameters:
    """Exponent of the power nearest to the parabola at the commands of the run; as hidden if none lies in between."""
    size = np.abs(commands[:, :2]).ravel()
    size = size[(size > 0.0) & (size < 1.0)]
    hidden = 1.0 + float(p[at.THRUST_BEND])
    if not len(size):
        return {"exponent": hidden}
    wanted = size * (1.0 + p[at.THRUST_BEND] * (size - 1.0))
    return {"exponent": float(least_squares(lambda n: size ** n[0] - wanted, [hidden]).x[0])}


def battery_sag(p: FloatArray, rows: FloatArray, _commands: FloatArray) -> Parameters:
    """What is lost at the end."""
    return {"fraction_lost": float(1.0 - left_in_battery(p, rows[-1, at.CHARGE]))}


def hull_compressibility(p: FloatArray, rows: FloatArray, _commands: FloatArray) -> Parameters:
    """Slope of the line through the surface at the depths visited."""
    depth = -rows[::EVERY, at.Z]
    loss = p[at.SHRINK] * depth / (1.0 + depth / p[at.SHRINK_SCALE])
    return {"gradient": float((depth * loss).sum() / (depth * depth).sum())}


def density_gradient(p: FloatArray, rows: FloatArray, _commands: FloatArray) -> Parameters:
    """Slope of the line through the surface at the depths visited."""
    depth = -rows[::EVERY, at.Z]
    gained = p[at.DENSER] * p[at.DENSER_SCALE] * -np.expm1(-depth / p[at.DENSER_SCALE])
    return {"gradient": float((depth * gained).sum() / (depth * depth).sum())}


def hull_emergence(p: FloatArray, rows: FloatArray, _commands: FloatArray) -> Parameters:
    """Share of a wall-sided hull that loses most alike at the depths visited; as hidden if it never came up."""
    z = rows[::EVERY, at.Z]
    walls = np.clip(0.5 + z / at.TALL, 0.0, 1.0)
    lost = p[at.EMERGE] * np.array([emerged(each) for each in z])
    return {"share": _slope(walls, lost, np.ones_like(walls), p[at.EMERGE])}


AFTER: dict[str, After] = {
    "sheared_current": sheared_current,
    "tether": tether_line,
    "advance_loss": advance_loss,
    "crashback_loss": crashback_loss,
    "thrust_curve": thrust_curve,
    "battery_sag": battery_sag,
    "hull_compressibility": hull_compressibility,
    "density_gradient": density_gradient,
    "hull_emergence": hull_emergence,
}


def settle(secret: Secret, p: FloatArray, rows: FloatArray, commands: FloatArray) -> None:
    """Fills in the parameters of a secret: numbers (SIZE,), trajectory (rows, ROW), commands (ticks, 3) of a robot."""
    if secret.id in AFTER:
        secret.parameters = AFTER[secret.id](p, rows, commands)
