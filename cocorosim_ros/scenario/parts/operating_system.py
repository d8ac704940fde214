"""The numbers of a robot's own operating system: avoidance, heading, depth, dive speed, command scale."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.reading.records import choice, quantity


@dataclass(frozen=True)
class OperatingSystem:
    """Parameters of the functions that a robot offers its controller, in SI units.

    Avoidance [m, 1]: nearer than `wall_threshold`, `floor_threshold` or `surface_depth` the robot avoids:
    horizontally with `avoidance_thrust` of its maximum and heading gain `avoidance_gain`, vertically to
    `depth_margin` beyond the threshold.
    Heading [command units]: gain * heading_proportional * error + sqrt(gain) * heading_damping * yaw rate.
    Depth [m/s]: depth_proportional * error, at most `dive_limit`.
    Vertical [command units]: vertical_proportional * speed error + vertical_damping * acceleration.
    Scale: `command_full_scale` units, `units_per_volt`, and `full_voltage` at an actuator's maximum.
    avoidance_readings: whether walls are avoided by the ranges read in `this_tick` or in the `previous_tick` (as in the
    released model); None where the file does not say, which is this tick. Floor and surface go by this tick's always.
    """

    wall_threshold: float = field(metadata=quantity("length", "not negative"))
    floor_threshold: float = field(metadata=quantity("length", "not negative"))
    surface_depth: float = field(metadata=quantity("length", "not negative"))
    avoidance_thrust: float = field(metadata=quantity("pure number", "not negative"))
    avoidance_gain: float = field(metadata=quantity("pure number", "positive"))
    depth_margin: float = field(metadata=quantity("length", "not negative"))
    depth_proportional: float = field(metadata=quantity("rate", "not negative"))
    dive_limit: float = field(metadata=quantity("speed", "not negative"))
    heading_proportional: float = field(metadata=quantity("inverse angle", "not negative"))
    heading_damping: float = field(metadata=quantity("inverse angular velocity", "not negative"))
    vertical_proportional: float = field(metadata=quantity("slowness", "not negative"))
    vertical_damping: float = field(metadata=quantity("inverse acceleration", "not negative"))
    command_full_scale: float = field(metadata=quantity("pure number", "positive"))
    units_per_volt: float = field(metadata=quantity("inverse voltage", "positive"))
    full_voltage: float = field(metadata=quantity("voltage", "positive"))
    avoidance_readings: Literal["this_tick", "previous_tick"] | None = field(
        default=None, metadata=choice("this_tick", "previous_tick")
    )

    @property
    def full_command_fraction(self) -> float:
        """The fraction of an actuator's maximum that the full command gives: 127 / 51 / 2.5 on Lily."""
        return self.command_full_scale / self.units_per_volt / self.full_voltage
