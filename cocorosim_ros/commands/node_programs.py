"""The programs `physics_node`, `controller_node` and `metrics_node`, which say in a sentence that ROS is missing."""

from __future__ import annotations

import importlib
import sys

from cocorosim_ros.commands.missing_package import missing_package


def physics_node() -> None:
    """Run the physics node."""
    _run("physics_node")


def controller_node() -> None:
    """Run the controller node of one robot."""
    _run("controller_node")


def metrics_node() -> None:
    """Run the metrics node."""
    _run("metrics_node")


def _run(name: str) -> None:
    try:
        module = importlib.import_module(f"cocorosim_ros.graph.nodes.{name}")
    except ModuleNotFoundError as error:
        sentence = missing_package(error.name or "")
        if sentence is None:
            raise
        sys.stderr.write(f"{name}: {sentence}\n")
        sys.exit(2)
    module.main()
