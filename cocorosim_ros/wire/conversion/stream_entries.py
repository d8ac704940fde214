"""The streams of a table in a map file: topics of the contract with their numbers."""

from __future__ import annotations

import re
from dataclasses import replace

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.allocation import allocated
from cocorosim_ros.wire.conversion.conversion_map import StreamMap, Value
from cocorosim_ros.wire.conversion.streams import NUMBERS, check_stream
from cocorosim_ros.wire.conversion.value_entries import ValueReader
from cocorosim_ros.wire.topics.actuator_feedback import FEEDBACK, FRACTION, QUANTITIES, feedback_name

AXES = ("enu_flu", "ned_frd")
COMMAND = "thruster_command"
TOPICS = (*NUMBERS, COMMAND, FEEDBACK)
_ACTUATOR_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def read_stream(topic: str, entry: Entry, reader: ValueReader) -> StreamMap:
    """The stream of one topic. Raises CocorosimError if its numbers do not suffice for a message."""
    if topic not in TOPICS:
        raise entry.problem(f"is no topic that can be converted; allowed: {', '.join(TOPICS)}.")
    given = dict(entry.mapping())
    axes = given.pop("axes", None)
    down = axes is not None and axes.choice(AXES) == "ned_frd"
    if topic == COMMAND:
        return StreamMap(topic, _commands(replace(entry, value=given), reader), down, entry)
    if topic == FEEDBACK:
        if axes is not None:
            raise axes.problem("says nothing here; turn the sign of an angle by 'scale: -1', as its command has it.")
        return StreamMap(topic, _feedback(replace(entry, value=given), reader), down, entry)
    section = replace(entry, value=given).section((), NUMBERS[topic])
    values = {
        name: reader.heading(part) if topic == "pose" and name == "yaw" else reader.value(part, NUMBERS[topic][name])
        for name, part in section.items()
    }
    check_stream(topic, values, entry)
    return StreamMap(topic, values, down, entry)


def _commands(entry: Entry, reader: ValueReader) -> dict[str, Value]:
    """The commands of all actuators, given one by one or by an allocation."""
    given = dict(entry.mapping())
    together = given.get("allocation")
    if together is not None and isinstance(together.value, dict) and "wrench" in together.value:
        del given["allocation"]
        mixed = allocated(together, reader)
        twice = sorted(set(mixed) & set(given))
        if twice:
            raise given[twice[0]].problem("is given by 'allocation' too; give each actuator once.")
        _check_actuators(replace(together, value=dict(together.mapping()["thrusters"].mapping())))
        given_alone: dict[str, Value] = {name: reader.command(part) for name, part in given.items()}
        return {**mixed, **given_alone}
    _check_actuators(entry)
    return {name: reader.command(part) for name, part in given.items()}


def _feedback(entry: Entry, reader: ValueReader) -> dict[str, Value]:
    """What all actuators report, by the names of the messages; a fraction is given as its command is."""
    _check_actuators(entry, "left: {rotation: {column: ..., unit: rpm}}")
    found: dict[str, Value] = {}
    for actuator, part in entry.mapping().items():
        numbers = part.section((), tuple(QUANTITIES))
        if not numbers:
            raise part.problem(f"names nothing that this actuator reports; add one of {', '.join(QUANTITIES)}.")
        for quantity, number in numbers.items():
            found[feedback_name(actuator, quantity)] = _reported(number, quantity, reader)
    return found


def _reported(entry: Entry, quantity: str, reader: ValueReader) -> Value:
    if quantity != FRACTION:
        return reader.column(entry, (QUANTITIES[quantity].dimension,))
    value = reader.command(entry)
    if value.measured:
        raise entry.problem(
            "has 'measured', which says nothing here, since all that actuators report is; leave it out."
        )
    return value


def _check_actuators(entry: Entry, example: str = "left: {column: ..., unit: ...}") -> None:
    if not entry.mapping():
        raise entry.problem(f"names no actuator; write '{example}' lines under it.")
    for name, part in entry.mapping().items():
        if not _ACTUATOR_NAME.fullmatch(name):
            raise part.problem("is no name of an actuator; use letters, digits and _.")
