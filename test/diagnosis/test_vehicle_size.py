"""How strong a vehicle is, and what is taken for strong where it has no actuator."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.vehicle_size import full_forces


def vehicle(*force: float) -> Any:
    """What is asked of a vehicle."""
    return SimpleNamespace(force_scale=np.array(force))


def test_a_lily_is_as_strong_as_its_actuators() -> None:
    """Two thrusters ahead, a lever, a pump."""
    assert full_forces(vehicle(0.01, 0.0, 0.0981, 2.5e-4)) == (0.01, 0.0981, 2.5e-4)


def test_what_cannot_turn_itself_is_turned_all_the_same() -> None:
    """Four propellers downwards: random forces across and in yaw are looked for in the size of these."""
    across, heave, yaw = full_forces(vehicle(0.0, 0.0, 20.0, 0.0))
    assert (across, heave) == (2.0, 20.0) and yaw == pytest.approx(0.04)


def test_what_only_drifts_has_a_lilys_measure() -> None:
    """No actuator at all is no reason for forces of nothing."""
    assert min(full_forces(vehicle(0.0, 0.0, 0.0, 0.0))[::2]) > 0.0
