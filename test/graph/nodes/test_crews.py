"""Which controllers share a process."""

from __future__ import annotations

from itertools import chain
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.graph.nodes.graph import PROCESSES, GraphPlan, crew_name


def _plan(robots: int, external: int = 0, processes: int = PROCESSES) -> GraphPlan:
    described = [SimpleNamespace(name=f"lily_{number}", external=number < external) for number in range(robots)]
    scenario: Any = SimpleNamespace(robots=described)
    return GraphPlan(scenario, "made", Path("out"), processes=processes)


@pytest.mark.parametrize(("robots", "external", "processes"), [(1, 0, 12), (12, 0, 12), (13, 2, 5), (200, 0, 12)])
def test_every_controller_of_the_run_is_in_one_process(robots: int, external: int, processes: int) -> None:
    """In the order of the robots, external ones left out, shared out evenly over at most so many processes."""
    crews = _plan(robots, external, processes).crews()
    assert list(chain.from_iterable(crews)) == list(range(external, robots))
    sizes = [len(crew) for crew in crews]
    assert len(crews) == min(robots - external, processes)
    assert max(sizes) - min(sizes) <= 1


def test_a_run_may_have_no_controllers_of_its_own() -> None:
    """All are left to somebody else."""
    assert _plan(3, external=3).crews() == []


def test_up_to_a_dozen_each_has_a_process_that_goes_by_its_name() -> None:
    """Beyond, a process goes by the first of its robots, and says how many more there are."""
    assert [crew_name([f"lily_{number}" for number in crew]) for crew in _plan(2).crews()] == [
        "controller_lily_0",
        "controller_lily_1",
    ]
    assert crew_name(["lily_3", "lily_4", "lily_5"]) == "controller_lily_3_and_2_more"
