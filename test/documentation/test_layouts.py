"""The layouts for Foxglove, Lichtblick, RViz and PlotJuggler show what a recording has, by the contract's names."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from ruamel.yaml import YAML

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.library.record import new_record
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.cdr.type_store import deserialize
from cocorosim_ros.wire.topics.topics import split_topic
from cocorosim_ros.world.checks.loading import load_scenario

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
}
MARKERS = {"/markers/tank", "/markers/swarm"}
PAPER = {"polarisation", "angular_momentum", "shoal_speed", "separation", "lost", "shoals"}


@dataclass(frozen=True)
class Shown:
    """One number that a layout draws: its topic, the way to it in the message, and what the layout calls it."""

    topic: str
    path: tuple[str, ...]
    label: str = ""


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


def check(bag: Bag, shown: list[Shown]) -> None:
    """Every number is there in the first message of its topic, whose type is that of the contract."""
    topics = {each.topic for each in shown}
    first = {}
    for message in bag.messages(topics):
        first.setdefault(message.topic, deserialize(message.type_name, message.data))
    assert set(first) == topics
    for each in shown:
        assert bag.summary.types[each.topic] == CONTRACT[split_topic(each.topic)[1]]
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
def test_foxglove_and_lichtblick(file: Path, bag: Bag) -> None:
    """Every panel that is laid out is described and the other way round; every topic and number is recorded."""
    content = json.loads(file.read_text("utf-8"))
    assert sorted(panels(content["layout"])) == sorted(content["configById"])
    shown = foxglove_numbers(content)
    assert len(shown) > 10
    check(bag, shown)
    for name, panel in content["configById"].items():
        topics = panel["topics"] if name.startswith("3D!") else [panel["topicPath"]] if "topicPath" in panel else []
        assert all(bag.summary.types[topic] == CONTRACT[split_topic(topic)[1]] for topic in topics)
        if name.startswith("3D!"):
            frames = {"world", *(f"{split_topic(topic)[0]}/base_link" for topic in topics)}
            layers = panel["layers"].values()
            grids = [layer["frameId"] for layer in layers if layer["layerId"] == "foxglove.Grid"]
            assert {panel["followTf"], *grids} <= frames
            models = [layer["topic"] for layer in layers if layer["layerId"] == "foxglove.Urdf"]
            assert {split_topic(topic)[0] for topic in models} == {split_topic(t)[0] for t in {*topics} - MARKERS}
            assert {bag.summary.types[topic] for topic in models} == {CONTRACT["robot_description"]}


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
    check(bag, plotjuggler_numbers(bag))
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
