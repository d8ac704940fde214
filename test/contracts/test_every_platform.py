"""Every platform in config/ can be put into a world, whatever it lacks: pump, yaw control, sensors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.tick.assembly import build_world

SCENARIO = """\
name: alone
description: one robot that does nothing
seed: 1
tick: 0.5 s
duration: 1 s
tank: {size: [6 m, 6 m, 2 m]}
integrator: {name: rk4, step: 0.0625 s, contact: inelastic}
swarm:
  - {platform: PLATFORM, prefix: robot, controller: idle, start: {poses: [[0 m, 0 m, -1 m, 0 deg]]}}
"""


@pytest.mark.parametrize("name", config_names("platforms"))
def test_world_has_its_numbers(name: str, tmp_path: Path) -> None:
    """The world of one such robot holds its mass and the limits of its actuators."""
    path = tmp_path / "alone.yaml"
    path.write_text(SCENARIO.replace("PLATFORM", name))
    world = build_world(load_scenario(path))
    platform = load_platform(name)
    assert world.vehicles.parameters[0, 0, 0] == platform.mass
    np.testing.assert_array_equal(world.vehicles.actuator_limit[0, 0], platform.actuator_limits())
