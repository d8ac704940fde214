"""Meanings of columns by their names: the words in it, the letter of an axis at its end, a unit behind it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from cocorosim_ros.scenario.reading.quantity import UNITS


class Meaning(NamedTuple):
    """A number of a stream, and the unit that the name says; of a command the name of the actuator."""

    stream: str
    number: str
    unit: str


_UNITS = {
    "rad/s": "rad/s", "rad_s": "rad/s", "rads": "rad/s", "radps": "rad/s", "rad/sec": "rad/s",
    "deg/s": "deg/s", "deg_s": "deg/s", "dps": "deg/s", "degps": "deg/s", "deg/sec": "deg/s",
    "m/s^2": "m/s^2", "m/s2": "m/s^2", "m_s2": "m/s^2", "mps2": "m/s^2", "m/s/s": "m/s^2",
    "m/s": "m/s", "m_s": "m/s", "mps": "m/s", "cm/s": "cm/s", "mm/s": "mm/s",
    "rad": "rad", "radians": "rad", "deg": "deg", "degrees": "deg", "degree": "deg", "°": "deg",
    "m": "m", "meter": "m", "meters": "m", "metres": "m", "cm": "cm", "mm": "mm",
    "pa": "Pa", "hpa": "hPa", "kpa": "kPa", "mbar": "mbar", "dbar": "dbar", "bar": "bar",
    "s": "s", "sec": "s", "secs": "s", "seconds": "s", "ms": "ms", "us": "us", "ns": "ns", "nsec": "ns",
    "n": "N", "rpm": "rpm", "rps": "rev/s", "v": "V",
}  # fmt: skip
_BY_UNIT = {"angular velocity": "rate", "acceleration": "acc", "speed": "vel", "pressure": "pressure"}
_DIMENSION_OF_UNIT = {unit: context for dimension, context in _BY_UNIT.items() for unit in UNITS[dimension]}
_BRACKETED = re.compile(r"\s*[\[(]\s*([^\])]+?)\s*[\])]\s*$")
_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
_CONTEXTS: dict[str, frozenset[str]] = {
    "mag": frozenset({"mag", "magnetic", "magnetometer", "covariance", "variance", "std", "sd", "error", "desired",
                      "ref", "reference", "target", "goal", "setpoint", "wind", "current", "voltage", "battery"}),
    "command": frozenset({"cmd", "command", "commands", "motor", "thruster", "thrusters", "thrust", "pwm", "propeller",
                          "prop", "rotor", "rudder", "servo", "esc", "actuator", "force", "torque", "wrench", "rpm",
                          "input", "port", "starboard", "buoyancy", "pump", "ballast"}),
    "acc": frozenset({"acc", "accel", "acceleration", "accelerometer"}),
    "rate": frozenset({"angular", "gyro", "gyr", "rate", "rates", "omega", "w"}),
    "vel": frozenset({"velocity", "vel", "velo", "linear", "twist", "dvl", "speed"}),
    "turn": frozenset({"orientation", "quaternion", "quat", "q", "attitude", "rotation", "euler"}),
}  # fmt: skip
_AXES = ("x", "y", "z")
_OTHER_AXES = {"east": "x", "north": "y", "u": "x", "v": "y"}
_GLUED = {
    **{f"v{axis}": ("vel", axis) for axis in "xyz"},
    **{f"a{axis}": ("acc", axis) for axis in "xyz"},
    **{f"g{axis}": ("rate", axis) for axis in "xyz"},
    **{f"w{axis}": ("rate", axis) for axis in "xyz"},
    **{f"p{axis}": ("place", axis) for axis in "xyz"},
    **{f"q{axis}": ("quaternion", axis) for axis in "xyzw"},
}
_TURNS = {"roll": "roll", "phi": "roll", "pitch": "pitch", "theta": "pitch", "yaw": "yaw", "psi": "yaw"}
_HEADINGS = ("heading", "hdg", "compass", "bearing")
_TIMES = ("time", "t", "timestamp", "stamp", "secs", "seconds", "elapsed")
_STREAMS = {"vel": "velocity", "acc": "imu", "rate": "imu", "place": "pose", "quaternion": "pose"}
_SIDES = ("left", "right", "port", "starboard")


def tokens_and_unit(name: str) -> tuple[list[str], str]:
    """The words of a name in small letters, and the unit that it ends with; "" for none."""
    bracketed = _BRACKETED.search(name)
    if bracketed:
        unit = _UNITS.get(bracketed[1].lower().replace(" ", ""), "")
        return _words(name[: bracketed.start()]), unit
    words = _words(name)
    for count in (2, 1):
        ending = "_".join(words[-count:])
        if len(words) > count and ending in _UNITS and not (count == 1 and len(ending) == 1 and len(words[-2]) == 1):
            return words[:-count], _UNITS[ending]
    return words, ""


def is_time(name: str) -> bool:
    """Tell whether a column is a time by its name."""
    words, _ = tokens_and_unit(name)
    return bool(words) and words[-1] in _TIMES and not set(words) & _CONTEXTS["command"]


def is_heading(name: str) -> bool:
    """Tell whether a column is called as compasses call what they show."""
    words, _ = tokens_and_unit(name)
    return bool(words) and words[-1] in _HEADINGS


def meaning_of(name: str, others: Mapping[str, object]) -> Meaning | None:
    """Meaning of a column of a table; `others` are the table's columns, which decide between meanings of a letter."""
    words, unit = tokens_and_unit(name)
    if not words or set(words) & _CONTEXTS["mag"]:
        return None
    if set(words) & _CONTEXTS["command"] or (len(words) == 1 and words[0] in _SIDES):
        return Meaning("thruster_command", "_".join(words), unit)
    return _simple(words, unit) or _turn(words, unit) or _axis(words, unit, others)


