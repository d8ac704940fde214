"""`cocorosim diagnose` as it is typed; the diagnosis itself is played by a stand-in."""

from __future__ import annotations

import io
import json
import re
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import pytest
from rich.console import Console

from cocorosim_ros.commands.diagnose import shown_progress
from cocorosim_ros.commands.stage_lines import StageLines
from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.report.junit_file import junit_xml
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.checks.loading import load_scenario

Command = Callable[..., SimpleNamespace]
SENTENCE = "The left thruster of lily_1 [sic] is 5 % weaker than the right one."
WANTED = ["diagnosis.json", "model.yaml", "report.html"]


def found(evidence: Any) -> Diagnosis:
    """A diagnosis of all robots of the evidence."""
    robots = tuple(robot.name for recording in evidence.recordings for robot in recording.robots)
    drag = Recalibrated("drag", 1.7778, Estimate(1.9, 1.8, 2.0, "kg/m"), robots)
    weaker = FoundEffect(
        "thruster_asymmetry", "thrusters that differ", "N = -e b F", robots, "confirmed",
        {"difference": Estimate(0.05, 0.04, 0.06, "1")}, 52.0,
    )  # fmt: skip
    return Diagnosis("mismatch", SENTENCE, (drag,), (), (weaker,), (), (), {})


@pytest.fixture
def diagnose(monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[..., Diagnosis]], list[Any]]:
    """A function that puts a stand-in in the place of the diagnosis; what it gives is the evidence that came in."""

    def stand_in(answer: Callable[..., Diagnosis]) -> list[Any]:
        seen: list[Any] = []

        def played(evidence: Any, progress: Callable[[str, float], None]) -> Diagnosis:
            seen.append(evidence)
            progress("thinking", 0.5)
            return answer(evidence)

        module = ModuleType("cocorosim_ros.diagnosis.diagnose")
        module.diagnose = played  # type: ignore[attr-defined]
        monkeypatch.setitem(sys.modules, module.__name__, module)
        return seen

    return stand_in


