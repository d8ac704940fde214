"""Arm three, an actuator by itself: how well the forms of a platform file hold the published table of a thruster."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import least_squares

FOLDER, FORCE, STOP, FULL = "t200_thruster", 5, 1500.0, 400.0  # column of the force; PWM [us]
KEPT = 10  # every tenth reading, 40 us apart, makes the curve; it is tried on all others
STANDARD_GRAVITY = 9.80665  # m/s^2: the table has kilograms
LARGEST, FORMS = "largest force", ("linear", "square", "linear with a dead band", "table")


def thruster_figures(data: Path) -> dict[str, dict[str, float]]:
    """By supply voltage, the largest force and what each form errs by [N]; nothing where the table is not there."""
    return {path.stem: _errors(path) for path in sorted((data / FOLDER).glob("*.csv"))}


def thruster_rows(found: dict[str, dict[str, float]]) -> list[str]:
    """Rows of the page."""
    return [
        f"| {name} | {told[LARGEST]:.1f} | {' | '.join(f'{told[form]:.2f}' for form in FORMS)} |"
        for name, told in found.items()
    ]


def _errors(path: Path) -> dict[str, float]:
    """Largest force of the table, and root mean square of force less table on readings that made no curve [N]."""
    pulse, force = np.genfromtxt(path, delimiter=",", skip_header=1, usecols=(0, FORCE)).T
    command, force = (pulse - STOP) / FULL, STANDARD_GRAVITY * force
    made = np.zeros(len(command), dtype=bool)
    made[::KEPT] = True
    found = {LARGEST: float(np.abs(force).max())}
    for form in FORMS:
        told = forces(fitted(form, command[made], force[made]), command[~made])
        found[form] = float(np.sqrt(np.mean((told - force[~made]) ** 2)))
    return found


def fitted(form: str, command: Any, force: Any) -> Any:
    """A thruster of a platform whose curve has this form, by least squares; a table goes through all its points."""
    from cocorosim_ros.scenario.parts.thrust_curve import ThrustCurve

    ahead, astern = max(float(force[-1]), 1e-3), max(-float(force[0]), 1e-3)
    if form == "table":
        quiet = np.where(force * command > 0.0, force, 0.0)  # at rest single readings have the other sign
        return _thruster(ahead, astern, ThrustCurve("table", None, tuple(command), tuple(quiet)))

    def made(numbers: Any) -> Any:
        band = float(numbers[2]) if form == FORMS[2] else None
        return _thruster(float(numbers[0]), float(numbers[1]), ThrustCurve(form.split(maxsplit=1)[0], band))

    def off(numbers: Any) -> Any:
        return forces(made(numbers), command) - force

    return made(least_squares(off, [ahead, astern, 0.05], bounds=([1e-3, 1e-3, 0.0], [1e3, 1e3, 0.5])).x)


@lru_cache(maxsize=1)
def _rov() -> Any:
    from cocorosim_ros.scenario.parts.platform import load_platform

    return load_platform("bluerov2_heavy")


def _thruster(ahead: float, astern: float, curve: Any) -> Any:
    from cocorosim_ros.scenario.parts.vehicle_parts import Thruster

    platform = _rov()
    first = next(each for each in platform.actuators if isinstance(each, Thruster))
    return replace(platform, actuators=(replace(first, maximum=ahead, maximum_reverse=astern, curve=curve),))


def forces(platform: Any, commands: Any) -> Any:
    """What the only thruster of a platform gives at each command (n,) [N]."""
    from cocorosim_ros.world.vehicle_model.curves import forces_at

    return forces_at(platform, commands[:, None])[:, 0]
