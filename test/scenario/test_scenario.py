"""Scenarios: what a good one says, its round trip, and one sentence for each wrong one."""

from __future__ import annotations

import pickle
import time
from dataclasses import replace
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario

from .conftest import BOX, Complaint, ScenarioFile


def test_good_scenario(scenario_file: ScenarioFile) -> None:
    """Times are whole nanoseconds, robots are named after their platform, the rest has its default."""
    scenario = load_scenario(scenario_file())
    assert (scenario.tick_ns, scenario.ticks, scenario.steps_per_tick) == (500_000_000, 20, 5)
    assert (scenario.tick, scenario.duration, scenario.integrator.step) == (0.5, 10.0, 0.1)
    assert [robot.name for robot in scenario.robots] == ["lily_01", "lily_02", "lily_03"]
    assert (scenario.lockstep.silent_controller, scenario.lockstep.patience) == ("thrusters_off", 10.0)
    assert (scenario.recording.topics, scenario.integrator.contact) == ("all", "inelastic")
    assert {robot.radio_range for robot in scenario.robots} == {0.5}
    assert not any(robot.external for robot in scenario.robots)


def test_options_replace_what_the_file_says(scenario_file: ScenarioFile) -> None:
    """Seed, duration and external robots can be given from outside."""
    scenario = load_scenario(scenario_file(), seed=9, duration="1 min", external=["lily_02"])
    assert (scenario.seed, scenario.ticks) == (9, 120)
    assert [robot.external for robot in scenario.robots] == [False, True, False]


def test_radio_range_override(scenario_file: ScenarioFile) -> None:
    """The scenario's radio range replaces that of the platforms."""
    scenario = load_scenario(scenario_file(("swarm:", "radio: {range: 80 cm}\nswarm:")))
    assert {robot.radio_range for robot in scenario.robots} == {0.8}


def test_controller_overrides(scenario_file: ScenarioFile) -> None:
    """A group can change its controller's parameters."""
    overrides = "overrides: {alignment_weight: 0, separation_threshold: 20 cm}\n    start:"
    values = load_scenario(scenario_file(("start:", overrides))).robots[0].controller.values
    assert (values["alignment_weight"], values["separation_threshold"]) == (0.0, 0.2)


def test_names_grow_with_the_count(scenario_file: ScenarioFile) -> None:
    """Numbers have two digits, or as many as the largest needs."""
    box = BOX.replace("size: [1 m, 1 m, 1 m]", "size: [4 m, 4 m, 1 m]")
    robots = load_scenario(scenario_file(("count: 3", "count: 100\n    prefix: fish"), (BOX, box))).robots
    assert (robots[0].name, robots[99].name) == ("fish_001", "fish_100")


def test_files_beside_the_scenario(scenario_file: ScenarioFile) -> None:
    """A path in a scenario counts from the scenario's own folder."""
    path = scenario_file(("platform: lily", "platform: ./own.yaml"))
    (path.parent / "own.yaml").write_text("name: own\nbased_on: lily\n")
    assert load_scenario(path).robots[0].name == "own_01"


@pytest.mark.parametrize("name", ["eleven_lilys", "one_lily", "paper_lilys"])
def test_text_of_a_scenario_is_the_scenario(name: str) -> None:
    """The text is self-contained, reads back equal, and is the same bytes again; so is a pickle."""
    scenario = load_scenario(name, seed=5)
    text = scenario.to_yaml()
    assert parse_scenario(text, "recording") == scenario
    assert parse_scenario(text, "recording").to_yaml() == text
    assert pickle.loads(pickle.dumps(scenario)) == scenario


def test_loading_is_quick() -> None:
    """A scenario with its platform and controller takes less than 0.15 s of processor time."""
    load_scenario("eleven_lilys")
    start = time.process_time()
    load_scenario("eleven_lilys")
    assert time.process_time() - start < 0.15


POSES = "poses: [[0 m, 0 m, -1 m, 0 deg], [1 m, 0 m, -1 m, 90 deg], [2 m, 0 m, -1 m, 0 deg]]"
BALL = "obstacles: [{name: ball, kind: sphere, centre: [1 m, 0 m, -1 m], radius: 0.3 m}]"


