"""What a platform is made of: hull, actuators, sensors."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.parts.direction import DIRECTION
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.parts.steering import Azimuth, Rudder
from cocorosim_ros.scenario.parts.thrust_curve import ThrustCurve, read_curve
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import quantity_text, read_quantity
from cocorosim_ros.scenario.reading.records import (
    FLAG,
    TEXT,
    choice,
    form_of,
    list_of,
    other_flags,
    quantities,
    quantity,
    record_tree,
    stored,
    vector,
)

Vector3 = tuple[float, float, float]


def unit_vector(azimuth: float, elevation: float) -> Vector3:
    """The direction at these angles [rad]: azimuth from forward to port, elevation upwards, as in REP 103."""
    level = math.cos(elevation)
    return level * math.cos(azimuth), level * math.sin(azimuth), math.sin(elevation)


def _read_cone(entry: Entry) -> float:
    angle = read_quantity(entry, "angle", "positive")
    if angle > 2 * math.pi:
        raise entry.problem(f"has {entry.found()}; a cone is at most 360 deg wide.")
    return angle


_CONE = stored(
    _read_cone, lambda value: quantity_text(value, "angle"), form=f"{form_of('angle', 'positive')}, 2 pi at most"
)


@dataclass(frozen=True)
class Hull:
    """Outer size [m; body axes].

    front_above_water, side_above_water: areas that the wind meets from ahead and from the side [m^2], 0 if None.
    cable_diameter: of the cable that it tows, 0 where it swims free, None where that is not known. cable_length: what
    is deployed of it, None where that is the distance to the place from which it is tended.
    """

    length: float = field(metadata=quantity("length", "positive"))
    width: float = field(metadata=quantity("length", "positive"))
    height: float = field(metadata=quantity("length", "positive"))
    front_above_water: float | None = field(default=None, metadata=quantity("area", "not negative"))
    side_above_water: float | None = field(default=None, metadata=quantity("area", "not negative"))
    cable_diameter: float | None = field(default=None, metadata=quantity("length", "not negative"))
    cable_length: float | None = field(default=None, metadata=quantity("length", "positive"))


@dataclass(frozen=True)
class Thruster:
    """A fixed propeller.

    position: [m; body, from the centre of rotation]. direction: unit vector of its push forwards [body].
    maximum, maximum_reverse: force forwards and backwards [N], the same if `maximum_reverse` is None.
    curve: how the force grows with the command, in proportion if None. gain: what it pushes as a multiple of all this.
    diameter: of its propeller [m], None where nothing is to be known of its jet.
    """

    name: str = field(metadata=TEXT)
    position: Vector3 = field(metadata=vector("length", 3))
    direction: Vector3 = field(metadata=DIRECTION)
    maximum: float = field(metadata=quantity("force", "positive"))
    maximum_reverse: float | None = field(default=None, metadata=quantity("force", "not negative"))
    curve: ThrustCurve | None = field(
        default=None,
        metadata={**stored(read_curve, record_tree, form="curve from command to force"), "inside": ThrustCurve},
    )
    gain: float | None = field(default=None, metadata=quantity("pure number", "positive"))
    diameter: float | None = field(default=None, metadata=quantity("length", "positive"))
    kind: Literal["thruster"] = field(default="thruster", metadata=choice("thruster"))

    @property
    def reverse(self) -> float:
        """Force backwards at command -1 [N], unsigned."""
        return self.maximum if self.maximum_reverse is None else self.maximum_reverse


@dataclass(frozen=True)
class BuoyancyPump:
    """A pump that changes the robot's volume: `neutral_volume` +- `volume_range` [m^3] at command +-1."""

    name: str = field(metadata=TEXT)
    neutral_volume: float = field(metadata=quantity("volume", "positive"))
    volume_range: float = field(metadata=quantity("volume", "positive"))
    kind: Literal["buoyancy"] = field(default="buoyancy", metadata=choice("buoyancy"))


@dataclass(frozen=True)
class BlueLightSensor:
    """One blue-light sensor: a cone around its axis, and rays along which it sees obstacles.

    azimuth, elevation: cone axis [rad; body]. cone_angle: full opening [rad].
    neighbour_range, obstacle_range: how far it sees robots and obstacles [m]; an obstacle_range of 0 sees none.
    obstacle_rays: offsets of the rays from the axis in azimuth [rad].
    """

    name: str = field(metadata=TEXT)
    azimuth: float = field(metadata=quantity("angle"))
    elevation: float = field(metadata=quantity("angle"))
    cone_angle: float = field(metadata=_CONE)
    neighbour_range: float = field(metadata=quantity("length", "not negative"))
    obstacle_range: float = field(metadata=quantity("length", "not negative"))
    obstacle_rays: tuple[float, ...] = field(default=(0.0,), metadata=quantities("angle"))


@dataclass(frozen=True)
class ObstacleSensor:
    """Rays along which a robot sees obstacles and no robots.

    azimuth, elevation: the direction that it looks in and counts for [rad; body]. obstacle_range: how far it sees [m].
    obstacle_rays: offsets of the rays from that direction in azimuth [rad].
    """

    name: str = field(metadata=TEXT)
    azimuth: float = field(metadata=quantity("angle"))
    elevation: float = field(metadata=quantity("angle"))
    obstacle_range: float = field(metadata=quantity("length", "positive"))
    obstacle_rays: tuple[float, ...] = field(default=(0.0,), metadata=quantities("angle"))

    def without_cone(self) -> BlueLightSensor:
        """The same as a blue-light sensor that sees no robot."""
        return BlueLightSensor(
            self.name, self.azimuth, self.elevation, 0.0, 0.0, self.obstacle_range, self.obstacle_rays
        )


@dataclass(frozen=True)
class Sensors:
    """What a robot perceives with; `radio_range` [m] is 0 for a robot without radio.

    obstacles: sensors for obstacles alone, beside the blue-light sensors; None where the file names none.
    further: whether it has the sensors of that topic that have no key of their own here (see world.sensors.SENSORS).
    """

    compass: bool = field(default=False, metadata=FLAG)
    pressure: bool = field(default=False, metadata=FLAG)
    imu: bool = field(default=False, metadata=FLAG)
    velocity: bool = field(default=False, metadata=FLAG)
    radio_range: float = field(default=0.0, metadata=quantity("length", "not negative"))
    blss: tuple[BlueLightSensor, ...] = field(default=(), metadata=list_of(BlueLightSensor))
    obstacles: tuple[ObstacleSensor, ...] | None = field(default=None, metadata=list_of(ObstacleSensor))
    further: Mapping[str, bool] = field(default_factory=dict, hash=False, metadata=other_flags())

    @property
    def directed(self) -> tuple[BlueLightSensor, ...]:
        """All that looks in a direction, in the order of all arrays about it: blue light, then obstacles alone."""
        return (*self.blss, *(sensor.without_cone() for sensor in self.obstacles or ()))

    def has(self, topic: str) -> bool:
        """Whether the robot has the sensor of this topic."""
        return bool(self.further.get(topic, getattr(self, topic, False)))


Actuator = Thruster | BuoyancyPump | Rudder | Azimuth | Fin | SlidingMass
ACTUATORS: dict[str, type[Actuator]] = {
    "thruster": Thruster, "buoyancy": BuoyancyPump, "rudder": Rudder, "azimuth": Azimuth,
    "fin": Fin, "sliding_mass": SlidingMass,
}  # fmt: skip
