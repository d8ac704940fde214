"""A run as it goes on, for Rerun: the scene of `scene`, drawn message by message."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace

import numpy as np
import rerun as rr

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.study.pictures.colours import robot_colours
from cocorosim_ros.study.pictures.facts import MetricSeries, ScenarioFacts
from cocorosim_ros.study.scene.drifting_plume import drifting_plume, leaking_plume
from cocorosim_ros.study.scene.moving_water import MOST_MOMENTS, moving_water
from cocorosim_ros.study.scene.rerun_file import ROOTS, in_bytes
from cocorosim_ros.study.scene.rerun_layout import layout
from cocorosim_ros.study.scene.rerun_robots import TIMELINE, Canvas, Colour, draw_robots
from cocorosim_ros.study.scene.rerun_surroundings import draw_current, draw_puffs, draw_surroundings
from cocorosim_ros.study.scene.scene import Hearing, Scene, SceneRobot, ShoalMembers
from cocorosim_ros.wire.bags.readings import TopicReadings
from cocorosim_ros.wire.bags.tracks import decode_poses
from cocorosim_ros.wire.cdr.type_store import deserialize
from cocorosim_ros.wire.topics.topics import TOPICS, split_topic
from cocorosim_ros.world.state.pose_track import PoseTrack

_CURVE = Colour(70, 160, 230)
_LAST_WORDS = 2.0  # s that the last messages get to reach a viewer
_STATISTICS = "/shoal_statistics"
_COMMAND = TOPICS["thruster_command"].type_name


@contextmanager
def live_scene(scenario: Scenario, facts: ScenarioFacts, url: str) -> Iterator[LiveScene]:
    """Within, a scene that Rerun's viewer at the address shows; a viewer that comes later sees it all."""
    stream = rr.RecordingStream("cocorosim")
    stream.connect_grpc(url)
    scene = LiveScene(stream, scenario, facts)
    try:
        yield scene
    finally:
        with suppress(RuntimeError):  # the viewer was closed before the run ended
            stream.flush(timeout_sec=_LAST_WORDS)
        with suppress(RuntimeError):
            stream.disconnect()


