"""The streams of the contract that a table holds, by the type of its messages or by the names of its columns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.guessing.column_names import Meaning, meaning_of
from cocorosim_ros.diagnosis.guessing.known_types import PX4_TOPICS, ROS_TYPES, Fields, dimension_of_number
from cocorosim_ros.diagnosis.guessing.log_table import Guess, LogTable, Number
from cocorosim_ros.scenario.reading.quantity import UNITS, si_unit
from cocorosim_ros.wire.bags.poses_of_others import TRANSFORMS

_QUATERNION = ("qx", "qy", "qz", "qw")
_TURNS = ("roll", "pitch", "yaw")
_DATA = "data"  # of std_msgs/Float64 and its like


def recognised(table: LogTable) -> Iterator[Guess]:
    """The streams of a table, commands left out; units that nothing says are left open."""
    known, down = _known(table)
    if known is None:
        yield from _by_names(table)
        return
    for topic, fields in known.items():
        numbers = {name: _in_si(table, topic, name, path) for name, path in fields.items() if path in table.columns}
        numbers = _without_dead_quaternion(numbers)
        if numbers and (topic != "pose" or {"x", "y"} <= numbers.keys()):
            yield _complete(Guess(table, topic, numbers, north_east_down=down or None))


def meanings(table: LogTable) -> dict[str, Meaning]:
    """Meanings of the columns of a table by their names; a topic's own name counts where a field says nothing."""
    if not table.kind:
        found = {name: meaning_of(name, table.columns) for name in table.columns}
    else:
        found = {name: _of_field(table, name) for name in table.columns}
    return {name: meaning for name, meaning in found.items() if meaning is not None}


def _known(table: LogTable) -> tuple[Mapping[str, Fields] | None, bool]:
    """The known streams of a table's messages, and whether their axes are north-east-down."""
    if table.kind.startswith(TRANSFORMS):
        names = list(table.columns)
        return {"pose": dict(zip(("x", "y", "z", *_QUATERNION), names, strict=True))}, False
    if table.kind == "px4":
        return PX4_TOPICS.get(table.source.partition("[")[0], {}), True
    return ROS_TYPES.get(table.kind), False


def _of_field(table: LogTable, path: str) -> Meaning | None:
    """Meaning of a field of a message: its own words, with those of the topic before them."""
    words = path.partition("[")[0].removeprefix(_DATA).strip(".")
    return meaning_of(f"{table.source}/{words}".strip("/"), table.columns)


def _in_si(table: LogTable, topic: str, name: str, path: str) -> Number:
    dimension = dimension_of_number(topic, name)
    return Number(path, dimension, table.columns[path], si_unit(dimension), sure=True)


def _without_dead_quaternion(numbers: dict[str, Number]) -> dict[str, Number]:
    """Leave out an attitude that is zero, or of which a part is missing."""
    turn = [numbers[name].values for name in _QUATERNION if name in numbers]
    if len(turn) == len(_QUATERNION) and np.nanmedian(np.abs(turn).sum(axis=0)) > 0.0:
        return numbers
    return {name: number for name, number in numbers.items() if name not in _QUATERNION}


def _by_names(table: LogTable) -> Iterator[Guess]:
    streams: dict[str, dict[str, Number]] = {}
    doubled: list[str] = []
    for column, (topic, name, unit) in meanings(table).items():
        if topic == "thruster_command":
            continue
        dimension = dimension_of_number(topic, name)
        fits = unit if unit in UNITS[dimension] else ""
        number = Number(column, dimension, table.columns[column], fits, sure=bool(fits))
        if name in streams.setdefault(topic, {}):
            doubled.append(f"'{column}' could be {name}, too; '{streams[topic][name].column}' is taken.")
        else:
            streams[topic][name] = number
    for topic, numbers in _shared(streams).items():
        yield _complete(Guess(table, topic, numbers).doubting(*doubled))
        doubled = []


def _shared(streams: dict[str, dict[str, Number]]) -> dict[str, dict[str, Number]]:
    """Depths and headings go where they are needed: to a pose that lacks them, or to streams of their own."""
    found = {topic: dict(numbers) for topic, numbers in streams.items()}
    pose = _without_dead_quaternion(found.pop("pose", {}))
    if {"x", "y"} <= pose.keys():
        found["pose"] = _completed_pose(pose, found)
    else:
        if "yaw" in pose and "compass" not in found:
            found["compass"] = {"heading": pose["yaw"]}
        attitude = {name: pose[name] for name in (*_QUATERNION, "roll", "pitch") if name in pose}
        if set(_QUATERNION) <= attitude.keys():
            found.setdefault("imu", {}).update({name: attitude[name] for name in _QUATERNION})
    if "pressure" in found and len(found["pressure"]) > 1:
        del found["pressure"]["depth"]
    return {topic: numbers for topic, numbers in found.items() if numbers}


def _completed_pose(pose: dict[str, Number], others: dict[str, dict[str, Number]]) -> dict[str, Number]:
    """Add the depth and the heading of other streams, where they lack in it; those are then not used twice."""
    if "z" not in pose and "depth" in others.get("pressure", {}):
        pose = {**pose, "depth": others["pressure"].pop("depth")}
    if set(_QUATERNION) <= pose.keys():
        return {name: number for name, number in pose.items() if name not in _TURNS}
    if "yaw" not in pose and "heading" in others.get("compass", {}):
        pose = {**pose, "yaw": others["compass"].pop("heading")}
    return pose


def _complete(guess: Guess) -> Guess:
    """Add what a pose must have: a height and a heading."""
    if guess.topic != "pose":
        return guess
    fixed: dict[str, dict[str, str | bool]] = {}
    doubts: list[str] = []
    if not {"z", "depth"} & guess.numbers.keys():
        fixed["z"] = {"fixed": "0 m"}
        doubts.append("There is no height and no depth: the vehicle is taken to stay at the surface.")
    if not {"yaw", "qw"} & guess.numbers.keys():
        fixed["yaw"] = {"travel": True}
        doubts.append(
            "There is no heading: the direction of travel is taken for it. Of a vehicle that drifts, write "
            "'yaw: {unknown: true}' and give its compass."
        )
    return replace(guess, fixed=fixed).doubting(*doubts)
