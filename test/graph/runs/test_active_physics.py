"""What acts in a run, in words: everything that a scenario names stands on one side or the other."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.graph.runs.active_physics import active_physics
from cocorosim_ros.scenario.reading.yaml_file import yaml_text
from cocorosim_ros.world.checks.loading import load_scenario

WITHOUT_EFFECT = " Named, but without effect: "
TWO = {
    "name": "two",
    "description": "two",
    "seed": 1,
    "tick": "0.5 s",
    "duration": "5 s",
    "tank": {"size": ["4 m", "4 m", "2 m"]},
    "integrator": {"name": "rk4", "step": "0.25 s"},
}


def sourced(text: str) -> dict[str, Any]:
    """A number of a platform file."""
    value, unit = text.split()
    return {"value": float(value), "unit": unit, "source": "choice of this test", "confidence": "estimate"}


@pytest.fixture
def words(tmp_path: Path) -> Callable[..., str]:
    """A function of effects, each with its numbers, and keys: the words about two such Lilys in such a scenario."""

    def tell(effects: dict[str, dict[str, str]], **keys: Any) -> str:
        numbers = {effect: {name: sourced(text) for name, text in of.items()} for effect, of in effects.items()}
        platform = {"name": "odd", "description": "odd", "based_on": "lily", "effects": numbers}
        (tmp_path / "odd.yaml").write_text(yaml_text(platform), "utf-8")
        start = {"box": {"centre": ["0 m", "0 m", "-1 m"], "size": ["1 m", "1 m", "1 m"]}}
        group = {"platform": "./odd.yaml", "count": 2, "prefix": "lily", "controller": "idle", "start": start}
        (tmp_path / "two.yaml").write_text(yaml_text({**TWO, "swarm": [group], **keys}), "utf-8")
        return active_physics(load_scenario(str(tmp_path / "two.yaml")))

    return tell


def test_plain_water() -> None:
    """A Lily in still water has drag, buoyancy and her two media, and nothing named is idle."""
    expected = "Effects: quadratic_drag, net_buoyancy; water: still; sensor errors: none; media: blue light, radio."
    assert active_physics(load_scenario("one_lily")) == expected


@pytest.mark.parametrize(
    ("effects", "reason"),
    [
        ({"wall_effect": {"gain": "0 1", "range": "0.2 m"}}, "wall_effect (gain 0)"),
        ({"thruster_lag": {"time_constant": "0 s"}}, "thruster_lag (time_constant 0)"),
        ({"steady_current": {"x": "0 m/s", "y": "0 m/s"}}, "steady_current (x 0, y 0)"),
        ({"pressure_offset": {"offset": "0 Pa"}}, "pressure_offset (offset 0)"),
    ],
)
def test_a_zero_is_said(words: Callable[..., str], effects: dict[str, dict[str, str]], reason: str) -> None:
    """An effect whose strength is zero stands among what does nothing, with the number."""
    acting, idle = words(effects).split(WITHOUT_EFFECT)
    assert idle == f"{reason}."
    assert next(iter(effects)) not in acting


def test_what_acts(words: Callable[..., str]) -> None:
    """The same effects with numbers act; one of two numbers is enough."""
    effects = {
        "wall_effect": {"gain": "1 1", "range": "0.2 m"},
        "steady_current": {"x": "0 m/s", "y": "0.01 m/s"},
        "pressure_offset": {"offset": "10 Pa"},
    }
    told = words(effects)
    assert told.startswith("Effects: quadratic_drag, net_buoyancy, steady_current, wall_effect; water: still; ")
    assert "sensor errors: pressure_offset;" in told
    assert WITHOUT_EFFECT not in told


def test_water_and_corruptions(words: Callable[..., str]) -> None:
    """Currents, cold spots, noise and losses without strength are idle; the others act."""
    told = words(
        {},
        water={
            "currents": [
                {"kind": "uniform", "x": "0 m/s", "y": "0 m/s"},
                {"kind": "tidal", "x": "0.01 m/s", "y": "0 m/s", "period": "60 s"},
            ],
            "force_currents": {"cold_spots": {"force": "0 N"}, "wakes": {"strength": 1}},
        },
        corruption=[
            {"channel": "compass", "kind": "noise", "sd": "0 deg"},
            {"channel": "pressure", "kind": "noise", "sd": "5 Pa"},
            {"channel": "radio", "kind": "loss", "probability": "0 %"},
        ],
    )
    acting, idle = told.split(WITHOUT_EFFECT)
    assert "water: tidal current, wakes of thrusters; sensor errors: pressure noise; media: blue light, radio" in acting
    assert idle == (
        "uniform current (its speed is 0), cold spots (force 0), compass noise (sd 0), radio loss (probability 0)."
    )
