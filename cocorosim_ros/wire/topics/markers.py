"""What RViz, Foxglove and Lichtblick draw of a tank and its swarm: `visualization_msgs/MarkerArray`.

What stays is one latched message. What moves is one message every few seconds, made of few numbers: the ways of all
robots since the one before, which fade out by their lifetime, and the jets of their thrusters.
"""

from __future__ import annotations

import colorsys
import struct
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.light import Light
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.tank import Obstacle, Sphere, Tank
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build, serialize
from cocorosim_ros.wire.topics.colours import Rgb, Rgba
from cocorosim_ros.wire.topics.robot_parts import BODY
from cocorosim_ros.wire.topics.swarm_messages import WORLD_FRAME

ARRAY = "visualization_msgs/msg/MarkerArray"
CUBE, SPHERE, LINE_LIST, TEXT = 1, 2, 5, 9  # visualization_msgs/msg/Marker
TRAIL_SECONDS = 30  # how long a way is seen
JET_LENGTH = 0.3  # m, of a thruster at full command
_SATURATION, _BRIGHTNESS = 0.76, 0.886  # of robots, here and in the layouts of config
_WATER, _FLOOR = Rgba(0.5, 0.75, 0.9, 0.8), Rgba(0.3, 0.4, 0.45, 0.35)
_STONE, _LAMP = Rgba(0.5, 0.5, 0.5, 0.8), Rgba(1.0, 0.9, 0.3, 0.6)
_JET, _NAME = Rgba(1.0, 0.6, 0.25, 0.8), Rgba(0.9, 0.93, 0.95, 0.9)
_LINE, _TRAIL, _TEXT_HEIGHT, _FLOOR_HEIGHT = 0.01, 0.008, 0.06, 0.005  # m
_GRAIN = 2.0**-10  # m; places in a few bits compress to half the size of exact ones


def robot_colour(number: int, robots: int) -> Rgb:
    """Colour of one robot of so many: hues all around."""
    return Rgb(*colorsys.hsv_to_rgb(number / robots, _SATURATION, _BRIGHTNESS))


def tank_markers(tank: Tank | None, light: Light | None, names: Sequence[str]) -> bytes:
    """The bytes of `/markers/tank`: walls, floor, obstacles and lamps, where known, and the robots' names."""
    markers = [] if tank is None else [*_walls(tank), *map(_obstacle, range(len(tank.obstacles)), tank.obstacles)]
    for number, lamp in enumerate(() if light is None else light.lamps):
        markers.append(_solid("lamps", number, SPHERE, lamp.position, (0.1, 0.1, 0.1), _LAMP))
    for number, name in enumerate(names):
        above: dict[str, Any] = {"position": {"z": 2 * _TEXT_HEIGHT}, "orientation": {"w": 1.0}}
        text: dict[str, Any] = {"text": name, "scale": {"z": _TEXT_HEIGHT}, "frame_locked": True, "pose": above}
        markers.append(_marker("names", number, TEXT, _NAME, frame=f"{name}/{BODY}", **text))
    return serialize(build(ARRAY, {"markers": markers}))


