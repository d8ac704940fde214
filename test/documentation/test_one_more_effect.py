"""What CONTRIBUTING.md promises: an effect is one new file and one line. Its leak is added to a copy of the package."""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace

import pytest

pytestmark = pytest.mark.timeout(1800)  # s; everything is compiled anew
RATE = 2e-5  # N/s
PLATFORM = f"""name: leaky
description: a Lily that leaks
based_on: lily
effects: {{leak: {{rate: {{value: {RATE}, unit: N/s, source: a test}}}}}}
"""
SCENARIO = """name: driven
description: one Lily that is driven about
seed: 1
tick: 0.5 s
duration: 90 s
tank: {size: [8 m, 8 m, 4 m]}
integrator: {name: rk4, step: 0.05 s, contact: inelastic}
swarm:
  - platform: PLATFORM
    prefix: lily
    controller: programme
    overrides:
      {row_1_time: 6 s, row_1_ahead: 0.8, row_2_time: 4 s, row_3_time: 3 s, row_3_turn: 0.4, row_4_time: 4 s,
        row_5_time: 4 s, row_5_ahead: 0.4, row_5_rise: 0.1, row_6_time: 4 s, row_6_rise: -0.1, row_7_time: 3 s,
        row_7_turn: -0.4}
    start: {poses: [[0 m, 0 m, -1.5 m, 0 deg]]}
corruption:
  - {channel: compass, kind: noise, sd: 1 deg}
  - {channel: pressure, kind: noise, sd: 20 Pa}
lockstep: {silent_controller: thrusters_off, patience: 10 s}
recording: {topics: all}
"""


def test_what_every_effect_has_to_keep_is_tested_on_it_unasked(python: Callable[..., str]) -> None:
    """The tests over the tables pick it up: motion, innovations, units, a platform file."""
    files = (
        "contracts/test_every_effect.py",
        "diagnosis/test_catalogue.py",
        "world/motion/test_units.py",
        "world/vehicle_model",
    )
    python("-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", "leak", *(f"test/{name}" for name in files))


@pytest.fixture(scope="module", params=["leaky", "tight"])
def diagnosed(
    request: pytest.FixtureRequest, python: Callable[..., str], tmp_path_factory: pytest.TempPathFactory
) -> SimpleNamespace:
    """A run of a Lily with or without the leak, recorded, and what a diagnosis says of it that has a plain Lily."""
    folder = tmp_path_factory.mktemp(request.param)
    (folder / "leaky.yaml").write_text(PLATFORM)
    platform = folder / "leaky.yaml" if request.param == "leaky" else "lily"
    (folder / "driven.yaml").write_text(SCENARIO.replace("PLATFORM", str(platform)))
    command = ("-c", "from cocorosim_ros.commands.main import main; main()")
    python(*command, "run", folder / "driven.yaml", "--in-process", "--out", folder / "run")
    python(*command, "diagnose", folder / "run", "--platform", "lily", "--out", folder / "out")
    return SimpleNamespace(
        leaks=request.param == "leaky",
        said=json.loads((folder / "out" / "diagnosis.json").read_text()),
        model=folder / "out" / "model.yaml",
        page=(folder / "out" / "report.html").read_text("utf-8"),
    )


def test_it_is_simulated_recorded_and_found(diagnosed: SimpleNamespace) -> None:
    """With the leak it is what is named, alone, with its number in the interval; without it nothing is."""
    found = diagnosed.said["effects"]
    if not diagnosed.leaks:
        assert found == []
        return
    (leak,) = found
    assert (leak["id"], leak["name"], leak["equation"]) == ("leak", "hull that leaks", "Z = -rate t")
    rate = leak["parameters"]["rate"]
    assert rate["unit"] == "N/s" and rate["ci95"][0] <= RATE <= rate["ci95"][1]
    assert rate["ci95"][1] - rate["ci95"][0] < 0.5 * RATE


def test_it_is_drawn_and_written_down(diagnosed: SimpleNamespace, python: Callable[..., str]) -> None:
    """The page says what to check on the robot; the model is a platform that has the effect."""
    assert ("look for water" in diagnosed.page) == diagnosed.leaks
    assert ("hull that leaks" in diagnosed.page) == diagnosed.leaks
    assert ("leak:" in diagnosed.model.read_text("utf-8")) == diagnosed.leaks
    python(
        "-c",
        "from cocorosim_ros.scenario.parts.platform import load_platform\n"
        "from cocorosim_ros.world.vehicle_model.platform_effects import check_platform\n"
        f"check_platform(load_platform({str(diagnosed.model)!r}))",
    )
