"""Thrusters whose curve is another than the file's: named with its exponent, and no dead band; nor the other way round.

The swims are the simulator's, and its curves are the platform's own (`ThrustCurve`), no effect of the catalogue.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.thrust_curve import ThrustCurve
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster

SECONDS = 240.0


def lily(curve: ThrustCurve) -> Platform:
    """A Lily both of whose thrusters follow a curve."""
    plain = load_platform("lily")
    actuators = (replace(each, curve=curve) if isinstance(each, Thruster) else each for each in plain.actuators)
    return replace(plain, actuators=tuple(actuators))


def table(law: Callable[[Any], Any]) -> ThrustCurve:
    """The curve of a law of commands from 0 to 1, the same backwards, as a table."""
    commands = np.linspace(-1.0, 1.0, 81)
    forces = 0.005 * np.sign(commands) * law(np.abs(commands))
    return ThrustCurve("table", commands=tuple(commands.tolist()), forces=tuple(forces.tolist()))


@pytest.mark.parametrize(
    ("curve", "exponent", "within"),
    [
        (ThrustCurve("square"), 2.0, 0.05),
        (table(lambda size: size**1.4), 1.4, 0.05),
        (table(lambda size: size**0.7), 0.7, 0.05),
        (table(lambda size: 0.5 * size + 0.5 * size**2), 1.4, 0.15),
    ],
    ids=["square", "power of 1.4", "power of 0.7", "half a square law"],
)
def test_a_curve_is_named_with_its_power(swim: Any, curve: ThrustCurve, exponent: float, within: float) -> None:
    """Of powers it is the exponent, of other curves about that of the nearest; no dead band is named beside it."""
    found = diagnose(swim(lily(curve), SECONDS, seed=4, base=load_platform("lily")), lambda words, share: None)
    assert [each.id for each in found.effects] == ["thrust_curve"]
    assert found.effects[0].parameters["exponent"].value == pytest.approx(exponent, abs=within)


@pytest.mark.parametrize("form", [0.0, 1.0], ids=["jump", "ramp"])
def test_a_dead_band_keeps_its_name(swim: Any, form: float) -> None:
    """With a jump or a ramp behind it, a tenth of the command wide."""
    numbers = {"width": 0.1, "ramp": form}
    base = load_platform("lily")
    hidden = hiding(base, {"thruster_deadband": numbers})
    found = diagnose(swim(hidden, SECONDS, seed=4, base=base), lambda words, share: None)
    assert [each.id for each in found.effects] == ["thruster_deadband"]
    assert found.effects[0].parameters["width"].value == pytest.approx(0.1, rel=0.1)
