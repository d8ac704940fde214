"""Ranges of a platform's numbers: kept by name, in SI, and sensible."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.scenario.reading.ranges import INTERVAL, Range, collect_ranges
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml


def ranges(rest: str) -> dict[str, Range]:
    """The ranges of a small file."""
    return collect_ranges(parse_yaml(rest, "p.yaml"))


def test_ranges_are_in_si_and_go_by_name() -> None:
    """Parts of a list are called by their name, and g become kg."""
    found = ranges(
        "mass: {value: 440, unit: g, range: [400, 500], source: hand}\n"
        "drag: {value: 1, unit: kg/m, source: hand}\n"
        "actuators:\n  - {name: left, maximum: {value: 1, unit: N, range: [0.5, 2], source: hand}}\n"
    )
    assert found == {"mass": Range(0.4, 0.5, "kg"), "actuators.left.maximum": Range(0.5, 2.0, "N")}


@pytest.mark.parametrize(
    ("value", "limits", "sentence"),
    [
        ("1", "[2, 3]", "leaves out the value '1'; widen it"),
        ("1", "[3, 0]", "write the lowest and the highest value"),
        ("1", "[1]", "write the lowest and the highest value"),
        ("1", "[0, .inf]", "is not a finite number"),
        ("[1, 2]", "[0, 3]", "stands beside a list"),
    ],
)
def test_wrong_ranges(value: str, limits: str, sentence: str) -> None:
    """A range must be two growing numbers around one value."""
    with pytest.raises(CocorosimError, match=sentence):
        ranges(f"mass: {{value: {value}, unit: kg, range: {limits}, source: hand}}\n")


@pytest.mark.parametrize(
    ("limits", "sentence"),
    [
        ("[0, 3]", r"has \[0, 3\] beside a list of 3; write the lowest and the highest of each"),
        ("[[0, 0, 0], [2, 2]]", "of 3 numbers each"),
        ("[[0, 0, 3], [2, 4, 1]]", "write the lowest and the highest value"),
        ("[[2, 0, 0], [3, 4, 4]]", "leaves out the value '1'; widen it"),
    ],
)
def test_wrong_ranges_of_six_degrees(limits: str, sentence: str) -> None:
    """There each number of a list has its own."""
    with pytest.raises(CocorosimError, match=sentence):
        ranges(f"six_degrees: {{added_mass: {{value: [1, 2, 2], unit: kg, range: {limits}, source: hand}}}}\n")


@pytest.mark.parametrize("name", ["hovercraft_epfl", "haizhe_auv"])
def test_ranges_survive_being_written(name: str) -> None:
    """A platform with ranges reads back as it was written; its mass is known within a range only."""
    platform = load_platform(name)
    again = read_platform(entry_of(platform_tree(platform), "again"))
    assert again == platform
    assert again.ranges == platform.ranges
    assert platform.ranges["mass"].low < platform.mass < platform.ranges["mass"].high


def test_vehicles_without_pump_and_yaw_control() -> None:
    """Haizhe's propellers push down and cannot turn it; the hovercraft has no reverse."""
    haizhe, hovercraft = load_platform("haizhe_auv"), load_platform("hovercraft_epfl")
    assert haizhe.actuator_wrenches().tolist() == [[0.0, 0.0, -1.0, 0.0]] * 4
    assert hovercraft.actuator_limits()[:, 1].tolist() == [0.0, 0.0]


def test_a_range_beside_a_law_in_words_is_of_its_number() -> None:
    """In SI units, under the key that the number has where a law stands in codes; the number must lie in it."""
    law = 'law_1: {{surge: {{value: "-0.5 * |u| * u", range: {}, ci95: [-0.6, -0.4], source: hand}}}}\n'
    assert ranges(law.format("[-1, 0]")) == {"law_1.coefficient": Range(-1.0, 0.0, "1")}
    assert collect_ranges(parse_yaml(law.format("[-1, 0]"), "p.yaml"), INTERVAL) == {
        "law_1.coefficient": Range(-0.6, -0.4, "1")
    }
    with pytest.raises(CocorosimError, match=r"range.*leaves out the value '-0\.5 \* \|u\| \* u'"):
        ranges(law.format("[0, 1]"))


def test_an_interval_stands_beside_a_range(tmp_path: Path) -> None:
    """What was measured has a 95 % interval, what may be has a range; a robot of its own has its own interval."""
    (tmp_path / "model.yaml").write_text(
        """based_on: lily
drag: {value: 1.9, unit: kg/m, range: [1, 4], ci95: [1.8, 2.1], source: hand}
robots:
  lily_02: {drag: {value: 2.0, unit: kg/m, ci95: [1.7, 2.2], source: hand}}
""",
        "utf-8",
    )
    model = load_platform(tmp_path / "model.yaml")
    assert model.ranges == {"drag": Range(1.0, 4.0, "kg/m")}
    assert model.intervals == {"drag": Range(1.8, 2.1, "kg/m")}
    assert model.of_robot("lily_02").intervals == {"drag": Range(1.7, 2.2, "kg/m")}
    again = read_platform(entry_of(platform_tree(model), "again"))
    assert again == model
    assert again.of_robot("lily_02").intervals == model.of_robot("lily_02").intervals


def test_a_wrong_interval() -> None:
    """It has to hold its value, and the sentence says which key."""
    with pytest.raises(CocorosimError, match=r"'mass.ci95' has .*leaves out the value '1'; widen it"):
        collect_ranges(parse_yaml("mass: {value: 1, unit: kg, ci95: [2, 3], source: hand}\n", "p.yaml"), INTERVAL)