def test_explicit_poses(scenario_file: ScenarioFile) -> None:
    """Given poses need no count."""
    scenario = load_scenario(scenario_file((BOX, POSES), ("    count: 3\n", "")))
    assert len(scenario.robots) == 3


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            "size: [6 m, 6 m, 2 m]",
            "size: [6 m, 6 kg, 2 m]",
            "x.yaml line 7: 'tank.size' has '6 kg', which is not a length; write it in m, cm or mm, e.g. '6 m'.",
        ),
        ("size: [6 m, 6 m, 2 m]", "size: 6 m", "'tank.size' has '6 m' where a list is needed"),
        (
            "size: [6 m, 6 m, 2 m]",
            "size: [6 m, -6 m, 2 m]",
            "'tank.size' has '-6 m'; it must be greater than zero.",
        ),
        ("tank:", "tnk:", "line 6: 'tnk' is not a known key; did you mean 'tank'?"),
        ("tick: 0.5 s\n", "", "lacks 'tick'; add it."),
        ("tick: 0.5 s\nduration: 10 s\n", "", "lacks 'tick' and 'duration'; add them."),
        (
            "duration: 10 s",
            "duration: 10",
            "'duration' has '10', which has no unit; write it in s, ms, us, ns, min or h",
        ),
        ("duration: 10 s", "duration: -10 s", "'duration' has '-10 s'; it must be greater than zero."),
        (
            "duration: 10 s",
            "duration: 10.2 s",
            "line 5: 'duration' has '10.2 s', which is not a whole number of ticks of '0.5 s'; "
            "choose a multiple of the tick, e.g. '10 s'.",
        ),
        (
            "tick: 0.5 s",
            "tick: 0.0000000005 s",
            "'tick' has '0.0000000005 s', which is not a whole number of nanoseconds",
        ),
        (
            "step: 100 ms",
            "step: 0.2 s",
            "line 10: 'integrator.step' has '0.2 s', which does not divide the tick of '0.5 s'; "
            "choose the tick or a whole fraction of it, e.g. '0.125 s'.",
        ),
        ("step: 100 ms", "step: 1 s", "e.g. '0.5 s'."),
        (
            "name: rk4",
            "name: rk5",
            "'integrator.name' has 'rk5'; did you mean 'rk4'? Allowed: rk4, semi_implicit_euler.",
        ),
        ("seed: 3", "seed: -3", "'seed' has '-3'; write a whole number from 0 to"),
        ("seed: 3", "seed: 3.5", "'seed' has '3.5'; write a whole number"),
        ("name: small", "name: 5", "'name' has '5' where text is needed"),
        ("count: 3", "count: 0", "line 13: 'swarm[0].count' has '0'; write a whole number from 1 to 100000."),
        ("count: 3", "count: 1000000", "'swarm[0].count' has '1000000'; write a whole number from 1 to 100000."),
        ("    count: 3\n", "", "'swarm[0]' lacks 'count'; add the number of robots."),
        (
            "platform: lily",
            "platform: lilly",
            "line 12: 'swarm[0].platform' has 'lilly', the name of no platform; did you mean 'lily'?",
        ),
        (
            "platform: lily",
            "platform: ./lily.yaml",
            "'swarm[0].platform' names the file 'lily.yaml', which does not exist",
        ),
        (
            "controller: boids_blt",
            "controller: boids",
            "'swarm[0].controller' has 'boids', the name of no controller",
        ),
        (
            "count: 3",
            "count: 3\n    prefix: Lily-1",
            "gives robots the name 'Lily-1', which is no ROS namespace",
        ),
        ("count: 3", "count: 3\n    prefix: a__b", "which is no ROS namespace"),
        ("count: 3", "count: 3\n    prefix: 1st", "which is no ROS namespace"),
        (
            "start:",
            "overrides: {speed_cap: 2}\n    start:",
            "'swarm[0].overrides.speed_cap' has 2, outside what is allowed; choose from 0 to 1.",
        ),
        (
            "start:",
            "overrides: {sped_cap: 1}\n    start:",
            "'swarm[0].overrides.sped_cap' is no parameter of controller 'boids_blt'; did you mean 'speed_cap'?",
        ),
        ("start:", "overrides: {separation_threshold: 1}\n    start:", "which has no unit"),
        (BOX, f"{BOX}\n      {POSES}", "'swarm[0].start' needs either 'box' or 'poses'"),
        (
            "centre: [0 m, 0 m, -1 m]",
            "centre: [0 m, 0 m, 1 m]",
            "line 16: 'swarm[0].start.box' reaches from z = 0.5 m to 1.5 m, out of the tank (-2 m "
            "to 0 m; z is 0 at the surface",
        ),
        (
            "size: [1 m, 1 m, 1 m]",
            "size: [0.1 m, 0.1 m, 0.1 m]",
            "'swarm' cannot be placed: 'lily_02' finds no room in the start box of 0.1 m x 0.1 m "
            "x 0.1 m at least 0.13 m",
        ),
        (
            BOX,
            POSES.replace("2 m, 0 m, -1 m", "2 m, 4 m, -1 m"),
            "'swarm[0].start.poses[2]' puts 'lily_03' at [2 m, 4 m, -1 m], outside the tank; the "
            "tank has x from -3 m to 3 m",
        ),
        (
            BOX,
            POSES.replace("[1 m,", "[0.05 m,"),
            "'swarm[0].start.poses[1]' puts 'lily_02' 0.05 m from 'lily_01', within each other's "
            "hull; keep them 0.13 m apart.",
        ),
        (
            BOX,
            POSES.replace(", [2 m, 0 m, -1 m, 0 deg]", ""),
            "'swarm[0].count' has '3' but 'start.poses' has 2 poses; make them equal.",
        ),
        (BOX, "poses: [[0 m, 0 m, -1 m]]", "write 4 values: [... m, ... m, ... m, ... rad]"),
        (BOX, f"{POSES}\nexternal: [lily_4]", "'external' has 'lily_4', the name of no robot; did you mean"),
        (
            BOX,
            f"{BOX}\nlockstep: {{silent_controller: wait}}",
            "'lockstep.silent_controller' has 'wait'; allowed: stop, thrusters_off.",
        ),
    ],
)
def test_wrong_scenarios(complaint: Complaint, old: str, new: str, sentence: str) -> None:
    """Each mistake is one sentence that begins with the file."""
    told = complaint((old, new))
    assert sentence in told
    assert told.startswith("x.yaml")
    assert "\n" not in told


