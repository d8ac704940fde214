"""The numbers of each topic that a map may give, and how the fields of its messages follow from them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion import axes
from cocorosim_ros.wire.conversion.attitude import QUATERNION
from cocorosim_ros.wire.conversion.conversion_map import StreamMap, TravelValue, UnknownValue, Value
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE, SURFACE_PRESSURE

Columns = Mapping[str, Floats]

_TURNS = ("roll", "pitch", "yaw")
_RATES = ("rate_x", "rate_y", "rate_z")
_FORCES = ("acceleration_x", "acceleration_y", "acceleration_z")
_VELOCITY = {**dict.fromkeys(("x", "y", "z"), "speed"), "yaw_rate": "angular velocity"}
_UNKNOWN_AXIS = 1e6  # rad^2; the variance of an axis of an attitude that was not measured
_ABSENT = np.array([-1.0, 0, 0, 0, 0, 0, 0, 0, 0])  # sensor_msgs/Imu: this is not measured

# The numbers of each topic with their dimensions; positions in world, rates and accelerations in body axes.
NUMBERS: dict[str, dict[str, str]] = {
    "pose": {
        **dict.fromkeys(("x", "y", "z", "depth"), "length"),
        **dict.fromkeys(_TURNS, "angle"),
        **dict.fromkeys(QUATERNION, "pure number"),
    },
    "compass": {"heading": "angle"},
    "pressure": {"pressure": "pressure", "depth": "length"},
    "imu": {
        **dict.fromkeys(_RATES, "angular velocity"),
        **dict.fromkeys(_FORCES, "acceleration"),
        **dict.fromkeys(_TURNS, "angle"),
        **dict.fromkeys(QUATERNION, "pure number"),
    },
    "velocity": _VELOCITY,
    "ground_velocity": _VELOCITY,
}


@dataclass(frozen=True)
class StreamRows:
    """The numbers of messages of one topic: (n, f) `values` of the message's `fields`, `extra` for its template."""

    fields: tuple[str, ...]
    values: Floats
    extra: Mapping[str, Any]


def check_stream(topic: str, given: Mapping[str, Value], place: Entry) -> None:
    """Nothing, if the numbers given suffice for a message and do not contradict each other."""
    problem = _CHECKS[topic](set(given))
    if has_no_heading(given) and {"roll", "pitch"} & set(given):
        problem = "has 'roll' or 'pitch' beside a 'yaw' that was not recorded; give these as 'imu'."
    if problem:
        raise place.problem(problem)


def angles_among(mapped: StreamMap) -> dict[str, Value]:
    """Those of a stream's numbers that are angles."""
    dimensions = NUMBERS.get(mapped.topic, {})
    return {name: value for name, value in mapped.values.items() if dimensions.get(name) == "angle"}


def stream_rows(topic: str, columns: Columns, *, north_east_down: bool) -> StreamRows:
    """The fields of a topic's messages from (n,) SI numbers by name."""
    return _BUILDERS[topic](columns, north_east_down)


def named_rows(field: str, names: tuple[str, ...], values: Floats) -> StreamRows:
    """Messages with a list `name` and as many numbers in `field`; (n, names) values."""
    extra = {"name": list(names), field: [0.0] * len(names)}
    return StreamRows(tuple(f"{field}[{name}]" for name in names), values, extra)


def travels(given: Mapping[str, Value]) -> bool:
    """Whether the heading is to follow from the track."""
    return isinstance(given.get("yaw"), TravelValue)


def has_no_heading(given: Mapping[str, Value]) -> bool:
    """Whether the heading was not recorded."""
    return isinstance(given.get("yaw"), UnknownValue)


def without_heading(rows: StreamRows) -> StreamRows:
    """Poses with an attitude of four zeros, which says that it was not recorded."""
    values = rows.values.copy()
    values[:, 3:] = 0.0
    return replace(rows, values=values)


def heading_of_travel(position: Floats) -> Floats:
    """(n,) direction from each of (n, 3) places in order to the next other one, the last one's from before [rad]."""
    step = np.diff(position[:, :2], axis=0)
    moves = np.flatnonzero((step != 0).any(axis=1))
    if not moves.size:
        return np.zeros(len(position))
    direction = np.arctan2(step[moves, 1], step[moves, 0])
    following = np.minimum(np.searchsorted(moves, np.arange(len(position))), moves.size - 1)
    return np.asarray(direction[following])


def _check_pose(given: set[str]) -> str:
    if not {"x", "y"} <= given:
        return "lacks 'x' or 'y'; without both there is no pose: give depth as 'pressure' and yaw as 'compass'."
    if len({"z", "depth"} & given) != 1:
        return "needs either 'z' or 'depth'; a vehicle that stays at the surface has 'z: {fixed: 0 m}'."
    mixed = _check_turns(given)
    if mixed:
        return mixed
    if {"yaw", "qw"} & given:
        return ""
    return "lacks 'yaw' or a quaternion; a heading that was not recorded is '{unknown: true}'."


