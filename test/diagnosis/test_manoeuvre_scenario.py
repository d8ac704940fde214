"""Every advised manoeuvre can be driven."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from cocorosim_ros.diagnosis.catalogue.manoeuvres import can_drive
from cocorosim_ros.diagnosis.report.advice import MANOEUVRES
from cocorosim_ros.diagnosis.report.manoeuvre_scenario import PROGRAMMES, RAMPED, scenario_of
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.controllers.programme import ROWS


def test_every_manoeuvre_has_a_programme() -> None:
    """What the advice can name, a scenario can drive."""
    assert set(PROGRAMMES) == set(MANOEUVRES)


CASES = [
    *((name, "lily") for name in MANOEUVRES),
    ("zig_zag", "hovercraft_epfl"),
    ("steps", "haizhe_auv"),
    ("crash_stops", "kvlcc2_hsva"),
    ("repeat_at_end", "kvlcc2_hsva"),
]
DRIVEN = [
    (platform, name)
    for platform in ("hovercraft_epfl", "haizhe_auv", "slocum_glider", "kvlcc2_hsva", "milliampere_ferry", "tauv_pool")
    for name in MANOEUVRES
    if can_drive(load_platform(platform), name)
]


def seconds_of(settings: dict[str, Any]) -> list[float]:
    """How long each row lasts [s], by the settings of the controller."""
    return [float(value.removesuffix(" s")) for key, value in settings.items() if re.fullmatch(r"row_\d+_time", key)]


@pytest.mark.parametrize(("name", "platform"), CASES)
def test_it_can_be_driven(name: str, platform: str, tmp_path: Path) -> None:
    """It loads, lasts whole rounds of ten minutes at least, and its first ticks do what its first row says."""
    from cocorosim_ros.world.seeding.seeding import start_poses
    from cocorosim_ros.world.tick.assembly import build_world
    from cocorosim_ros.world.tick.simulation import Simulation

    file = tmp_path / "next_manoeuvre.yaml"
    file.write_text(scenario_of(name, load_platform(platform), platform))
    scenario: Any = load_scenario(str(file))
    (swarm,) = yaml.safe_load(file.read_text())["swarm"]
    once = sum(seconds_of(swarm["overrides"]))
    if platform == "lily":
        assert once == sum(row.seconds for row in PROGRAMMES[name])
    assert scenario.duration > once or name != "repeat_at_end"
    assert scenario.duration >= 600.0 and scenario.duration % once == pytest.approx(0.0)
    simulation = Simulation(build_world(scenario), start_poses(scenario, 0)[None])
    for _ in range(2):
        simulation.sense()
        simulation.decide()
        simulation.advance()
    assert np.isfinite(simulation.state).all()
    row = PROGRAMMES[name][0]
    if platform == "lily" and name not in RAMPED:
        wanted = np.clip([row.ahead - row.turn, row.ahead + row.turn, row.rise], -1.0, 1.0)
        np.testing.assert_allclose(simulation.command[0], np.tile(wanted, (len(scenario.robots), 1)))


@pytest.mark.parametrize(("platform", "name"), DRIVEN)
def test_what_is_advised_moves_an_actuator(platform: str, name: str) -> None:
    """At least one actuator has a share in a motion that the programme asks for: no scenario lies still throughout."""
    (swarm,) = yaml.safe_load(scenario_of(name, load_platform(platform), platform))["swarm"]
    settings = swarm["overrides"]
    used = {
        motion
        for motion in ("ahead", "turn", "rise")
        if any(key.startswith("row_") and key.endswith(motion) and float(value) for key, value in settings.items())
        and any(key.startswith("actuator_") and key.endswith(motion) and value for key, value in settings.items())
    }
    assert used, settings


def test_a_ship_turns_under_way() -> None:
    """Its rudder does nothing at rest, so that rows that turn drive ahead too; a vehicle that turns at rest stays."""

    def ahead_while_turning(platform: str) -> set[float]:
        (swarm,) = yaml.safe_load(scenario_of("slow_turns", load_platform(platform), platform))["swarm"]
        rows = swarm["overrides"]
        turning = [key for key, value in rows.items() if key.startswith("row_") and key.endswith("turn") and value]
        return {float(rows[key.replace("turn", "ahead")]) for key in turning}

    assert ahead_while_turning("kvlcc2_hsva") == {0.5}
    assert ahead_while_turning("lily") == {0.0}


@pytest.mark.parametrize("name", ["lily", "jeff", "esso_osaka", "kvlcc2_hsva"])
def test_a_crash_stop_begins_at_full_speed_within_the_tank(name: str) -> None:
    """Within a twentieth: from rest u = V tanh(t k V / m) is the solution of m u' = k V^2 - k u^2."""
    platform = load_platform(name)
    full = math.sqrt(np.abs(platform.actuator_wrenches()[:, 0] @ platform.full_forces()[:, 0]) / platform.drag)
    scenario = yaml.safe_load(scenario_of("crash_stops", platform, name))
    seconds = seconds_of(scenario["swarm"][0]["overrides"])
    assert math.tanh(seconds[0] * platform.drag * full / platform.mass) > 0.95
    assert float(scenario["tank"]["size"][0].removesuffix(" m")) > 2.0 * seconds[0] * full


def test_a_slow_vehicle_sinks_no_farther() -> None:
    """A Jeff coasts longer than a Lily; the steps of a staircase of depths stay as they are."""
    (swarm,) = yaml.safe_load(scenario_of("depth_staircase", load_platform("jeff"), "jeff"))["swarm"]
    assert seconds_of(swarm["overrides"]) == [row.seconds for row in PROGRAMMES["depth_staircase"]]


def test_fins_turn_and_lift(tmp_path: Path) -> None:
    """A torpedo's rudders at the stern turn it to the left by a negative angle; its stern planes lift it."""
    text = (Path(__file__).parents[2] / "config/platforms/remus100.yaml").read_text("utf-8")
    file = tmp_path / "torpedo.yaml"
    file.write_text(text[: text.index("six_degrees:\n")] + text[text.index("actuators:\n") :])
    (swarm,) = yaml.safe_load(scenario_of("zig_zag", load_platform(file), str(file)))["swarm"]
    shares = [
        [float(swarm["overrides"][f"actuator_{n}_{way}"]) for way in ("ahead", "turn", "rise")] for n in (1, 2, 3)
    ]
    assert shares == [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]


def test_a_programme_fits_the_table() -> None:
    """No manoeuvre has more rows than the controller plays."""
    assert max(len(rows) for rows in PROGRAMMES.values()) <= ROWS
