"""Steps of time that an integrator does not bear are refused, and the limit is the true one."""

from __future__ import annotations

import math
from typing import Any

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.world.checks.loading import read_scenario
from cocorosim_ros.world.checks.stability import STABLE_INTERVAL, fastest_rate, longest_stable_step

TEXT = """
name: fast
description: one Lily
seed: 1
tick: {step} s
duration: 60 s
tank: {{size: [6 m, 6 m, 2 m]}}
integrator: {{name: {name}, step: {step} s}}
swarm:
  - {{platform: lily, controller: idle, start: {{poses: [[0 m, 0 m, -1 m, 0 deg]]}}}}
"""
# Pump 0.0981 N and thrusters 0.01 N at right angles, k = 1.7778 kg/m, m = 0.44 kg.
RATE = 2.0 * math.sqrt(1.7778 * math.hypot(0.0981, 0.01)) / 0.44


def test_the_rate_by_hand() -> None:
    """Lily's fastest motion is up and down; a floater without actuators has none."""
    assert fastest_rate(load_platform("lily")) == pytest.approx(RATE, rel=1e-9)
    assert longest_stable_step("rk4", load_platform("floater")) == math.inf


@pytest.mark.parametrize("name", STABLE_INTERVAL)
def test_the_limit_is_where_deviations_begin_to_grow(name: str) -> None:
    """One step of v' = -rate v multiplies a deviation by 1 - z, or its series to the fourth order: of size 1 there."""
    z = longest_stable_step(name, load_platform("lily")) * RATE
    factor = 1 - z if name == "semi_implicit_euler" else 1 - z + z**2 / 2 - z**3 / 6 + z**4 / 24
    assert abs(factor) == pytest.approx(1.0, abs=1e-8)


@pytest.mark.parametrize(("name", "good", "bad"), [("semi_implicit_euler", 1.0, 1.1), ("rk4", 1.4, 1.5)])
def test_a_step_beyond_it(name: str, good: float, bad: float) -> None:
    """1.05 s for the paper's integrator, 1.46 s for Runge-Kutta; the sentence says so."""
    read_scenario(parse_yaml(TEXT.format(name=name, step=good).replace("60 s", f"{60 * good:g} s"), "good"))
    with pytest.raises(CocorosimError, match=rf"step of {bad:g} s, beyond the 1\.\d+ s up to which '{name}'.*'lily'"):
        read_scenario(parse_yaml(TEXT.format(name=name, step=bad).replace("60 s", f"{60 * bad:g} s"), "bad"))


def test_what_makes_motions_faster_by_hand() -> None:
    """Water of 0.5 m/s, linear drag of 2 N s/m, and twice the drag in heave, each added to the rate."""
    from dataclasses import replace

    from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of

    lily = load_platform("lily")
    effects = {
        "linear_drag": {"heave": Quantity(2.0, "N s/m", dimension_of("N s/m"))},
        "anisotropic_drag": {"heave_ratio": Quantity(2.0, "1", dimension_of("1"))},
    }
    rate = (2.0 * math.sqrt(2.0 * 1.7778 * math.hypot(0.0981, 0.01)) + 2.0 * 2.0 * 1.7778 * 0.5 + 2.0) / 0.44
    assert fastest_rate(replace(lily, effect_quantities=effects), 0.5) == pytest.approx(rate, rel=1e-9)


@pytest.mark.parametrize(
    ("current", "speed"),
    [
        ("kind: uniform, x: 3 m/s, y: 4 m/s", 5.0),
        ("kind: tidal, x: 3 m/s, y: 4 m/s, period: 60 s", 5.0),
        ("kind: sheared, x: 1 m/s, y: 0 m/s, dx_dy: 1 1/s", 4.0),
        ("kind: vortex, x: 0 m, y: 0 m, circulation: 20 m^2/s, core: 0.5 m", 0.6382 * 20.0 / math.pi),
    ],
)
def test_water_that_is_too_fast_for_a_step(current: str, speed: float) -> None:
    """Lily's terminal speed and the water's together decide; 6 m of tank shear by 3 m/s from the middle to the wall."""
    longest = 2.0 / (RATE + 2.0 * 1.7778 * speed / 0.44)
    text = TEXT.format(name="semi_implicit_euler", step=0.5) + f"water: {{currents: [{{{current}}}]}}\n"
    with pytest.raises(CocorosimError, match=rf"beyond the {longest:.3g} s .* in water of up to {speed:.3g} m/s"):
        read_scenario(parse_yaml(text, "swift"))


def test_a_gridded_current_is_as_fast_as_its_fastest_place(tmp_path: Any) -> None:
    """Two places, one second: 0.1 m/s and, by Pythagoras, 5 m/s."""
    import numpy as np
    import xarray

    speeds = {"u": (("y", "x"), np.array([[0.1, 3.0]])), "v": (("y", "x"), np.array([[0.0, 4.0]]))}
    xarray.Dataset(speeds, coords={"x": [0.0, 1.0], "y": [0.0]}).to_netcdf(tmp_path / "flow.nc")
    water = f"water: {{currents: [{{kind: gridded, file: {tmp_path / 'flow.nc'}}}]}}\n"
    with pytest.raises(CocorosimError, match="in water of up to 5 m/s"):
        read_scenario(parse_yaml(TEXT.format(name="rk4", step=0.5) + water, "swift"))
