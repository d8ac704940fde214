"""Every advised manoeuvre can be driven."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.report.advice import MANOEUVRES
from cocorosim_ros.diagnosis.report.manoeuvre_scenario import PROGRAMMES, RAMPED, scenario_of
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.controllers.programme import ROWS


def test_every_manoeuvre_has_a_programme() -> None:
    """What the advice can name, a scenario can drive."""
    assert set(PROGRAMMES) == set(MANOEUVRES)


CASES = [*((name, "lily") for name in MANOEUVRES), *(("zig_zag", name) for name in ("hovercraft_epfl", "haizhe_auv"))]


@pytest.mark.parametrize(("name", "platform"), CASES)
def test_it_can_be_driven(name: str, platform: str, tmp_path: Path) -> None:
    """It loads, lasts whole rounds of ten minutes at least, and its first ticks do what its first row says."""
    from cocorosim_ros.world.seeding.seeding import start_poses
    from cocorosim_ros.world.tick.assembly import build_world
    from cocorosim_ros.world.tick.simulation import Simulation

    file = tmp_path / "next_manoeuvre.yaml"
    file.write_text(scenario_of(name, load_platform(platform), platform))
    scenario: Any = load_scenario(str(file))
    once = sum(row.seconds for row in PROGRAMMES[name])
    assert scenario.duration >= 600.0 and scenario.duration % once == pytest.approx(0.0)
    simulation = Simulation(build_world(scenario), start_poses(scenario, 0)[None])
    for _ in range(2):
        simulation.sense()
        simulation.decide()
        simulation.advance()
    assert np.isfinite(simulation.state).all()
    row = PROGRAMMES[name][0]
    if platform == "lily" and name not in RAMPED:
        wanted = np.clip([row.ahead - row.turn, row.ahead + row.turn, row.rise], -1.0, 1.0)
        np.testing.assert_allclose(simulation.command[0], np.tile(wanted, (len(scenario.robots), 1)))


def test_a_programme_fits_the_table() -> None:
    """No manoeuvre has more rows than the controller plays."""
    assert max(len(rows) for rows in PROGRAMMES.values()) <= ROWS
