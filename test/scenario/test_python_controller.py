"""Scenarios that name a class in a Python file, patterns of external robots, and one controller for all robots."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario

ScenarioFile = Callable[..., Path]
Complaint = Callable[..., str]
SOURCE = "class Mine:\n    def __call__(self, sensed):\n        return {}\n"
OURS = "controller: boids_blt"


def controller_of(path: Path) -> PythonController:
    """The controller of the first robot."""
    controller = load_scenario(path).robots[0].controller
    assert isinstance(controller, PythonController)
    return controller


def test_the_short_form(scenario_file: ScenarioFile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A relative path counts from the scenario's file, wherever one stands; the digest is that of the bytes."""
    (tmp_path / "mine.py").write_text(SOURCE, "utf-8")
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    controller = controller_of(scenario_file((OURS, "controller: mine.py:Mine")))
    assert (controller.file, controller.class_name) == (str(tmp_path / "mine.py"), "Mine")
    assert controller.sha256 == hashlib.sha256(SOURCE.encode()).hexdigest()
    assert controller.values == {}


def test_parameters_stand_as_they_are(scenario_file: ScenarioFile, tmp_path: Path) -> None:
    """Numbers, texts, truth values and lists; overrides of the group replace some and add others."""
    (tmp_path / "mine.py").write_text(SOURCE, "utf-8")
    parameters = "{gain: 1.0e-5, mode: slow, turn: true, speeds: [0.1, 2], none: null, more: {deep: '1'}}"
    long = f"controller: {{file: mine.py:Mine, parameters: {parameters}}}\n    overrides: {{mode: fast, count: 3}}"
    controller = controller_of(scenario_file((OURS, long)))
    expected = {"gain": 1e-5, "mode": "fast", "turn": True, "speeds": [0.1, 2], "none": None, "more": {"deep": "1"}}
    assert controller.values == {**expected, "count": 3}


def test_a_recorded_scenario_is_read_without_the_file(scenario_file: ScenarioFile, tmp_path: Path) -> None:
    """It names file, class, digest and arguments, and is the same scenario again when the file is gone."""
    (tmp_path / "mine.py").write_text(SOURCE, "utf-8")
    long = "controller: {file: mine.py:Mine, parameters: {gain: 1.0e-5, names: [a, b]}}"
    scenario = load_scenario(scenario_file((OURS, long)))
    (tmp_path / "mine.py").unlink()
    text = scenario.to_yaml()
    assert f"{tmp_path / 'mine.py'}:Mine" in text and hashlib.sha256(SOURCE.encode()).hexdigest() in text
    again = parse_scenario(text, "a bag")
    assert again == scenario
    assert again.to_yaml() == text


@pytest.mark.parametrize(
    ("written", "told"),
    [
        (
            "mine.py",
            "x.yaml line 14: 'swarm[0].controller' has 'mine.py', which names no class of a Python file; write",
        ),
        ("mine.py:3", "which names no class of a Python file; write 'my_file.py:MyController'."),
        ("none.py:Mine", "none.py', which cannot be read (No such file or directory); correct it."),
        ("{file: mine.txt:Mine}", "'swarm[0].controller.file' has 'mine.txt:Mine', which names no class"),
        ("{file: mine.py:Mine, gain: 3}", "'swarm[0].controller.gain' is not a known key"),
        ("{file: mine.py:Mine, parameters: 3}", "'swarm[0].controller.parameters' has '3' where a mapping is needed"),
    ],
)
def test_mistakes(complaint: Complaint, tmp_path: Path, written: str, told: str) -> None:
    """File, line and key, what was found, what to write."""
    (tmp_path / "mine.py").write_text(SOURCE, "utf-8")
    assert told in complaint((OURS, f"controller: {written}"))


def test_one_controller_for_all_robots(
    scenario_file: ScenarioFile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The option takes what a scenario takes, counts paths from the present folder, and drops what was overridden."""
    (tmp_path / "mine.py").write_text(SOURCE, "utf-8")
    path = scenario_file((OURS, f"{OURS}\n    overrides: {{alignment_weight: 5}}"))
    monkeypatch.chdir(tmp_path)
    robots = load_scenario(path, controller="mine.py:Mine").robots
    assert {robot.controller.name for robot in robots} == {"Mine"}
    assert {robot.controller.values == {} for robot in robots} == {True}
    assert {robot.controller.name for robot in load_scenario(path, controller="idle").robots} == {"idle"}
    with pytest.raises(CocorosimError, match="The argument 'controller' has 'idel', the name of no controller"):
        load_scenario(path, controller="idel")


@pytest.mark.parametrize(
    ("external", "expected"),
    [
        (["lily_*"], ("lily_01", "lily_02", "lily_03")),
        (["lily_0[23]"], ("lily_02", "lily_03")),
        (["lily_03", "lily_?1"], ("lily_03", "lily_01")),
        (["lily_02", "*_02"], ("lily_02",)),
    ],
)
def test_external_takes_patterns(scenario_file: ScenarioFile, external: list[str], expected: tuple[str, ...]) -> None:
    """In the option and in the file; what is kept are names, each once."""
    assert load_scenario(scenario_file(), external=external).external == expected
    listed = ", ".join(f"'{name}'" for name in external)
    in_file = load_scenario(scenario_file(("swarm:", f"external: [{listed}]\nswarm:")))
    assert in_file.external == expected
    assert [robot.name for robot in in_file.robots if robot.external] == sorted(expected)


def test_a_pattern_that_fits_no_robot(scenario_file: ScenarioFile) -> None:
    """The sentence names the robots."""
    with pytest.raises(CocorosimError) as caught:
        load_scenario(scenario_file(), external=["jeff_*"])
    told = "The argument 'external' has 'jeff_*', a pattern that fits the name of no robot"
    assert told in str(caught.value) and "lily_01, lily_02, lily_03" in str(caught.value)
