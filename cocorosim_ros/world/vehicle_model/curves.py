"""From the curves of a platform's actuators to the rows that compiled loops read."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.parts.steering import Azimuth, Rudder
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator, Thruster
from cocorosim_ros.world.terms.curve import ANGLE, AZIMUTH, LINEAR, SQUARE, TABLE, thrust_share, turn_thrusts

_FORMS = {"linear": LINEAR, "square": SQUARE, "table": TABLE}
_PLAIN = (LINEAR, 0.0)


def build_curves(platforms: Sequence[Platform]) -> Floats:
    """(robots, actuators, columns) the curves of one robot per platform; without columns where all are plain."""
    actuators = max(len(platform.actuators) for platform in platforms)
    rows = [[_row(actuator, platform) for actuator in platform.actuators] for platform in platforms]
    widths = [len(row) for robot in rows for row in robot if row != _PLAIN]
    curves = np.zeros((len(platforms), actuators, max(widths, default=0)))
    if widths:
        for robot, own in enumerate(rows):
            for actuator, row in enumerate(own):
                curves[robot, actuator, : len(row)] = row
    return curves


def forces_at(platform: Platform, command: Floats) -> Floats:
    """(n, actuators) what each actuator delivers at commands (n, actuators), fractions in -1..1 [N].

    An azimuth has the part of its thruster's force to the left, a rudder its angle [rad],
    a sliding mass its way [m].
    """
    curves = build_curves([platform])[0]
    share = command.copy()
    if curves.shape[1] > 0:
        _into_shares(share, curves)
    forward, reverse = platform.actuator_limits().T
    force: Floats = np.where(share > 0.0, share * forward, share * reverse)
    if curves.shape[1] > 0:
        _turn_all(force, curves)
    return force


@kernel
def _into_shares(share: Floats, curves: Floats) -> None:
    for row in range(share.shape[0]):
        for actuator in range(share.shape[1]):
            share[row, actuator] = thrust_share(curves[actuator], share[row, actuator])


@kernel
def _turn_all(force: Floats, curves: Floats) -> None:
    for row in range(force.shape[0]):
        turn_thrusts(curves, force[row])


def _row(actuator: Actuator, platform: Platform) -> tuple[float, ...]:
    if isinstance(actuator, (Rudder, Fin, SlidingMass)):
        return ANGLE, 0.0
    if isinstance(actuator, Azimuth):
        return AZIMUTH, float(platform.actuator_names.index(actuator.thruster))
    if not isinstance(actuator, Thruster) or actuator.curve is None:
        return _PLAIN
    curve = actuator.curve
    if curve.form != "table":
        return _FORMS[curve.form], curve.dead_band or 0.0
    shares = [force / (actuator.maximum if force >= 0.0 else actuator.reverse) for _, force in curve.points]
    return TABLE, float(len(shares)), *(command for command, _ in curve.points), *shares