def _words(name: str) -> list[str]:
    return [word for word in re.split(r"[^a-z0-9°]+", _CAMEL.sub("_", name).lower()) if word]


def _context(words: list[str], unit: str) -> str:
    if unit in _DIMENSION_OF_UNIT:
        return _DIMENSION_OF_UNIT[unit]
    return next((kind for kind in ("acc", "rate", "vel", "turn") if set(words[:-1]) & _CONTEXTS[kind]), "place")


def _simple(words: list[str], unit: str) -> Meaning | None:
    last = words[-1]
    if last in ("depth",) and unit not in _DIMENSION_OF_UNIT:
        return Meaning("pressure", "depth", unit)
    if last in ("pressure", "press", "baro", "barometer"):
        return Meaning("pressure", "pressure", unit)
    if last in _HEADINGS:
        return Meaning("compass", "heading", unit)
    return None


def _turn(words: list[str], unit: str) -> Meaning | None:
    named = [word for word in words if word in _TURNS]
    if not named:
        return None
    turn = _TURNS[named[-1]]
    if unit in ("rad/s", "deg/s") or set(words) & _CONTEXTS["rate"]:
        return Meaning("imu", f"rate_{dict(roll='x', pitch='y', yaw='z')[turn]}", unit)
    return Meaning("pose", turn, unit) if not set(words) & _CONTEXTS["acc"] else None


def _axis(words: list[str], unit: str, others: Mapping[str, object]) -> Meaning | None:
    context = _context(words, unit)
    last = next((word for word in reversed(words) if word in _AXES or word in _GLUED or word in _OTHER_AXES), words[-1])
    if last in _GLUED:
        context, last = _GLUED[last]
    elif last in ("u", "v") and (context == "vel" or {"u", "v"} <= {name.lower() for name in others}):
        context, last = "vel", _OTHER_AXES[last]
    else:
        last = _OTHER_AXES.get(last, last)
    if context == "quaternion" or (context == "turn" and last in "xyzw" and _has_w(words, others)):
        return Meaning("pose", f"q{last}", "") if last in ("x", "y", "z", "w") else None
    if last not in _AXES or context == "pressure":
        return None
    if context == "turn":
        return Meaning("pose", dict(x="roll", y="pitch", z="yaw")[last], unit)
    number = {"acc": f"acceleration_{last}", "rate": f"rate_{last}"}.get(context, last)
    return Meaning(_STREAMS[context], number, unit)


def _has_w(words: list[str], others: Mapping[str, object]) -> bool:
    """Tell whether there is a fourth component beside x, y and z."""
    return any(_words(name) == [*words[:-1], "w"] for name in others)
