"""Platform files: Lily's numbers, wrenches of any fixed thrusters, and the sentences about wrong files."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.scenario.parts.platform import Platform, load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.parts.platform_checks import check_effects
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.reading.quantity import Sign
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml, yaml_text

LEVER = 0.055 * math.cos(math.radians(63))
SOURCE = 'source: "hand"'
BOAT = f"""\
name: boat
description: a model boat with two propellers and a weak reverse, and a bow thruster to the left
hull:
  length: {{value: 0.6, unit: m, {SOURCE}}}
  width: {{value: 0.2, unit: m, {SOURCE}}}
  height: {{value: 0.1, unit: m, {SOURCE}}}
mass: {{value: 2, unit: kg, {SOURCE}}}
yaw_inertia: {{value: 0.06, unit: kg m^2, {SOURCE}}}
drag: {{value: 3, unit: kg/m, {SOURCE}}}
yaw_drag: {{value: 0.1, unit: N m s^2, {SOURCE}}}
water_density: {{value: 1000, unit: kg/m^3, {SOURCE}}}
gravity: {{value: 9.81, unit: m/s^2, {SOURCE}}}
actuators:
  - name: port
    kind: thruster
    position: {{value: [-30, 5, 0], unit: cm, {SOURCE}}}
    direction: {{value: [1, 0, 0], unit: "1", {SOURCE}}}
    maximum: {{value: 4, unit: N, {SOURCE}}}
    maximum_reverse: {{value: 3, unit: N, {SOURCE}}}
  - name: bow
    kind: thruster
    position: {{value: [0.25, 0, 0], unit: m, {SOURCE}}}
    direction: {{value: [0, 2, 0], unit: "1", {SOURCE}}}
    maximum: {{value: 1, unit: N, {SOURCE}}}
sensors:
  compass: true
effects:
  linear_drag:
    surge: {{value: 0.3, unit: N s/m, {SOURCE}}}
"""


def boat(tmp_path: Path, old: str = "", new: str = "") -> Platform:
    """The boat's file with one piece replaced, loaded."""
    assert old in BOAT
    path = tmp_path / "boat.yaml"
    path.write_text(BOAT.replace(old, new))
    return load_platform(path)


def test_lily_has_the_numbers_of_the_contract() -> None:
    """Lily's terminal speed, yaw rate and pump force follow from its file as the paper states them."""
    lily = load_platform("lily")
    thrust = sum(part.maximum for part in lily.actuators if isinstance(part, Thruster))
    torque = 2 * 0.005 * LEVER
    assert (lily.mass, lily.yaw_inertia, lily.drag, lily.yaw_drag) == (0.44, 4.05e-4, 1.7778, 1.140e-4)
    assert lily.actuator_names == ("left", "right", "buoyancy")
    assert math.sqrt(thrust / lily.drag) == pytest.approx(0.075, rel=1e-4)
    assert math.sqrt(torque / lily.yaw_drag) == pytest.approx(1.48, rel=1e-3)
    assert (lily.hull.length, lily.hull.width, lily.hull.height) == (0.13, 0.10, 0.07)
    assert lily.effects == {}


def test_a_map_is_no_platform() -> None:
    """A map of `convert` that is given for the platform of a diagnosis."""
    with pytest.raises(
        CocorosimError, match=r"odometry_bag\.yaml is a map of `cocorosim convert`.*, no platform; give"
    ):
        load_platform(Path(__file__).parents[2] / "config" / "maps" / "odometry_bag.yaml")


def test_lily_wrenches() -> None:
    """The left thruster pushes ahead and turns to the right, the pump lifts 0.0981 N."""
    lily = load_platform("lily")
    expected = [[1.0, 0.0, 0.0, -LEVER], [1.0, 0.0, 0.0, LEVER], [0.0, 0.0, 1.0, 0.0]]
    np.testing.assert_allclose(lily.actuator_wrenches(), expected, rtol=1e-15)
    limits = [[0.005, 0.005], [0.005, 0.005], [0.0981, 0.0981]]
    np.testing.assert_allclose(lily.actuator_limits(), limits, rtol=1e-14)
    radius = [math.hypot(*part.position) for part in lily.actuators if isinstance(part, Thruster)]
    assert radius == pytest.approx([0.055, 0.055], rel=1e-15)


def test_lily_sensors() -> None:
    """Five cones of 120 degrees: +-60, 180, up and down; rays at the limits of the level ones."""
    cones = {part.name: part for part in load_platform("lily").sensors.blss}
    axes = {name: (math.degrees(part.azimuth), math.degrees(part.elevation)) for name, part in cones.items()}
    expected = {
        "front_left": (60, 0),
        "front_right": (-60, 0),
        "back": (180, 0),
        "up": (0, 90),
        "down": (0, -90),
    }
    assert list(axes) == list(expected)
    for name, axis in expected.items():
        assert axes[name] == pytest.approx(axis)
        level = axis[1] == 0
        assert np.degrees(cones[name].obstacle_rays) == pytest.approx([0, 60, -60] if level else [0])
        assert math.degrees(cones[name].cone_angle) == pytest.approx(120)
        assert (cones[name].neighbour_range, cones[name].obstacle_range) == (0.5, 0.3)


