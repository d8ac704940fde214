"""What a calibration writes: thrust as a gain, by which no command changes, and every kind of actuator."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.mixing import FullSticks, Mixing
from cocorosim_ros.scenario.parts.platform import Platform, load_platform, read_platform_file
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.study.calibration.fit import Fit, Fitted
from cocorosim_ros.study.calibration.platform_file import write_platform
from cocorosim_ros.world.vehicle_model.curves import forces_at

GAIN = 0.8
PLATFORMS = sorted(path.stem for path in (Path(__file__).parents[3] / "config" / "platforms").glob("*.yaml"))


def weaker(platform: Platform, folder: Path) -> Platform:
    """The platform that is written for thrusters of `GAIN` times their thrust, read back."""
    found = Fit((Fitted("thrust_gain", "1", 1.0, GAIN, GAIN - 0.01, GAIN + 0.01),), (), (0.0,) * 4)
    write_platform(folder / "found.yaml", platform, found, "a bag")
    return read_platform_file(folder / "found.yaml")


@pytest.mark.parametrize("name", PLATFORMS)
def test_thrusters_push_less_and_all_else_stays(name: str, tmp_path: Path) -> None:
    """Also those with a curve, beside rudders in a jet, fins and what turns a thruster, whose limit is no force."""
    before = load_platform(name)
    after = weaker(before, tmp_path)
    share = [GAIN if isinstance(part, Thruster) else 1.0 for part in before.actuators]
    np.testing.assert_allclose(after.actuator_limits(), before.actuator_limits() * np.array(share)[:, None], rtol=1e-15)
    assert [replace(part, gain=None) if isinstance(part, Thruster) else part for part in after.actuators] == [
        replace(part, gain=None) if isinstance(part, Thruster) else part for part in before.actuators
    ]


def test_half_a_stick_stays_half_a_command(tmp_path: Path) -> None:
    """The fitted Lily is commanded as the recorded one was, and pushes 0.8 times as much; a gain of its own is kept."""
    lily = load_platform("lily")
    left, right, pump = lily.actuators
    assert isinstance(left, Thruster)
    lily = replace(
        lily,
        actuators=(replace(left, gain=0.5), right, pump),
        mixing=Mixing("allocation", full_sticks=FullSticks(surge=0.01)),
    )
    after = weaker(lily, tmp_path)
    after = replace(after, mixing=lily.mixing)
    mixing = after.stick_mixing()
    assert mixing is not None
    commands = mixing.commands(np.array([[0.5]]))
    np.testing.assert_allclose(commands, [[0.5, 0.5]], rtol=1e-12)
    forces = forces_at(after, np.array([[*commands[0], 0.0]]))[0, :2]
    np.testing.assert_allclose(forces, [0.5 * 0.8 * 0.0025, 0.8 * 0.0025], rtol=1e-12)
