"""What the nodes of a run warn of reaches the terminal of the command."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

from cocorosim_ros.graph.nodes.graph import GraphPlan
from cocorosim_ros.graph.nodes.supervisor import Supervisor


def test_warnings_of_physics_and_recorder_are_passed_on() -> None:
    """Each once: commands that are not in the recording are known to the recorder alone."""
    scenario: Any = SimpleNamespace(robots=[])
    told: list[str] = []
    supervisor = Supervisor(GraphPlan(scenario, "made", Path("out")), told.append)
    said = {"physics": ["lily_01: no answer"], "metrics": ["lily_02: 3 of the commands are not in the recording"]}
    everything = [words for each in said.values() for words in each]
    for name, warnings in said.items():
        node = SimpleNamespace(warnings=lambda left=warnings: [left.pop()] if left else [])
        setattr(supervisor, f"_{name}", node)
    supervisor._look_around()
    supervisor._look_around()
    assert told == everything
