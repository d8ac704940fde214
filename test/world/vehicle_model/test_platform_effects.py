"""What a platform file says of effects and gains reaches the simulation, or is refused in a sentence."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform, load_platform, platform_tree
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS, is_simulated
from cocorosim_ros.world.state.state import SURGE, YAW, X
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.vehicle_model.platform_effects import (
    KNOWN_EFFECTS,
    RECORDING_EFFECTS,
    build_delays,
    build_faults,
    check_platform,
    not_simulated,
)
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS


def lily(tmp_path: Path, more: str = "", name: str = "own") -> Platform:
    """A Lily with more in its file; SOURCE stands for a source."""
    text = f"name: {name}\ndescription: a Lily\nbased_on: lily\n{more}"
    path = tmp_path / f"{name}.yaml"
    path.write_text(text.replace("SOURCE", "source: a test"))
    return load_platform(path)


def effects(tmp_path: Path, lines: str) -> Platform:
    """A Lily with effects, written in one line: 'linear_drag: {surge: 0.01 N s/m}'."""
    return lily(tmp_path, f"effects: {{{lines}}}\n")


def number(value: float, unit: str) -> str:
    """A number as a platform file has it."""
    return f'{{value: {value!r}, unit: "{unit}", SOURCE}}'


def column(platform: Platform, name: str) -> float:
    """A number of the built vehicle."""
    return float(build_vehicles([platform]).parameters[0, 0, PARAMETER_COLUMNS[name]])


@pytest.mark.parametrize("effect", KNOWN_EFFECTS)
def test_every_effect_can_stand_in_a_platform_file(tmp_path: Path, effect: str) -> None:
    """All parameters in their own units are read, applied where they belong, and written back the same."""
    values = {name: part.neutral + 1.0 + index for index, (name, part) in enumerate(KNOWN_EFFECTS[effect].items())}
    if effect == "anisotropic_drag":
        values["form"] = 2.0  # one that adds to the drag by total speed, which Lily has
    if effect == "offset_centre":
        values = {name: 0.01 * value for name, value in values.items()}  # within her hull, or she is refused
    parts = [
        f"{name}: {number(value, '1' if KNOWN_EFFECTS[effect][name].unit == '*' else KNOWN_EFFECTS[effect][name].unit)}"
        for name, value in values.items()
    ]
    platform = effects(tmp_path, f"{effect}: {{{', '.join(parts)}}}")
    assert platform.effects == {effect: values}
    vehicles, faults = build_vehicles([platform]), build_faults([platform])
    if effect in CATALOGUE_EFFECTS:
        assert vehicles.active[0, 0] & EFFECT_BIT[effect]
        for name, value in values.items():
            assert vehicles.parameters[0, 0, PARAMETER_COLUMNS[f"{effect}.{name}"]] == value
    of_robot = effect in ERRORS and any(is_simulated(effect, part) for part in ERRORS[effect].parameters)
    assert (faults is not None or build_delays([platform]).any()) == of_robot
    without_diameter = effect == "wash_loss"  # a Lily's propellers have none in her file
    assert bool(not_simulated({"lily_01": platform})) == (effect in RECORDING_EFFECTS or without_diameter)


def test_a_form_of_drag_that_does_not_exist(tmp_path: Path) -> None:
    """Forms are numbered; what is no number of one is refused with the numbers there are."""
    platform = effects(tmp_path, f"anisotropic_drag: {{form: {number(2.5, '1')}}}")
    with pytest.raises(
        CocorosimError,
        match=r"'effects\.anisotropic_drag\.form' has '2\.5'.*write total_speed or added_own_speed or added_strips",
    ):
        build_vehicles([platform])


def test_a_sensor_that_does_not_exist(tmp_path: Path) -> None:
    """A flag that no sensor has is refused with the nearest name; one that a sensor has is kept and written back."""
    sensors = "sensors: {compass: true, SENSOR: true}\n"
    with pytest.raises(
        CocorosimError, match=re.escape("'sensors.presure' is no known sensor; did you mean 'pressure'?")
    ):
        check_platform(lily(tmp_path, sensors.replace("SENSOR", "presure")))
    platform = lily(tmp_path, sensors.replace("SENSOR", "thermometer"), "warm")
    assert platform.sensors.has("thermometer") and platform.sensors.has("compass")
    assert not platform.sensors.has("pressure")
    assert platform_tree(platform)["sensors"]["thermometer"] is True


def test_what_is_no_flag_is_no_sensor(tmp_path: Path) -> None:
    """A key with a number is not taken for a sensor."""
    with pytest.raises(CocorosimError, match=re.escape("'sensors.radio_rnge' is not a known key")):
        lily(tmp_path, f"sensors: {{radio_rnge: {number(0.5, 'm')}}}\n")


def test_shipped_lilys_have_no_effects() -> None:
    """Lily swims as before: two bits, gains of one, no faults."""
    vehicles = build_vehicles([load_platform("lily")])
    assert vehicles.active[0, 0] == EFFECT_BIT["quadratic_drag"] | EFFECT_BIT["net_buoyancy"]
    assert [column(load_platform("lily"), name) for name in ("thrust_gain", "yaw_torque_gain", "buoyancy_gain")] == [
        1.0
    ] * 3
    assert build_faults([load_platform("lily")]) is None
    assert not_simulated({"lily_01": load_platform("lily")}) == []


def test_gains_of_a_platform(tmp_path: Path) -> None:
    """A gain of the thrust is one of turning too, unless that has its own."""
    both = lily(tmp_path, f"thrust_gain: {number(0.9, '1')}\nbuoyancy_gain: {number(1.1, '1')}\n")
    own = lily(tmp_path, f"thrust_gain: {number(0.9, '1')}\nyaw_torque_gain: {number(1.2, '1')}\n", "turning")
    names = ("thrust_gain", "yaw_torque_gain", "buoyancy_gain")
    assert [column(both, name) for name in names] == [0.9, 0.9, 1.1]
    assert [column(own, name) for name in names] == [0.9, 1.2, 1.0]


@pytest.mark.parametrize(
    ("lines", "sentence"),
    [
        ("linear_drg: {surge: 1 N s/m}", "'effects.linear_drg' is no known effect; did you mean 'linear_drag'?"),
        ("patch_force: {patch_force_x: 1 N}", "'effects.patch_force' is no known effect"),
        ("linear_drag: {surg: 1 N s/m}", "'effects.linear_drag.surg' is no parameter of this effect; did you mean"),
        ("linear_drag: {surge: 1 N}", "'effects.linear_drag.surge' has '1.0 N', which is no linear drag; write it"),
        ("thruster_lag: {time_constant: -1 s}", "'effects.thruster_lag.time_constant' has '-1.0 s'; it must not"),
        ("wall_effect: {gain: 1, range: 0 m}", "'effects.wall_effect.range' has '0.0 m'; it must be greater than zero"),
        ("battery_sag: {fraction_lost: 0.1}", "'effects.battery_sag' lacks 'duration' (from the start to"),
        ("tidal_current: {x: 1 m/s}", "'effects.tidal_current' lacks 'period'"),
        ("law_1: {coefficient: 1, equation: 7}", "'effects.law_1.equation' has '7'; write a whole number from 0 to 6."),
        ("sensor_law_2: {reading: 16}", "'effects.sensor_law_2.reading' has '16'; write a whole number from 0 to 15."),
        ("sensor_law_1: {regressor_1: 16}", "'effects.sensor_law_1.regressor_1' has '16', sin_t, of which no reading"),
        ("law_1: {coefficient: 1, regressor_2: 1.5}", "'effects.law_1.regressor_2' has '1.5'; write a whole number"),
        ("sensor_latency: {blss: 1 s}", "'effects.sensor_latency.blss' is no parameter of this effect"),
    ],
)  # fmt: skip
def test_mistakes_in_effects(tmp_path: Path, lines: str, sentence: str) -> None:
    """Each is told with file, key, what was found and what is allowed; nobody ignores it."""
    full = re.sub(r": ([-0-9.]+) ?([^,{}]*)(?=[,}])", lambda it: f": {number(float(it[1]), it[2] or '1')}", lines)
    platform = effects(tmp_path, full)
    with pytest.raises(CocorosimError) as caught:
        check_platform(platform)
    assert sentence in str(caught.value)
    assert "own.yaml" in str(caught.value)
    with pytest.raises(CocorosimError):
        build_vehicles([platform])


def test_effects_of_a_single_robot_are_checked_too(tmp_path: Path) -> None:
    """What stands below 'robots' is no blind spot."""
    platform = lily(tmp_path, "robots: {lily_02: {effects: {linear_drg: {surge: " + number(1, "N s/m") + "}}}}\n")
    with pytest.raises(CocorosimError, match="linear_drg"):
        check_platform(platform)


def test_what_belongs_to_the_recording_is_said(tmp_path: Path) -> None:
    """Camera, clocks, late poses and mixed-up frames have one sentence each, on whatever robot."""
    lines = (
        f"sensor_latency: {{pose: {number(0.1, 's')}, compass: {number(0.2, 's')}}}, "
        f"clock_skew: {{imu: {number(1e-4, 's/s')}}}, camera_scale: {{scale: {number(1.02, '1')}}}"
    )
    platform = lily(tmp_path, f"effects: {{{lines}}}\nframe_corrections: {{compass: the reading is in degrees}}\n")
    told = not_simulated({"lily_01": platform, "lily_02": platform, "lily_03": load_platform("lily")})
    assert [sentence.partition(" belongs")[0] for sentence in told] == [
        "sensor_latency of pose", "clock_skew of imu", "camera_scale", "frame_mixup of compass",
    ]  # fmt: skip
    assert all("lily_01 and 1 more" in sentence for sentence in told)


def simulated(platform: Platform) -> Simulation:
    """One Lily of this platform at rest, looking along 0.9 rad, 1 m deep."""
    scenario = load_scenario("eleven_lilys")
    (group,) = scenario.swarm
    group = dataclasses.replace(group, platform=platform, count=1)
    world = build_world(dataclasses.replace(scenario, swarm=(group,)))
    return Simulation(world, np.array([[[0.0, 0.0, -1.0, 0.9]]]))


def test_a_platform_with_a_current_drifts(tmp_path: Path) -> None:
    """The simulation's own loop drags a robot from rest by U t - m/k ln(1 + k U t / m)."""
    platform = effects(tmp_path, f"steady_current: {{x: {number(0.02, 'm/s')}}}")
    simulation, still = simulated(platform), simulated(load_platform("lily"))
    for _ in range(120):
        simulation.advance()
        still.advance()
    mass, drag, time = 0.44, 1.7778, 120 * simulation.world.tick_ns * 1e-9
    drift = 0.02 * time - mass / drag * math.log(1 + drag * 0.02 * time / mass)
    assert simulation.state[0, 0, X] - still.state[0, 0, X] == pytest.approx(drift, rel=1e-5)


