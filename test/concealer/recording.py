"""One recording from one seed: what is drawn, how it moves, what is written, what is sealed."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from concealer import bag, oracle, prior
from concealer import layout as at
from concealer.catalogue_sensors import CATALOGUE
from concealer.disguise import Disguise
from concealer.layout import FloatArray
from concealer.outside import OUTSIDE
from concealer.prior import Plot, Wish
from concealer.scene import Secret
from concealer.seal import canonical, file_digest, seal
from concealer.sensors import observe
from concealer.staging import move, stage
from concealer.truth_after import settle
from concealer.twins import twins

EXPECTED = {
    "nothing": ["consistent", "recalibrate"],
    "recalibration": ["recalibrate"],
    "cannot_tell": ["insufficient", "consistent", "recalibrate"],
}


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


def instruments(sensors: dict[str, Any], plot: Plot) -> dict[str, Any]:
    """Numbers of the sensors; where no ruler may be there, nothing but camera and compass."""
    if plot.manoeuvre != "no_ruler":
        return sensors
    gone = {topic: sensors[topic] | {"missing": 1.0} for topic in ("pressure", "imu")}
    return sensors | gone | {"velocity": sensors["velocity"] | {"present": 0.0}}


def described(secret: Secret, share: float, spec: dict[str, Any], names: list[str]) -> dict[str, Any]:
    """A secret as the envelope states it."""
    return asdict(secret) | {"size": share, "large": spec["large"], "unit": spec["unit"], "robots": names}


def spec_of(numbers: dict[str, Any], name: str) -> dict[str, Any]:
    """Large and unit of an entry of the prior; a law of the grammar is as large as forces that swing."""
    return dict(prior.entries(numbers).get(name, {"large": 1.0, "unit": "of the grammar's large"}))


def make(index: int, seed: int, out: Path, numbers: dict[str, Any], wish: Wish) -> tuple[str, dict[str, str]]:
    """Writes recording and envelope number `index` of a trial; returns its name and its entry in the ledger.

    Where the numbers hold a table of `families`, members of it are drawn.
    """
    name = f"r{index:04d}"
    plotting, hiding, moving, sensing = np.random.default_rng([seed, index]).spawn(4)
    plot = prior.draw(plotting, numbers, wish)
    disguise = Disguise(np.random.default_rng([seed, index, 2]), numbers, plot) if "families" in numbers else None
    scene, secrets = disguise.stage(hiding) if disguise else stage(hiding, numbers, plot)
    rows, commands = disguise.move(moving, scene) if disguise else move(moving, plot, scene)
    robots = [f"lily_{i + 1:02d}" for i in range(plot.robots)]
    sensors = instruments(disguise.sensors if disguise else numbers["sensors"], plot)
    streams = {
        robot: observe(rows[:, i], commands[:, i], scene.faults[i], sensors, sensing) for i, robot in enumerate(robots)
    }
    bag.write(out / "recordings" / name, streams)
    hidden = []
    own_rows, own_commands = rows[:, scene.victim], commands[:, scene.victim]
    for secret, (key, share) in zip(secrets, plot.hidden.items(), strict=True):
        told = disguise.settle(key, secret, scene, own_rows, own_commands) if disguise else {}
        if "concealed" not in told and key in CATALOGUE | OUTSIDE:
            settle(secret, scene.own, own_rows, own_commands)
        found = twins(secret, scene.own, own_rows, own_commands, (plot.noise, plot.correlation))
        secret.twins = (*secret.twins, *found)
        where = robots if secret.shared else [robots[scene.victim]]
        hidden.append(described(secret, share, spec_of(numbers, key), where) | told)
    truth = {
        "recording": name, "kind": plot.kind, "effects": hidden, "robots": robots, "manoeuvre": plot.manoeuvre,
        "expected_verdicts": EXPECTED.get(plot.kind, ["mismatch"]), "duration": plot.duration, "side": plot.side,
        "noise": plot.noise, "correlation": plot.correlation, "seed": [seed, index],
        "vehicles": {robot: vehicle_in_words(p) for robot, p in zip(robots, scene.robots, strict=True)},
        "oracle": oracle.oracle(scene.robots, rows, commands, [stream[0] for stream in streams.values()]),
        "salt": np.random.default_rng([seed, index, 1]).bytes(16).hex(),
    }  # fmt: skip
    if disguise:
        truth["families"] = disguise.described()
    envelope = out / "envelopes" / f"{name}.json"
    envelope.write_bytes(canonical(truth))
    return name, {"envelope": seal(truth), "recording": file_digest(out / "recordings" / name / f"{name}.mcap")}
