"""The topics of the contract, in one table: name, type, publisher, quality of service."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.topics.actuator_feedback import FEEDBACK
from cocorosim_ros.wire.topics.service_quality import CLOCK, LATCHED, STREAM, TRANSFORMS, ServiceQuality
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.sensor import Sensor

__all__ = [
    "DRAWN",
    "GLOBAL_TOPICS",
    "ROBOT_TOPICS",
    "TOPICS",
    "Topic",
    "is_drawn",
    "robot_topic",
    "split_topic",
    "stamp_ns",
]


@dataclass(frozen=True)
class Topic:
    """One row of the table."""

    name: str  # relative to the robot's namespace, or absolute with a leading slash
    type_name: str
    publisher: str  # who publishes it, in words
    quality: ServiceQuality
    optional: bool
    meaning: str
    drawn: bool = False  # for viewers alone and made from the rest: no part of a recording's digest

    @property
    def per_robot(self) -> bool:
        """Whether every robot has this topic under its own namespace."""
        return not self.name.startswith("/")


def _of_sensor(sensor: Sensor) -> Topic:
    return Topic(sensor.topic, sensor.message, sensor.publisher, STREAM, sensor.optional, sensor.meaning)


_ROBOT = [
    *(_of_sensor(sensor) for sensor in SENSORS.values() if not sensor.asked),
    Topic("thruster_command", "cocorosim_msgs/msg/ThrusterCommand", "controller", STREAM, False,
          "what the controller asks of the actuators"),
    Topic(FEEDBACK, "cocorosim_msgs/msg/ActuatorFeedback", "robot", STREAM, True,
          "what the actuators report: rotation, angle, current, voltage; of recordings, no simulation makes it"),
    Topic("radio_tx", "cocorosim_msgs/msg/RadioMessage", "controller", STREAM, True,
          "what the robot says"),
    Topic("radio_rx", "cocorosim_msgs/msg/RadioInbox", "simulation, or the radio driver", STREAM, True,
          "what the robot has heard since its last inbox"),
    *(_of_sensor(sensor) for sensor in SENSORS.values() if sensor.asked),
    Topic("blue_light_tx", "cocorosim_msgs/msg/RadioMessage", "controller", STREAM, True,
          "what the robot says over its blue-light sensors"),
    Topic("blue_light_rx", "cocorosim_msgs/msg/RadioInbox", "simulation, or the blue-light driver", STREAM, True,
          "what the robot has heard over its blue-light sensors, where the controller asks for it"),
    Topic("acoustic_tx", "cocorosim_msgs/msg/RadioMessage", "controller", STREAM, True,
          "what the robot says by sound"),
    Topic("acoustic_rx", "cocorosim_msgs/msg/AcousticInbox", "simulation, or the acoustic modem", STREAM, True,
          "what the robot has heard by sound, with ranges, where the controller asks for it"),
    Topic("neighbours", "cocorosim_msgs/msg/Neighbours", "simulation", STREAM, True,
          "exact places and velocities of all robots within 0.5 m, where the controller asks for it"),
    Topic("robot_description", "std_msgs/msg/String", "simulation", LATCHED, True,
          "the robot as URDF, made from its platform", drawn=True),
]  # fmt: skip
_GLOBAL = [
    Topic("/clock", "rosgraph_msgs/msg/Clock", "simulation", CLOCK, False,
          "simulated time"),
    Topic("/tf", "tf2_msgs/msg/TFMessage", "simulation", TRANSFORMS, True,
          "`world` to each robot's base_link"),
    Topic("/shoal_statistics", "cocorosim_msgs/msg/ShoalStatistics", "metrics", STREAM, True,
          "the shoal's metrics at this moment"),
    Topic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", "simulation", STREAM, True,
          "what went wrong with which robot, and how the run ended"),
    Topic("/tf_static", "tf2_msgs/msg/TFMessage", "simulation", LATCHED, True,
          "each base_link to the robot's thrusters, and to its sensors that look in a direction", drawn=True),
    Topic("/markers/tank", "visualization_msgs/msg/MarkerArray", "simulation", LATCHED, True,
          "tank, obstacles, lamps and the robots' names, to be drawn", drawn=True),
    Topic("/markers/swarm", "visualization_msgs/msg/MarkerArray", "metrics", STREAM, True,
          "trails of the robots and jets of their thrusters, every 2 s, to be drawn", drawn=True),
]  # fmt: skip
ROBOT_TOPICS = {topic.name: topic for topic in _ROBOT}
GLOBAL_TOPICS = {topic.name: topic for topic in _GLOBAL}
DRAWN = frozenset(name for name, topic in {**ROBOT_TOPICS, **GLOBAL_TOPICS}.items() if topic.drawn)
TOPICS = {**ROBOT_TOPICS, **GLOBAL_TOPICS}


def robot_topic(namespace: str, name: str) -> str:
    """The absolute name of a robot's topic: ("lily_01", "pose") is /lily_01/pose."""
    return "/" + "/".join(part for part in (namespace.strip("/"), name) if part)


def is_drawn(topic: str) -> bool:
    """Whether an absolute topic is for viewers alone."""
    return topic in DRAWN or split_topic(topic)[1] in DRAWN


def split_topic(topic: str) -> tuple[str, str]:
    """Namespace and last name of an absolute topic: /tank/lily_01/pose is (tank/lily_01, pose)."""
    namespace, _, name = topic.strip("/").rpartition("/")
    return namespace, name
