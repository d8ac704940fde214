"""The action for repositories of robots: every command line in it is one that the commands take."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import click
import pytest
from ruamel.yaml import YAML

from cocorosim_ros.commands.main import cocorosim

ACTION = Path(__file__).parents[2] / ".github" / "actions" / "diagnose" / "action.yml"
CONTENT: dict[str, Any] = YAML(typ="safe").load(ACTION.read_text("utf-8"))
STEPS: list[dict[str, Any]] = CONTENT["runs"]["steps"]
LINES = [line for step in STEPS for line in step["run"].splitlines() if line.startswith("cocorosim ")]


@pytest.mark.parametrize("line", LINES, ids=lambda line: line.split()[1])
def test_each_command_line_is_taken(line: str) -> None:
    """Arguments and options are those of the command, and an option that needs a value has one."""
    _, name, *words = shlex.split(line.partition(" || ")[0].replace("$FAIL_ON", "mismatch"))
    command = cocorosim.get_command(click.Context(cocorosim), name)
    assert command is not None
    with command.make_context(name, words) as context:
        given = {each for each, source in context._parameter_source.items() if source.name == "COMMANDLINE"}
        assert len(given) >= 1
    assert len(LINES) == 2


def test_what_the_steps_use_is_given() -> None:
    """Each variable is set in its step from an input that the action has, and each input is used."""
    used: set[str] = set()
    for step in STEPS:
        assert step["shell"] == "bash"
        named = set(re.findall(r"\$([A-Z_]+)", step["run"])) - {"GITHUB_STEP_SUMMARY"}
        assert named == set(step["env"])
        inputs = [re.fullmatch(r"\$\{\{ inputs\.([\w-]+) \}\}", value) for value in step["env"].values()]
        used |= {match[1] for match in inputs if match}
        assert all(inputs)
    assert used == set(CONTENT["inputs"])
