"""A platform to begin with for the robot of a recording: actuators by its commands, sensors that it has."""

from __future__ import annotations

import json
import re

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.library.recording import read_recording
from cocorosim_ros.scenario.parts.six_degrees import AXES
from cocorosim_ros.scenario.reading.arguments import Place
from cocorosim_ros.scenario.reading.entry import listed

_COMMAND = "thruster_command"
_SENSORS = ("compass", "pressure", "imu", "velocity", "ground_velocity")
_ESTIMATE = "source: to be measured, confidence: estimate"
_KINDS = (
    ("buoyancy", r"buoy|ballast|pump|bladder|piston"),
    ("fin", r"plane|sternplane|elevator"),
    ("rudder", r"rudder|delta|fin"),
)  # what the name of a command tells of what it drives; a thruster otherwise
_NUMBERS: dict[str, dict[str, tuple[object, str]]] = {
    "buoyancy": {"neutral_volume": (20000, "unit: cm^3"), "volume_range": (500, "unit: cm^3")},
    "rudder": {
        "position": ([-0.4, 0, 0], "unit: m"),
        "area": (0.005, "unit: m^2"),
        "aspect_ratio": (1.5, 'unit: "1"'),
        "largest_angle": (35, "unit: deg"),
    },
    "fin": {
        "position": ([-0.4, 0, 0], "unit: m"),
        "direction": ([0, 0, 1], 'unit: "1"'),
        "area": (0.005, "unit: m^2"),
        "lift_slope": (3, "unit: 1/rad"),
        "largest_angle": (20, "unit: deg"),
    },
}
_UPWARDS = r"vert|heave|lift|up|down"
_SIDES = {r"left|port": 0.15, r"right|starboard|stbd": -0.15}  # m, of a thruster on that side; y points left


def with_the_parts_of(text: str, recording: Place) -> str:
    """The template of a platform, with the actuators that a recording commands and the sensors that it has.

    text: the template, whose blocks `actuators` and `sensors` are replaced. Thrusters, pumps, rudders and stern
    planes are told by their names; every number stays an estimate to be replaced. Raises
    CocorosimError if the recording cannot be read, holds no commands, or those of sticks alone.
    """
    read = read_recording(recording)
    names, there = list[str](), set[str]()
    for topics in read.readings.values():
        there |= topics.keys()
        if _COMMAND in topics:
            names += [name for name in topics[_COMMAND].columns if name not in names]
    if not names:
        found = ", ".join(sorted(there)) or "no readings"
        raise CocorosimError(
            f"{read.path} holds no {_COMMAND} (it has {found}), so it does not tell the actuators; leave out --for."
        )
    if set(names) <= set(AXES):
        raise CocorosimError(
            f"{read.path} holds a {_COMMAND} of {listed(names, 'and')}, which are sticks and no actuators; leave out "
            "--for, name the actuators that the vehicle has, and say by 'mixing' what sticks make of them."
        )
    head, _, rest = text.partition("\nactuators:")
    comment, _, end = rest.partition("\nsensors:")
    first_line, tail = end.partition("\n")[0], end.partition("\n\n")[2]
    sensors = [f"  {name}: true" for name in _SENSORS if name in there]
    return "\n".join(
        [
            f"{head}\nactuators:{comment.partition(chr(10))[0]}",
            *(_actuator(name) for name in names),
            "",
            f"sensors:{first_line}" if sensors else "sensors: {}",
            *sensors,
            "",
            tail,
        ]
    )


def _actuator(name: str) -> str:
    """The entry of one actuator, by what its name tells."""
    kind = next((kind for kind, words in _KINDS if _tells(name, words)), "thruster")
    numbers = _NUMBERS[kind] if kind != "thruster" else _thruster(name)
    lines = [f"- name: {json.dumps(name)}", f"  kind: {kind}"]
    lines += [f"  {key}: {{value: {value}, {further}, {_ESTIMATE}}}" for key, (value, further) in numbers.items()]
    return "\n".join(f"  {line}" for line in lines)


def _thruster(name: str) -> dict[str, tuple[object, str]]:
    """Where it is and how it pushes, as far as its name tells."""
    across = next((place for words, place in _SIDES.items() if _tells(name, words)), 0)
    upwards = _tells(name, _UPWARDS)
    return {
        "position": ([0 if upwards else -0.3, across, 0], "unit: m"),
        "direction": ([0, 0, 1] if upwards else [1, 0, 0], 'unit: "1"'),
        "maximum": (20, "unit: N, range: [5, 60]"),
    }


def _tells(name: str, words: str) -> bool:
    """Whether one of the words begins a part of the name."""
    return any(re.match(words, part) for part in re.split(r"[\W_\d]+", name.lower()))
