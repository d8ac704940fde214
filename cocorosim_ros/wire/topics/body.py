"""What the messages of one robot must say beside the numbers, and which topics it has."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.scenario.parts.stick_mixing import StickMixing
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.controller import EXTRA_TOPICS
from cocorosim_ros.world.controllers.traits import traits_of
from cocorosim_ros.world.sensors import SENSORS


@dataclass(frozen=True)
class BodyDescription:
    """One robot as its topics show it."""

    name: str
    sensors: tuple[BlueLightSensor, ...]
    actuators: tuple[str, ...]
    topics: tuple[str, ...]  # published by the body: its instruments and what it hears
    speaks: bool  # its controller owes a message to others at every tick
    mixing: StickMixing | None = None  # of sticks that it may be commanded by
    talk: str = ""  # the topic on which its controller may speak, '' for none

    @property
    def frame(self) -> str:
        """REP 105 name of the body frame."""
        return f"{self.name}/base_link"

    @property
    def answers(self) -> tuple[str, ...]:
        """The topics that its controller publishes."""
        return ("thruster_command", self.talk) if self.speaks else ("thruster_command",)


def describe_body(robot: RobotDescription) -> BodyDescription:
    """The body of a scenario's robot. An external controller owes no messages, though it may send some."""
    controller = traits_of(robot.controller)
    sensors = robot.platform.sensors
    present = {topic: sensors.has(topic) for topic, sensor in SENSORS.items() if not (sensor.asked or topic == "pose")}
    present["radio_rx"] = sensors.radio_range > 0.0
    extra = [name for name in EXTRA_TOPICS if name in controller.needs]
    means = {"radio": present["radio_rx"], "blue_light": bool(sensors.blss), "acoustic": robot.acoustic}
    talk = f"{controller.medium}_tx" if means[controller.medium] else ""
    return BodyDescription(
        name=robot.name,
        sensors=sensors.directed,
        actuators=robot.platform.actuator_names,
        mixing=robot.platform.stick_mixing(),
        topics=(*(name for name, there in present.items() if there), *extra),
        speaks=controller.speaks and bool(talk) and not robot.external,
        talk=talk,
    )