def test_faulty_instruments(tmp_path: Path) -> None:
    """Compass, pressure and IMU of a robot at rest show what its platform says, the truth is as it was."""
    lines = (
        f"compass_distortion: {{offset: {number(0.05, 'rad')}, sin: {number(0.1, 'rad')}, "
        f"cos: {number(-0.2, 'rad')}}}, "
        f"pressure_offset: {{offset: {number(120, 'Pa')}}}, pressure_drift: {{rate: {number(-2, 'Pa/s')}}}, "
        f"imu_bias: {{gyro_z: {number(0.02, 'rad/s')}, accel_x: {number(0.1, 'm/s^2')}, "
        f"accel_y: {number(0.2, 'm/s^2')}, accel_z: {number(0.3, 'm/s^2')}}}"
    )
    faulty, right = simulated(effects(tmp_path, lines)), simulated(load_platform("lily"))
    for _ in range(3):
        faulty.advance()
        right.advance()
    shown, true = faulty.sense(), right.sense()
    assert np.array_equal(faulty.state, right.state)
    time = 3 * faulty.world.tick_ns * 1e-9
    yaw = right.state[0, 0, YAW]
    error = 0.05 + 0.1 * math.sin(yaw) - 0.2 * math.cos(yaw)
    assert shown.compass[0, 0] - true.compass[0, 0] == pytest.approx(error, rel=1e-9)
    assert shown.pressure[0, 0] - true.pressure[0, 0] == pytest.approx(120 - 2 * time, rel=1e-9)
    assert shown.angular_rate[0, 0, 2] - true.angular_rate[0, 0, 2] == pytest.approx(0.02, rel=1e-9)
    np.testing.assert_allclose(
        shown.specific_force[0, 0] - true.specific_force[0, 0], [0.1, 0.2, 0.3], rtol=0, atol=1e-12
    )