class LiveScene:
    """Draws every message that it is sent (`wire.live.viewers.Viewers`), of poses, commands and statistics."""

    def __init__(self, stream: rr.RecordingStream, scenario: Scenario, facts: ScenarioFacts) -> None:
        """Draw what stands still, the tank and the robots' bodies, and the water at the start."""
        robots = sorted(scenario.robots, key=lambda robot: robot.name)
        scene = _empty(scenario, facts, robots)
        self._stream, self._root = stream, ROOTS[0]
        self._colours = [in_bytes(*each) for each in robot_colours([robot.name for robot in robots]).values()]
        self._robots = {robot.name: robot for robot in robots}
        self._last: dict[str, Floats] = {}
        self._canvas = canvas = Canvas(stream, self._root, 0)
        self._scenario, self._plume = scenario, leaking_plume(scenario, scenario.ticks)
        self._water_drawn_ns = 0
        stream.send_blueprint(layout((self._root,), (_in_the_middle(scene, scenario),), live=True))
        canvas.always("", rr.ViewCoordinates.RIGHT_HAND_Z_UP)
        draw_robots(canvas, scene, self._colours)
        draw_surroundings(canvas, scene, _CURVE)
        for robot, colour in zip(robots, self._colours, strict=True):
            stream.log(
                f"{self._root}/robots/{robot.name}/body", rr.Ellipsoids3D.from_fields(colors=[colour]), static=True
            )

    def add(self, topic: str, type_name: str, schema: str = "") -> None:
        """Offer a topic: entities need no announcement."""

    def send(self, topic: str, stamp_ns: int, data: bytes, *, latched: bool = False) -> None:
        """Draw a message."""
        robot, name = split_topic(topic)
        draw = {"pose": self._pose, "thruster_command": self._command}.get(name) if robot in self._robots else None
        if draw is None and topic != _STATISTICS:
            return
        self._stream.set_time(TIMELINE, duration=np.timedelta64(stamp_ns, "ns"))
        if draw is not None:
            draw(robot, data)
        else:
            self._statistics(data)
            self._water(stamp_ns)

    def _water(self, stamp_ns: int) -> None:
        """What has become of the water, which no message tells, since it was drawn last."""
        if self._plume is not None:
            draw_puffs(self._canvas, self._plume.until(stamp_ns))
        if stamp_ns - self._water_drawn_ns >= self._scenario.duration_ns // MOST_MOMENTS:
            self._water_drawn_ns = stamp_ns
            water = moving_water(self._scenario, np.array([stamp_ns]))
            if water is not None:
                draw_current(self._canvas, water)

    def _pose(self, robot: str, data: bytes) -> None:
        (place,), (yaw,) = decode_poses([data])
        if not np.isfinite(place).all():
            return
        turn = (0.0, 0.0, float(np.sin(yaw / 2)), float(np.cos(yaw / 2)))
        path = f"{self._root}/robots/{robot}"
        self._stream.log(path, rr.Transform3D(translation=place, quaternion=turn))
        before = self._last.get(robot)
        self._last[robot] = place
        if before is not None:
            trail = rr.LineStrips3D.from_fields(strips=[np.stack([before, place])])
            self._stream.log(f"{self._root}/trails/{robot}", trail)

    def _command(self, robot: str, data: bytes) -> None:
        platform = self._robots[robot].platform
        message = deserialize(_COMMAND, data)
        asked = dict(zip(message.name, message.command.tolist(), strict=True))
        directions = [each.direction if isinstance(each, Thruster) else (0.0, 0.0, 1.0) for each in platform.actuators]
        vectors = [
            platform.hull.length * asked.get(each.name, 0.0) * np.array(direction)
            for each, direction in zip(platform.actuators, directions, strict=True)
        ]
        path = f"{self._root}/robots/{robot}/thrusters"
        self._stream.log(path, rr.Arrows3D.from_fields(vectors=vectors))

    def _statistics(self, data: bytes) -> None:
        message = deserialize(TOPICS[_STATISTICS].type_name, data)
        for name, value in zip(message.name, message.value.tolist(), strict=True):
            if name in PAPER_METRICS and np.isfinite(value):
                self._stream.log(f"{self._root}/metrics/{name}", rr.Scalars([value]))


def _empty(scenario: Scenario, facts: ScenarioFacts, robots: list[RobotDescription]) -> Scene:
    """The scene before the first message."""
    none, nothing = np.empty(0, np.int64), np.empty(0)
    track = PoseTrack(none, np.empty((0, 3)), nothing)
    seen = tuple(SceneRobot(robot.name, track, robot.platform, _no_commands(robot), None) for robot in robots)
    return Scene(
        facts,
        0,
        seen,
        Hearing(none, none, np.empty((0, 2, 3))),
        ShoalMembers(none, np.empty((0, len(robots)), np.int64)),
        MetricSeries(none, np.empty((0, len(METRICS)))),
        moving_water(scenario, np.zeros(1, np.int64)),
        drifting_plume(scenario, np.zeros(1, np.int64)),
        (),
    )


def _in_the_middle(scene: Scene, scenario: Scenario) -> Scene:
    """The scene for its layout: robots in the middle of the tank, from the start to the end of the run."""
    middle = 0.5 * (np.array(scenario.tank.lower_corner()) + np.array(scenario.tank.upper_corner()))
    track = PoseTrack(np.array([0, scenario.duration_ns]), np.tile(middle, (2, 1)), np.zeros(2))
    return replace(scene, robots=tuple(replace(robot, track=track) for robot in scene.robots))


def _no_commands(robot: RobotDescription) -> TopicReadings:
    names = robot.platform.actuator_names
    return TopicReadings(
        robot.name, "thruster_command", np.empty(0, np.int64), names, ("1",) * len(names), np.empty((0, len(names))), 0
    )
