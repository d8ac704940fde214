"""Ways to tamper with the logs of real recordings, and whether a diagnosis found what was done."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Way:
    """One way to tamper, and what is to be found: effect, stream, its number and by how much that changes."""

    how: str
    amount: float
    effect: str
    topic: str | None
    parameter: str
    change: float
    same: tuple[str, str] = ("", "")  # effect and number that stand for the same where nothing else measures time

    @property
    def name(self) -> str:
        """A name for folders."""
        return f"{self.how.replace(':', '_')}_{self.amount:g}"


def _gain(index: int, amount: float) -> Way:
    left, right = (1.0 / (1.0 + amount), 1.0) if index == 0 else (1.0, 1.0 / (1.0 + amount))
    return Way(f"gain:{index}", amount, "thruster_asymmetry", None, "difference", 2.0 * (right - left) / (right + left))


def _late_pose(seconds: float) -> Way:
    """With the pose as the only stream, one that is late and thrusters that lag are told apart by their forms alone."""
    same = ("thruster_lag", "time_constant")
    return Way("delay:pose", seconds, "sensor_latency", "pose", "latency", seconds, same)


# Commands are 0 or 1 there: the log of one can be made weaker, but not stronger than full.
WAYS = {
    "hovercraft_epfl": (
        _gain(0, -0.15), _gain(1, -0.15), _gain(0, -0.3), _late_pose(0.05), _late_pose(0.15),
        Way("scale", 0.1, "camera_scale", "pose", "scale", 0.1),
    ),
    "haizhe_auv": (
        Way("delay:compass", 0.3, "sensor_latency", "compass", "latency", 0.3),
        Way("delay:imu", 0.3, "sensor_latency", "imu", "latency", 0.3),
        Way("delay:pressure", 0.5, "sensor_latency", "pressure", "latency", 0.5),
        Way("compass", 0.15, "compass_distortion", "compass", "sin", 0.15),
        Way("mirror", 1.0, "frame_mixup", "compass", "", math.nan),
        Way("gyro", 0.05, "imu_bias", "imu", "gyro_z", 0.05),
    ),
}  # fmt: skip
OUTCOMES = ("right", "cannot be seen", "missed", "named wrongly", "no diagnosis")
UNTOLD = {"camera_scale": "thrust, drag and inertia take it up where nothing else measures a length"}


def answer(folder: Path) -> dict[str, Any] | None:
    """A diagnosis, if there is one."""
    path = folder / "diagnosis.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def effects(diagnosis: dict[str, Any] | None) -> list[dict[str, Any]]:
    """Effects that a diagnosis reports."""
    return list((diagnosis or {}).get("effects") or [])


def effects_of_way(diagnosis: dict[str, Any] | None, way: Way) -> list[tuple[dict[str, Any], str]]:
    """Reported effects of what a way does, each with the number that tells how much."""
    found = []
    for effect in effects(diagnosis):
        topic = effect.get("topic")
        if effect["id"] == way.effect and (not topic or not way.topic or topic == way.topic):
            found.append((effect, way.parameter))
        elif effect["id"] == way.same[0]:
            found.append((effect, way.same[1]))
    return found


def number(found: list[tuple[dict[str, Any], str]], way: Way) -> tuple[float, float] | None:
    """Value and half of its 95 % interval; not named counts as nothing, not as unknown."""
    total, half = (1.0 if way.effect == "camera_scale" and not found else 0.0), 0.0
    for effect, parameter in found:
        told = (effect.get("parameters") or {}).get(parameter)
        if not told or told.get("value") is None:
            return None
        low, high = told.get("ci95") or (math.nan, math.nan)
        total += float(told["value"])
        half = math.hypot(half, 0.5 * (float(high) - float(low)) if None not in (low, high) else math.nan)
    return total, half


def judged(control: dict[str, Any] | None, tampered: dict[str, Any] | None, way: Way) -> dict[str, Any]:
    """What was found of one way in one group, and the outcome.

    right: it is named, and its number moved by what was put in, within 30 % or what both intervals allow.
    named wrongly: not right, and an effect of the catalogue is named that the control does not have.
    cannot be seen: neither, and the diagnosis says that these recordings could not show it.
    """
    before, after = effects_of_way(control, way), effects_of_way(tampered, way)
    one, two = number(before, way), number(after, way)
    named, in_control = (any(effect["id"] == way.effect for effect, _ in found) for found in (after, before))
    right, moved = False, None
    if after and not way.parameter:
        right = not before
    elif after and one and two:
        moved = two[0] - one[0]
        right = abs(moved - way.change) <= max(0.3 * abs(way.change), math.hypot(one[1], two[1]))
    known = {way.effect, way.same[0], *(effect["id"] for effect in effects(control))}
    wrong = [effect["id"] for effect in effects(tampered) if effect["id"] not in known and ":" not in effect["id"]]
    unseen = way.effect in ((tampered or {}).get("not_shown_by_this_recording") or [])
    outcome = "right" if right else "named wrongly" if wrong else "cannot be seen" if unseen else "missed"
    return {
        "named": named, "in_control": in_control, "moved": moved, "right": right, "named_wrongly": wrong,
        "outcome": outcome if tampered is not None else "no diagnosis",
    }  # fmt: skip
