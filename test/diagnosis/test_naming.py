"""What is hidden in a simulated recording is named, and nothing where nothing is."""

from __future__ import annotations

from typing import Any

import pytest

SECONDS = 150.0
# Effect, what is hidden of it, and the number that is checked.
HIDDEN = [
    ("thruster_lag", {"time_constant": 0.3}),
    ("torque_bias", {"torque": 1e-5}),
    ("pump_lag", {"time_constant": 0.5}),
    ("linear_drag", {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 3e-5}),
]


def diagnosed(swim: Any, hidden: dict[str, dict[str, float]], seed: int) -> Any:
    """The diagnosis of a swim with these effects, by a base that lacks them, and the progress that was told."""
    from dataclasses import replace

    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.physics.effects import EFFECTS
    from cocorosim_ros.scenario.platform import load_platform
    from cocorosim_ros.scenario.quantity import Quantity, dimension_of

    plain = load_platform("lily")
    units = {name: {part.name: part.unit for part in EFFECTS[name].parameters} for name in hidden}
    effects = {
        name: {key: Quantity(value, units[name][key], dimension_of(units[name][key])) for key, value in part.items()}
        for name, part in hidden.items()
    }
    platform = replace(plain, effect_quantities=effects)
    said: list[str] = []
    return diagnose(swim(platform, SECONDS, seed=seed, base=plain), lambda words, share: said.append(words)), said


@pytest.mark.parametrize(("effect", "numbers"), HIDDEN, ids=[effect for effect, _ in HIDDEN])
def test_what_is_hidden_is_named(swim: Any, effect: str, numbers: dict[str, float]) -> None:
    """Two and a half minutes name the effect and nothing else, with the truth within twice its interval."""
    diagnosis, said = diagnosed(swim, {effect: numbers}, seed=1)
    assert diagnosis.verdict == "mismatch"
    assert [part.id for part in diagnosis.effects] == [effect]
    for name, truth in numbers.items():
        found = diagnosis.effects[0].parameters[name]
        assert abs(found.value - truth) <= found.high - found.low
    assert diagnosis.fit["position"].augmented < diagnosis.fit["position"].recalibrated * 1.05
    assert said


def test_nothing_is_accused_where_nothing_is_hidden(swim: Any) -> None:
    """A recording of the very model is called consistent, or insufficient for some effects, never a mismatch."""
    diagnosis, _ = diagnosed(swim, {}, seed=2)
    assert diagnosis.verdict in ("consistent", "insufficient")
    assert diagnosis.effects == ()


def test_a_pump_that_is_late_by_a_moment_is_not_accused(swim: Any) -> None:
    """Thirty-five milliseconds are somebody's clock; neither the pump nor a law that says the same is to blame."""
    diagnosis, _ = diagnosed(swim, {"pump_lag": {"time_constant": 0.035}}, seed=3)
    assert diagnosis.effects == ()
