"""The tank: a box of water below the surface, with solid obstacles in it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.parts.vehicle_parts import Vector3
from cocorosim_ros.scenario.reading.records import TEXT, choice, list_of, quantity, vector


@dataclass(frozen=True)
class Sphere:
    """A solid ball; centre [m; world], radius [m]."""

    name: str = field(metadata=TEXT)
    centre: Vector3 = field(metadata=vector("length", 3))
    radius: float = field(metadata=quantity("length", "positive"))
    kind: Literal["sphere"] = field(default="sphere", metadata=choice("sphere"))

    def contains(self, position: Vector3) -> bool:
        """Whether a place [m; world] is inside the ball or on it."""
        return sum((p - c) ** 2 for p, c in zip(position, self.centre, strict=True)) <= self.radius**2


@dataclass(frozen=True)
class Box:
    """A solid box along the world's axes; centre [m; world], full size [m]."""

    name: str = field(metadata=TEXT)
    centre: Vector3 = field(metadata=vector("length", 3))
    size: Vector3 = field(metadata=vector("length", 3, "positive"))
    kind: Literal["box"] = field(default="box", metadata=choice("box"))

    def contains(self, position: Vector3) -> bool:
        """Whether a place [m; world] is inside the box or on it."""
        return all(abs(p - c) <= s / 2 for p, c, s in zip(position, self.centre, self.size, strict=True))

    def corners(self) -> tuple[float, ...]:
        """The smallest x, y, z, then the greatest [m; world]."""
        parts = [(c, s / 2) for c, s in zip(self.centre, self.size, strict=True)]
        return *(c - half for c, half in parts), *(c + half for c, half in parts)


Obstacle = Sphere | Box
OBSTACLES: dict[str, type[Sphere] | type[Box]] = {
    "sphere": Sphere,
    "box": Box,
}


@dataclass(frozen=True)
class Tank:
    """Water for |x| <= size[0]/2, |y| <= size[1]/2, -size[2] <= z <= 0 [m; world], less the obstacles."""

    size: Vector3 = field(metadata=vector("length", 3, "positive"))
    obstacles: tuple[Obstacle, ...] = field(default=(), metadata=list_of(OBSTACLES))

    @property
    def depth(self) -> float:
        """How deep the water is [m]."""
        return self.size[2]

    def lower_corner(self) -> Vector3:
        """The corner with the smallest coordinates [m; world]."""
        return -self.size[0] / 2, -self.size[1] / 2, -self.size[2]

    def upper_corner(self) -> Vector3:
        """The corner with the greatest coordinates [m; world]."""
        return self.size[0] / 2, self.size[1] / 2, 0.0

    def contains(self, position: Vector3) -> bool:
        """Whether a place [m; world] is within walls, floor and surface, or on them."""
        bounds = zip(self.lower_corner(), position, self.upper_corner(), strict=True)
        return all(low <= value <= high for low, value, high in bounds)

    def obstacle_at(self, position: Vector3) -> Obstacle | None:
        """The obstacle that a place [m; world] is inside of."""
        return next((obstacle for obstacle in self.obstacles if obstacle.contains(position)), None)
