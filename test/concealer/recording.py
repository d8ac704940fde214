"""One recording from one seed: what is drawn, how it moves, what is written, what is sealed."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from concealer import bag, oracle, prior, water
from concealer import layout as at
from concealer.catalogue_sensors import CATALOGUE
from concealer.layout import FloatArray
from concealer.manoeuvres import MANOEUVRES, Pool
from concealer.outside import OUTSIDE
from concealer.physics import drive
from concealer.prior import Plot, Wish
from concealer.scene import Faults, Scene, Secret
from concealer.seal import canonical, file_digest, seal
from concealer.sensors import observe
from concealer.truth_after import settle
from concealer.twins import twins

SPREAD = (at.MASS, at.INERTIA, at.DRAG, at.YAW_DRAG, at.THRUST, at.LEVER, at.PUMP)
EXPECTED = {
    "nothing": ["consistent", "recalibrate"],
    "recalibration": ["recalibrate"],
    "cannot_tell": ["insufficient", "consistent", "recalibrate"],
}


def vehicle(rng: np.random.Generator, numbers: dict[str, Any], kind: str) -> FloatArray:
    """(SIZE,) a robot off nominal: a little everywhere, or by much in a few places, or not at all."""
    p = at.nominal_robot()
    width = float(rng.uniform(*numbers["spread"]))
    factors = 1.0 + rng.uniform(-width, width, len(SPREAD))
    exact = rng.random() < numbers["exact_when_nothing"]
    far = rng.choice([-1.0, 1.0], len(SPREAD)) * rng.uniform(*numbers["recalibration_spread"], size=len(SPREAD))
    chosen = rng.permutation(len(SPREAD))[: rng.integers(2, 5)]
    if kind == "nothing" and exact:
        factors[:] = 1.0
    if kind == "recalibration":
        factors[chosen] = 1.0 + far[chosen]
    p[list(SPREAD)] *= factors
    return p


def vehicle_in_words(p: FloatArray) -> dict[str, float]:
    """The parameters that the interface lets a tool recalibrate."""
    nominal = at.nominal_robot()
    thrust, torque = p[at.THRUST] / nominal[at.THRUST], p[at.LEVER] / nominal[at.LEVER]
    return {
        "mass": float(p[at.MASS]), "moving_mass": float(p[at.MASS] + p[at.ADDED_SURGE]),
        "inertia": float(p[at.INERTIA]), "drag": float(p[at.DRAG]), "yaw_drag": float(p[at.YAW_DRAG]),
        "thrust_gain": float(thrust), "yaw_torque_gain": float(thrust * torque),
        "buoyancy_gain": float(p[at.PUMP] / nominal[at.PUMP]),
    }  # fmt: skip


def stage(rng: np.random.Generator, numbers: dict[str, Any], plot: Plot) -> tuple[Scene, list[Secret]]:
    """Robots and water with everything hidden that the plot wants."""
    robots = np.array([vehicle(rng, numbers["vehicle"], plot.kind) for _ in range(plot.robots)])
    scene = Scene(robots, [Faults() for _ in robots], int(rng.integers(plot.robots)))
    scene.everywhere(half_x=0.5 * plot.side, half_y=0.5 * plot.side, floor=-numbers["tank"]["depth"])
    scene.everywhere(duration=plot.duration)
    secrets = []
    for name, share in plot.hidden.items():
        hide = CATALOGUE.get(name) or OUTSIDE[name]
        large = (numbers["effects"] | numbers["outside"])[name]["large"]
        secrets.append(hide(rng, share * large, scene))
    if plot.kind == "cannot_tell":
        # Behind a dead zone without a jump every level of thrust is a little lower, which any recording shows.
        scene.own[at.DEAD_JUMP] = max(scene.own[at.DEAD_JUMP], scene.own[at.DEAD_CONTINUOUS])
        scene.own[at.DEAD_CONTINUOUS] = 0.0
    return scene, secrets


def start(rng: np.random.Generator, plot: Plot, depth: float) -> FloatArray:
    """(robots, STATE) at rest around the middle of the tank."""
    s = np.zeros((plot.robots, at.STATE))
    s[:, at.X], s[:, at.Y] = 0.3 * plot.side * rng.uniform(-1.0, 1.0, (2, plot.robots))
    s[:, at.Z] = -0.5 * depth + rng.uniform(-0.2, 0.2, plot.robots)
    s[:, at.YAW] = rng.uniform(-np.pi, np.pi, plot.robots)
    return s


def forces(rng: np.random.Generator, plot: Plot, ticks: int) -> FloatArray:
    """Knots (2 ticks + 2, robots, 4) of the water's random forces."""
    knots = water.matern(rng, (2 * ticks + 2, 4 * plot.robots), 0.5 * at.TICK, plot.correlation)
    scale = plot.noise * np.array([at.FULL_THRUST, at.FULL_THRUST, at.FULL_THRUST, at.FULL_TORQUE])
    return knots.reshape(-1, plot.robots, 4) * scale