def test_lily_operating_system() -> None:
    """The full command gives 127 / 51 / 2.5 of an actuator's maximum."""
    system = load_platform("lily").operating_system
    assert system is not None
    assert system.full_command_fraction == pytest.approx(0.99608, abs=1e-5)


def test_paper_lily_differs_in_inertia_alone() -> None:
    """`lily_paper` is Lily but for the moment of inertia, name and description."""
    lily, paper = platform_tree(load_platform("lily")), platform_tree(load_platform("lily_paper"))
    assert {key for key in lily if lily[key] != paper[key]} == {"name", "description", "yaw_inertia"}
    assert load_platform("lily_paper").yaw_inertia == 5e-4


def test_any_fixed_thrusters(tmp_path: Path) -> None:
    """Directions are made unit vectors; moments are x * Fy - y * Fx; reverse has its own maximum."""
    vehicle = boat(tmp_path)
    np.testing.assert_allclose(vehicle.actuator_wrenches(), [[1, 0, 0, -0.05], [0, 1, 0, 0.25]])
    np.testing.assert_array_equal(vehicle.actuator_limits(), [[4, 3], [1, 1]])
    assert vehicle.operating_system is None
    assert vehicle.sensors.radio_range == 0.0


def test_vehicle_without_actuators(tmp_path: Path) -> None:
    """A drifter has arrays of no rows."""
    start, end = BOAT.index("actuators:"), BOAT.index("sensors:")
    drifter = boat(tmp_path, BOAT[start:end], "actuators: []\n")
    assert drifter.actuator_wrenches().shape == (0, 4)
    assert drifter.actuator_limits().shape == (0, 2)


def test_platform_reads_back_and_pickles(tmp_path: Path) -> None:
    """Writing a platform out and reading it again, or sending it to another process, changes nothing."""
    for platform in (load_platform("lily"), boat(tmp_path)):
        text = yaml_text(platform_tree(platform))
        assert read_platform(parse_yaml(text, "t")) == platform
        assert pickle.loads(pickle.dumps(platform)) == platform
        hash(platform)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            "mass: {value: 2, unit: kg",
            "mass: {value: 2, unit: m",
            "line 7: 'mass' has '2 m', which is not a mass",
        ),
        ("mass: {value: 2,", "mass: {value: -2,", "'mass' has '-2 kg'; it must be greater than zero."),
        ("mass: {", "masse: {", "line 7: 'masse' is not a known key; did you mean 'mass'?"),
        (f"{{value: 2, unit: kg, {SOURCE}}}", "2 kg", "line 7: 'mass' has '2 kg' without a source"),
        (f"mass: {{value: 2, unit: kg, {SOURCE}}}\n", "", "line 1: lacks 'mass'; add it."),
        ("kind: thruster", "kind: truster", "'actuators[0].kind' has 'truster'; did you mean 'thruster'?"),
        (
            "    kind: thruster\n",
            "",
            "'actuators[0]' lacks 'kind'; allowed: thruster, buoyancy, rudder, azimuth, fin, sliding_mass.",
        ),
        ("value: [0, 2, 0]", "value: [0, 0, 0]", "which points nowhere"),
        ("value: [0, 2, 0]", "value: [0, 2]", "write 3 values"),
        ("name: bow", "name: port", "'actuators' has the name 'port' more than once"),
        ("compass: true", "compass: 1", "'sensors.compass' has '1' without a source"),
        ("compass: true", "compass: maybe", "'sensors.compass' has 'maybe'; write true or false."),
        ("unit: N s/m", "unit: N h", "'effects.linear_drag.surge' has '0.3 N h', whose unit is unknown"),
        (
            "name: boat",
            "name: boat\nbased_on: lilly",
            "'based_on' has 'lilly', the name of no platform; did you mean",
        ),
    ],
)
def test_wrong_files(tmp_path: Path, old: str, new: str, sentence: str) -> None:
    """Each mistake is one sentence with line and key."""
    with pytest.raises(CocorosimError) as caught:
        boat(tmp_path, old, new)
    assert sentence in str(caught.value)
    assert "boat.yaml" in str(caught.value)


def test_cone_wider_than_a_sphere() -> None:
    """A cone of more than a full turn is refused."""
    tree = platform_tree(load_platform("lily"))
    tree["sensors"]["blss"][0]["cone_angle"] = "400 deg"
    with pytest.raises(CocorosimError, match="a cone is at most 360 deg wide"):
        read_platform(parse_yaml(yaml_text(tree), "t"))


