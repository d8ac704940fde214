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

    @property
    def name(self) -> str:
        """A name for folders."""
        return f"{self.how.replace(':', '_')}_{self.amount:g}"


def _gain(index: int, amount: float) -> Way:
    left, right = (1.0 / (1.0 + amount), 1.0) if index == 0 else (1.0, 1.0 / (1.0 + amount))
    return Way(f"gain:{index}", amount, "thruster_asymmetry", None, "difference", 2.0 * (right - left) / (right + left))


WAYS = {
    "hovercraft_epfl": (
        _gain(0, 0.2), _gain(1, 0.2), _gain(0, -0.15),
        Way("delay:pose", 0.05, "sensor_latency", "pose", "latency", 0.05),
        Way("delay:pose", 0.15, "sensor_latency", "pose", "latency", 0.15),
        Way("lowpass", 0.15, "thruster_lag", None, "time_constant", -0.15),
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
UNTOLD = {"camera_scale": "thrust, drag and inertia take it up where nothing else measures a length"}


def answer(folder: Path) -> dict[str, Any] | None:
    """A diagnosis, if there is one."""
    path = folder / "diagnosis.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def accused(diagnosis: dict[str, Any] | None, way: Way) -> dict[str, Any] | None:
    """The accusation of what a way does, if there is one."""
    for effect in (diagnosis or {}).get("effects") or []:
        topic = effect.get("topic")
        if effect["id"] == way.effect and (not topic or not way.topic or topic == way.topic):
            return dict(effect)
    return None


def number(effect: dict[str, Any] | None, way: Way) -> tuple[float, float] | None:
    """Value and half of its 95 % interval; not accused counts as nothing, not as unknown."""
    if effect is None:
        return (1.0, 0.0) if way.effect == "camera_scale" else (0.0, 0.0)
    found = (effect.get("parameters") or {}).get(way.parameter)
    if not found or found.get("value") is None:
        return None
    low, high = found.get("ci95") or (math.nan, math.nan)
    return float(found["value"]), 0.5 * (float(high) - float(low)) if None not in (low, high) else math.nan


def judged(control: dict[str, Any] | None, tampered: dict[str, Any] | None, way: Way) -> dict[str, Any]:
    """What was found of one way in one group.

    `right`: it is accused, and its number moved by what was put in, within 30 % or what both intervals allow.
    """
    before, after = accused(control, way), accused(tampered, way)
    one, two = number(before, way), number(after, way)
    row: dict[str, Any] = {"named": after is not None, "in_control": before is not None, "moved": None, "right": False}
    rivals = [
        rival["id"] for effect in (tampered or {}).get("effects") or [] for rival in effect.get("ambiguous_with") or []
    ]
    row["in_ambiguity_set"] = after is not None or way.effect in rivals
    if after is not None and not way.parameter:
        row["right"] = before is None
    elif after is not None and one and two:
        row["moved"] = two[0] - one[0]
        slack = max(0.3 * abs(way.change), math.hypot(one[1], two[1]))
        row["right"] = abs(row["moved"] - way.change) <= slack
    return row
