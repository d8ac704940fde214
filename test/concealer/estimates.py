"""Numbers of a diagnosis beside those of the envelope: parameters of effects, and of the platform.

A trajectory knows forces relative to the mass and torques relative to the inertia alone: a robot that is 5 % heavier
and pushed 5 % harder moves the same. So the truth is stated for the mass and inertia that the diagnosis assumes, which
are the nominal ones unless it says that it refitted them. True mass: with the added mass in surge, which the
interface's model does not have.
"""

from __future__ import annotations

import math
from typing import Any

from concealer.cases import Case, names
from concealer.layout import INERTIA, MASS, nominal_robot

Found = tuple[str, float, dict[str, Any]]  # name, truth, {"value", "ci95", ...}

PER_MASS = {
    "linear_drag": ("surge", "sway", "heave"), "added_mass": ("sway_minus_surge",), "tether": ("stiffness",),
    "buoyancy_trim": ("force",), "hull_compressibility": ("gradient",), "stratification": ("force",),
    "density_gradient": ("gradient",),
    "payload_shift": ("force",), "platform": ("drag", "thrust_gain", "buoyancy_gain"),
}  # fmt: skip
PER_INERTIA = {
    "linear_drag": ("yaw",), "torque_bias": ("torque",),
    "platform": ("yaw_drag", "yaw_torque_gain"),
}  # fmt: skip


AMPLITUDES = (("x", "y"), ("speed",))  # of what swings, by the names of its numbers
ANGLES = ("phase", "direction")


def aligned(truth: dict[str, Any], answer: dict[str, Any]) -> dict[str, Any]:
    """A truth with a phase in the answer's half-turn: (x, y, phase) is the same as (-x, -y, phase + pi)."""

    def has(*keys: str) -> bool:
        return all(key in answer and key in truth for key in keys)

    swinging = next((keys for keys in AMPLITUDES if has(*keys, "phase")), ())
    if not swinging:
        return truth
    out = dict(truth)
    if sum(float(answer[key]["value"]) * float(truth[key]) for key in swinging) < 0.0:
        out |= {key: -truth[key] for key in swinging} | {"phase": truth["phase"] + math.pi}
    for angle in filter(has, ANGLES):
        turns = round((float(answer[angle]["value"]) - out[angle]) / (2.0 * math.pi))
        out[angle] += 2.0 * math.pi * turns
    return out


def refitted(case: Case, robot: str) -> dict[str, dict[str, Any]]:
    """The platform's parameters that the diagnosis changes for a robot, by name."""
    entries = (case.diagnosis or {}).get("recalibrated") or []
    return {e["parameter"]: e for e in entries if not e.get("robots") or robot in e["robots"]}


def scales(case: Case, robot: str) -> tuple[float, float]:
    """By how much forces and torques of the truth are to be multiplied: assumed over true mass, and inertia."""
    true = (case.truth.get("vehicles") or {}).get(robot)
    if not true:
        return 1.0, 1.0
    said, nominal = refitted(case, robot), nominal_robot()
    mass = float(said["mass"]["value"]) if "mass" in said else float(nominal[MASS])
    inertia = float(said["inertia"]["value"]) if "inertia" in said else float(nominal[INERTIA])
    return mass / true.get("moving_mass", true["mass"]), inertia / true["inertia"]


def added_inertia(case: Case, robot: str, added: float, factors: tuple[float, float]) -> float:
    """Added inertia that a diagnosis finds: Munk's moment ties the whole moment of inertia to the mass."""
    true = case.truth["vehicles"].get(robot)
    if not true:
        return added
    return float(factors[0] * (true["inertia"] + added) - factors[1] * true["inertia"])


def scaled(name: str, key: str, value: float, factors: tuple[float, float]) -> float:
    """The truth for the diagnosis's mass and inertia."""
    if key in PER_MASS.get(name, ()):
        return value * factors[0]
    return value * factors[1] if key in PER_INERTIA.get(name, ()) else value


def in_answers_terms(case: Case, truth: dict[str, Any], answers: dict[str, Any]) -> dict[str, float]:
    """The numbers of a secret, for the mass, the inertia and the half-turn of the answer."""
    robot = (truth.get("robots") or [""])[0]
    factors = scales(case, robot)
    numbers = aligned(truth["parameters"], answers)
    out = {k: scaled(truth["id"], k, float(v), factors) for k, v in numbers.items() if isinstance(v, float | int)}
    if truth["id"] == "added_mass" and case.truth.get("vehicles"):
        out["yaw"] = added_inertia(case, robot, float(numbers["yaw"]), factors)
    return out


def of_effects(case: Case) -> list[Found]:
    """(effect.parameter, truth, answer) of every effect rightly named, where both are numbers.

    Not of laws outside the catalogue: what a coefficient is per depends on how its regressor is measured.
    """
    found: list[Found] = []
    for effect in case.effects:
        for truth in case.truth["effects"]:
            if effect["id"] != truth["id"] or not names(effect, truth) or truth["id"].startswith("unknown:"):
                continue
            answers = effect.get("parameters") or {}
            for key, value in in_answers_terms(case, truth, answers).items():
                answer = answers.get(key)
                if answer and answer.get("value") is not None:
                    found.append((f"{truth['id']}.{key}", value, answer))
    return found


def of_platform(case: Case) -> list[Found]:
    """(parameter, truth, answer) of every parameter of the platform that the diagnosis says it refitted.

    Not where an effect is named wrongly or not at all: numbers of a wrong model have no true value.
    """
    found: list[Found] = []
    if case.unnamed() or case.spurious() or case.kind == "outside":
        return found
    comparable = {"drag", "thrust_gain", "yaw_drag", "yaw_torque_gain", "buoyancy_gain"}
    if "added_mass" in case.hidden:
        comparable = {"drag", "thrust_gain"}  # heave and yaw have another moving mass
    for robot, true in (case.truth.get("vehicles") or {}).items():
        factors = scales(case, robot)
        for key, answer in refitted(case, robot).items():
            if key in comparable and answer.get("value") is not None:
                found.append((f"platform.{key}", scaled("platform", key, float(true[key]), factors), answer))
    return found