def move(rng: np.random.Generator, plot: Plot, scene: Scene) -> tuple[FloatArray, FloatArray]:
    """Trajectory (rows, robots, ROW) and commands (ticks, robots, 3)."""
    ticks, depth = round(plot.duration / at.TICK), -float(scene.own[at.FLOOR])
    margin = 0.25 if "wall_effect" in plot.hidden else 0.5
    pool = Pool(0.5 * plot.side, depth, plot.duration, margin, "neighbour_wake" in plot.hidden)
    plans = [MANOEUVRES[plot.manoeuvre](rng, pool) for _ in range(plot.robots)]
    padded = np.zeros((plot.robots, max(map(len, plans)), plans[0].shape[1]))
    for row, plan in zip(padded, plans, strict=True):
        row[: len(plan)] = plan
        row[len(plan) :] = plan[-1]
        row[len(plan) :, 0] = 2.0 * plot.duration  # never reached
    rows, commands = drive(scene.robots, start(rng, plot, depth), padded, forces(rng, plot, ticks), ticks)
    return rows, commands


def instruments(sensors: dict[str, Any], plot: Plot) -> dict[str, Any]:
    """Numbers of the sensors; where no ruler may be there, nothing but camera and compass."""
    if plot.manoeuvre != "no_ruler":
        return sensors
    gone = {topic: sensors[topic] | {"missing": 1.0} for topic in ("pressure", "imu")}
    return sensors | gone | {"velocity": sensors["velocity"] | {"present": 0.0}}


def described(secret: Secret, share: float, spec: dict[str, Any], names: list[str]) -> dict[str, Any]:
    """A secret as the envelope states it."""
    return asdict(secret) | {"size": share, "large": spec["large"], "unit": spec["unit"], "robots": names}


def make(index: int, seed: int, out: Path, numbers: dict[str, Any], wish: Wish) -> tuple[str, dict[str, str]]:
    """Writes recording and envelope number `index` of a trial; returns its name and its entry in the ledger."""
    name = f"r{index:04d}"
    plotting, hiding, moving, sensing = np.random.default_rng([seed, index]).spawn(4)
    plot = prior.draw(plotting, numbers, wish)
    scene, secrets = stage(hiding, numbers, plot)
    rows, commands = move(moving, plot, scene)
    robots = [f"lily_{i + 1:02d}" for i in range(plot.robots)]
    streams = {
        robot: observe(rows[:, i], commands[:, i], scene.faults[i], instruments(numbers["sensors"], plot), sensing)
        for i, robot in enumerate(robots)
    }
    bag.write(out / "recordings" / name, streams)
    hidden = []
    own_rows, own_commands = rows[:, scene.victim], commands[:, scene.victim]
    for secret, (key, share) in zip(secrets, plot.hidden.items(), strict=True):
        settle(secret, scene.own, own_rows, own_commands)
        secret.twins = tuple(twins(secret, scene.own, own_rows, own_commands, (plot.noise, plot.correlation)))
        spec = (numbers["effects"] | numbers["outside"])[key]
        hidden.append(described(secret, share, spec, robots if secret.shared else [robots[scene.victim]]))
    truth = {
        "recording": name, "kind": plot.kind, "effects": hidden, "robots": robots, "manoeuvre": plot.manoeuvre,
        "expected_verdicts": EXPECTED.get(plot.kind, ["mismatch"]), "duration": plot.duration, "side": plot.side,
        "noise": plot.noise, "correlation": plot.correlation, "seed": [seed, index],
        "vehicles": {robot: vehicle_in_words(p) for robot, p in zip(robots, scene.robots, strict=True)},
        "oracle": oracle.oracle(scene.robots, rows, commands, [stream[0] for stream in streams.values()]),
        "salt": np.random.default_rng([seed, index, 1]).bytes(16).hex(),
    }  # fmt: skip
    envelope = out / "envelopes" / f"{name}.json"
    envelope.write_bytes(canonical(truth))
    return name, {"envelope": seal(truth), "recording": file_digest(out / "recordings" / name / f"{name}.mcap")}
