"""Scenario files made from one good text by replacing one piece of it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.checks.loading import load_scenario

GOOD = """\
name: small
description: three robots
seed: 3
tick: 0.5 s
duration: 10 s
tank:
  size: [6 m, 6 m, 2 m]
integrator:
  name: rk4
  step: 100 ms
swarm:
  - platform: lily
    count: 3
    controller: boids_blt
    start:
      box: {centre: [0 m, 0 m, -1 m], size: [1 m, 1 m, 1 m]}
"""
BOX = "box: {centre: [0 m, 0 m, -1 m], size: [1 m, 1 m, 1 m]}"

ScenarioFile = Callable[..., Path]
Complaint = Callable[..., str]


@pytest.fixture
def scenario_file(tmp_path: Path) -> ScenarioFile:
    """Write the good scenario with (old, new) pieces replaced; every old piece must be there."""

    def write(*replacements: tuple[str, str]) -> Path:
        text = GOOD
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "x.yaml"
        path.write_text(text)
        return path

    return write


@pytest.fixture
def complaint(scenario_file: ScenarioFile, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Complaint:
    """The sentence that loading the changed scenario ends with, seen from the file's own folder."""
    monkeypatch.chdir(tmp_path)

    def load(*replacements: tuple[str, str]) -> str:
        with pytest.raises(CocorosimError) as caught:
            load_scenario(scenario_file(*replacements))
        return str(caught.value)

    return load
