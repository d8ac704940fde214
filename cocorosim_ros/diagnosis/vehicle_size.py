"""How much of everything a vehicle has beside a Lily: what is large for a Lily is small for a ship."""

from __future__ import annotations

import math
from collections.abc import Mapping

from cocorosim_ros.diagnosis.track import Track
from cocorosim_ros.physics.vehicles import MASS, PARAMETER_COLUMNS, YAW_INERTIA

# The Lily that the sizes of the catalogue belong to: N, N m, kg, kg m^2, m/s, rad/s.
LILY = {"force": 0.01, "moment": 2.5e-4, "mass": 0.44, "inertia": 4.05e-4, "speed": 0.075, "turn": 1.48}


def sizes(track: Track) -> Mapping[str, float]:
    """By unit of an amplitude: the factor that makes what is large for a Lily large for this vehicle."""
    row = track.platform_row
    force = float(max(track.force_scale[0], track.force_scale[1])) or 0.1 * float(track.force_scale[2])
    moment = float(track.force_scale[3]) or 0.02 * force
    drag, yaw_drag = float(row[PARAMETER_COLUMNS["drag"]]), float(row[PARAMETER_COLUMNS["yaw_drag"]])
    size = {
        "force": force,
        "moment": moment,
        "mass": float(row[MASS]),
        "inertia": float(row[YAW_INERTIA]),
        "speed": math.sqrt(force / drag) if drag > 0.0 else LILY["speed"],
        "turn": math.sqrt(moment / yaw_drag) if yaw_drag > 0.0 else LILY["turn"],
    }
    share = {name: size[name] / LILY[name] if size[name] > 0.0 else 1.0 for name in LILY}
    return {
        "N": share["force"],
        "N m": share["moment"],
        "N s/m": share["force"] / share["speed"],
        "N m s": share["moment"] / share["turn"],
        "N/m": share["force"],
        "kg": share["mass"],
        "kg m^2": share["inertia"],
        "m/s": share["speed"],
        "1/s": share["speed"],
        "s/m": 1.0 / share["speed"],
        "m/s^2": share["force"] / share["mass"],
        "rad/s": share["turn"],
    }
