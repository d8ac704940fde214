"""Fits a platform to a calibration run by least squares on the free-run trajectory.

The robot starts at rest where it was seen first; from there on the model runs free under the recorded commands, and
the differences to all recorded poses are made small. Mass, geometry and the density of water are taken as known:
drag, inertia and thrust are found relative to the mass. The 95 % intervals follow from the curvature of the sum of
squares and the scatter of the residuals, each channel (horizontal, depth, heading) weighted by its own; they assume
errors of measurement that are independent and a model that is right.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import t as student

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.study.calibration.calibration_run import CalibrationRun
from cocorosim_ros.study.calibration.free_run import ACCURATE, free_run
from cocorosim_ros.world.terms.curve import is_thruster
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS, YAW_INERTIA, Vehicles

FIRST_SCATTER = np.array([0.01, 0.01, 0.01, 0.02])  # m, m, m, rad: before the residuals are known
SMALLEST_SCATTER = np.array([1e-7, 1e-7, 1e-7, 1e-7])  # keeps recordings without noise from infinite weights
UNSEEN = 1e-6  # a parameter that moves no pose by this share of the scatter is not shown
ROUNDS = 3


@dataclass(frozen=True)
class Fitted:
    """One number with its 95 % interval, SI units; `nominal` is that of the platform."""

    name: str
    unit: str
    nominal: float
    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Fit:
    """The numbers, what the recording does not show of them, and what is left over: rms (4,) [m, m, m, rad]."""

    numbers: tuple[Fitted, ...]
    not_shown: tuple[str, ...]
    scatter: tuple[float, ...]


class _Model:
    """The free run as a function of scaled parameters: factors of the nominal, and trim in tenths of the pump."""

    def __init__(self, platform: Platform, run: CalibrationRun) -> None:
        self._run = run
        self._base = build_vehicles([platform])
        row = self._base.parameters[0, 0]
        pumps, curves = self._base.is_pump[0, 0], self._base.actuator_curve[0, 0]
        # What is told an angle has a limit too, which is no force.
        self._thrusters = np.array([part for part in range(len(pumps)) if is_thruster(pumps, curves, part)], np.int64)
        self._pumps = np.flatnonzero(pumps)
        self.names = ["thrust_gain", "drag", "yaw_drag", "inertia"]
        self.units = ["1", "kg/m", "N m s^2", "kg m^2"]
        self.nominal = [1.0, row[PARAMETER_COLUMNS["drag"]], row[PARAMETER_COLUMNS["yaw_drag"]], row[YAW_INERTIA]]
        self.scale = list(self.nominal)
        if len(self._pumps):
            self.names += ["buoyancy_gain", "buoyancy_trim"]
            self.units += ["1", "N"]
            self.nominal += [1.0, row[PARAMETER_COLUMNS["net_buoyancy"]]]
            self.scale += [1.0, 0.1 * float(self._base.actuator_limit[0, 0, self._pumps[0], 0])]
        self.start = np.array(self.nominal) / np.array(self.scale)

    def vehicles(self, scaled: Floats) -> Vehicles:
        """The robot with these parameters."""
        values = scaled * np.array(self.scale)
        parameters, limit = self._base.parameters.copy(), self._base.actuator_limit.copy()
        row = parameters[0, 0]
        limit[0, 0, self._thrusters] *= values[0]
        row[PARAMETER_COLUMNS["drag"]] = values[1]
        row[PARAMETER_COLUMNS["yaw_drag"]] = values[2]
        row[YAW_INERTIA] = values[3]
        if len(self._pumps):
            limit[0, 0, self._pumps] *= values[4]
            row[PARAMETER_COLUMNS["net_buoyancy"]] = values[5]
        return self._base._replace(parameters=parameters, actuator_limit=limit)

    def residuals(self, scaled: Floats) -> Floats:
        """(poses, 4) model less recording [m, m, m, rad]."""
        run = self._run
        path = free_run(self.vehicles(scaled), run.poses[0], run.moments, run.commands, ACCURATE)[run.measured]
        difference = path - run.poses
        difference[:, 3] = (difference[:, 3] + np.pi) % (2.0 * np.pi) - np.pi
        return difference


def fit_platform(platform: Platform, run: CalibrationRun) -> Fit:
    """The parameters of `platform` that make its free run follow the recorded one.

    Raises CocorosimError if nothing moves in the recording or no parameters can be found.
    """
    model = _Model(platform, run)
    scatter, shown = FIRST_SCATTER, _shown(model)
    if not shown.any():
        raise CocorosimError(
            f"'{run.robot}' was never commanded to move, so nothing can be fitted; see calibration_run."
        )
    scaled = model.start.copy()
    for _ in range(ROUNDS):
        scaled = _improved(model, scaled, shown, scatter)
        left = model.residuals(scaled)
        scatter = np.maximum(np.sqrt(np.mean(left**2, axis=0)), SMALLEST_SCATTER)
    numbers = _with_intervals(model, scaled, shown, scatter)
    missing = tuple(name for name, seen in zip(model.names, shown, strict=True) if not seen)
    return Fit(numbers, missing, tuple(np.sqrt(np.mean(left**2, axis=0)).tolist()))


def _improved(model: _Model, scaled: Floats, shown: Flags, scatter: Floats) -> Floats:
    """The scaled parameters that make the residuals over `scatter` (4,) smallest."""
    result = least_squares(
        lambda part: (model.residuals(_filled(scaled, shown, part)) / scatter).ravel(),
        scaled[shown],
        bounds=(np.where(_is_signed(model, shown), -np.inf, 1e-3), np.inf),
        x_scale=np.maximum(np.abs(model.start[shown]), 0.1),
    )
    return _filled(scaled, shown, result.x)


def _filled(scaled: Floats, shown: Flags, part: Floats) -> Floats:
    whole = scaled.copy()
    whole[shown] = part
    return whole


def _is_signed(model: _Model, shown: Flags) -> Flags:
    return np.array([name == "buoyancy_trim" for name in model.names])[shown]


def _slopes(model: _Model, scaled: Floats, scatter: Floats) -> Floats:
    """(residuals, parameters) change of the weighted residuals per scaled parameter, by central differences."""
    columns = []
    for index in range(len(scaled)):
        step = np.zeros(len(scaled))
        step[index] = 1e-4
        change = model.residuals(scaled + step) - model.residuals(scaled - step)
        columns.append((change / scatter).ravel() / 2e-4)
    return np.array(columns).T


def _shown(model: _Model) -> Flags:
    """Which parameters move the free run at all."""
    slopes = _slopes(model, model.start, FIRST_SCATTER)
    return np.asarray(np.abs(slopes).max(axis=0) > UNSEEN)


def _with_intervals(model: _Model, scaled: Floats, shown: Flags, scatter: Floats) -> tuple[Fitted, ...]:
    slopes = _slopes(model, scaled, scatter)[:, shown]
    freedom = max(1, len(slopes) - slopes.shape[1])
    spread = np.sqrt(np.diag(np.linalg.pinv(slopes.T @ slopes))) * student.ppf(0.975, freedom)
    fitted = []
    for column, index in enumerate(np.flatnonzero(shown)):
        value, reach = scaled[index] * model.scale[index], spread[column] * abs(model.scale[index])
        name, unit, nominal = model.names[index], model.units[index], float(model.nominal[index])
        fitted.append(Fitted(name, unit, nominal, float(value), float(value - reach), float(value + reach)))
    return tuple(fitted)
