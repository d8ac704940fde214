"""The layouts for Foxglove, Lichtblick, RViz and PlotJuggler show what a recording has, by the contract's names."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from ruamel.yaml import YAML

from cocorosim_ros.diagnosis.findings import (
    BodyVelocity,
    CourseVelocity,
    Diagnosis,
    FreeRun,
    GatheredEvidence,
    ResidualForce,
)
from cocorosim_ros.diagnosis.report.overlay import write_overlay
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.library.record import new_record
from cocorosim_ros.wire.bags.bag_reader import Bag, RecordedMessage, read_bag
from cocorosim_ros.wire.cdr.type_store import deserialize
from cocorosim_ros.wire.topics.topics import split_topic
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.terms.course import Course

CONFIG = Path(__file__).parents[2] / "config"
FOXGLOVE = sorted((CONFIG / "foxglove").glob("*.json"))
CONTRACT = {
    "pose": "geometry_msgs/msg/PoseStamped",
    "compass": "cocorosim_msgs/msg/Compass",
    "pressure": "sensor_msgs/msg/FluidPressure",
    "imu": "sensor_msgs/msg/Imu",
    "velocity": "geometry_msgs/msg/TwistStamped",
    "thruster_command": "cocorosim_msgs/msg/ThrusterCommand",
    "shoal_statistics": "cocorosim_msgs/msg/ShoalStatistics",
    "diagnostics": "diagnostic_msgs/msg/DiagnosticArray",
    "tank": "visualization_msgs/msg/MarkerArray",
    "swarm": "visualization_msgs/msg/MarkerArray",
    "robot_description": "std_msgs/msg/String",
    "residuals": "visualization_msgs/msg/MarkerArray",
    "residual_force": "geometry_msgs/msg/WrenchStamped",
    "residual_force_left": "geometry_msgs/msg/WrenchStamped",
    "evidence": "std_msgs/msg/Float64",
}
MARKERS = {"/markers/tank", "/markers/swarm"}
PAPER = {"polarisation", "angular_momentum", "shoal_speed", "separation", "lost", "shoals"}


@dataclass(frozen=True)
class Shown:
    """One number that a layout draws: its topic, the way to it in the message, and what the layout calls it."""

    topic: str
    path: tuple[str, ...]
    label: str = ""


@dataclass(frozen=True)
class Opened:
    """Bags that a viewer has opened together."""

    bags: tuple[Bag, ...]

    @property
    def types(self) -> dict[str, str]:
        """The type of every topic."""
        return {topic: kind for bag in self.bags for topic, kind in bag.summary.types.items()}

    def messages(self, topics: Iterable[str]) -> Iterator[RecordedMessage]:
        """The messages of these topics, one bag after the other."""
        wanted = set(topics)
        for bag in self.bags:
            yield from bag.messages(wanted & bag.summary.types.keys())


@pytest.fixture(scope="module")
def overlay(tmp_path_factory: pytest.TempPathFactory) -> Bag:
    """What a diagnosis of lily_01 lays over its recording: ghosts, velocities, forces and evidence of ten seconds."""
    time, still = np.arange(0.0, 10.0), np.zeros((10, 4))
    corners = np.full(3, -1.0), np.zeros(3)
    course = Course(time, np.zeros((10, 8)), still, still, still, np.zeros(4, bool), corners, np.zeros((1, 0, 5)), -1)
    velocity = BodyVelocity(still, still)
    forces = (ResidualForce("lily_01", still, still, course),)
    diagnosis = Diagnosis(
        *("mismatch", "", (), (), (), (), (), {}),
        residual_before=forces,
        residual_after=forces,
        free_runs=(FreeRun("lily_01", time, *(still for _ in range(4)), velocity=velocity),),
        velocities=(CourseVelocity("lily_01", time, velocity),),
        gathered=(GatheredEvidence("lily_01", time, time),),
    )
    folder = tmp_path_factory.mktemp("layouts") / "overlay"
    write_overlay(diagnosis, 0.15, folder)
    return read_bag(folder)


@pytest.fixture(scope="module")
def bag(tmp_path_factory: pytest.TempPathFactory) -> Bag:
    """The first second of the main job: eleven Lilys."""
    folder = tmp_path_factory.mktemp("layouts") / "bag"
    scenario = load_scenario("eleven_lilys", duration="1 s")
    record = new_record(scenario, folder)
    run_in_process(scenario, record)
    record.close()
    return read_bag(folder)


def panels(layout: Any) -> Iterator[str]:
    """The names of all panels in a tree of splits."""
    if isinstance(layout, str):
        yield layout
    else:
        yield from panels(layout["first"])
        yield from panels(layout["second"])


def foxglove_numbers(content: dict[str, Any]) -> list[Shown]:
    """What the plots of a layout draw; a path is TOPIC.field.field[index]."""
    found = []
    for name, panel in content["configById"].items():
        for line in panel["paths"] if name.startswith("Plot!") else ():
            topic, _, fields = line["value"].partition(".")
            found.append(Shown(topic, tuple(re.findall(r"\w+", fields)), line["label"]))
    return found


def plotjuggler_numbers(bag: Bag) -> list[Shown]:
    """What the curves of PlotJuggler's layout draw; a name is TOPIC/field/field[index]."""
    found = []
    for area in ElementTree.parse(CONFIG / "plotjuggler/swarm.xml").iter("DockArea"):
        for curve in area.iter("curve"):
            name = curve.attrib["name"]
            topic = next(topic for topic in bag.summary.types if name.startswith(topic + "/"))
            found.append(Shown(topic, tuple(re.findall(r"\w+", name.removeprefix(topic))), area.attrib["name"]))
    return found


