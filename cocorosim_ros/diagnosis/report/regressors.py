"""Data of a picture of the missing force: the force missing from an equation, and the regressors it may follow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.findings import Located, ResidualForce
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.equations import EQUATION
from cocorosim_ros.world.terms.regressors import REGRESSOR, values_along

OF_BODY = ("surge", "sway", "heave", "yaw")
"""The equations whose residual force is known as such: its columns."""
_SPREAD = {"world_x": 0, "world_y": 1, "world_z": 2} | {name: column for column, name in enumerate(OF_BODY)}


class Along(NamedTuple):
    """Values (n,) along a recording and their SI unit."""

    values: Floats
    unit: str


class Missing(NamedTuple):
    """Force or moment missing from an equation (n,), its standard deviation (n,) and the unit of both."""

    values: Floats
    spread: Floats
    unit: str


@dataclass(frozen=True)
class SaidLaw:
    """The equation of a finding and what it is in proportion to, by their own names."""

    equation: str
    regressor: str


def said_law(located: Located) -> SaidLaw:
    """Equation and regressor by their own names; diagnosis.json writes 'x (world_x)' beside an equation of the body."""
    if located.law is None or located.law.topic is not None:
        return SaidLaw(located.equation, located.regressor)
    return SaidLaw(located.law.of, located.law.product.text)


def residual_of(equation: str, residual: ResidualForce) -> Missing | None:
    """Force or moment missing from an equation of motion; None for a stream's equation."""
    if equation not in EQUATION:
        return None
    yaw = residual.place[:, YAW]
    along, across, upwards, moment = residual.force.T
    turned = {
        "world_x": along * np.cos(yaw) - across * np.sin(yaw),
        "world_y": along * np.sin(yaw) + across * np.cos(yaw),
        "world_z": upwards,
        **dict(zip(OF_BODY, (along, across, upwards, moment), strict=True)),
    }
    return Missing(turned[equation], residual.spread[:, _SPREAD[equation]], EQUATION[equation].unit)


def regressor_of(name: str, residual: ResidualForce) -> Along:
    """Values of a regressor that does not swing in time, or of the heading, at the moments of a residual force."""
    regressor = REGRESSOR[name]
    return Along(regressor.along(residual.course, np.zeros(len(residual.time))), regressor.unit)


def followed_by(located: Located, residual: ResidualForce) -> Along | None:
    """Values of what a law of motion is in proportion to, the time for a constant; None for all other findings."""
    if located.law is None or located.law.topic is not None:
        return None
    product = located.law.product
    if not product.factors:
        return Along(residual.time, "s")
    with np.errstate(divide="ignore", invalid="ignore"):
        return Along(product.along(values_along(residual.course, *located.swing)), product.unit)
