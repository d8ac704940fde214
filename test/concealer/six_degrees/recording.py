"""One recording of a vehicle with six degrees of freedom from one seed, and its envelope."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from ruamel.yaml import YAML

from concealer import bag, water
from concealer.layout import FloatArray
from concealer.prior import Wish, entries, pick, size
from concealer.seal import canonical, file_digest, seal
from concealer.six_degrees import layout as at
from concealer.six_degrees.effects import EFFECTS, Scene
from concealer.six_degrees.instruments import observed
from concealer.six_degrees.makes import MAKES
from concealer.six_degrees.oracle import noise as noise_of_pose
from concealer.six_degrees.oracle import oracle
from concealer.six_degrees.programme import drawn, drive

VERDICTS = {"nothing": ["consistent", "recalibrate"], "recalibration": ["recalibrate"]}
COUNTS = {"single": 1, "several": 2, "outside": 1}  # of what is hidden
MOVED = (*range(at.LINEAR, at.LINEAR + 3), at.LINEAR + 5, *range(at.QUADRATIC, at.QUADRATIC + 3), at.QUADRATIC + 5,
         at.LIFT, at.THRUST)  # fmt: skip


def prior_of(name: str) -> Path:
    """Path of the registered prior of a make."""
    return Path(__file__).with_name(f"{name}.yaml")


def load(name: str) -> dict[str, Any]:
    """The prior of a make as plain dictionaries."""
    return dict(YAML(typ="safe").load(prior_of(name).read_text(encoding="utf-8")))


def vehicle(rng: np.random.Generator, numbers: dict[str, Any], kind: str, duration: float) -> FloatArray:
    """(SIZE,) a vehicle off nominal: a little in drag, lift and thrust, or by much in three of them."""
    p = MAKES[numbers["robot"]].nominal()
    width = rng.uniform(*numbers["spread"])
    factors = 1.0 + rng.uniform(-width, width, len(MOVED))
    far = 1.0 + rng.choice([-1.0, 1.0], len(MOVED)) * rng.uniform(*numbers["recalibration_spread"], size=len(MOVED))
    chosen = rng.permutation(len(MOVED))[:3]
    if kind == "recalibration":
        factors[chosen] = far[chosen]
    p[list(MOVED)] *= factors
    p[at.DURATION] = duration
    return p


def in_words(p: FloatArray, nominal: FloatArray) -> dict[str, Any]:
    """Numbers of the vehicle by the names that a diagnosis has for them; mass and inertia with what the water adds.

    `assumed` are mass and inertia of the platform file, whose vehicle `nominal` is.
    """
    gain, drag = float(p[at.THRUST] / nominal[at.THRUST]), float(p[at.QUADRATIC])
    linear = zip(("surge", "sway", "heave", "yaw"), p[at.LINEAR + np.array([0, 1, 2, 5])], strict=True)
    return {
        "mass": float(p[at.MASS]), "inertia": float(p[at.INERTIA + 2]), "drag": drag,
        "yaw_drag": float(p[at.QUADRATIC + 5]), "thrust_gain": gain, "yaw_torque_gain": gain,
        **{f"linear_drag.{axis}": float(value) for axis, value in linear},
        "anisotropic_drag.sway_ratio": float(p[at.QUADRATIC + 1]) / drag,
        "anisotropic_drag.heave_ratio": float(p[at.QUADRATIC + 2]) / drag,
        "buoyancy_trim.force": float(p[at.LIFT]),
        "assumed": {"mass": float(nominal[at.MASS]), "inertia": float(nominal[at.INERTIA + 2])},
    }  # fmt: skip


def _drawn_secrets(rng: np.random.Generator, numbers: dict[str, Any], kind: str, wish: Wish) -> dict[str, float]:
    """Sizes by name of what is hidden."""
    names = list(wish.effects)
    if not names and kind in COUNTS:
        table = list(numbers["outside" if kind == "outside" else "effects"])
        names = [str(name) for name in rng.choice(table, COUNTS[kind], replace=False)]
    return {name: wish.size or size(rng, numbers, kind) for name in names}


def make(index: int, seed: int, out: Path, numbers: dict[str, Any], wish: Wish) -> tuple[str, dict[str, str]]:
    """Writes recording and envelope number `index`; returns its name and its entry in the ledger."""
    name, made = f"r{index:04d}", MAKES[numbers["robot"]]
    plotting, hiding, moving, sensing = np.random.default_rng([seed, index]).spawn(4)
    kind, noise = pick(plotting, numbers["composition"]), pick(plotting, numbers["noise"])
    correlation = float(np.exp(plotting.uniform(*np.log(numbers["correlation"]))))
    kind, noise = wish.kind or kind, float(noise if wish.noise is None else wish.noise)
    duration = float(wish.duration or numbers["duration"])
    scene = Scene(vehicle(hiding, numbers, kind, duration))
    specs, hidden = entries(numbers), []
    for key, share in _drawn_secrets(plotting, numbers, kind, wish).items():
        secret = EFFECTS[key](hiding, share * specs[key]["large"], scene)
        hidden.append(asdict(secret) | specs[key] | {"size": share, "robots": [made.robot]})
    ticks = round(duration / at.TICK)
    scale = noise * np.array(made.full)[[0, 0, 0, 1]]
    knots = water.matern(moving, (ticks + 1, 4), at.TICK, correlation) * scale
    rows, commands = drive(scene.p, drawn(moving, duration, made.pilot), knots, ticks)
    streams = {made.robot: observed(rows, commands, scene, numbers["sensors"], sensing)}
    bag.write(out / "recordings" / name, streams, actuators=list(made.names))
    topic, late = scene.latency
    floor = noise_of_pose(streams[made.robot][0], rows, late if topic == "pose" else 0.0)
    truth = {
        "recording": name, "kind": kind, "effects": hidden, "robots": [made.robot], "manoeuvre": "rich",
        "expected_verdicts": VERDICTS.get(kind, ["mismatch"]), "duration": duration, "noise": noise,
        "correlation": correlation, "seed": [seed, index],
        "vehicles": {made.robot: in_words(scene.p, made.nominal())},
        "oracle": {made.robot: oracle(scene.p, rows, commands, floor)},
        "salt": np.random.default_rng([seed, index, 1]).bytes(16).hex(),
    }  # fmt: skip
    (out / "envelopes" / f"{name}.json").write_bytes(canonical(truth))
    return name, {"envelope": seal(truth), "recording": file_digest(out / "recordings" / name / f"{name}.mcap")}