def test_start_inside_an_obstacle(complaint: Complaint) -> None:
    """A robot whose given place is solid is named with the obstacle."""
    told = complaint(("tank:", f"tank:\n  {BALL}"), (BOX, POSES))
    assert "puts 'lily_02' at [1 m, 0 m, -1 m], inside the obstacle 'ball'" in told


def test_no_groups(complaint: Complaint, scenario_file: ScenarioFile) -> None:
    """A swarm of nobody is refused, whether it has no groups or an empty list of poses."""
    text = scenario_file().read_text()
    told = complaint((text[text.index("swarm:") :], "swarm: []\n"))
    assert "'swarm' has no group of robots; add at least one" in told
    assert "write a whole number from 1 to" in complaint((BOX, "poses: []"), ("    count: 3\n", ""))


def test_a_million_robots_in_groups_that_may_be(complaint: Complaint, scenario_file: ScenarioFile) -> None:
    """Ten groups of as many as one may have are refused in a sentence before anything is made of them."""
    text = scenario_file().read_text()
    group = text[text.index("  - platform") :]
    many = "".join(group.replace("count: 3", f"count: 100000\n    prefix: shoal_{number}") for number in range(10))
    assert "'swarm' has 1,000,000 robots in all its groups, more than the 100,000" in complaint((group, many))


def test_two_groups_of_one_name(complaint: Complaint, scenario_file: ScenarioFile) -> None:
    """Robots of two groups may not have the same names."""
    text = scenario_file().read_text()
    group = text[text.index("  - platform") :]
    assert "'swarm[0]' shares the prefix 'lily' with another group" in complaint((group, group + group))


def test_robots_of_two_groups_in_each_other(complaint: Complaint, scenario_file: ScenarioFile) -> None:
    """Given poses are compared across groups, and the two robots named."""
    text = scenario_file().read_text()
    group = text[text.index("  - platform") :].replace(BOX, POSES)
    other = group.replace("count: 3", "count: 3\n    prefix: fish")
    assert "puts 'fish_01' 0 m from 'lily_01'" in complaint((text[text.index("  - platform") :], group + other))


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"duration": "10 kg"}, "The argument 'duration' has '10 kg', which is not a time"),
        (
            {"duration": "0.7 s"},
            "The argument 'duration' has '0.7 s', which is not a whole number of ticks",
        ),
        ({"seed": -1}, "The argument 'seed' has '-1'"),
        ({"external": ["lily_9"]}, "The argument 'external' has 'lily_9', the name of no robot"),
    ],
)
def test_wrong_options(scenario_file: ScenarioFile, options: dict[str, object], sentence: str) -> None:
    """A wrong option is said to be one of the option, not of the file."""
    with pytest.raises(CocorosimError) as caught:
        load_scenario(scenario_file(), **options)  # type: ignore[arg-type]
    assert sentence in str(caught.value)


def test_unknown_scenario() -> None:
    """A misspelt name is answered with the nearest one, a missing path with the path."""
    with pytest.raises(
        CocorosimError, match=r"'eleven_lily' is the name of no scenario; did you mean 'eleven_lilys'\?"
    ):
        load_scenario("eleven_lily")
    with pytest.raises(CocorosimError, match="does not exist; check the path"):
        load_scenario(Path("nowhere") / "x.yaml")


def test_robots_that_differ_swim_as_they_are() -> None:
    """A platform's own numbers for one robot reach that robot and no other."""
    scenario = load_scenario("five_lilys")
    (group,) = scenario.swarm
    platform = replace(group.platform, robots={"lily_02": replace(group.platform, mass=0.5)})
    robots = replace(scenario, swarm=(replace(group, platform=platform),)).robots
    assert {robot.name: robot.platform.mass for robot in robots if robot.platform.mass != 0.44} == {"lily_02": 0.5}


def test_a_platform_is_no_scenario() -> None:
    """A platform's file in the place of a scenario is named as what it is, with the way to use it."""
    lily = Path("config") / "platforms" / "lily.yaml"
    words = "describes a platform, as 'actuators' shows, and no scenario"
    with pytest.raises(CocorosimError, match=words) as raised:
        load_scenario(Path(__file__).parents[2] / lily)
    assert str(lily) in str(raised.value)
