"""What is being hidden: the robots' numbers, the faults of their sensors, and the record of it for the envelope."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from concealer.layout import FloatArray


@dataclass
class Faults:
    """What is wrong with the sensors and clocks of one robot; as made, nothing."""

    hard_iron: tuple[float, float] = (0.0, 0.0)  # fraction of the earth's field, body axes
    soft_iron: float = 0.0  # fraction by which the field along its axis is stronger
    iron_axis: float = 0.0  # rad: to the left of forward, of the direction in which the field is stronger
    compass_offset: float = 0.0  # rad
    compass_motor: float = 0.0  # rad at full thrust
    pressure_offset: float = 0.0  # Pa
    pressure_drift: float = 0.0  # Pa from the start to the end
    drift_time: float = 600.0  # s, of the exponential that the drift follows
    gauge_gain: float = 0.0  # mean fraction by which the gauge shows too much of the water's pressure
    gauge_warmth: tuple[float, float] = (1.0, 0.0)  # s, rad: period and phase with which that fraction swings
    latency: dict[str, float] = field(default_factory=dict)  # s, by topic
    skew: dict[str, float] = field(default_factory=dict)  # s/s, by topic
    command_late: float = 0.0  # s, mean time from a command to what it does
    command_scatter: float = 0.0  # share of it by which that differs from command to command
    scale: float = 1.0  # of the camera
    mixup: str = ""
    gyro_bias: float = 0.0  # rad/s
    gyro_gain: float = 0.0  # mean fraction by which the gyroscope shows too much
    gyro_uneven: float = 0.0  # share of it by which that is more to the left than the mean
    log_scale: float = 0.0  # mean fraction by which the speed log shows too much
    log_warmth: tuple[float, float] = (1.0, 0.0)  # s, rad: period and phase with which that fraction swings
    log_turn: tuple[float, float] = (0.0, 0.0)  # rad, of its forward and of its sideways beam
    log_place: tuple[float, float] = (0.0, 0.0)  # m ahead and to the left of the centre, of the speed log
    log_swing: float = 0.0  # fraction by which a pole that it hangs from leans outwards in turns to the left
    marker_turn: float = 0.0  # rad, of the camera's marker
    marker_wobble: float = 0.0  # fraction of that by which it differs with the heading
    marker: tuple[float, float] = (0.0, 0.0)  # m ahead and to the left of the centre
    motor_uneven: float = 0.0  # (left - right) / mean of what the motors do to the compass
    accel_bias: tuple[float, float, float] = (0.0, 0.0, 0.0)  # m/s^2


@dataclass
class Scene:
    """Robots and water before anything moves."""

    robots: FloatArray  # (robots, SIZE) see layout.py
    faults: list[Faults]
    victim: int  # the robot that gets what is a robot's own

    @property
    def own(self) -> FloatArray:
        """(SIZE,) numbers of the victim, to be changed in place."""
        return np.asarray(self.robots[self.victim])

    @property
    def fault(self) -> Faults:
        """The victim's faults, to be changed in place."""
        return self.faults[self.victim]

    def everywhere(self, **places: float) -> None:
        """Sets numbers of all robots: what belongs to the water. Keywords are names of layout.py in lower case."""
        from concealer import layout

        for name, value in places.items():
            self.robots[:, getattr(layout, name.upper())] = value


@dataclass
class Secret:
    """One hidden effect as the envelope states it."""

    id: str
    parameters: dict[str, float | str]
    form: str  # the law in words, where it differs from the obvious one
    topic: str | None = None
    shared: bool = False  # of the water, so felt by all robots
    acceptable: tuple[str, ...] = ()  # patterns of right names, for what no catalogue has
    tolerated: tuple[str, ...] = ()  # catalogue entries that describe it nearly as well
    twins: tuple[str, ...] = ()  # entries that this very recording cannot tell from it


def direction(rng: np.random.Generator, length: float) -> tuple[float, float]:
    """A vector of this length in a random direction of the plane."""
    angle = rng.uniform(-np.pi, np.pi)
    return float(length * np.cos(angle)), float(length * np.sin(angle))


def signed(rng: np.random.Generator, value: float) -> float:
    """The value or its opposite."""
    return float(value * rng.choice([-1.0, 1.0]))
