"""Recordings made by the simulator's own step, with random forces and readings added by NumPy."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

MADE = str(Path(__file__).parent / "made")  # vehicles that no simulator of ours moves
TRIALS = str(Path(__file__).parents[1])  # drivers of trials, which know how recordings of others are cut
for folder in (MADE, TRIALS):
    if folder not in sys.path:
        sys.path.append(folder)

SEED = 20261121
STEP = 0.05  # s, of the simulation
TICK = 0.5  # s between commands
NOISE = {"pose": (0.002, 0.002, 0.002, 0.01), "compass": (0.02,), "pressure": (8.0,), "imu": (0.004,)}
LOG_NOISE = (0.001, 0.001, 0.001)  # m/s


def rich_commands(rng: np.random.Generator, seconds: float) -> Any:
    """(ticks, 3) spins, coasts, reverse, turns and pump pulses, held 1.5 to 6 s."""
    rows: list[list[float]] = []
    while len(rows) * TICK < seconds:
        kind = rng.integers(5)
        common = rng.uniform(-0.6, 1.0) if kind else 0.0
        turn = rng.uniform(-0.5, 0.5) if kind in (2, 3) else 0.0
        common = rng.uniform(-0.09, 0.09) if kind == 4 else common
        pump = rng.uniform(-0.1, 0.1)
        row = [float(np.clip(common - turn, -1, 1)), float(np.clip(common + turn, -1, 1)), pump]
        rows += [row] * int(rng.integers(3, 13))
    return np.array(rows[: round(seconds / TICK)])


@pytest.fixture(scope="session")
def swim() -> Callable[..., Any]:
    """Function of (platform, seconds, seed, disturbance as a share of full thrust ...): evidence of one Lily.

    blur: times the usual noise of the readings.
    """
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream

    def make(
        platform: Any, seconds: float, seed: int = 0, disturbance: float = 0.005, base: Any = None, blur: float = 1.0
    ) -> Any:
        rng = np.random.default_rng([SEED, seed])
        commands = rich_commands(rng, seconds)
        path = trajectory(platform, commands, rng, disturbance)
        stamps = np.arange(len(path)) * STEP
        streams = {}
        for name, every in (("pose", 2), ("compass", 4), ("pressure", 2), ("imu", 1)):
            time, rows = stamps[::every], path[::every]
            truth = {
                "pose": rows[:, :4],
                "compass": rows[:, 3:4],
                "pressure": 101325.0 - platform.water_density * platform.gravity * rows[:, 2:3],
                "imu": np.column_stack([rows[:, 7], np.full((len(rows), 3), np.nan)]),
            }[name]
            noise = np.full(truth.shape[1], np.nan)
            noise[: len(NOISE[name])] = blur * np.array(NOISE[name])
            value = truth + np.where(np.isnan(noise), 0.0, noise) * rng.standard_normal(truth.shape)
            streams[name] = Stream(time, value, noise)
        log = RobotLog("lily_01", np.arange(len(commands)) * TICK, commands, streams)
        return Evidence(base or platform, (RecordingLog("simulated", seconds, (log,)),))

    return make


@pytest.fixture(scope="session")
def truth_of() -> Callable[..., Any]:
    """Function of (platform, seconds, seed): the true states (rows, 8) every STEP of what `swim` makes of the same."""

    def make(platform: Any, seconds: float, seed: int) -> Any:
        rng = np.random.default_rng([SEED, seed])
        return trajectory(platform, rich_commands(rng, seconds), rng, 0.005)

    return make


@pytest.fixture(scope="session")
def swim_with_logs(swim: Callable[..., Any]) -> Callable[..., Any]:
    """Function of (platform, seconds, seed, base, current): the same evidence with speed logs over ground and in water.

    current: (2,) [m/s; world], at which the water of the platform moves. base: the platform of the evidence.
    """
    from cocorosim_ros.diagnosis.evidence.streams.log import Stream

    def make(
        platform: Any, seconds: float, seed: int, base: Any = None, current: tuple[float, float] = (0.0, 0.0)
    ) -> Any:
        evidence, rng = swim(platform, seconds, seed, base=base), np.random.default_rng([SEED, seed])
        path = trajectory(platform, rich_commands(rng, seconds), rng, 0.005)[::2]
        (east, north), yaw, ground, noise = current, path[:, 3], path[:, 4:7], np.array(LOG_NOISE)
        ahead, left = east * np.cos(yaw) + north * np.sin(yaw), north * np.cos(yaw) - east * np.sin(yaw)
        speeds = {"velocity": ground - np.column_stack([ahead, left, 0.0 * yaw]), "ground_velocity": ground}
        logs = {
            topic: Stream(
                2 * STEP * np.arange(len(speed)),
                speed + noise * np.random.default_rng([SEED, seed, number]).standard_normal(speed.shape),
                noise,
            )
            for number, (topic, speed) in enumerate(speeds.items(), start=1)
        }
        (recording,) = evidence.recordings
        (log,) = recording.robots
        robots = (replace(log, streams={**log.streams, **logs}),)
        return replace(evidence, recordings=(replace(recording, robots=robots),))

    return make


@pytest.fixture(scope="session")
def swim_with_log(swim_with_logs: Callable[..., Any]) -> Callable[..., Any]:
    """Function of (platform, seconds, seed): the same evidence, and a speed log through water at rest beside it."""

    def make(platform: Any, seconds: float, seed: int) -> Any:
        evidence = swim_with_logs(platform, seconds, seed)
        (recording,) = evidence.recordings
        (log,) = recording.robots
        streams = {topic: stream for topic, stream in log.streams.items() if topic != "ground_velocity"}
        return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))

    return make


def trajectory(platform: Any, commands: Any, rng: np.random.Generator, disturbance: float) -> Any:
    """(rows, 8) states every STEP, by the simulator's own tick; the random force holds for a tick."""
    from cocorosim_ros.study.calibration.free_run import OPEN_WATER, STILL
    from cocorosim_ros.world.motion.contact import INELASTIC
    from cocorosim_ros.world.motion.integrators import INTEGRATOR_CODE
    from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
    from cocorosim_ros.world.state.state import row_size
    from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
    from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PATCH_FORCE_COLUMNS

    vehicles = build_vehicles([platform])
    vehicles.active[:] |= EFFECT_BIT["patch_force"]
    state = np.zeros((1, 1, row_size(3)))
    state[0, 0, :4] = [0.3, -0.2, -1.0, 0.5]
    stepping = Stepping(INTEGRATOR_CODE["rk4"], 1, STEP, INELASTIC)
    scale = disturbance * np.array([0.01, 0.01, 0.01, 2.5e-4])
    force, decay = scale * rng.standard_normal(4), math.exp(-STEP / 2.0)
    path = [state[0, 0, :8].copy()]
    per = round(TICK / STEP)
    for index in range(len(commands) * per):
        apply_commands(state, np.ascontiguousarray(commands[None, None, index // per]), vehicles)
        vehicles.parameters[0, 0, PATCH_FORCE_COLUMNS] = force
        move(state, vehicles, OPEN_WATER, stepping, STILL, index * STEP)
        force = decay * force + math.sqrt(1.0 - decay**2) * scale * rng.standard_normal(4)
        path.append(state[0, 0, :8].copy())
    return np.array(path)
