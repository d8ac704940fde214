"""Steps of time that an integrator does not bear are refused, and the limit is the true one."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.errors import CocorosimError
from cocorosim_ros.scenario.platform import load_platform
from cocorosim_ros.scenario.scenario import read_scenario
from cocorosim_ros.scenario.stability import STABLE_INTERVAL, fastest_rate, longest_stable_step
from cocorosim_ros.scenario.yaml_file import parse_yaml

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
