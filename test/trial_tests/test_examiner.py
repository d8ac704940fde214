"""Diagnoses are run once each, ended at the limit, and their ends are noted."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

Tool = Callable[[str], Path]


def test_an_answer_is_kept_and_not_asked_for_again(tool: Tool, tmp_path: Path) -> None:
    """The second run finds the outcome of the first; the page of the report is left out."""
    from trial.examiner import Task, Terms, examine_all

    runs = tool('mkdir -p "$out"; echo {} > "$out/diagnosis.json"; echo page > "$out/report.html"')
    tasks = [Task(f"r{k}", (tmp_path / "bag",), tmp_path / "answers" / f"r{k}") for k in range(3)]
    for _ in range(2):
        outcomes = sorted(examine_all(tasks, Terms()), key=lambda outcome: outcome.name)
        assert [(o.name, o.status) for o in outcomes] == [("r0", 0), ("r1", 0), ("r2", 0)]
    assert runs.read_text().split() == ["ran"] * 3
    assert sorted(path.name for path in (tmp_path / "answers" / "r0").iterdir()) == ["diagnosis.json"]


def test_a_failure_is_noted_with_what_was_said(tool: Tool, tmp_path: Path) -> None:
    """Status 2 and its sentence; nothing half-written is left."""
    from trial.examiner import Task, Terms, examine_all

    tool('mkdir -p "$out"; echo half > "$out/diagnosis.json"; echo "the bag is empty" >&2; exit 2')
    (outcome,) = examine_all([Task("r0", (tmp_path / "bag",), tmp_path / "answers" / "r0")], Terms(1))
    assert (outcome.status, outcome.said) == (2, "the bag is empty")
    assert not (tmp_path / "answers" / "r0").exists()


def test_a_diagnosis_out_of_time_is_ended_with_all_its_processes(tool: Tool, tmp_path: Path) -> None:
    """A tool that sleeps in a child is stopped at the limit, and so is the child."""
    from trial.examiner import Task, Terms, examine_all

    tool(f"(sleep 2; echo late > {tmp_path / 'late'}) & wait")
    begun = time.monotonic()
    (outcome,) = examine_all([Task("r0", (tmp_path / "bag",), tmp_path / "answers" / "r0")], Terms(1, limit=0.3))
    assert outcome.status is None and "0.3 s" in outcome.said
    assert time.monotonic() - begun < 1.9
    time.sleep(max(0.0, begun + 2.6 - time.monotonic()))
    assert not (tmp_path / "late").exists()


def test_when_time_is_up_nothing_more_is_begun(tool: Tool, tmp_path: Path) -> None:
    """Without any minutes only what has an outcome already is told."""
    from trial.examiner import Task, Terms, examine_all

    runs = tool('mkdir -p "$out"')
    tasks = [Task(f"r{k}", (tmp_path / "bag",), tmp_path / "answers" / f"r{k}") for k in range(3)]
    assert [o.name for o in examine_all(tasks[:1], Terms())] == ["r0"]
    assert [o.name for o in examine_all(tasks, Terms(minutes=-1.0))] == ["r0"]
    assert runs.read_text().split() == ["ran"]


def test_a_tool_that_is_loaded_once_says_the_same(tmp_path: Path) -> None:
    """Forked from a process that has loaded it, the tool ends with the same status and sentence as by itself."""
    from dataclasses import replace

    from trial.examiner import Task, Terms, examine_all

    plain = Terms(1, limit=60.0)
    tasks = [Task("r0", (tmp_path / "nowhere",), tmp_path / way / "r0") for way in ("cold", "warm")]
    (cold,) = examine_all(tasks[:1], plain)
    (warm,) = examine_all(tasks[1:], replace(plain, warm_up=tasks[1]))
    assert (cold.status, warm.status) == (2, 2)
    assert cold.said == warm.said and "nowhere does not exist" in warm.said
