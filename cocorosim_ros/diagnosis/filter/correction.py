"""Correction of the mean by a reading."""

from __future__ import annotations

from cocorosim_ros.diagnosis.filter.motion import PUSH_X, PUSH_Y, PUSH_YAW, PUSH_Z, Motion
from cocorosim_ros.diagnosis.filter.reading import is_upright
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.blocks import HFX, HFY, HGN, HGX, HGY, HN, HR, HU, HV, HX, HY, HYAW, VFZ, VGZ, VW, VZ
from cocorosim_ros.world.vehicle_model.vehicles import Body


@kernel
def correct(motion: Motion, body: Body, kind: int, gain: Floats, innovation: float) -> None:
    """Move the mean by gain times innovation."""
    row, gust = motion.row, motion.gust
    if is_upright(kind):
        row[Z] += gain[VZ] * innovation
        row[HEAVE] += gain[VW] * innovation
        body.parameters[PUSH_Z] += gain[VFZ] * innovation
        gust[2] += gain[VGZ] * innovation
        return
    row[X] += gain[HX] * innovation
    row[Y] += gain[HY] * innovation
    row[YAW] += gain[HYAW] * innovation
    row[SURGE] += gain[HU] * innovation
    row[SWAY] += gain[HV] * innovation
    row[YAW_RATE] += gain[HR] * innovation
    body.parameters[PUSH_X] += gain[HFX] * innovation
    body.parameters[PUSH_Y] += gain[HFY] * innovation
    body.parameters[PUSH_YAW] += gain[HN] * innovation
    gust[0] += gain[HGX] * innovation
    gust[1] += gain[HGY] * innovation
    gust[3] += gain[HGN] * innovation
