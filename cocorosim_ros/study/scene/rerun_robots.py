"""Robots as entities of Rerun: ROOT/robots/NAME moves in the tank, and what is part of it hangs below it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor, Hull, Thruster
from cocorosim_ros.study.pictures.decimation import longest_interval
from cocorosim_ros.study.scene.cones import cone_lines
from cocorosim_ros.study.scene.scene import Scene, SceneRobot

TIMELINE = "time"
_UNKNOWN_HULL = Hull(0.13, 0.10, 0.07)  # m, a Lily's, where a recording does not tell
_ABSENT = (120, 130, 140)
_PUSH, _CONE, _SEEN = (255, 150, 60), (70, 110, 150), (255, 214, 90)
_THIN = 0.002  # m, half the width of lines and arrows on a robot


class Colour(NamedTuple):
    """Parts of a colour, 0 to 255."""

    red: int
    green: int
    blue: int


@dataclass(frozen=True)
class Canvas:
    """Where a scene is drawn: a Rerun stream, the path that all entities of the scene are below, its zero of time."""

    stream: rr.RecordingStream
    root: str
    start_ns: int

    def moments(self, stamp_ns: Integers) -> rr.TimeColumn:
        """The time line's values of stamps (t,) [ns]."""
        return rr.TimeColumn(TIMELINE, duration=(stamp_ns - self.start_ns).astype("timedelta64[ns]"))

    def always(self, path: str, content: rr.AsComponents) -> None:
        """Draw what holds at all times."""
        self.stream.log(f"{self.root}/{path}", content, static=True)

    def over_time(self, path: str, stamp_ns: Integers, columns: rr.ComponentColumnList) -> None:
        """Draw rows that hold from one moment to the next."""
        if stamp_ns.size:
            self.stream.send_columns(f"{self.root}/{path}", [self.moments(stamp_ns)], columns)


def draw_robots(canvas: Canvas, scene: Scene, colours: Sequence[Colour]) -> None:
    """All robots: bodies in the colour of their shoal, trails in their own; one colour for each robot."""
    palette = np.array([*colours, _ABSENT], np.uint8)
    for number, robot in enumerate(scene.robots):
        path = f"robots/{robot.name}"
        _draw_body(canvas, path, robot)
        _draw_shoal(canvas, f"{path}/body", scene.shoals.stamp_ns, palette[scene.shoals.shoal[:, number]])
        _draw_thrusters(canvas, f"{path}/thrusters", robot)
        _draw_cones(canvas, path, robot)
        _draw_trail(canvas, f"trails/{robot.name}", robot, colours[number])


def _draw_body(canvas: Canvas, path: str, robot: SceneRobot) -> None:
    hull = _UNKNOWN_HULL if robot.platform is None else robot.platform.hull
    half = (hull.length / 2, hull.width / 2, hull.height / 2)
    yaw = np.nan_to_num(robot.track.yaw) / 2
    nothing = np.zeros_like(yaw)
    columns = rr.Transform3D.columns(
        translation=robot.track.position, quaternion=np.stack([nothing, nothing, np.sin(yaw), np.cos(yaw)], axis=-1)
    )
    canvas.over_time(path, robot.track.stamp_ns, columns)
    body = rr.Ellipsoids3D(half_sizes=[half], fill_mode="solid", labels=[robot.name], show_labels=False)
    canvas.always(f"{path}/body", body)
    bow = rr.Arrows3D(vectors=[(hull.length, 0, 0)], radii=hull.height / 12, colors=[(235, 240, 245)])
    canvas.always(f"{path}/bow", bow)


def _draw_shoal(canvas: Canvas, path: str, stamp_ns: Integers, colours: NDArray[np.uint8]) -> None:
    """The colour (t, 3) where it changes."""
    changes = np.ones(len(stamp_ns), np.bool_)
    changes[1:] = (colours[1:] != colours[:-1]).any(axis=1)
    canvas.over_time(path, stamp_ns[changes], rr.Ellipsoids3D.columns(colors=colours[changes]))


def _draw_thrusters(canvas: Canvas, path: str, robot: SceneRobot) -> None:
    """What is asked of each actuator: its push as an arrow, one hull long at full command; a pump's points up."""
    if robot.commands is None or robot.platform is None:
        return
    actuators = [each for each in robot.platform.actuators if each.name in robot.commands.columns]
    if not actuators:
        return
    length = robot.platform.hull.length
    thrusters = [isinstance(each, Thruster) for each in actuators]
    origins = [each.position if isinstance(each, Thruster) else (0.0, 0.0, 0.0) for each in actuators]
    directions = [each.direction if isinstance(each, Thruster) else (0.0, 0.0, 1.0) for each in actuators]
    canvas.always(path, rr.Arrows3D.from_fields(origins=origins, colors=[_PUSH], radii=[_THIN * (1 + any(thrusters))]))
    command = np.nan_to_num(np.stack([robot.commands.column(each.name) for each in actuators], axis=-1))
    vectors = length * command[..., None] * np.array(directions)
    stamps = robot.commands.stamp_ns
    columns = rr.Arrows3D.columns(vectors=vectors.reshape(-1, 3)).partition([len(actuators)] * stamps.size)
    canvas.over_time(path, stamps, columns)


def _draw_cones(canvas: Canvas, path: str, robot: SceneRobot) -> None:
    """All cones at their full reach, and at each moment those that see a robot, out to where it is."""
    sensors = () if robot.platform is None else robot.platform.sensors.blss
    if not sensors:
        return
    cones = [line for sensor in sensors for line in _lines(sensor, sensor.neighbour_range)]
    canvas.always(f"{path}/cones", rr.LineStrips3D(cones, colors=[_CONE], radii=_THIN / 2))
    if robot.sight is None:
        return
    canvas.always(f"{path}/sight", rr.LineStrips3D.from_fields(colors=[_SEEN], radii=[_THIN / 2]))
    known = [sensor for sensor in sensors if f"{sensor.name}.neighbour_range" in robot.sight.columns]
    ranges = {sensor.name: robot.sight.column(f"{sensor.name}.neighbour_range") for sensor in known}
    strips: list[Floats] = []
    lengths: list[int] = []
    for row in range(robot.sight.stamp_ns.size):
        seen = [(sensor, float(ranges[sensor.name][row])) for sensor in known]
        lines = [line for sensor, reach in seen if np.isfinite(reach) for line in _lines(sensor, reach)]
        strips += lines
        lengths.append(len(lines))
    columns = rr.LineStrips3D.columns(strips=strips).partition(lengths)
    canvas.over_time(f"{path}/sight", robot.sight.stamp_ns, columns)


def _lines(sensor: BlueLightSensor, reach: float) -> list[Floats]:
    return cone_lines(sensor.azimuth, sensor.elevation, sensor.cone_angle, reach)


def _draw_trail(canvas: Canvas, path: str, robot: SceneRobot, colour: Colour) -> None:
    """The way from each pose to the next, none across a gap; a view shows as much of it as its time range says."""
    canvas.always(path, rr.LineStrips3D.from_fields(colors=[colour], radii=[_THIN]))
    track = robot.track
    near = np.flatnonzero(np.diff(track.stamp_ns) <= longest_interval(track.stamp_ns))
    ways = np.stack([track.position[near], track.position[near + 1]], axis=1)
    canvas.over_time(path, track.stamp_ns[near + 1], rr.LineStrips3D.columns(strips=ways))
