"""A ship with a rudder in the filter: the simulator's course; numbers of the rudder, and wind, from recordings."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import ships

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.showing.estimates import fitted, recalibrated

NOISE = np.array([0.005, 0.005, 0.005, 0.001])  # m, m, m, rad
RANGED = "range: [0.3, 2], "
HULL = f"""effects:
  added_mass: {{sway_minus_surge: {ships.number(2000, "kg")}, yaw: {ships.number(6000, "kg m^2")}}}
  hull_lift: {{sway_by_drift: {ships.number(500, "kg/m")}, yaw_by_turn: {ships.number(3800, "kg m")}}}
"""


def behind(gain: float, wake: float, ranges: bool) -> str:
    """Propeller, and a rudder behind it with these numbers."""
    known = ships.PROPELLER + ships.RUDDER.replace(f", {ships.STOCK[1]}, 0]", ", 0, 0]") + ships.BEHIND
    return known + (
        f"    gain: {ships.number(gain, '1', RANGED if ranges else '')}\n"
        f"    wake: {ships.number(wake, '1', 'range: [0, 0.8], ' if ranges else '')}\n"
    )


def zigzag(ticks: int) -> Any:
    """(ticks, 2) commands: the propeller in steps, the rudder to and fro."""
    tick = np.arange(ticks)
    angle = 0.6 * np.sign(np.sin(2.0 * np.pi * tick / 70.0)) * (tick > 20)
    return np.column_stack([np.where(tick % 150 < 100, 0.9, 0.5), angle])


def recorded(given: Any, truth: Any, ticks: int = 500) -> Evidence:
    """Evidence of a zigzag of a true ship, poses every half second, for a given platform."""
    commands = zigzag(ticks)
    rows = ships.run(truth, commands, start=(0.8, 0.0, 0.0))[:, :4]
    value = rows + NOISE * np.random.default_rng(20261123).standard_normal(rows.shape)
    pose = Stream(0.5 * np.arange(ticks + 1), value, NOISE)
    log = RobotLog("ship", 0.5 * np.arange(ticks), commands, {"pose": pose})
    return Evidence(given, (RecordingLog("made", 0.5 * ticks, (log,)),))


def test_the_filter_runs_the_simulators_ship(tmp_path: Path) -> None:
    """A free run of the filter's model from the true start follows the simulator to the error of its midpoint steps."""
    truth = ships.ship(tmp_path, behind(0.8, 0.25, ranges=False), HULL)
    evidence = recorded(truth, truth, 120)
    track = first_fit(evidence).tracks[0]
    rows = ships.run(truth, zigzag(120), start=(0.8, 0.0, 0.0))
    grid = track.timeline.grid
    path = track.filter.free_run(track.vehicle.row, rows[0, :8], 0, grid.points)
    seen = np.column_stack([np.interp(grid.moments, 0.5 * np.arange(121), rows[:, column]) for column in range(8)])
    at_ticks = np.isclose(grid.moments % 0.5, 0.0) | np.isclose(grid.moments % 0.5, 0.5)
    np.testing.assert_allclose(path[at_ticks], seen[at_ticks], atol=2e-3)
    assert np.abs(rows[-1, 3]) > 0.1


def test_a_rudder_is_recalibrated(tmp_path: Path) -> None:
    """A true gain of 0.8 and wake of 0.25 lie within the intervals of a fit that begins at 1 and 0.4."""
    (tmp_path / "true").mkdir()
    truth = ships.ship(tmp_path / "true", behind(0.8, 0.25, ranges=False), HULL)
    given = ships.ship(tmp_path, behind(1.0, 0.4, ranges=True), HULL)
    every, _ = recalibrated(fitted(settled(first_fit(recorded(given, truth)), 6)))
    found = {each.parameter: each.estimate for each in every}
    assert found["actuators.rudder.gain"].value == pytest.approx(0.8, rel=0.1)
    assert found["actuators.rudder.gain"].holds(0.8)
    assert found["actuators.rudder.wake"].holds(0.25)


def test_wind_is_looked_for_where_something_stands_above_the_water(tmp_path: Path) -> None:
    """With areas in the wind the entry is tried with these, times their coefficients; without them it is not."""
    wind = [entry for entry in ENTRIES if entry.id == "wind"]
    areas = f"  front_above_water: {ships.number(0.5, 'm^2')}\n  side_above_water: {ships.number(2.0, 'm^2')}\n"
    plain = ships.ship(tmp_path, ships.PROPELLER + ships.RUDDER)
    text = (tmp_path / "ship.yaml").read_text().replace("  height:", f"{areas}  height:")
    (tmp_path / "windy.yaml").write_text(text)
    from cocorosim_ros.scenario.parts.platform import load_platform

    windy = load_platform(tmp_path / "windy.yaml")
    for platform, expected in ((plain, 0), (windy, 1)):
        fit = first_fit(recorded(platform, plain, 60))
        found = expand(wind, fit.tracks, fit.rows)
        assert len(found) == expected
    settings = list(found[0].settings(scene_of(fit.tracks, smoothed_tracks(fit))))
    assert {each["wind.front"] for each in settings} == {0.7 * 0.5}
    assert {each["wind.side"] for each in settings} == {0.85 * 2.0}
    assert len({each["wind.arm"] for each in settings}) == 4