def test_late_instruments(tmp_path: Path) -> None:
    """A compass that is one and a half ticks late shows the mean of the two readings around then."""
    tick = simulated(load_platform("lily")).world.tick_ns * 1e-9
    platform = effects(
        tmp_path, f"sensor_latency: {{compass: {number(1.5 * tick, 's')}, pressure: {number(tick, 's')}}}"
    )
    late, right = simulated(platform), simulated(load_platform("lily"))
    shown, true, depths = [], [], []
    for _ in range(8):
        depths.append((late.sense().pressure[0, 0], right.sense().pressure[0, 0]))
        shown.append(late.readings.compass[0, 0])
        true.append(right.readings.compass[0, 0])
        for simulation in (late, right):
            simulation.command[...] = (-1.0, 1.0, 0.5)
            simulation.advance()
    turn = np.unwrap(true)
    expected = np.concatenate([turn[:1], [turn[0]], 0.5 * (turn[:-2] + turn[1:-1])])
    np.testing.assert_allclose(np.angle(np.exp(1j * (np.array(shown) - expected))), 0.0, atol=1e-12)
    assert np.ptp(turn) > 1.0
    late_depth, depth = np.array(depths).T
    assert np.array_equal(late_depth, np.concatenate([depth[:1], depth[:-1]]))


def test_a_gain_moves_a_robot(tmp_path: Path) -> None:
    """With 0.81 of its thrust a Lily comes to 0.9 of its speed."""
    simulation = simulated(lily(tmp_path, f"thrust_gain: {number(0.81, '1')}\n"))
    for _ in range(60):
        simulation.command[...] = (1.0, 1.0, 0.0)
        simulation.advance()
    assert simulation.state[0, 0, SURGE] == pytest.approx(0.9 * math.sqrt(0.01 / 1.7778), rel=1e-4)