def test_platform_based_on_itself(tmp_path: Path) -> None:
    """A circle of files is said to be one, not followed for ever."""
    for own, other in (("a", "b"), ("b", "a")):
        (tmp_path / f"{own}.yaml").write_text(f"name: {own}\nbased_on: {other}.yaml\n")
    with pytest.raises(CocorosimError, match="is based on this platform itself"):
        load_platform(tmp_path / "a.yaml")


def test_unknown_name_gives_near_matches() -> None:
    """A misspelt name is answered with the nearest one."""
    with pytest.raises(CocorosimError, match=r"'lilly' is the name of no platform; did you mean 'lily'\?"):
        load_platform("lilly")


EFFECTS = {"linear_drag": {name: Parameter(name, "N s/m", "drag") for name in ("surge", "sway")}}


def test_effects_are_checked_against_a_table(tmp_path: Path) -> None:
    """Known effects with right dimensions pass, and come as plain SI numbers."""
    vehicle = boat(tmp_path)
    check_effects(vehicle, EFFECTS)
    assert vehicle.effects == {"linear_drag": {"surge": 0.3}}


@pytest.mark.parametrize(
    ("table", "sentence"),
    [
        ({"linear_drags": {}}, "'effects.linear_drag' is no known effect; did you mean 'linear_drags'?"),
        (
            {"linear_drag": {"sway": Parameter("sway", "N s/m", "drag")}},
            "'effects.linear_drag.surge' is no parameter of this effect",
        ),
        ({"linear_drag": {"surge": Parameter("surge", "N", "drag")}}, "has '0.3 N s/m', which is no force"),
        (
            {"linear_drag": {**EFFECTS["linear_drag"], "time": Parameter("time", "s", "when", needed=True)}},
            "'effects.linear_drag' lacks 'time' (when); add it, in s.",
        ),
    ],
)
def test_effects_outside_the_table(tmp_path: Path, table: dict[str, dict[str, Parameter]], sentence: str) -> None:
    """Unknown effects, unknown parameters, wrong dimensions and what is missing are told apart."""
    with pytest.raises(CocorosimError) as caught:
        check_effects(boat(tmp_path), table)
    assert sentence in str(caught.value)


@pytest.mark.parametrize(
    ("sign", "value", "sentence"),
    [("positive", "0", "must be greater than zero"), ("not negative", "-0.3", "must not be negative")],
)
def test_signs_of_effects(tmp_path: Path, sign: Sign, value: str, sentence: str) -> None:
    """A number that cannot be zero or negative is refused with the reason."""
    path = tmp_path / "signed.yaml"
    path.write_text(BOAT.replace("value: 0.3, unit: N s/m", f"value: {value}, unit: N s/m"))
    with pytest.raises(CocorosimError, match=sentence):
        check_effects(load_platform(path), {"linear_drag": {"surge": Parameter("surge", "N s/m", "drag", sign=sign)}})


OWN = f"""\
robots:
  boat_02:
    mass: {{value: 2.5, unit: kg, {SOURCE}}}
    effects: {{}}
frame_corrections:
  compass: the reading is in degrees
"""


def own_boats(tmp_path: Path, own: str = OWN) -> Platform:
    """The boat with a robot that differs."""
    path = tmp_path / "boats.yaml"
    path.write_text(BOAT + own)
    return load_platform(path)


def test_a_robot_may_differ(tmp_path: Path) -> None:
    """Below 'robots' whole keys are replaced for the robot of that name, the others are as the platform says."""
    boats = own_boats(tmp_path)
    second = boats.of_robot("boat_02")
    assert boats.of_robot("boat_01") is boats
    assert (boats.mass, second.mass) == (2.0, 2.5)
    assert (boats.effects, second.effects) == ({"linear_drag": {"surge": 0.3}}, {})
    assert second.frame_corrections == {"compass": "the reading is in degrees"}
    assert second.drag == boats.drag


def test_robots_that_differ_survive_writing(tmp_path: Path) -> None:
    """What platform_tree writes reads as the same platform, effects that are taken away included."""
    boats = own_boats(tmp_path)
    again = read_platform(parse_yaml(yaml_text(platform_tree(boats)), "written"))
    assert again == boats
    assert again.of_robot("boat_02").effects == {}


def test_robots_of_a_platform_have_the_same_actuators(tmp_path: Path) -> None:
    """Other actuators would be another platform: the sentence names both."""
    own = f"""\
robots:
  boat_02:
    actuators:
      - name: only
        kind: buoyancy
        neutral_volume: {{value: 1, unit: cm^3, {SOURCE}}}
        volume_range: {{value: 1, unit: cm^3, {SOURCE}}}
"""
    with pytest.raises(CocorosimError, match=r"'robots\.boat_02' has the actuators 'only'.*'port' and 'bow'"):
        own_boats(tmp_path, own)