def _check_turns(given: set[str]) -> str:
    """The fault of an attitude, empty if it has none: angles beside a quaternion, or a part of one."""
    turned = set(QUATERNION) & given
    if turned and (turned != set(QUATERNION) or set(_TURNS) & given):
        return "needs all of 'qx', 'qy', 'qz', 'qw' and then no 'yaw', or 'yaw' alone."
    return ""


def _check_one(*names: str) -> Callable[[set[str]], str]:
    told = " or ".join(f"'{name}'" for name in names)
    return lambda given: "" if len(given) == 1 else f"needs {'either ' if len(names) > 1 else ''}{told}."


def _check_imu(given: set[str]) -> str:
    return _check_turns(given) or _check_any(given)


def _check_any(given: set[str]) -> str:
    return "" if given else "names no column, so there is nothing to convert."


_CHECKS: dict[str, Callable[[set[str]], str]] = {
    "pose": _check_pose,
    "compass": _check_one("heading"),
    "pressure": _check_one("pressure", "depth"),
    "imu": _check_imu,
    "velocity": _check_any,
    "ground_velocity": _check_any,
}


def _count(columns: Columns) -> int:
    return len(next(iter(columns.values())))


def _three(columns: Columns, names: tuple[str, ...]) -> Floats:
    """(n, 3) the columns of these names, NaN where there is none."""
    blank = np.full(_count(columns), np.nan)
    return np.column_stack([columns.get(name, blank) for name in names])


def _pose(columns: Columns, down: bool) -> StreamRows:
    level = np.zeros(_count(columns))
    height = columns.get("z", level)
    if "depth" in columns:
        height = columns["depth"] if down else 0.0 - columns["depth"]
    position = np.column_stack([columns["x"], columns["y"], height])
    attitude = _attitude(columns, down)
    if down:
        position = axes.world_from_ned(position)
    fields = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
    return StreamRows(tuple(fields), np.hstack([position, attitude]), {})


def _attitude(columns: Columns, down: bool) -> Floats:
    """(n, 4) x y z w, from a quaternion or angles; angles that are not given are 0."""
    if "qx" in columns:
        attitude = np.column_stack([columns[name] for name in QUATERNION])
    else:
        level = np.zeros(_count(columns))
        attitude = axes.quaternion(*(columns.get(name, level) for name in _TURNS))
    return axes.attitude_from_ned(attitude) if down else attitude


def _compass(columns: Columns, down: bool) -> StreamRows:
    heading = axes.heading_from_ned(columns["heading"]) if down else columns["heading"]
    return StreamRows(("heading",), axes.wrap(heading)[:, None], {})


def is_made_of_depth(topic: str, names: Iterable[str]) -> bool:
    """Whether a stream of these numbers shows pressures that no sensor measured, made of depths."""
    return topic == "pressure" and "depth" in names


def _pressure(columns: Columns, down: bool) -> StreamRows:
    if is_made_of_depth("pressure", columns):
        values = SURFACE_PRESSURE + PASCAL_PER_METRE * columns["depth"]
    else:
        values = columns["pressure"]
    return StreamRows(("fluid_pressure",), values[:, None], {})


def _imu(columns: Columns, down: bool) -> StreamRows:
    extra: dict[str, Any] = {"orientation_covariance": _ABSENT, "orientation": {"w": 1.0}}
    fields: list[str] = []
    parts: list[Floats] = []
    if {*_TURNS, *QUATERNION} & set(columns):
        extra = {"orientation_covariance": _axes_not_measured(columns)}
        fields += [f"orientation.{axis}" for axis in "xyzw"]
        parts.append(_attitude(columns, down))
    for names, message, part in (
        (_RATES, "angular_velocity", "angular_velocity_covariance"),
        (_FORCES, "linear_acceleration", "linear_acceleration_covariance"),
    ):
        if any(name in columns for name in names):
            vector = _three(columns, names)
            fields += [f"{message}.{axis}" for axis in "xyz"]
            parts.append(axes.body_from_frd(vector) if down else vector)
        else:
            extra[part] = _ABSENT
    return StreamRows(tuple(fields), np.hstack(parts), extra)


def _axes_not_measured(columns: Columns) -> Floats:
    """(9,) covariance of an attitude: 0, which is unknown, or so large that an axis says nothing."""
    known = ["qx" in columns or name in columns for name in _TURNS]
    return np.diag([0.0 if measured else _UNKNOWN_AXIS for measured in known]).ravel()


def _velocity(columns: Columns, down: bool) -> StreamRows:
    linear, turning = _three(columns, ("x", "y", "z")), _three(columns, ("yaw_rate",))
    if down:
        linear, turning = axes.body_from_frd(linear), -turning
    fields = [f"twist.linear.{axis}" for axis in "xyz"]
    return StreamRows((*fields, "twist.angular.z"), np.hstack([linear, turning]), {})


_BUILDERS: dict[str, Callable[[Columns, bool], StreamRows]] = {
    "pose": _pose,
    "compass": _compass,
    "pressure": _pressure,
    "imu": _imu,
    "velocity": _velocity,
    "ground_velocity": _velocity,
}
