"""Every command and every snippet of the documents runs, or is at least taken apart as its program would."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import click
import pytest

from cocorosim_ros.commands.main import cocorosim
from cocorosim_ros.graph.nodes import controller_node, metrics_node, physics_node
from cocorosim_ros.scenario.parts.controller_file import load_controller

from .documents import ROOT, commands, documents, fenced

README = (ROOT / "README.md").read_text("utf-8")
DOCUMENTS = {str(path.relative_to(ROOT)): path.read_text("utf-8") for path in documents()}
ALL = [pytest.param(words, id=" ".join(words)) for text in DOCUMENTS.values() for words in commands(text)]
BIN = Path(sys.prefix, "bin")
NODES = {"physics_node": physics_node, "controller_node": controller_node, "metrics_node": metrics_node}
# Programs of a ROS installation, of the shell and of the Python world, which are not looked into.
TRUSTED = {"export", "cp", "cd", "python3", "pip", "python", "rosdep", "rviz2", "."}


def check_cocorosim(words: list[str]) -> None:
    """The sub-command exists, and click takes the arguments."""
    command = cocorosim.get_command(click.Context(cocorosim), words[0])
    assert command is not None, words
    command.make_context(words[0], list(words[1:]))


def check_node(name: str, words: list[str]) -> None:
    """Every -p sets a parameter that the node declares, or one of a shipped controller's."""
    known = {part.name for part in NODES[name].PARAMETERS}
    known |= {f"controller.{setting}" for setting in load_controller("boids_blt").parameters}
    given = {words[index + 1].split(":=")[0] for index, word in enumerate(words) if word == "-p"}
    assert given <= known


def check_make(words: list[str]) -> None:
    """The targets exist, and so does every variable that is set."""
    makefile = (ROOT / "Makefile").read_text("utf-8")
    targets = re.findall(r"^([\w-]+):", makefile, re.MULTILINE)
    settings = {word.partition("=")[0] for word in words if "=" in word}
    assert {word for word in words if "=" not in word} <= set(targets)
    assert all(f"$({name})" in makefile for name in settings)


def check_ros2(words: list[str]) -> None:
    """`run` names a node, `launch` a launch file and its arguments; `bag` is rosbag2's."""
    if words[0] == "run":
        assert words[1] == "cocorosim_ros" and words[2] in NODES
    elif words[0] == "launch":
        source = (ROOT / "cocorosim_ros/graph/launch" / words[2]).read_text("utf-8")
        (table,) = (
            node for node in ast.parse(source).body if isinstance(node, ast.Assign) and _name(node) == "ARGUMENTS"
        )
        assert {word.split(":=")[0] for word in words[3:]} <= ast.literal_eval(table.value).keys()
    else:
        assert words[0] == "bag"


def _name(node: ast.Assign) -> str:
    target = node.targets[0]
    return target.id if isinstance(target, ast.Name) else ""


CHECKS: dict[str, Callable[[list[str]], None]] = {"cocorosim": check_cocorosim, "make": check_make, "ros2": check_ros2}


@pytest.mark.parametrize("words", ALL)
def test_command_is_understood(words: list[str]) -> None:
    """The program exists and takes these options; files of this tree that it is given exist."""
    program = Path(words[0]).name
    if words[0].startswith(".venv/"):
        assert (BIN / program).exists()
    if program in NODES:
        check_node(program, words[1:])
    elif program in CHECKS:
        CHECKS[program](words[1:])
    else:
        assert words[0] in TRUSTED or words[0].startswith(".venv/"), words
    for word in words[1:]:
        if re.match(r"(test|cocorosim_ros|config)/[\w./]+$", word):
            assert (ROOT / word).exists(), word


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which the README's commands find what `make demo` leaves, from a shorter run, and its controller."""
    place = tmp_path_factory.mktemp("readme")
    command = [BIN / "cocorosim", "run", "eleven_lilys", "--in-process", "--duration", "20 s", "--out", "runs/demo"]
    subprocess.run(command, cwd=place, check=True, capture_output=True)
    (own,) = (code for code in fenced(README, "python") if "class Circle" in code)
    (place / "circle.py").write_text(own, "utf-8")
    return place


def runnable() -> list[list[str]]:
    """The README's own commands that need nobody else."""
    ours = [words for words in commands(README) if words[0] == ".venv/bin/cocorosim"]
    return [words for words in ours if "--external" not in words]


def test_the_commands_of_the_readme_run(folder: Path) -> None:
    """One after the other, as a reader would type them, each ends with status 0 and without a word of complaint."""
    # A browser that opens nothing, and a place for pages that goes with the test.
    environment = {**os.environ, "BROWSER": "true", "TMPDIR": str(folder)}
    for words in runnable():
        shortened = ["5 s" if word == "60 s" else word for word in words[1:]]
        done = subprocess.run(
            [BIN / "cocorosim", *shortened],
            cwd=folder,
            env=environment,
            capture_output=True,
            text=True,
            timeout=600,
            check=False,
        )
        assert (done.returncode, done.stderr) == (0, ""), (words, done.stdout, done.stderr)


def test_what_the_readme_says_lies_in_the_folder(folder: Path) -> None:
    """A run of the graph leaves exactly the files of the README's table."""
    rows = re.search(r"holds:\n\n(.*?)\n\n", README, re.DOTALL)
    assert rows is not None
    said = {name.rstrip("/") for name in re.findall(r"^\| `([\w./]+)`", rows[1], re.MULTILINE)}
    command = [BIN / "cocorosim", "run", "one_lily", "--duration", "2 s", "--out", "runs/graph"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    assert {path.name for path in (folder / "runs/graph").iterdir()} == said


def test_the_snippets_of_the_readme_run(folder: Path) -> None:
    """Each Python snippet ends without an error."""
    for code in fenced(README, "python"):
        subprocess.run([sys.executable, "-c", code], cwd=folder, check=True, timeout=300)
