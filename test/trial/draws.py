"""Ways to alter logs of each data set, as they are drawn: by how much, and what is then to be found.

Data sets and their ways stand in one table, SETS: a further data set is a line there.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from trial.recordings import (
    NLP1,
    crossings,
    dives,
    flights,
    hovercraft,
    minutes_in_the_pool,
    parts_of_a_mission,
    pond,
    zigzags,
)
from trial.ways import Way

NOTHING = "nothing"  # to be found of a stream that is hidden: the vehicle is as it was
WHOLE = "thrust_gain"  # of all thrusters: a number of the platform, which is that of a single one
FACTORS = (
    "camera_scale",
    "thruster_gain",
    WHOLE,
    "pressure_gain",
    "gyro_scale",
)  # numbers that are 1 where nothing is wrong

# Effects and numbers that are one thing where a vehicle has poses alone, by what was done.
TWINS = {"sensor_latency": ("command_delay", "delay"), "command_delay": ("sensor_latency", "latency")}


@dataclass(frozen=True)
class Draw:
    """How one way to alter a log is drawn: the least and the greatest amount, of either sign where it may have both."""

    how: str
    least: float
    most: float
    both: bool = True
    thruster: str = ""  # name, where there are not two of them
    poses_alone: bool = False  # no other stream, so that late poses are commands that act late
    square: bool = False  # thrust goes with the square of the command

    def drawn(self, chance: random.Random) -> Way:
        """The way with an amount, and what it does."""
        amount = round(chance.uniform(self.least, self.most), 4)
        amount = -amount if self.both and chance.random() < 0.5 else amount
        way = way_of(self.how, amount, self.thruster, power=2 if self.square else 1)
        return replace(way, same=TWINS[way.effect]) if self.poses_alone else way


@dataclass(frozen=True)
class DataSet:
    """A data set: its recordings in groups that are alike, how many of a group are taken, and ways to alter them."""

    folder: str
    platform: str
    groups: Callable[[Path, Path], Iterator[tuple[str, list[Path]]]]
    most: int
    ways: tuple[Draw, ...]


def way_of(how: str, amount: float, thruster: str = "", power: int = 1) -> Way:
    """What is to be found of a way to alter a log: effect, stream, number and its size; thrust ~ command**power."""
    kind, _, detail = how.partition(":")
    if kind == "gain":  # what the log understates, the thruster has more of
        factor = (1.0 + amount) ** -power
        if thruster == WHOLE:
            return Way(how, amount, WHOLE, None, WHOLE, factor)
        if thruster:
            return Way(how, amount, "thruster_gain", None, thruster, factor)
        sign = -1.0 if detail == "0" else 1.0
        return Way(how, amount, "thruster_asymmetry", None, "difference", sign * 2.0 * (factor - 1.0) / (factor + 1.0))
    if how == "delay:thruster_command":  # stamps that are late: thrust is there before its command
        return Way(how, amount, "command_delay", None, "delay", -amount)
    if kind == "delay":
        return Way(how, amount, "sensor_latency", detail, "latency", amount)
    effect, topic, number, change = {
        "scale": ("camera_scale", "pose", "scale", 1.0 + amount),
        "compass": ("compass_distortion", "compass", "sin", amount),
        "heading": ("compass_distortion", "compass", "offset", amount),
        "mirror": ("frame_mixup", "compass", "", math.nan),
        "gyro": ("imu_bias", "imu", "gyro_z", amount),
        "gyroscale": ("gyro_scale", "imu", "scale", 1.0 + amount),
        "pressure": ("pressure_offset", "pressure", "offset", amount),
        "drift": ("pressure_drift", "pressure", "rate", amount),
        "pressuregain": ("pressure_gain", "pressure", "gain", 1.0 + amount),
        "hidden": (NOTHING, None, "", math.nan),
        "axis": ("frame_mixup", "pose", "", math.nan),
        "rightdown": ("frame_mixup", "velocity", "", math.nan),
        "swapped": ("frame_mixup", "velocity", "", math.nan),
        "earth": ("frame_mixup", "velocity", "", math.nan),
        "degrees": ("frame_mixup", "imu", "", math.nan),
    }[kind]
    return Way(how, amount, effect, topic, number, change)


def _by_day(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    runs = hovercraft(data, out)
    for day in ("2019-04-11", "2019-04-16"):
        yield f"hovercraft_{day}", [bag for bag in runs if day in bag.name]


def _of_reference(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    bags = dives(data, out, "reference")
    for first in range(0, len(bags) - 15, 16):
        yield f"haizhe_{first:03d}", bags[first : first + 16]


def _in_the_pool(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    bags = minutes_in_the_pool(data, out)
    for first in range(1, len(bags) - 3, 4):  # in the first minute it is let into the water
        yield f"tauv_{first:02d}", bags[first : first + 4]


def _of_like_thrusts(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    bags = {bag.name: bag for bag in flights(data, out)}
    for name, chosen in FLIGHTS.items():
        if set(chosen) <= bags.keys():
            yield name, [bags[each] for each in chosen]


def _of_the_mission(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    yield "glider", parts_of_a_mission(data, out)


def _of_zigzags(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    yield "kvlcc2", zigzags(data, out)


def _on_the_pond(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    yield "esso", pond(data, out, "zigzag")


def _of_a_crossing(data: Path, out: Path) -> Iterator[tuple[str, list[Path]]]:
    yield "ferry", crossings(data, out, *NLP1)


# Flights by turns: one to be compared with, and one of the same thrusts and gondola to be judged.
FLIGHTS = {
    "rgblimp_long": ("001", "002", "011", "012", "041", "042", "061", "062"),
    "rgblimp_short": ("011", "012", "021", "022", "061", "062", "081", "082", "121", "122", "125", "128"),
}
SETS = (
    DataSet(
        "hovercraft_epfl", "hovercraft_epfl", _by_day, 6,
        (
            Draw("gain:0", -0.3, -0.1, both=False), Draw("gain:1", -0.3, -0.1, both=False),
            Draw("delay:pose", 0.05, 0.2, both=False, poses_alone=True),
            Draw("delay:thruster_command", -0.3, -0.1, both=False, poses_alone=True),
            Draw("scale", 0.05, 0.15),
        ),
    ),
    DataSet(
        "haizhe_auv", "haizhe_auv", _of_reference, 16,
        (
            Draw("delay:compass", 0.1, 0.4, both=False), Draw("delay:imu", 0.1, 0.4, both=False),
            Draw("delay:pressure", 0.3, 0.8, both=False),
            Draw("compass", 0.1, 0.3), Draw("heading", 0.1, 0.5), Draw("mirror", 1.0, 1.0, both=False),
            Draw("gyro", 0.02, 0.08), Draw("gyroscale", 0.1, 0.3), Draw("pressure", 300.0, 1500.0),
            Draw("drift", 20.0, 80.0), Draw("degrees", 1.0, 1.0, both=False),
        ),
    ),
    DataSet(
        "tauv_pool", "tauv_pool", _in_the_pool, 4,
        (
            Draw("gain:0", -0.5, -0.25, both=False, thruster="ahead"),
            Draw("gain:1", -0.5, -0.25, both=False, thruster="right"),
            Draw("gain:2", -0.5, -0.25, both=False, thruster="down"),
            Draw("delay:pose", 0.1, 0.4, both=False), Draw("delay:velocity", 0.1, 0.4, both=False),
            Draw("delay:thruster_command", -0.4, -0.15, both=False), Draw("scale", 0.05, 0.15),
            Draw("axis", 1.0, 1.0, both=False), Draw("rightdown", 1.0, 1.0, both=False),
            Draw("hidden:velocity", 1.0, 1.0, both=False),
            Draw("swapped", 1.0, 1.0, both=False), Draw("earth", 1.0, 1.0, both=False),
        ),
    ),
    DataSet(
        "rgblimp", "rgblimp", _of_like_thrusts, 12,
        (
            Draw("gain:0", -0.5, -0.25, both=False), Draw("gain:1", -0.5, -0.25, both=False),
            Draw("scale", 0.05, 0.15), Draw("axis", 1.0, 1.0, both=False),
        ),
    ),
    DataSet(
        "slocum_glider", "slocum_glider", _of_the_mission, 2,
        (
            Draw("delay:pressure", 5.0, 20.0, both=False), Draw("pressure", 3000.0, 15000.0),
            Draw("drift", 2.0, 8.0), Draw("pressuregain", 0.03, 0.1),
        ),
    ),
    DataSet(
        "kvlcc2_hsva", "kvlcc2_hsva", _of_zigzags, 12,
        (
            Draw("delay:pose", 0.5, 2.0, both=False), Draw("delay:velocity", 0.5, 2.0, both=False),
            Draw("delay:imu", 0.5, 2.0, both=False), Draw("delay:thruster_command", -2.0, -0.5, both=False),
            Draw("gyro", 0.002, 0.01), Draw("gyroscale", 0.1, 0.3), Draw("scale", 0.05, 0.15),
            Draw("axis", 1.0, 1.0, both=False), Draw("rightdown", 1.0, 1.0, both=False),
            Draw("hidden:velocity", 1.0, 1.0, both=False),
            Draw("swapped", 1.0, 1.0, both=False), Draw("earth", 1.0, 1.0, both=False),
            Draw("degrees", 1.0, 1.0, both=False),
        ),
    ),
    DataSet(
        "esso_osaka", "esso_osaka", _on_the_pond, 8,
        (
            Draw("gain:0", -0.3, -0.15, both=False, thruster=WHOLE, square=True),
            Draw("delay:pose", 0.5, 2.0, both=False, poses_alone=True),
            Draw("delay:thruster_command", -2.0, -0.5, both=False, poses_alone=True),
            Draw("scale", 0.05, 0.15), Draw("axis", 1.0, 1.0, both=False),
        ),
    ),
    DataSet(
        "milliampere_ferry", "milliampere_ferry", _of_a_crossing, 4,
        (
            Draw("gain:0", -0.3, -0.15, both=False, thruster="bow_port", square=True),
            Draw("gain:4", -0.3, -0.15, both=False, thruster="stern_starboard", square=True),
            Draw("delay:pose", 0.3, 1.0, both=False, poses_alone=True),
            Draw("delay:thruster_command", -1.0, -0.3, both=False, poses_alone=True),
            Draw("scale", 0.05, 0.15), Draw("axis", 1.0, 1.0, both=False),
        ),
    ),
)  # fmt: skip
