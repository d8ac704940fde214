"""`cocorosim run` before anything runs: what it refuses, what it leaves alone, and the status it ends with."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

COMMAND = Path(sys.executable).parent / "cocorosim"
Run = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """Function of the arguments after `cocorosim run`: how it ended."""

    def call(*arguments: Any, **environment: str) -> subprocess.CompletedProcess[str]:
        words = [str(COMMAND), "run", *map(str, arguments)]
        variables = {**os.environ, "COLUMNS": "300", **environment}
        return subprocess.run(
            words, cwd=tmp_path, env=variables, capture_output=True, text=True, timeout=600, check=False
        )

    return call


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("no_such_scenario",), "no_such_scenario"),
        (("one_lily", "--external", "lily_77"), "lily_77"),
        (("five_lilys", "--external", "jeff_*"), "lily_01, lily_02, lily_03, lily_04, lily_05"),
        (("one_lily", "--controller", "mine.py:Mine"), "mine.py', which cannot be read"),
        (("one_lily", "--controller", "mine.py"), "names no class of a Python file"),
        (("one_lily", "--duration", "60"), "duration"),
        (("one_lily", "--seed", "-3"), "seed"),
        (("one_lily", "--rate", "-1"), "--rate has -1"),
        (("one_lily", "--rate", "nan"), "--rate has nan"),
        (("one_lily", "--wait", "-1"), "--wait has -1"),
        (("one_lily", "--composed", "--in-process"), "exclude each other"),
        (("one_lily", "--composed", "--rate", "1"), "run in lock-step"),
        (("eleven_lilys", "--external", "lily_03", "--in-process"), "The controller of lily_03 is left to you"),
        (("one_lily", "--processes", "0"), "--processes has 0; give a whole number from 1"),
        (("one_lily", "--processes", "2", "--composed"), "leave out --processes"),
        (("one_lily", "--nonsense"), "--nonsense"),
    ],
)
def test_unusable_options(run: Run, tmp_path: Path, arguments: tuple[str, ...], words: str) -> None:
    """Status 2, one sentence on standard error, and not a file is made."""
    done = run(*arguments)
    assert done.returncode == 2, done.stderr
    assert words in done.stderr
    assert done.stderr.strip().count("\n") == 0, done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_domain_that_is_none(run: Run, tmp_path: Path) -> None:
    """What the user sets is used or refused, never replaced in silence."""
    done = run("one_lily", ROS_DOMAIN_ID="elephant")
    assert done.returncode == 2
    assert "ROS_DOMAIN_ID is 'elephant'" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_topics_that_are_none_and_poses_that_are_missing(run: Run, tmp_path: Path) -> None:
    """`recording.topics` must fit the run and hold what the statistics are made from."""
    shipped = Path(__file__).parents[2] / "config" / "scenarios" / "one_lily.yaml"
    for topics, words in (("[pose, sonar]", "'sonar', which is no topic"), ("[compass]", "has no poses")):
        path = tmp_path / "scenario.yaml"
        path.write_text(shipped.read_text().replace("topics: all", f"topics: {topics}"))
        done = run(path)
        assert done.returncode == 2, done.stderr
        assert words in done.stderr


PLATFORM = """\
name: {name}
description: a Lily with an effect
based_on: lily
effects: {{{effects}}}
"""


def test_effects_of_a_platform(run: Run, tmp_path: Path) -> None:
    """An effect that does not exist is refused before anything is touched; one of a camera is said not to be there."""
    shipped = Path(__file__).parents[2] / "config" / "scenarios" / "one_lily.yaml"
    scenario = shipped.read_text().replace("platform: lily", "platform: own.yaml")
    (tmp_path / "scenario.yaml").write_text(scenario.replace("name: one_lily", "name: scenario"))
    number = '{value: 1.02, unit: "1", source: a test}'
    for effects in (f"camera_scal: {{scale: {number}}}", f"camera_scale: {{scale: {number}}}"):
        (tmp_path / "own.yaml").write_text(PLATFORM.format(name="own", effects=effects))
        done = run("scenario.yaml", "--duration", "1 s", "--in-process", "--out", "here")
        if "camera_scale" in effects:
            assert done.returncode == 0, done.stderr
            assert "camera_scale belongs to a recording's camera and clocks" in done.stdout
        else:
            assert done.returncode == 2
            assert "'effects.camera_scal' is no known effect; did you mean 'camera_scale'?" in done.stderr
            assert not (tmp_path / "here").exists()


def test_folders(run: Run, tmp_path: Path) -> None:
    """A run is not overwritten without --force; other people's files never; a file is no folder."""
    first = run("one_lily", "--duration", "2 s", "--in-process", "--out", "here")
    assert first.returncode == 0, first.stderr
    bag = (tmp_path / "here" / "bag" / "bag_0.mcap").read_bytes()

    refused = run("one_lily", "--duration", "2 s", "--in-process", "--seed", 5, "--out", "here")
    assert refused.returncode == 2
    assert "here holds a run already" in refused.stderr
    assert (tmp_path / "here" / "bag" / "bag_0.mcap").read_bytes() == bag

    forced = run("one_lily", "--duration", "4 s", "--in-process", "--out", "here", "--force")
    assert forced.returncode == 0, forced.stderr
    assert (tmp_path / "here" / "bag" / "bag_0.mcap").read_bytes() != bag

    (tmp_path / "here" / "thesis.txt").write_text("years of work")
    foreign = run("one_lily", "--in-process", "--out", "here", "--force")
    assert foreign.returncode == 2
    assert "'thesis.txt', which is no part of a run" in foreign.stderr
    assert (tmp_path / "here" / "bag").is_dir()

    below = run("one_lily", "--in-process", "--out", "here/thesis.txt/run")
    assert below.returncode == 2
    assert "is a file, or lies below one" in below.stderr

    unwritable = run("one_lily", "--in-process", "--out", "/proc/run")
    assert unwritable.returncode == 2
    assert "/proc/run cannot be written" in unwritable.stderr


def test_help_tells_the_statuses(run: Run) -> None:
    """What a script needs to know."""
    done = run("--help")
    assert done.returncode == 0
    for words in ("0 the run was done", "1 it began and failed", "2 the input", "130 interrupted"):
        assert words in " ".join(done.stdout.split())


def test_nothing_stays_in_shared_memory(run: Run, domain: int) -> None:
    """No mode leaves a port of its domain behind: a half-written one would make later participants wait."""
    for mode in ((), ("--composed",), ("--network", "--composed")):
        done = run("one_lily", "--duration", "2 s", "--out", "_".join(("run", *mode)), *mode)
        assert done.returncode == 0, done.stderr
    ports = {int(path.name[13:]) for path in Path("/dev/shm").glob("fastrtps_port*") if path.name[13:].isdecimal()}
    assert not ports & set(range(7400 + 250 * domain, 7650 + 250 * domain))


def test_a_motion_that_runs_away(
    cocorosim: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One sentence, status 1, and what was recorded until then can be read."""
    from cocorosim_ros.world.tick.simulation import Simulation

    decide = Simulation.decide

    def lost_at_four(swarm: Simulation) -> None:
        decide(swarm)
        if swarm.tick == 4:
            swarm.state[0, 0, 0] = math.nan

    monkeypatch.setattr(Simulation, "decide", lost_at_four)
    said = cocorosim("run", "eleven_lilys", "--in-process", "--duration", "10 s", "--out", tmp_path / "out")
    assert said.status == 1
    assert "'lily_01' ran away at" in said.err
    assert cocorosim("metrics", tmp_path / "out" / "bag").status == 0
