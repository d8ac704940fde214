"""The action for repositories of robots: every command line in it is one that the commands take."""

from __future__ import annotations

import re
import shlex
import subprocess
from pathlib import Path
from typing import Any

import click
import pytest
from ruamel.yaml import YAML

from cocorosim_ros.commands.main import cocorosim

ROOT = Path(__file__).resolve().parents[2]
ACTION = ROOT / ".github" / "actions" / "diagnose" / "action.yml"
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


@pytest.mark.parametrize("package, installed", [("", str(ROOT)), ("cocorosim==0.2.0", "cocorosim==0.2.0")])
def test_it_installs_its_own_tree_unless_told(package: str, installed: str, tmp_path: Path) -> None:
    """As a shell carries out its first step: GitHub puts the action's whole repository around its folder."""
    python = tmp_path / "python"
    python.write_text('#!/bin/sh\nshift 3\nif [ -d "$1" ]; then cd "$1" && pwd -P; else echo "$1"; fi\n')
    python.chmod(0o755)
    environment = {"PATH": f"{tmp_path}:/usr/bin:/bin", "PACKAGE": package, "GITHUB_ACTION_PATH": str(ACTION.parent)}
    command = ["bash", "-e", "-c", STEPS[0]["run"]]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == installed
    assert CONTENT["inputs"]["package"]["default"] == ""


def test_what_the_steps_use_is_given() -> None:
    """Each variable is set in its step from an input that the action has, and each input is used."""
    used: set[str] = set()
    for step in STEPS:
        assert step["shell"] == "bash"
        named = set(re.findall(r"\$\{?([A-Z_]+)", step["run"])) - {"GITHUB_STEP_SUMMARY", "GITHUB_ACTION_PATH"}
        assert named == set(step["env"])
        inputs = [re.fullmatch(r"\$\{\{ inputs\.([\w-]+) \}\}", value) for value in step["env"].values()]
        used |= {match[1] for match in inputs if match}
        assert all(inputs)
    assert used == set(CONTENT["inputs"])