def test_a_recording_is_diagnosed(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """Three files, the sentence and the table; the model loads; a second time needs --force."""
    seen = diagnose(found)
    arguments = ("diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "out")
    done = cocorosim(*arguments)
    assert (done.status, done.err) == (0, "")
    assert SENTENCE in done.out
    assert "0.050 " in done.out
    assert [robot.name for robot in seen[0].recordings[0].robots] == run_of_20_seconds.robots
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == WANTED
    assert json.loads((tmp_path / "out" / "diagnosis.json").read_text())["verdict"] == "mismatch"
    assert "5 % weaker" in (tmp_path / "out" / "report.html").read_text("utf-8")
    model = load_platform(tmp_path / "out" / "model.yaml")
    assert (model.drag, model.effects) == (1.9, {"thruster_asymmetry": {"difference": 0.05}})
    again = cocorosim(*arguments)
    assert again.status == 2
    assert "exists already" in again.err
    assert cocorosim(*arguments, "--force").status == 0


@pytest.mark.parametrize(
    ("fail_on", "status"), [("mismatch,recalibrate", 3), ("insufficient, mismatch", 3), ("recalibrate", 0)]
)
def test_machines_ask_for_a_status_by_verdict(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path, fail_on: str, status: int
) -> None:
    """3 for the verdicts that --fail-on names, with all results written; 0 for the others."""
    diagnose(found)
    done = cocorosim(
        "diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "out", "--fail-on", fail_on
    )
    assert (done.status, done.err) == (status, "")
    assert ("status 3: --fail-on names the verdict mismatch" in done.out) == (status == 3)
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == WANTED


def test_no_such_verdict(cocorosim: Command, run_of_20_seconds: SimpleNamespace, tmp_path: Path) -> None:
    """A misspelt verdict is said before the work."""
    done = cocorosim(
        "diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "out", "--fail-on", "mismatched"
    )
    assert done.status == 2
    assert "--fail-on has 'mismatched', which is no verdict" in done.err
    assert "mismatch" in done.err.partition("no verdict")[2]
    assert not (tmp_path / "out").exists()


def test_what_to_drive_next_is_a_scenario(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """Where something was not shown, the folder holds a scenario with its model; a later diagnosis takes it away."""
    names = ("four_headings",)
    diagnose(lambda evidence: Diagnosis("consistent", SENTENCE, (), (), (), ("tether",), names, {}))
    arguments = ("diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "out")
    assert cocorosim(*arguments).status == 0
    scenario = load_scenario(tmp_path / "out" / "next_manoeuvre.yaml")
    assert scenario.robots[0].platform == load_platform(tmp_path / "out" / "model.yaml")
    diagnose(found)
    assert cocorosim(*arguments, "--force").status == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == WANTED


def test_known_effects_come_from_another_model(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """--known adds the effects of a model to the platform, and leaves the platform's numbers alone."""
    seen = diagnose(found)
    bag, other = run_of_20_seconds.bag, tmp_path / "other"
    assert cocorosim("run", "five_lilys", "--in-process", "--duration", "12 s", "--seed", 7, "--out", other).status == 0
    assert cocorosim("diagnose", bag, other, "--platform", "lily", "--out", tmp_path / "first").status == 0
    known = tmp_path / "first" / "model.yaml"
    assert cocorosim("diagnose", bag, "--platform", "lily", "--known", known, "--out", tmp_path / "x").status == 0
    assert len(seen[0].recordings) == 2
    platform = seen[1].platform
    assert (platform.drag, platform.effects) == (1.7778, {"thruster_asymmetry": {"difference": 0.05}})


def test_what_was_odd_about_the_recording_is_said(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """Remarks on faults and gaps reach the terminal, a few of them; even rates are for the report."""
    odd = (
        "a/pose: 3 messages hold no number; they were left out.",
        "a/imu: 9 readings at 2 Hz, 1 gap from 1.0 to 3.0 s.",
    )
    remarks = (*odd, "a/pose: 40 readings at 2 Hz.", "a/compass: 2 readings.", *["b/imu: time runs backwards."] * 9)
    diagnose(lambda evidence: Diagnosis("consistent", SENTENCE, (), (), (), (), (), {}, remarks=remarks))
    done = cocorosim("diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "out")
    assert all(remark in done.out for remark in odd)
    assert "a/pose: 40 readings" not in done.out and "a/compass" not in done.out
    assert done.out.count("backwards") == 6 and "3 more remarks are in report.html." in done.out


@pytest.mark.parametrize("broken", ["bag", "platform", "known", "out"])
def test_unusable_input_is_one_sentence(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path, broken: str
) -> None:
    """Status 2, one line that names what is wrong, and nothing is left behind."""
    diagnose(found)
    (tmp_path / "file").write_text("mine")
    given: dict[str, Any] = {"bag": run_of_20_seconds.bag, "platform": "lily", "known": "lily", "out": tmp_path / "out"}
    given[broken] = tmp_path / "file" if broken == "out" else tmp_path / "missing.yaml"
    done = cocorosim(
        "diagnose", given["bag"], "--platform", given["platform"], "--known", given["known"], "--out", given["out"]
    )
    assert done.status == 2
    assert len(done.err.strip().splitlines()) == 1
    assert given[broken].name in done.err
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_failure_leaves_nothing_behind(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """An error in the middle of the diagnosis is its sentence, and no folder."""

    def fail(evidence: Any) -> Diagnosis:
        raise CocorosimError("The recording is of another planet; record on this one.")

    diagnose(fail)
    done = cocorosim("diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "a" / "b")
    assert (done.status, done.err) == (2, "cocorosim: The recording is of another planet; record on this one.\n")
    assert list(tmp_path.iterdir()) == []


def test_every_option_is_explained(cocorosim: Command) -> None:
    """--help says what is written, and a missing option is named."""
    words = " ".join(cocorosim("diagnose", "--help").out.split())
    for part in ("BAG...", "--platform", "--out", "--known", "--force", "model.yaml"):
        assert part in words
    missing = cocorosim("diagnose", "bag")
    assert missing.status == 2
    assert "--platform" in missing.err


def test_summaries_for_machines(
    cocorosim: Command, diagnose: Any, run_of_20_seconds: SimpleNamespace, tmp_path: Path
) -> None:
    """JUnit fails what --fail-on names, Markdown has the findings as a table, JSON is diagnosis.json."""
    diagnose(found)
    files = {name: tmp_path / f"summary.{name}" for name in ("junit", "markdown", "json")}
    options = [word for name, file in files.items() for word in (f"--{name}", file)]
    arguments = ("diagnose", run_of_20_seconds.bag, "--platform", "lily", "--out", tmp_path / "out", *options)
    done = cocorosim(*arguments, "--fail-on", "mismatch")
    assert done.status == 3, done.err
    suite = ElementTree.parse(files["junit"]).getroot()
    results = {case.get("name"): case.find("failure") is not None for case in suite.iter("testcase")}
    assert results == {"verdict": True, "effect thruster_asymmetry": True, "number drag": False}
    assert (suite.get("tests"), suite.get("failures"), suite.get("skipped")) == ("3", "2", "0")
    assert next(suite.iter("failure")).get("message") == SENTENCE
    rows = [line for line in files["markdown"].read_text().splitlines() if line.startswith("| ")]
    assert rows[0].startswith("| effect | robots | parameter |")
    assert any(row.startswith("| thruster_asymmetry | ") for row in rows)
    assert files["json"].read_text() == (tmp_path / "out" / "diagnosis.json").read_text()
    before = {name: file.read_bytes() for name, file in files.items()}
    assert cocorosim(*arguments).status == 2
    assert before == {name: file.read_bytes() for name, file in files.items()}


def test_a_recording_that_says_too_little_is_skipped() -> None:
    """In JUnit 'insufficient' is neither passed nor failed, unless that is asked for."""
    nothing = Diagnosis("insufficient", "It says too little.", (), (), (), (), (), {})
    for failing, child in (((), "skipped"), (("insufficient",), "failure")):
        (case,) = ElementTree.fromstring(junit_xml(nothing, "lily", failing))
        found_there = case.find(child)
        assert found_there is not None
        assert found_there.get("message") == "It says too little."


@pytest.mark.parametrize(("terminal", "bars"), [(True, 1), (False, 0)])
def test_progress_tells_time_gone_and_time_left(*, terminal: bool, bars: int) -> None:
    """On a terminal; a pipe gets no bar."""
    written = io.StringIO()
    with shown_progress(Console(file=written, force_terminal=terminal, width=100, color_system=None)) as show:
        show("fitting", 0.5)
    lines = re.findall(r"fitting .* (?:[-\d]+:){2}[-\d]+ (?:[-\d]+:){2}[-\d]+", written.getvalue())
    assert min(len(lines), 1) == bars


@pytest.mark.parametrize(("terminal", "told"), [(False, True), (True, False)])
def test_without_a_terminal_lines_tell_the_stage(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *, terminal: bool, told: bool
) -> None:
    """On standard error, again and again while a stage lasts; where results go there is none of it."""
    monkeypatch.setattr("cocorosim_ros.commands.diagnose.StageLines", partial(StageLines, every=0.01))
    written, said = io.StringIO(), ""
    with shown_progress(Console(file=written, force_terminal=terminal, width=100, color_system=None)) as show:
        show("fitting [1]", 0.25)
        waited = time.monotonic() + (10.0 if told else 0.2)  # s; far more than two lines take, also on a busy machine
        while said.count("\n") < 2 and time.monotonic() < waited:
            time.sleep(0.01)
            said += capsys.readouterr().err
    lines = said.splitlines()
    assert [line for line in lines if not re.fullmatch(r"after 0\.\d min, 25%: fitting \[1\]", line)] == []
    assert (len(lines) >= 2) == told
    assert ("after" in written.getvalue()) is False
