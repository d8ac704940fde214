"""What a plain Python controller may answer: fractions for its actuators, or a course for the operating system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Command:
    """Each actuator by itself; the operating system then neither steers nor avoids walls.

    A mapping in its place is a Command that says nothing.
    """

    actuators: Mapping[str, float] = field(default_factory=dict)
    """Fractions -1..1 of each actuator's maximum by name, or of sticks that its platform mixes; what is not named is
    off."""
    say: Sequence[float] = ()
    """What goes out at this tick by radio (or blue light): at most 8 finite numbers, nothing for silence."""


@dataclass(frozen=True)
class Course:
    """What the robot's operating system is to do until the next tick; near walls, floor and surface it avoids them."""

    heading: float | None = None
    """[rad; world, counter-clockwise from +x]; None keeps the last one, at first that of the start."""
    speed: float = 0.0
    """Fraction -1..1 of full thrust ahead."""
    depth: float | None = None
    """[m, down positive]; None leaves it to `climb`."""
    climb: float = 0.0
    """[m/s, up positive], where no depth is given."""
    turn_gain: float = 3.0
    """Of the operating system's heading controller, 0 or more; 3 is that of the released model's boids."""
    say: Sequence[float] = ()
    """As in Command."""
