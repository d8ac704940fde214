"""What holds for every command, a new one too: an example in its help, and `--json`, with - alone on standard output.

Commands that start nodes or need a large study are typed in the tests of their own.
"""

from __future__ import annotations

import json
import os
import shlex
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import click
import pytest
from click.shell_completion import ShellComplete

from cocorosim_ros.commands.completion import SHELLS
from cocorosim_ros.commands.examples import examples_of
from cocorosim_ros.commands.json_output import json_option
from cocorosim_ros.commands.main import COMMANDS, UNUSABLE_INPUT
from cocorosim_ros.commands.main import cocorosim as group
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store

Run = Callable[..., SimpleNamespace]
TYPED_HERE = {  # one example of a command; in this order, because later ones read what earlier ones have made
    "run": 1,
    "metrics": 0,
    "check": 0,
    "digest": 0,
    "view": 1,
    "diagnose": 0,
    "convert": 0,
    "experiment": 0,
    "report": 0,
    "calibrate": 0,
    "new": 0,
    "doctor": 0,
    "explain": 1,
}
TYPED_ELSEWHERE = {"replay": "test_replay.py", "claims": "test_claims.py", "figure4": "test_figure4.py"}
SHORTER = {"60 s": "5 s", "2": "1"}


def the_command(name: str) -> click.Command:
    """A sub-command."""
    found = group.get_command(click.Context(group), name)
    assert found is not None
    return found


@pytest.mark.parametrize("name", COMMANDS)
def test_json_is_one_option(name: str) -> None:
    """Every command has the option that all have, with the same words."""

    @click.command()
    @json_option
    def model(json_file: Path | None) -> None:
        """Has the option and nothing else."""

    (expected,) = model.params
    (found,) = [part for part in the_command(name).params if "--json" in part.opts]
    assert (found.opts, found.name, found.to_info_dict()) == (expected.opts, expected.name, expected.to_info_dict())


@pytest.mark.parametrize("name", COMMANDS)
def test_examples_are_understood(name: str, cocorosim: Run) -> None:
    """Each command's help shows one line to type or more, which click takes."""
    lines = examples_of(the_command(name))
    shown = cocorosim(name, "--help").out
    assert lines
    for line in lines:
        program, command, *words = shlex.split(line)
        assert (program, command) == ("cocorosim", name)
        assert line in shown
        the_command(name).make_context(name, words)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where somebody types the examples, with a bag of another robot in it."""
    place = tmp_path_factory.mktemp("typed")
    odometry, twist, force = "nav_msgs/msg/Odometry", "geometry_msgs/msg/TwistStamped", "std_msgs/msg/Float64"
    kinds = {"/odometry/filtered": odometry, "/dvl/twist": twist}
    kinds |= {f"/thrusters/{side}/input": force for side in ("left", "right")}
    with BagWriter(place / "drive", [Channel(topic, kind) for topic, kind in kinds.items()]) as writer:
        for second in range(5):
            for topic, kind in kinds.items():
                stamp: dict[str, Any] = {"data": 1.0}
                if kind != force:
                    stamp = {"header": {"stamp": {"sec": second, "nanosec": 0}}}
                if kind == odometry:
                    stamp |= {"pose": {"pose": {"orientation": {"w": 1.0}}}}
                data = type_store.serialize(type_store.build(kind, stamp))
                writer.write(topic, second * 10**9, second * 10**9, data)
    return place


@pytest.mark.parametrize("name", [*TYPED_HERE, *(set(COMMANDS) - {*TYPED_HERE, *TYPED_ELSEWHERE})])
def test_json_alone_on_standard_output(
    name: str, cocorosim: Run, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An example with `--json -` prints JSON and nothing else; what it says to people goes to standard error."""
    monkeypatch.chdir(folder)
    monkeypatch.setenv("OMP_NUM_THREADS", "1")
    line = examples_of(the_command(name))[TYPED_HERE.get(name, 0)]
    words = [SHORTER.get(word, word) for word in shlex.split(line)[1:]]
    done = cocorosim(*words, "--json", "-")
    assert done.status != UNUSABLE_INPUT, done.err
    assert isinstance(json.loads(done.out), dict)
    assert done.err
    assert not (folder / "-").exists()


@pytest.mark.parametrize("name", TYPED_ELSEWHERE)
def test_the_others_are_tested_elsewhere(name: str) -> None:
    """The test of the command itself asks for JSON on standard output."""
    text = Path(__file__).with_name(TYPED_ELSEWHERE[name]).read_text("utf-8")
    assert '"--json", "-"' in text and "json.loads" in text


COMPLETED = {
    ("run",): ("eleven_l", "eleven_lilys"),
    ("run", "five_lilys", "--controller"): ("boids_bl", "boids_blt"),
    ("calibrate", "--platform"): ("li", "lily"),
    ("diagnose", "bag", "--platform"): ("je", "jeff"),
    ("diagnose", "--fleet", "bags", "--platform"): ("li", "lily"),
    ("diagnose", "bag", "--fail-on"): ("mismatch,rec", "mismatch,recalibrate"),
    ("convert",): ("haizhe", "haizhe_auv"),
    ("experiment",): ("smo", "smoke"),
    ("explain",): ("wall_ef", "wall_effect"),
    ("explain", "--force"): ("polar", "polarisation"),
}


@pytest.mark.parametrize("before", COMPLETED, ids=" ".join)
def test_names_are_completed(before: tuple[str, ...]) -> None:
    """Behind the tab key stand scenarios, controllers, platforms, verdicts, maps, designs, effects and metrics."""
    typed, wanted = COMPLETED[before]
    shell = ShellComplete(group, {}, "cocorosim", "_COCOROSIM_COMPLETE")
    offered = {item.value: item.type for item in shell.get_completions(list(before), typed)}
    assert offered[wanted] == "plain"
    assert all(name.startswith(typed) for name in offered)


@pytest.mark.parametrize("shell", SHELLS)
def test_shells_can_be_told(shell: str, cocorosim: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the help says about completion gives a shell something to evaluate."""
    assert "_COCOROSIM_COMPLETE=bash_source" in cocorosim("--help").out
    monkeypatch.setitem(os.environ, "_COCOROSIM_COMPLETE", f"{shell}_source")
    monkeypatch.setattr("click.shell_completion.BashComplete._check_version", lambda self: None)
    assert "_cocorosim" in cocorosim().out
