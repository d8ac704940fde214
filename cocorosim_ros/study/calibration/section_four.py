"""Section 4 of the paper done again: each number from the published measurements, with both ways of stepping time."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.study.calibration import published
from cocorosim_ros.study.calibration.free_run import ACCURATE, PAPER, Stepper, constant_run, moment_of
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS, YAW_INERTIA, Vehicles

AHEAD, TURNING = (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0)
LONG = 60.0  # s, many time constants


@dataclass(frozen=True)
class Row:
    """One number: what the paper says, what was measured, and ours with either integrator. None where there is none."""

    quantity: str
    unit: str
    paper: float | None
    measured: float | None
    paper_integrator: float | None
    accurate: float | None


def drag_coefficient() -> float:
    """rho A Cd / 2 [kg/m] = F / v^2, equation (6)."""
    return published.THRUST / published.TERMINAL_SPEED**2


def yaw_drag_coefficient() -> float:
    """Cr [N m s^2] = torque / yaw rate^2, equation (9)."""
    return published.TORQUE / published.TERMINAL_YAW_RATE**2


def pump_force(volume: float) -> float:
    """Buoyancy less weight [N, up positive] at `volume` [m^3], equation (4) with up positive."""
    return (published.WATER_DENSITY * volume - published.MASS) * published.GRAVITY


def lily(inertia: float) -> Vehicles:
    """One Lily with the numbers of this section and a moment of inertia [kg m^2]."""
    vehicles = build_vehicles([load_platform("lily")])
    row = vehicles.parameters[0, 0]
    row[PARAMETER_COLUMNS["drag"]] = drag_coefficient()
    row[PARAMETER_COLUMNS["yaw_drag"]] = yaw_drag_coefficient()
    row[YAW_INERTIA] = inertia
    return vehicles


def start_time(stepper: Stepper) -> float:
    """When Lily at full thrust from rest has come 10 cm [s]."""
    moments, path = constant_run(lily(published.PRINTED_INERTIA), AHEAD, 10.0, stepper)
    return moment_of(moments, path[:, 0], published.START_DISTANCE)


def terminal_rate(command: tuple[float, ...], column: int, stepper: Stepper) -> float:
    """The rate of one column of the path after a long time under one command."""
    moments, path = constant_run(lily(published.PRINTED_INERTIA), command, LONG, stepper)
    return float((path[-1, column] - path[-2, column]) / (moments[-1] - moments[-2]))


def turn_times(inertia: float, stepper: Stepper) -> Floats:
    """(4,) when Lily at full torque from rest has turned by 90, 180, 270 and 360 degrees [s]."""
    moments, path = constant_run(lily(inertia), TURNING, 12.0, stepper)
    return np.array([moment_of(moments, path[:, 3], 0.5 * math.pi * quarter) for quarter in range(1, 5)])


def turn_misfit(inertia: float, stepper: Stepper) -> float:
    """Root mean square difference [s] to the four measured times."""
    return float(np.sqrt(np.mean((turn_times(inertia, stepper) - published.QUARTER_TURNS) ** 2)))


def best_inertia(stepper: Stepper) -> float:
    """The moment of inertia [kg m^2] whose four times are nearest to the measured ones."""
    fit = minimize_scalar(
        lambda scaled: turn_misfit(scaled * 1e-4, stepper), bounds=(2.0, 8.0), method="bounded", options={"xatol": 1e-3}
    )
    return float(fit.x) * 1e-4


def start_time_in_closed_form(force: float, mass: float, drag: float) -> float:
    """When 10 cm are done [s]: x = (m/k) ln cosh(t sqrt(k F) / m)."""
    return mass / math.sqrt(drag * force) * math.acosh(math.exp(published.START_DISTANCE * drag / mass))


def calibration_rows() -> list[Row]:
    """The table: paper, measured, and ours with the paper's integrator and with an accurate one."""
    drag, yaw_drag = drag_coefficient(), yaw_drag_coefficient()
    pump = pump_force(published.LARGEST_VOLUME)
    rows = [
        Row("A Cd", "m^2", published.PRINTED_AREA_DRAG, None, *2 * [2.0 * drag / published.WATER_DENSITY]),
        Row("rho A Cd / 2", "kg/m", None, None, drag, drag),
        _simulated("terminal speed", "m/s", published.TERMINAL_SPEED, lambda s: terminal_rate(AHEAD, 0, s)),
        _simulated("10 cm from rest", "s", published.START_TIME, start_time),
        Row("pump force at 450 cm^3", "N", published.PRINTED_PUMP_FORCE, None, pump, pump),
        Row("Cr", "N m s^2", published.PRINTED_YAW_DRAG, None, yaw_drag, yaw_drag),
        _simulated("terminal yaw rate", "rad/s", published.TERMINAL_YAW_RATE, lambda s: terminal_rate(TURNING, 3, s)),
        Row("I, best fit", "kg m^2", published.PRINTED_INERTIA, None, best_inertia(PAPER), best_inertia(ACCURATE)),
    ]
    times = [(inertia, turn_times(inertia, PAPER), turn_times(inertia, ACCURATE)) for inertia in (5e-4, 4.05e-4)]
    for inertia, stepped, accurate in times:
        for index, measured in enumerate(published.QUARTER_TURNS):
            name = f"{90 * (index + 1)} deg from rest, I = {inertia:g}"
            rows.append(Row(name, "s", measured, measured, float(stepped[index]), float(accurate[index])))
    return rows