def check(bag: Opened, shown: list[Shown]) -> None:
    """Every number is there in the first message of its topic, whose type is that of the contract."""
    topics = {each.topic for each in shown}
    first = {}
    for message in bag.messages(topics):
        first.setdefault(message.topic, deserialize(message.type_name, message.data))
    assert set(first) == topics
    for each in shown:
        assert bag.types[each.topic] == CONTRACT[split_topic(each.topic)[1]]
        value = first[each.topic]
        for step in each.path:
            value = value[int(step)] if step.isdecimal() else getattr(value, step)
        assert isinstance(float(value), float)


def metrics_shown(bag: Bag, shown: list[Shown]) -> dict[str, str]:
    """By the name of the metric that is drawn what the layout calls it."""
    message = next(iter(bag.messages(["/shoal_statistics"])))
    names = deserialize(message.type_name, message.data).name
    return {names[int(each.path[1])]: each.label for each in shown if each.topic == "/shoal_statistics"}


@pytest.mark.parametrize("file", FOXGLOVE, ids=lambda file: file.stem)
def test_foxglove_and_lichtblick(file: Path, bag: Bag, overlay: Bag) -> None:
    """Every panel that is laid out is described and the other way round; every topic and number is recorded.

    The layout of a diagnosis shows its overlay beside the recording.
    """
    opened = Opened((bag, overlay) if file.stem == "diagnosis" else (bag,))
    content = json.loads(file.read_text("utf-8"))
    assert sorted(panels(content["layout"])) == sorted(content["configById"])
    shown = foxglove_numbers(content)
    assert len(shown) > 10
    check(opened, shown)
    for name, panel in content["configById"].items():
        topics = panel["topics"] if name.startswith("3D!") else [panel["topicPath"]] if "topicPath" in panel else []
        assert all(opened.types[topic] == CONTRACT[split_topic(topic)[1]] for topic in topics)
        if name.startswith("3D!"):
            recorded = [topic for topic in topics if topic in bag.summary.types and topic not in MARKERS]
            frames = {"world", *(f"{split_topic(topic)[0]}/base_link" for topic in recorded)}
            layers = panel["layers"].values()
            grids = [layer["frameId"] for layer in layers if layer["layerId"] == "foxglove.Grid"]
            assert {panel["followTf"], *grids} <= frames
            models = [layer["topic"] for layer in layers if layer["layerId"] == "foxglove.Urdf"]
            assert {split_topic(topic)[0] for topic in models} == {split_topic(topic)[0] for topic in recorded}
            assert {bag.summary.types[topic] for topic in models} == {CONTRACT["robot_description"]}


def test_the_overlay_is_in_the_layout_of_a_diagnosis(overlay: Bag) -> None:
    """Every topic of the overlay is drawn: ghosts and arrows in the tank, velocities, forces and evidence as curves."""
    content = json.loads((CONFIG / "foxglove/diagnosis.json").read_text("utf-8"))
    drawn = {*content["configById"]["3D!robot"]["topics"], *(each.topic for each in foxglove_numbers(content))}
    assert set(overlay.summary.types) <= drawn


def test_all_robots_and_metrics_are_in_the_swarm_s_layouts(bag: Bag) -> None:
    """Eleven poses and the paper's six metrics, each under its own name."""
    poses = {topic for topic in bag.summary.types if topic.endswith("/pose")}
    content = json.loads((CONFIG / "foxglove/swarm.json").read_text("utf-8"))
    assert set(content["configById"]["3D!tank"]["topics"]) == poses | MARKERS
    named = metrics_shown(bag, foxglove_numbers(content))
    assert set(named) == PAPER
    assert all(label == metric for metric, label in named.items())
    named = metrics_shown(bag, plotjuggler_numbers(bag))
    assert set(named) == PAPER
    assert all(label.lower().replace(" ", "_").startswith(metric) for metric, label in named.items())


def test_plotjuggler(bag: Bag) -> None:
    """Every curve is a recorded number, and the shares of each splitter belong to its plots."""
    check(Opened((bag,)), plotjuggler_numbers(bag))
    for splitter in ElementTree.parse(CONFIG / "plotjuggler/swarm.xml").iter("DockSplitter"):
        count = len(splitter.findall("DockArea"))
        assert int(splitter.attrib["count"]) == len(splitter.attrib["sizes"].split(";")) == count


def test_rviz(bag: Bag) -> None:
    """Each robot has its arrow and its body, the markers are shown; RViz asks for each topic as it is offered."""
    content = YAML(typ="safe").load((CONFIG / "rviz/swarm.rviz").read_text("utf-8"))["Visualization Manager"]
    arrows = [each for each in content["Displays"] if each["Class"] == "rviz_default_plugins/Pose"]
    assert {each["Topic"]["Value"] for each in arrows} == {t for t in bag.summary.types if t.endswith("/pose")}
    asked = [each.get("Topic") or each.get("Description Topic") for each in content["Displays"]]
    topics = {each["Value"]: each for each in asked if each}
    bodies = {topic for topic in bag.summary.types if topic.endswith("/robot_description")}
    assert set(topics) == {each["Topic"]["Value"] for each in arrows} | bodies | MARKERS
    for topic, each in topics.items():
        assert bag.summary.types[topic] == CONTRACT[split_topic(topic)[1]]
        offered = {entry.topic: entry.offered_qos_profiles for entry in bag.summary.topics}[topic]
        assert f"reliability: {each['Reliability Policy'].lower()}" in offered
        assert f"durability: {each['Durability Policy'].lower().replace(' ', '_')}" in offered
