"""The fifth arm in small: a fleet of one-minute recordings, with both killings, measured twice and run once."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np


def test_a_fleet_is_made_killed_diagnosed_and_measured(tmp_path: Path) -> None:
    """Two robots in five weeks, one of which loses 5 % of its thrust a week: nothing is lost, and it is found."""
    from concealer.fleet import FleetPlan
    from trial.fleet import prove

    source = {"command": "prove.py fleet", "commit": "0" * 40, "machine": "a machine", "python": "3"}
    plan = FleetPlan(7, 2, 5, loser=1, loss=0.05, scatter=0.001, duration=60.0)
    assert prove(plan, tmp_path / "out", tmp_path / "pages", 1, source) == 0
    facts = json.loads((tmp_path / "pages" / "fleet.json").read_text("utf-8"))
    ran, found = facts["ran"], facts["figures"]
    assert 1 <= ran["worker_killed"] <= ran["command_killed"] < 10 and ran["lost"] == 0
    assert (found["recordings"], found["problems"]) == (10, 0)
    low, high = found["loser"]["ci95"]
    assert found["loser"]["robot"] == "lily_002" and low < -0.05 < high < 0.0
    page = (tmp_path / "pages" / "fleet.md").read_text("utf-8")
    assert "10 of 1 minutes, 2 robots, 5 weeks" in page and "0 of these lost" in page
    assert prove(plan, tmp_path / "out", tmp_path / "again", 1, source) == 0  # it is measured anew, and not run again
    assert (tmp_path / "again" / "fleet.md").read_text("utf-8") == page


def test_a_robot_loses_what_is_planned() -> None:
    """Its thrust falls by the planned share each week, that of the others scatters about their own by the day."""
    from concealer import layout as at
    from concealer.fleet import FleetPlan, name_of, robot_numbers

    plan = FleetPlan(7, 3, 6, loser=1, loss=0.03, scatter=0.0)
    thrust = np.array([robot_numbers(plan, index)[0, at.THRUST] for index in range(18)]).reshape(3, 6)
    assert np.allclose(thrust[1] / thrust[1, 0], 0.97 ** np.arange(6))
    assert np.all(thrust[[0, 2]] == thrust[[0, 2], :1]) and thrust[0, 0] != thrust[2, 0]
    assert np.all(np.abs(thrust[:, 0] / at.nominal_robot()[at.THRUST] - 1.0) <= plan.spread)
    assert len({name_of(plan, index) for index in range(18)}) == 18
    day = FleetPlan(7, 3, 6, scatter=0.01)
    shares = [robot_numbers(day, index)[0, at.THRUST] / thrust[0, 0] for index in range(6)]
    assert 0.0 < np.std(shares) < 0.03