def findings() -> list[str]:
    """What does not fit together, in words, each with the numbers that show it."""
    drag, force, mass = drag_coefficient(), published.THRUST, published.MASS
    literal = math.sqrt(2.0 * force / (published.WATER_DENSITY * published.PRINTED_AREA_DRAG))
    low_drag = brentq(lambda k: start_time_in_closed_form(force, mass, k) - published.START_TIME, 0.1, 5.0)
    more_force = brentq(
        lambda f: start_time_in_closed_form(f, mass, drag * f / force) - published.START_TIME, 0.005, 0.05
    )
    less_mass = brentq(lambda m: start_time_in_closed_form(force, m, drag) - published.START_TIME, 0.1, 1.0)
    exact = start_time_in_closed_form(force, mass, drag)
    # dt / I * (torque - Cr w^2) = w with the paper's step and inertia: equation (2) as it is printed.
    slope, yaw_drag = published.PRINTED_INERTIA / PAPER.longest_step, yaw_drag_coefficient()
    stuck = (-slope + math.sqrt(slope**2 + 4.0 * yaw_drag * published.TORQUE)) / (2.0 * yaw_drag)
    volume = (published.PRINTED_PUMP_FORCE / published.GRAVITY + mass) / published.WATER_DENSITY
    paper_fit, accurate_fit = turn_misfit(5e-4, PAPER), turn_misfit(5e-4, ACCURATE)
    return [
        f"A Cd = 1.78 is rho A Cd / 2 in kg/m; A Cd is {2 * drag / published.WATER_DENSITY:.4g} m^2. "
        f"1.78 m^2 in equation (1) would stop Lily at {1000 * literal:.3g} mm/s.",
        f"10 cm in 3.03 s and 7.5 cm/s exclude each other with 0.01 N and 0.44 kg: the exact time is {exact:.2f} s. "
        f"3.03 s takes rho A Cd / 2 = {low_drag:.3g} kg/m, and then {100 * math.sqrt(force / low_drag):.1f} cm/s; "
        f"keeping 7.5 cm/s it takes {more_force:.3g} N (within the spread of the readings, 0.8 to 1.2 g), or "
        f"{less_mass:.3g} kg.",
        f"I = 5e-4 makes up for the paper's step of 0.5 s: its four times are off by {paper_fit:.2f} s (rms) with "
        f"that integrator and by {accurate_fit:.2f} s with an accurate one, which wants {best_inertia(ACCURATE):.3g}.",
        f"Equation (4) gives {pump_force(published.LARGEST_VOLUME):.4f} N at 450 cm^3 (with its printed sign, "
        f"downwards); 0.1 N takes {1e6 * volume:.2f} cm^3.",
        f"Equation (2) as printed does not add up over time: yaw would stay at {stuck:.3f} rad/s instead of 1.48.",
    ]


def _simulated(quantity: str, unit: str, measured: float, ours: Callable[[Stepper], float]) -> Row:
    return Row(quantity, unit, measured, measured, ours(PAPER), ours(ACCURATE))
