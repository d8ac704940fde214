"""`cocorosim diagnose ... --against ...` as it is typed; the comparison itself is played by a stand-in."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, Estimate, FoundEffect, Recalibrated
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config

Command = Callable[..., SimpleNamespace]


def found(bad: Any, good: Any) -> Diagnosis:
    """A weak left thruster, late commands and more drag than the learned vehicle has."""
    robots = tuple(robot.name for recording in bad.recordings for robot in recording.robots)
    before = tuple(
        Recalibrated(name, nominal, Estimate(value, 0.9 * value, 1.1 * value, unit), robots)
        for name, nominal, value, unit in (("drag", 1.7778, 2.0, "kg/m"), ("thrust_gain", 1.0, 1.2, "1"))
    )
    drag = Recalibrated("drag", 2.0, Estimate(3.0, 2.9, 3.1, "kg/m"), robots)
    left = {"difference": Estimate(2.0 / 9.0, 0.2, 0.25, "1"), "left": Estimate(0.8, 0.78, 0.82, "1")}
    weak = FoundEffect("thruster_asymmetry", "thrust of left", "T = f T", robots, "confirmed", left, 90.0)
    late = {"delay": Estimate(0.2, 0.19, 0.21, "s")}
    delay = FoundEffect("command_delay", "commands that act later", "F(t) = F(t - d)", robots, "confirmed", late, 50.0)
    against = Comparison(
        tuple(each.origin for each in good.recordings), ("linear_drag",), (), {"command_delay": 1.2}, before
    )
    return Diagnosis("mismatch", "These differ.", (drag,), (), (weak, delay), (), (), {}, against=against)


@pytest.fixture
def seen(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The evidence of both sides as it comes in."""
    came: list[Any] = []

    def played(bad: Any, good: Any, progress: Callable[[str, float], None]) -> Diagnosis:
        came.append(([each.origin for each in bad.recordings], [each.origin for each in good.recordings]))
        return found(bad, good)

    module = ModuleType("cocorosim_ros.diagnosis.diagnose_against")
    module.diagnose_against = played  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, module.__name__, module)
    return came


@pytest.fixture
def bags(cocorosim: Command, run_of_20_seconds: SimpleNamespace, tmp_path: Path) -> list[Path]:
    """Three recordings that differ."""
    made = [run_of_20_seconds.bag]
    for seed in (7, 8):
        out = tmp_path / str(seed)
        run = ("run", "five_lilys", "--in-process", "--duration", "12 s", "--seed", seed, "--out", out)
        assert cocorosim(*run).status == 0
        made.append(out)
    return made


def test_several_recordings_may_follow_the_option(
    cocorosim: Command, seen: list[Any], bags: list[Path], tmp_path: Path
) -> None:
    """All words up to the next option are compared with; the files say what with and what was learned."""
    bad, *good = bags
    done = cocorosim("diagnose", bad, "--against", *good, "--platform", "lily", "--out", tmp_path / "out")
    assert (done.status, done.err) == (0, "")
    assert [len(side) for side in seen[0]] == [1, 2]
    tree = json.loads((tmp_path / "out" / "diagnosis.json").read_text("utf-8"))
    assert tree["against"] == seen[0][1]
    assert tree["against_control"] == {"verdict": "consistent", "differs": []}
    assert tree["against_learned"]["effects"] == ["linear_drag"]
    assert tree["recalibrated"][0]["nominal"] == 2.0
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert "one half of these recordings does not differ from the other" in page
    assert "What differs" in page


def test_the_model_has_what_a_platform_file_can_hold(
    cocorosim: Command, seen: list[Any], bags: list[Path], tmp_path: Path
) -> None:
    """A left thruster at 0.8 is a mean gain of 0.9 and an asymmetry of 2/9; commands act 0.2 s late."""
    out = tmp_path / "out"
    assert cocorosim("diagnose", bags[0], "--against", bags[1], "--platform", "lily", "--out", out).status == 0
    model = load_platform(out / "model.yaml")
    assert model.drag == pytest.approx(3.0)
    assert model.thrust_gain == pytest.approx(0.9 * 1.2)
    assert model.effects["thruster_asymmetry"]["difference"] == pytest.approx(2.0 / 9.0)
    assert model.effects["command_delay"] == {"delay": pytest.approx(0.2)}
    assert set(model.effects) == {"thruster_asymmetry", "command_delay"}


def test_the_same_recording_on_both_sides_is_refused(
    cocorosim: Command, seen: list[Any], bags: list[Path], tmp_path: Path
) -> None:
    """It would be its own control."""
    done = cocorosim("diagnose", bags[0], "--against", bags[0], "--platform", "lily", "--out", tmp_path / "out")
    assert done.status == 2
    assert "says the same as" in done.err


def test_recordings_of_another_hull_are_refused(
    cocorosim: Command, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """Runs of the simulator say what they were made with: a Lily twice as wide is none, before anything is fitted."""
    made = "unit: m, source: made, confidence: estimate"
    hull = (
        f"hull: {{length: {{value: 0.13, {made}}}, width: {{value: 0.2, {made}}}, height: {{value: 0.07, {made}}}}}\n"
    )
    (tmp_path / "wide.yaml").write_text(f"name: wide\nbased_on: lily\n{hull}")
    text = find_config("scenarios", "five_lilys").read_text("utf-8").replace("platform: lily", "platform: wide.yaml")
    (tmp_path / "wide_lilys.yaml").write_text(text)
    good = tmp_path / "good"
    assert (
        cocorosim("run", tmp_path / "wide_lilys.yaml", "--in-process", "--duration", "12 s", "--out", good).status == 0
    )
    bad = run_of_20_seconds.bag
    done = cocorosim("diagnose", bad, "--against", good, "--platform", "lily", "--out", tmp_path / "out")
    assert done.status == 2
    made_with = "'wide' (0.13 x 0.2 x 0.07 m, 0.44 kg, actuators left, right, buoyancy) as lily_01"
    assert f"--against has {good}, made with {made_with}" in " ".join(done.err.split())
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("after", [("--platform", "lily", "--out", "found"), ()])
def test_an_against_without_recordings_is_said(cocorosim: Command, bags: list[Path], after: tuple[str, ...]) -> None:
    """It had been taken for the option's own value, and the platform for missing."""
    done = cocorosim("diagnose", bags[0], "--against", *after)
    assert done.status == 2
    assert (
        done.err.strip() == "cocorosim: --against names no recording; give one or more of the sound vehicle after it."
    )
