"""The example of a plain Python controller does what it says, and the commands that it shows are understood."""

from __future__ import annotations

import ast
import math
import runpy
import shlex
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import click
import numpy as np
import pytest

from cocorosim_ros.commands.run import command

EXAMPLE = Path(__file__).with_name("own_controller.py")


@pytest.fixture
def follow() -> Any:
    """The example's class."""
    return runpy.run_path(str(EXAMPLE))["Follow"]


def seeing(nearest: float, heading: float = 0.2) -> Any:
    """What a robot senses that has a neighbour 60 degrees to the left of its bow at this distance [m]."""
    axes = {"front_left": (0.5, math.sqrt(0.75), 0.0), "back": (-1.0, 0.0, 0.0)}
    ranges = {"front_left": nearest, "back": math.inf}
    return SimpleNamespace(heading=heading, neighbour_range=ranges, sensor_axis=axes, heard=((1.0,), (2.0,)))


def test_it_swims_to_the_nearest_robot(follow: Any) -> None:
    """A neighbour seen 60 degrees to the left turns the course by that; it says how many it hears."""
    course = follow(depth=1.2)(seeing(0.3))
    assert course.heading == pytest.approx(0.2 + math.pi / 3)
    assert (course.depth, course.speed, course.say) == (1.2, 0.5, [2])


def test_it_wanders_alone_and_bears_a_dead_compass(follow: Any) -> None:
    """Without neighbours the turn is drawn from its own generator; without a compass it keeps its course."""
    course = follow(random=np.random.default_rng(3))(seeing(math.inf))
    assert course.heading == pytest.approx(0.2 + np.random.default_rng(3).normal(0.0, 0.3))
    assert follow()(seeing(0.3, heading=math.nan)).heading is None


def test_it_needs_no_more_than_the_package_and_shows_how_it_is_run() -> None:
    """What it imports is a short list, and `cocorosim run` takes the command of its first lines."""
    tree = ast.parse(EXAMPLE.read_text("utf-8"))
    imported = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    assert imported | {str(node.module) for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)} == {
        "math",
        "cocorosim_ros.world.controllers.plain",
    }
    (shown,) = (line for line in (ast.get_docstring(tree) or "").splitlines() if "cocorosim run" in line)
    context: click.Context = command.make_context("run", shlex.split(shown)[2:])
    assert context.params["controller"] == "test/examples/own_controller.py:Follow"
