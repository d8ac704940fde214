"""Expected readings, and their derivatives by the state."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.filter.layout import (
    ACCEL_X,
    ACCEL_Y,
    ACCEL_Z,
    BIAS_GYRO,
    BIAS_X,
    BIAS_Y,
    BIAS_Z,
    COMPASS,
    COSINE,
    GYRO,
    HORIZONTAL,
    HR,
    HU,
    HV,
    HX,
    HY,
    HYAW,
    OFFSET,
    POSE_X,
    POSE_Y,
    POSE_YAW,
    POSE_Z,
    PRESSURE,
    PRESSURE_OFFSET,
    PRESSURE_RATE,
    SCALE,
    SINE,
    VELOCITY_U,
    VELOCITY_V,
    VELOCITY_W,
    VERTICAL,
    VFZ,
    VW,
    VZ,
)  # fmt: skip
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.pressure import GRAVITY, PASCAL_PER_METRE, SURFACE_PRESSURE
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z

# mypy: disable-error-code="no-any-return"


@kernel
def expected(
    kind: int, when: tuple[float, float, float, float], row: Floats, rates: tuple[Floats, Floats], sensor: Floats,
    water: Floats,
) -> float:  # fmt: skip
    """Value that a reading of this kind would have without noise; `row` is the state at the grid point.

    when: stamp of the reading [s], time after the grid point [s], distance from it [s], and its side. rates: the mean
    rate of the state on both sides of the grid point, and the difference of the rate behind it and before it.
    """
    stamp, after, apart, side = when
    rate, leap = rates
    half = 0.5 * after * after
    if kind <= POSE_Y:
        sine, cosine = sine_cosine(row[YAW])
        forward, left = rate[SURGE] - row[SWAY] * row[YAW_RATE], rate[SWAY] + row[SURGE] * row[YAW_RATE]
        if kind == POSE_X:
            ahead = after * (row[SURGE] * cosine - row[SWAY] * sine) + half * (forward * cosine - left * sine)
            return sensor[SCALE] * (row[X] + ahead)
        ahead = after * (row[SURGE] * sine + row[SWAY] * cosine) + half * (forward * sine + left * cosine)
        return sensor[SCALE] * (row[Y] + ahead)
    if kind == POSE_Z or kind == PRESSURE:  # noqa: PLR1714
        height = row[Z] + after * row[HEAVE] + half * rate[HEAVE]
        if kind == POSE_Z:
            return sensor[SCALE] * height
        return SURFACE_PRESSURE - PASCAL_PER_METRE * height + sensor[PRESSURE_OFFSET] + sensor[PRESSURE_RATE] * stamp
    if kind == POSE_YAW or kind == COMPASS:  # noqa: PLR1714
        yaw = row[YAW] + after * row[YAW_RATE] + half * rate[YAW_RATE]
        if kind == POSE_YAW:
            return yaw
        straight = yaw + sensor[OFFSET]
        if sensor[SINE] == 0.0 and sensor[COSINE] == 0.0:  # the usual case
            return straight
        return straight + sensor[SINE] * math.sin(yaw) + sensor[COSINE] * math.cos(yaw)
    if kind == GYRO:
        return row[YAW_RATE] + after * rate[YAW_RATE] + 0.5 * apart * leap[YAW_RATE] + sensor[BIAS_GYRO]
    if kind == ACCEL_X:
        return rate[SURGE] + 0.5 * side * leap[SURGE] - row[SWAY] * row[YAW_RATE] + sensor[BIAS_X]
    if kind == ACCEL_Y:
        return rate[SWAY] + 0.5 * side * leap[SWAY] + row[SURGE] * row[YAW_RATE] + sensor[BIAS_Y]
    if kind == ACCEL_Z:
        return rate[HEAVE] + 0.5 * side * leap[HEAVE] + GRAVITY + sensor[BIAS_Z]
    return water[kind - VELOCITY_U]


@kernel
def sensitivity(kind: int, after: float, row: Floats, sensor: Floats, across: Floats, seen: Floats) -> None:
    """Write the derivative of a horizontal reading by the horizontal state into `seen` (HORIZONTAL,)."""
    for column in range(HORIZONTAL):
        seen[column] = 0.0
    sine, cosine = sine_cosine(row[YAW])
    if kind == POSE_X:
        seen[HX] = sensor[SCALE]
        seen[HYAW] = -sensor[SCALE] * after * (row[SURGE] * sine + row[SWAY] * cosine)
        seen[HU], seen[HV] = sensor[SCALE] * after * cosine, -sensor[SCALE] * after * sine
    elif kind == POSE_Y:
        seen[HY] = sensor[SCALE]
        seen[HYAW] = sensor[SCALE] * after * (row[SURGE] * cosine - row[SWAY] * sine)
        seen[HU], seen[HV] = sensor[SCALE] * after * sine, sensor[SCALE] * after * cosine
    elif kind == POSE_YAW:
        seen[HYAW], seen[HR] = 1.0, after
    elif kind == COMPASS:
        slope = 1.0 + sensor[SINE] * cosine - sensor[COSINE] * sine
        seen[HYAW], seen[HR] = slope, slope * after
    elif kind == GYRO:
        for column in range(HORIZONTAL):
            seen[column] = after * across[HR * HORIZONTAL + column]
        seen[HR] += 1.0
    elif kind == ACCEL_X:
        for column in range(HORIZONTAL):
            seen[column] = across[HU * HORIZONTAL + column]
        seen[HV] -= row[YAW_RATE]
        seen[HR] -= row[SWAY]
    elif kind == ACCEL_Y:
        for column in range(HORIZONTAL):
            seen[column] = across[HV * HORIZONTAL + column]
        seen[HU] += row[YAW_RATE]
        seen[HR] += row[SURGE]
    elif kind == VELOCITY_U:
        seen[HU] = 1.0
    elif kind == VELOCITY_V:
        seen[HV] = 1.0


@kernel
def sensitivity_upright(kind: int, after: float, sensor: Floats, upright: Floats, seen: Floats) -> None:
    """Write the derivative of a vertical reading by the vertical state into `seen` (VERTICAL,)."""
    for column in range(VERTICAL):
        seen[column] = 0.0
    if kind == POSE_Z:
        seen[VZ], seen[VW] = sensor[SCALE], sensor[SCALE] * after
    elif kind == PRESSURE:
        seen[VZ], seen[VW] = -PASCAL_PER_METRE, -PASCAL_PER_METRE * after
    elif kind == ACCEL_Z:
        seen[VZ], seen[VW] = upright[VW * VERTICAL + VZ], upright[VW * VERTICAL + VW]
        seen[VFZ] = upright[VW * VERTICAL + VFZ]
    else:
        seen[VW] = 1.0


@kernel
def is_upright(kind: int) -> bool:
    """Tell whether a reading of this kind belongs to the vertical block."""
    return kind == POSE_Z or kind == PRESSURE or kind == ACCEL_Z or kind == VELOCITY_W  # noqa: PLR1714


@kernel
def deviation(kind: int, value: float, expected: float) -> float:
    """Reading less expectation, angles by the shorter way."""
    difference = value - expected
    if kind == POSE_YAW or kind == COMPASS:  # noqa: PLR1714
        difference -= 2.0 * math.pi * math.floor(difference / (2.0 * math.pi) + 0.5)
    return difference
