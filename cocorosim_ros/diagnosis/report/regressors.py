"""Regressors of a residual by the names of the contract: values along a recording, and units."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from cocorosim_ros.diagnosis.findings import ResidualForce
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.unit_algebra import Powers, multiplied, powers_of, unit_of

EQUATIONS = {"surge": (0, "N"), "sway": (1, "N"), "heave": (2, "N"), "yaw": (3, "N m")}
"""Column of the residual force and its unit."""
_IN_WORLD = {"world_x": 0, "world_y": 1, "world_z": 2}
UNITS = {
    "x": "m", "y": "m", "z": "m", "t": "s", "u": "m/s", "v": "m/s", "w": "m/s", "r": "rad/s", "speed": "m/s",
    "yaw": "rad", "thrust": "N", "pump": "N", "yaw_command": "N m", "pump_rate": "N/s",
    "neighbour_distance": "m", "wall_distance": "m",
}  # fmt: skip
"""Units of the regressors that are no pure numbers."""
_FACTOR = re.compile(r"\|?([a-z_0-9]+)\|?(?:\^(-?[0-9.]+))?")
_OF_WORLD = re.compile(r"(.+) \((world_[xyz])\)")


def law_of(equation: str, regressor: str) -> tuple[str, str]:
    """Split a law into equation and regressor; 'x (world_x)' beside an equation of the body means x in world_x."""
    match = _OF_WORLD.fullmatch(regressor)
    return (match[2], match[1]) if match else (equation, regressor)


def residual_of(equation: str, residual: ResidualForce) -> tuple[Floats, Floats, str] | None:
    """Residual, its standard deviation (n,) and unit for an equation of motion; None for a stream's equation."""
    if equation in EQUATIONS:
        column, unit = EQUATIONS[equation]
        return residual.force[:, column], residual.spread[:, column], unit
    if equation not in _IN_WORLD:
        return None
    yaw = residual.place[:, 3]
    along, across = residual.force[:, 0], residual.force[:, 1]
    turned = {
        "world_x": along * np.cos(yaw) - across * np.sin(yaw),
        "world_y": along * np.sin(yaw) + across * np.cos(yaw),
        "world_z": residual.force[:, 2],
    }
    return turned[equation], residual.spread[:, _IN_WORLD[equation]], "N"


def regressor_of(name: str, residual: ResidualForce) -> tuple[Floats, str] | None:
    """Values (n,) of a regressor and its SI unit; None where the recording's residual does not hold it."""
    known = _series(residual)
    values = np.ones_like(residual.time)
    powers: Powers = {}
    for factor in name.replace(" ", "").split("*"):
        match = _FACTOR.fullmatch(factor)
        if match is None or match[1] not in known:
            return None
        exponent = float(match[2] or 1.0)
        base = known[match[1]]
        base = np.abs(base) if "|" in factor or exponent % 1.0 else base
        with np.errstate(divide="ignore", invalid="ignore"):
            values = values * base**exponent
        powers = multiplied(powers, powers_of(UNITS.get(match[1], "1")), exponent)
    return values, unit_of(powers)


def _series(residual: ResidualForce) -> Mapping[str, Floats]:
    x, y, z, yaw = residual.place.T
    u, v, w, r = residual.velocity.T
    return {
        "1": np.ones_like(x),
        **{"x": x, "y": y, "z": z, "t": residual.time, "u": u, "v": v, "w": w, "r": r},
        "yaw": yaw,
        "speed": np.sqrt(u**2 + v**2 + w**2),
        "sin_yaw": np.sin(yaw),
        "cos_yaw": np.cos(yaw),
        **residual.regressors,
    }
