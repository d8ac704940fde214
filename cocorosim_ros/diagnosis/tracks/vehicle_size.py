"""Sizes of a vehicle relative to a Lily, by unit: an amplitude that is large for a Lily is small for a ship."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from cocorosim_ros.diagnosis.criteria.fitting import FULL_FORCES
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS

# The Lily for which the catalogue gives sizes: N, N m, kg, kg m^2, m/s, rad/s, m.
LILY = {"force": 0.01, "moment": 2.5e-4, "mass": 0.44, "inertia": 4.05e-4, "speed": 0.075, "turn": 1.48, "length": 0.13}
LILY_COASTING = LILY["mass"] / math.sqrt(1.7778 * LILY["force"])  # s, of its drag of 1.7778 kg/m; see coasting_time
SCALED: dict[str, Callable[[Mapping[str, float]], float]] = {
    "N": lambda share: share["force"],
    "N/s": lambda share: share["force"] / share["time"],
    "N/m": lambda share: share["force"],
    "N s/m": lambda share: share["force"] / share["speed"],
    "kg/m": lambda share: share["force"] / share["speed"] ** 2,
    "N m": lambda share: share["moment"],
    "N m/s": lambda share: share["moment"] / share["time"],
    "N m s": lambda share: share["moment"] / share["turn"],
    "N m s^2": lambda share: share["moment"] / share["turn"] ** 2,
    "kg": lambda share: share["mass"],
    "kg m^2": lambda share: share["inertia"],
    "m/s": lambda share: share["speed"],
    "1/s": lambda share: share["speed"],
    "s/m": lambda share: 1.0 / share["speed"],
    "m/s^2": lambda share: share["force"] / share["mass"],
    "rad/s": lambda share: share["turn"],
    "m": lambda share: share["length"],
    "s": lambda share: share["time"],
}
"""Factor of an amplitude by its unit, as a function of the vehicle's share of each entry of LILY, and of its slowness.

A linear drag [N s/m], for one, grows with full force over full speed. Delays are longer of a vehicle that is slower
than a Lily, whose motion would not show them else; of quicker ones they are as long: motors and clocks know no drag.
"""
UNSCALED = ("1", "Hz", "rad", "Pa", "Pa/s", "s/s")
"""Units of amplitudes that are as large for every vehicle: pure numbers, errors of sensors and clocks."""
LILY_SIZES: Mapping[str, float] = dict.fromkeys((*SCALED, *UNSCALED), 1.0)
"""Factors for a Lily, which are 1, for every unit that an amplitude may have."""


class FullForces(NamedTuple):
    """Full forces of a vehicle, its actuators at their limits: horizontal [N], in heave [N] and in yaw [N m]."""

    across: float
    heave: float
    yaw: float

    @property
    def random_heave(self) -> float:
        """Force in heave that would be strong if it came from the water [N].

        It is a tenth of the pump's full force, or the full horizontal force if that is greater.
        """
        return max(FULL_FORCES.across * self.heave, self.across)


def full_forces(vehicle: VehicleModel) -> FullForces:
    """Full forces of a vehicle by its actuators, or by likely ratios in directions where it has none.

    The water turns a vehicle even if its own actuators cannot. So without yaw moment of its own, its full force times
    an arm stands for it, and without horizontal force a share of the force in heave.
    """
    surge, sway, heave, yaw = vehicle.force_scale.tolist()
    across = max(surge, sway) or FULL_FORCES.across * heave or LILY["force"]
    return FullForces(across, heave, yaw or FULL_FORCES.arm * across)


def coasting_time(vehicle: VehicleModel, row: Floats) -> float:
    """Time [s] in which a vehicle loses half of its full speed, or of its full turn rate if that takes longer.

    Quadratic drag k v^2 takes m / (k v) for it; full speed is v = sqrt(F / k), so that the time is m / sqrt(k F), and
    alike for turns. row (columns,): the numbers of the model. Infinite without drag.
    """
    full = full_forces(vehicle)
    gain, turning = row[COLUMN["thrust_gain"]], row[COLUMN["yaw_torque_gain"]]
    ahead = row[COLUMN["drag"]] * gain * full.across
    around = row[COLUMN["yaw_drag"]] * turning * full.yaw
    inertias = (vehicle.mass, ahead), (float(row[COLUMN["yaw_inertia"]]), around)
    return max(inertia / math.sqrt(braked) if braked > 0.0 else math.inf for inertia, braked in inertias)


def slowness(vehicle: VehicleModel) -> float:
    """Times of a vehicle relative to those of a Lily [1]: its coasting time over a Lily's; 1 for all that stop sooner.

    What the water does and what drivers ask for does not become quicker with the vehicle, nor do motors and clocks. By
    the numbers of the platform's file, so that it stays as it is while models are fitted; 1 without drag.
    """
    coasting = coasting_time(vehicle, vehicle.row)
    return max(coasting / LILY_COASTING, 1.0) if math.isfinite(coasting) else 1.0


def shortest_coasting(vehicle: VehicleModel, row: Floats | None = None) -> float:
    """Time [s] in which the vehicle loses half of its full speed or turn, along the axis where it is shortest.

    row (columns,): the numbers of a model; None: those of the platform's file.

    Quadratic drag k v^2 takes m / sqrt(k F) for it after a full force F, and linear drag d speeds it up by d / m. Only
    axes along which actuators push count; 0 without any.
    """
    row = vehicle.row if row is None else row
    drags = [row[COLUMN["drag"]]] * 3 + [row[COLUMN["yaw_drag"]]]
    linear = [row[COLUMN[f"linear_drag.{axis}"]] for axis in ("surge", "sway", "heave", "yaw")]
    inertias = [vehicle.mass] * 3 + [row[COLUMN["yaw_inertia"]]]
    gains = [row[COLUMN[name]] for name in ("thrust_gain", "thrust_gain", "buoyancy_gain", "yaw_torque_gain")]
    forces = [gain * full for gain, full in zip(gains, vehicle.force_scale.tolist(), strict=True)]
    rates = [
        (math.sqrt(drag * full) + slow) / inertia
        for drag, slow, full, inertia in zip(drags, linear, forces, inertias, strict=True)
        if full > 0.0
    ]
    fastest = max(rates, default=0.0)
    return 1.0 / fastest if fastest > 0.0 else 0.0


def sizes(vehicle: VehicleModel) -> Mapping[str, float]:
    """Factors by unit of an amplitude, from a value that is large for a Lily to one that is large for this vehicle."""
    row = vehicle.nominal
    force, _, moment = full_forces(vehicle)
    drag, yaw_drag = float(row[PARAMETER_COLUMNS["drag"]]), float(row[PARAMETER_COLUMNS["yaw_drag"]])
    size = {
        "force": force,
        "moment": moment,
        "mass": vehicle.mass,
        "inertia": vehicle.yaw_inertia,
        "speed": math.sqrt(force / drag) if drag > 0.0 else LILY["speed"],
        "length": vehicle.hull,
        "turn": math.sqrt(moment / yaw_drag) if yaw_drag > 0.0 else LILY["turn"],
    }
    share = {name: size[name] / LILY[name] if size[name] > 0.0 else 1.0 for name in LILY}
    share["time"] = slowness(vehicle)
    return {**LILY_SIZES, **{unit: scale(share) for unit, scale in SCALED.items()}}
