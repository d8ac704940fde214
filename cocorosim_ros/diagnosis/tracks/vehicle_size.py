"""How much of everything a vehicle has beside a Lily: what is large for a Lily is small for a ship."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS

# The Lily that the sizes of the catalogue belong to: N, N m, kg, kg m^2, m/s, rad/s.
LILY = {"force": 0.01, "moment": 2.5e-4, "mass": 0.44, "inertia": 4.05e-4, "speed": 0.075, "turn": 1.48}
SCALED: dict[str, Callable[[Mapping[str, float]], float]] = {
    "N": lambda share: share["force"],
    "N/s": lambda share: share["force"],
    "N/m": lambda share: share["force"],
    "N s/m": lambda share: share["force"] / share["speed"],
    "kg/m": lambda share: share["force"] / share["speed"] ** 2,
    "N m": lambda share: share["moment"],
    "N m/s": lambda share: share["moment"],
    "N m s": lambda share: share["moment"] / share["turn"],
    "N m s^2": lambda share: share["moment"] / share["turn"] ** 2,
    "kg": lambda share: share["mass"],
    "kg m^2": lambda share: share["inertia"],
    "m/s": lambda share: share["speed"],
    "1/s": lambda share: share["speed"],
    "s/m": lambda share: 1.0 / share["speed"],
    "m/s^2": lambda share: share["force"] / share["mass"],
    "rad/s": lambda share: share["turn"],
}
"""By unit of an amplitude: how it grows with what a vehicle has beside a Lily; lengths and times stay."""
UNSCALED = ("1", "m", "s", "Hz", "rad", "Pa", "Pa/s", "s/s")
"""Units of amplitudes that are large alike for every vehicle: pure numbers, and what sensors and clocks do wrong."""
LILY_SIZES: Mapping[str, float] = dict.fromkeys((*SCALED, *UNSCALED), 1.0)
"""The sizes of a Lily, for every unit that an amplitude may have."""
ACROSS = 0.1  # of the full force in heave
ARM = 0.02  # m, of the full force across


class FullForces(NamedTuple):
    """What is strong for a vehicle across [N], in heave [N] and yaw [N m]: its actuators at their limits."""

    across: float
    heave: float
    yaw: float

    @property
    def random_heave(self) -> float:
        """What would be strong in heave if the water did it [N]: a tenth of what a pump can, or the force across."""
        return max(ACROSS * self.heave, self.across)


def full_forces(vehicle: VehicleModel) -> FullForces:
    """Where no actuator acts, what the others let expect: a vehicle that cannot turn itself is turned all the same."""
    surge, sway, heave, yaw = vehicle.force_scale.tolist()
    across = max(surge, sway) or ACROSS * heave or LILY["force"]
    return FullForces(across, heave, yaw or ARM * across)


def sizes(vehicle: VehicleModel) -> Mapping[str, float]:
    """By unit of an amplitude: the factor that makes what is large for a Lily large for this vehicle."""
    row = vehicle.nominal
    force, _, moment = full_forces(vehicle)
    drag, yaw_drag = float(row[PARAMETER_COLUMNS["drag"]]), float(row[PARAMETER_COLUMNS["yaw_drag"]])
    size = {
        "force": force,
        "moment": moment,
        "mass": vehicle.mass,
        "inertia": vehicle.yaw_inertia,
        "speed": math.sqrt(force / drag) if drag > 0.0 else LILY["speed"],
        "turn": math.sqrt(moment / yaw_drag) if yaw_drag > 0.0 else LILY["turn"],
    }
    share = {name: size[name] / LILY[name] if size[name] > 0.0 else 1.0 for name in LILY}
    return {**LILY_SIZES, **{unit: scale(share) for unit, scale in SCALED.items()}}
