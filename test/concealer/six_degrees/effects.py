"""What may be hidden in a recording of a vehicle with six degrees of freedom.

Each function changes numbers or faults and says what it hid.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from concealer import speed_logs
from concealer.layout import FloatArray
from concealer.scene import Faults, Secret, signed
from concealer.six_degrees import layout as at


@dataclass
class Scene:
    """The vehicle's numbers (SIZE,), and what is wrong with its sensors."""

    p: FloatArray
    pressure_offset: float = 0.0  # Pa
    log: Faults = field(default_factory=Faults)  # of the speed log
    latency: tuple[str, float] = ("", 0.0)  # stream, s


Hide = Callable[[np.random.Generator, float, Scene], Secret]


def thruster_lag(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """All thrusters late by a first-order lag."""
    scene.p[at.LAG] = amount
    return Secret("thruster_lag", {"time_constant": amount}, "first order")


def thruster_deadband(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """No thrust below the width, and a jump behind it."""
    scene.p[at.DEAD] = amount
    return Secret("thruster_deadband", {"width": amount}, "jump to c behind it")


def reverse_loss(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Each thruster weaker backwards."""
    scene.p[at.REVERSE] = amount
    return Secret("reverse_loss", {"loss": amount}, "gain per thruster")


def battery_sag(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Thrust that falls with time."""
    scene.p[at.BATTERY] = amount
    return Secret("battery_sag", {"fraction_lost": amount}, "straight line over time")


def tether(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A cable that pulls to its end."""
    x, y = (float(value) for value in rng.uniform(-2.0, 2.0, 2))
    scene.p[[at.TETHER, at.TETHER_X, at.TETHER_Y]] = amount, x, y
    return Secret("tether", {"stiffness": amount, "x": x, "y": y}, "spring")


def tether_drag(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A cable that is towed from a place at the surface, and hangs in a bow."""
    x, y = (float(value) for value in rng.uniform(-4.0, 4.0, 2))
    scene.p[[at.CABLE, at.CABLE_X, at.CABLE_Y, at.CABLE_BOW]] = amount, x, y, rng.uniform(0.05, 0.15)
    form = "a bow of twelve pieces, with friction along each; the number is that of the flow across a piece"
    return Secret("tether_drag", {"coefficient": amount, "x": x, "y": y}, form)


def payload_shift(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A load lost or taken up within a second."""
    start, force = float(scene.p[at.DURATION] * rng.uniform(0.2, 0.8)), signed(rng, amount)
    scene.p[[at.LOAD_TIME, at.LOAD_FORCE]] = start, force
    return Secret("payload_shift", {"time": start + 0.5, "force": force}, "ramp of a second; time: its middle")


def side_thrust_lever(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Sideways thrust off the centre, farther off to one side than to the other; the number is the mean of both."""
    scene.p[[at.SIDE_LEVER, at.SIDE_UNEVEN]] = signed(rng, amount), rng.uniform(-0.2, 0.2)
    form = "lever (Y + e |Y|); lever: the mean of both sides"
    return Secret("side_thrust_lever", {"lever": float(scene.p[at.SIDE_LEVER])}, form)


def hull_lift(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A hull and fins that lift, behind or before the origin; the lift falls off at large angles of attack."""
    centre = rng.uniform(-0.3, 0.1)
    scene.p[[at.HULL_LIFT, at.HULL_CENTRE, at.HULL_STALL]] = amount, centre, rng.uniform(0.1, 0.4)
    form = "lift at a centre ahead of the origin, a (1 - k sin^2(attack)); numbers: those of small angles"
    numbers = {"sway_by_drift": amount, "yaw_by_drift": amount * centre, "heave_by_climb": amount}
    return Secret("hull_lift", numbers, form)


def wash_loss(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A propeller that loses thrust in the jet of another one."""
    scene.p[at.WASH] = amount
    return Secret("wash_loss", {"loss": amount}, "loss by the ratio of both thrusts, 1 at most, within a cone")


def ground_log_scale(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A log of the speed over ground with another gain."""
    return speed_logs.scale(rng, amount, scene.log, "ground_log", float(scene.p[at.DURATION]))


def ground_log_misalignment(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A log of the speed over ground that is put on askew."""
    return speed_logs.misalignment(rng, amount, scene.log, "ground_log")


def ground_log_lever(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A log of the speed over ground beside the centre."""
    return speed_logs.lever(rng, amount, scene.log, "ground_log")


def pressure_offset(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A constant number of pascals."""
    scene.pressure_offset = signed(rng, amount)
    return Secret("pressure_offset", {"offset": scene.pressure_offset}, "constant", "pressure")


def sensor_latency(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """One stream shows the past."""
    topic = str(rng.choice(["pose", "velocity"]))
    scene.latency = topic, amount
    return Secret("sensor_latency", {"latency": amount}, "constant", topic)


def _swing(rng: np.random.Generator, amount: float, scene: Scene, place: int) -> None:
    period = rng.uniform(8.0, 40.0)
    scene.p[[place, at.SWING_OMEGA, at.SWING_PHASE]] = amount, 2.0 * math.pi / period, rng.uniform(-math.pi, math.pi)


def swing_x(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A force along world x that swings."""
    _swing(rng, amount, scene, at.SWING)
    names = ("unknown:world_x~sin_t", "unknown:world_x~cos_t")
    return Secret(names[0], {"coefficient": amount}, "A sin(w t + phase)", acceptable=names)


def swing_yaw(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A moment about the body's vertical that swings."""
    _swing(rng, amount, scene, at.SWING_YAW)
    names = ("unknown:yaw~sin_t", "unknown:yaw~cos_t")
    return Secret(names[0], {"coefficient": amount}, "A sin(w t + phase)", acceptable=names)


EFFECTS: dict[str, Hide] = {
    hide.__name__: hide
    for hide in (
        thruster_lag, thruster_deadband, reverse_loss, battery_sag, tether, tether_drag, payload_shift,
        side_thrust_lever, pressure_offset, sensor_latency, swing_x, swing_yaw,
        hull_lift, wash_loss, ground_log_scale, ground_log_misalignment, ground_log_lever,
    )
}  # fmt: skip