class SwarmMarkers:
    """Makes `/markers/swarm`: the ways of robots since the last message (trails), and jets of thrusters (wakes)."""

    def __init__(self, platforms: Sequence[Platform], period: int) -> None:
        """`period`: whole seconds between messages."""
        count = len(platforms)
        self._jets = _Jets(platforms)
        self._last: Floats | None = None
        self._made = 0
        self._kept = max(1, TRAIL_SECONDS // period)
        colours = [Rgba(*robot_colour(number, count), 0.9)._asdict() for number in range(count) for _ in range(2)]
        lengths = 2 * count, 2 * self._jets.count
        trails: dict[str, Any] = {**_lines(lengths[0], TRAIL_SECONDS), "colors": colours}
        wakes = [_marker("wakes", 0, LINE_LIST, _JET, **_lines(lengths[1], 2 * period))] if lengths[1] else []
        contents = [[_marker("trails", number, LINE_LIST, _JET, **trails), *wakes] for number in (0, 1)]
        first, second = (build(ARRAY, {"markers": content}) for content in contents)
        self._number_at = _first_difference(serialize(first), serialize(second))
        fields = [f"markers[#{m}].points[#{p}].{axis}" for m in (0, 1) for p in range(lengths[m]) for axis in "xyz"]
        stamps = [f"markers[#{number}].header.stamp" for number in range(len(contents[0]))]
        self._message = PackedMessage([first], fields, stamps)

    def encode(self, stamp_ns: int, position: Floats, yaw: Floats, commands: Floats) -> bytes:
        """The bytes of the next message.

        position: (n, 3) [m; world]; yaw: (n,) [rad]; a robot without a finite pose stays where it was. commands:
        (n, most actuators) fractions, 0 for what is not commanded.
        """
        seen = np.isfinite(position).all(axis=1) & np.isfinite(yaw)
        before = np.zeros_like(position) if self._last is None else self._last
        here = np.where(seen[:, None], position, before)
        before = here if self._last is None else before
        self._last = here
        jets = self._jets.lines(here, np.where(seen, yaw, 0.0), np.where(seen[:, None], commands, 0.0))
        numbers = np.concatenate([np.stack([before, here], axis=1).ravel(), jets.ravel()])
        numbers = np.round(numbers / _GRAIN) * _GRAIN
        data = bytearray(self._message.encode(stamp_ns, numbers[None])[0])
        struct.pack_into("<i", data, self._number_at, self._made % self._kept)
        self._made += 1
        return bytes(data)


class _Jets:
    """The thrusters of all robots: where they are, where they blow, and where their commands stand."""

    def __init__(self, platforms: Sequence[Platform]) -> None:
        found = [
            (robot, column, each)
            for robot, platform in enumerate(platforms)
            for column, each in enumerate(platform.actuators)
            if isinstance(each, Thruster)
        ]
        self.count = len(found)
        self._robot = np.array([robot for robot, _, _ in found], np.intp)
        self._column = np.array([column for _, column, _ in found], np.intp)
        self._position = np.array([each.position for _, _, each in found], np.float64).reshape(-1, 3)
        self._direction = np.array([each.direction for _, _, each in found], np.float64).reshape(-1, 3)

    def lines(self, position: Floats, yaw: Floats, commands: Floats) -> Floats:
        """(thrusters, 2, 3) begin and end of each jet [m; world], of robots (n, 3), (n,) with commands (n, columns)."""
        fraction = commands[self._robot, self._column]
        ends = self._position - JET_LENGTH * fraction[:, None] * self._direction
        lines: Floats = np.stack([self._position, ends], axis=1)
        cosine, sine = np.cos(yaw)[self._robot, None], np.sin(yaw)[self._robot, None]
        x, y = lines[..., 0], lines[..., 1]
        lines[..., 0], lines[..., 1] = cosine * x - sine * y, sine * x + cosine * y
        return lines + position[self._robot, None]


def _lines(points: int, seconds: int) -> dict[str, Any]:
    """Lines between pairs of so many points, for so long."""
    return {"scale": {"x": _TRAIL}, "lifetime": {"sec": seconds}, "points": [{}] * points}


def _first_difference(one: bytes, other: bytes) -> int:
    return next(place for place, (left, right) in enumerate(zip(one, other, strict=True)) if left != right)


def _walls(tank: Tank) -> Iterator[dict[str, Any]]:
    """The edges of the water, and its floor."""
    low, high = np.array(tank.lower_corner()), np.array(tank.upper_corner())
    points = []
    for axis in range(3):
        for one, other in product((0.0, 1.0), repeat=2):
            for along in (0.0, 1.0):
                share = np.insert([one, other], axis, along)
                points.append(_point(low + share * (high - low)))
    yield _marker("tank", 0, LINE_LIST, _WATER, scale={"x": _LINE}, points=points)
    size = (tank.size[0], tank.size[1], _FLOOR_HEIGHT)
    yield _solid("tank", 1, CUBE, (0.0, 0.0, -tank.depth - 0.5 * _FLOOR_HEIGHT), size, _FLOOR)


def _obstacle(number: int, solid: Obstacle) -> dict[str, Any]:
    if isinstance(solid, Sphere):
        return _solid("obstacles", number, SPHERE, solid.centre, (2 * solid.radius,) * 3, _STONE)
    return _solid("obstacles", number, CUBE, solid.centre, solid.size, _STONE)


def _solid(
    group: str, number: int, kind: int, centre: Sequence[float], size: Sequence[float], colour: Rgba
) -> dict[str, Any]:
    pose = {"position": _point(centre), "orientation": {"w": 1.0}}
    return _marker(group, number, kind, colour, pose=pose, scale=_point(size))


def _marker(
    group: str, number: int, kind: int, colour: Rgba, *, frame: str = WORLD_FRAME, **content: Any
) -> dict[str, Any]:
    """A marker of a group in which it has a number; a later one of the same group and number takes its place."""
    first = {"header": {"frame_id": frame}, "ns": group, "id": number, "type": kind, "color": colour._asdict()}
    return {**first, "pose": {"orientation": {"w": 1.0}}, **content}


def _point(values: Sequence[float]) -> dict[str, float]:
    return dict(zip("xyz", map(float, values), strict=True))
