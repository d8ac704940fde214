"""Diagnoses as records: what the command prints and writes; the diagnosis itself is played by a stand-in."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

import cocorosim_ros as library
from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, FoundEffect, Recalibrated

SENTENCE = "The left thruster of lily_01 <sic> is 5 % weaker than the right one."
FILES = ["diagnosis.json", "model.yaml", "report.html"]


@pytest.fixture(autouse=True)
def seen(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The evidence that comes in; the answer is always one effect and one number that moved."""
    came: list[Any] = []

    def played(evidence: Any, progress: Callable[[str, float], None]) -> Diagnosis:
        came.append(evidence)
        progress("thinking", 0.5)
        robots = tuple(robot.name for recording in evidence.recordings for robot in recording.robots)
        drag = Recalibrated("drag", 1.7778, Estimate(1.9, 1.8, 2.0, "kg/m"), robots)
        weaker = FoundEffect(
            "thruster_asymmetry", "thrusters that differ", "N = -e b F", robots, "confirmed",
            {"difference": Estimate(0.05, 0.04, 0.06, "1")}, 52.0,
        )  # fmt: skip
        return Diagnosis("mismatch", SENTENCE, (drag,), (), (weaker,), (), (), {}, remarks=("It was odd.",))

    module = ModuleType("cocorosim_ros.diagnosis.diagnose")
    module.diagnose = played  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, module.__name__, module)
    return came


def test_the_files_are_those_of_the_command(
    shipped: Path, cocorosim: Callable[..., SimpleNamespace], tmp_path: Path
) -> None:
    """The same texts, byte for byte, in the record, in `out` and by `save`; the record's model loads."""
    ended = cocorosim("diagnose", shipped, "--platform", "lily", "--out", tmp_path / "its")
    assert (ended.status, ended.err) == (0, "")
    result = library.diagnose(shipped, "lily", out=tmp_path / "mine")
    assert result.save(tmp_path / "saved") == tmp_path / "saved"
    for folder in ("mine", "saved"):
        assert sorted(path.name for path in (tmp_path / folder).iterdir()) == FILES
        for name in FILES:
            assert (tmp_path / folder / name).read_bytes() == (tmp_path / "its" / name).read_bytes()
            assert (tmp_path / "its" / name).read_text("utf-8") == result.files[name]
    assert (result.model_yaml, result.report_html) == (result.files["model.yaml"], result.files["report.html"])
    assert result.next_manoeuvre_yaml is None
    assert json.loads(result.files["diagnosis.json"]) == result.tree
    assert result.tree["probabilities"] == result.probabilities
    assert sum(result.probabilities.values()) == pytest.approx(1.0)
    assert library.load_platform(tmp_path / "mine" / "model.yaml").drag == 1.9


def test_what_it_says(shipped: Path) -> None:
    """Verdict, sentence, effects and numbers; what is done is told on the way."""
    told: list[tuple[str, float]] = []
    result = library.diagnose(shipped, "lily", progress=lambda words, share: told.append((words, share)))
    assert (result.verdict, result.sentence, result.remarks) == ("mismatch", SENTENCE, ("It was odd.",))
    assert [found.id for found in result.effects] == ["thruster_asymmetry"]
    assert [moved.parameter for moved in result.recalibrated] == ["drag"]
    assert told == [("reading", 0.0), ("thinking", 0.5)]


def test_recordings_and_platforms_come_in_every_form(shipped: Path, seen: list[Any], tmp_path: Path) -> None:
    """Paths, records and lists of them; platforms by name, file and record; effects that are known."""
    library.diagnose([library.read_recording(shipped)], library.load_platform("lily"))
    library.diagnose(str(shipped), "lily", out=tmp_path / "out")
    library.diagnose((shipped,), "lily", known=tmp_path / "out" / "model.yaml")
    assert all(each.recordings[0].robots[0].name == "lily_01" for each in seen)
    assert [each.platform.effects for each in seen] == [{}, {}, {"thruster_asymmetry": {"difference": 0.05}}]


def test_frame_and_card(shipped: Path, parse: Callable[[str], Any]) -> None:
    """One row a number, with its interval; the sentence is text and no markup."""
    result = library.diagnose(shipped, "lily")
    frame = result.to_frame()
    assert frame["kind"].tolist() == ["effect", "recalibrated"]
    assert frame[["parameter", "value", "low", "high", "unit"]].iloc[0].tolist() == [
        "difference",
        0.05,
        0.04,
        0.06,
        "1",
    ]
    assert frame["nats"].isna().tolist() == [False, True]
    page = parse(result._repr_html_())
    assert {SENTENCE, "thruster_asymmetry", "difference", "It was odd."} <= set(page.cells)
    assert repr(result).startswith("<diagnosis of lily: verdict mismatch, recordings 1")


def test_what_cannot_be_used_is_refused_before_the_work(shipped: Path, seen: list[Any], tmp_path: Path) -> None:
    """A folder that holds a diagnosis, a recording that is none, no recording at all."""
    library.diagnose(shipped, "lily", out=tmp_path / "out")
    calls: list[tuple[Any, dict[str, Any], str]] = [
        (shipped, {"out": tmp_path / "out"}, "exists already"),
        (tmp_path / "absent", {}, "absent does not exist"),
        ([], {}, "'bags' has no recording; give one at least"),
        ([shipped, shipped], {}, "says the same as"),
    ]
    for bags, options, words in calls:
        with pytest.raises(library.CocorosimError, match=words):
            library.diagnose(bags, "lily", **options)
    with pytest.raises(library.CocorosimError, match="'lilly' is the name of no platform"):
        library.diagnose(shipped, "lilly")
    assert len(seen) == 1
    assert library.diagnose(shipped, "lily", out=tmp_path / "out", force=True).verdict == "mismatch"
