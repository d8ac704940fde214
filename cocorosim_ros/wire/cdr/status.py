"""The run's own words on `/diagnostics`: what went wrong with which robot, and how the run ended."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.alignment import LENGTH_BYTES
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS, padding

OK, WARN, ERROR = 0, 1, 2
PREFIX = "cocorosim: "  # of all names, by which aggregators find them
RUN, ANSWERS_MISSING = f"{PREFIX}run", f"{PREFIX}answers"


def robot_status(stamp_ns: int, robot: str, words: str) -> bytes:
    """The bytes of a DiagnosticArray that says what is wrong with a robot."""
    return status_bytes(stamp_ns, WARN, PREFIX + robot, words, {}, hardware=robot)


def status_bytes(
    stamp_ns: int, level: int, subject: str, words: str, values: Mapping[str, str], hardware: str = ""
) -> bytes:
    """The bytes of a DiagnosticArray with one status; `hardware`: the robot that it is about, if any."""
    seconds, nanoseconds = divmod(stamp_ns, NANOSECONDS)
    status = {
        "level": level,
        "name": subject,
        "message": words,
        "hardware_id": hardware,
        "values": [{"key": key, "value": value} for key, value in values.items()],
    }
    header = {"stamp": {"sec": seconds, "nanosec": nanoseconds}}
    array = type_store.build("diagnostic_msgs/msg/DiagnosticArray", {"header": header, "status": [status]})
    data = type_store.serialize(array)
    # DDS delivers whole multiples of four bytes; padded here, the bytes are the same wherever they come from.
    return data + padding(len(data), LENGTH_BYTES)


def end_of_run(stamp_ns: int, ticks: int, missing_answers: int) -> bytes:
    """The last word of a run: how many ticks it had, how many answers of controllers were missing."""
    words = f"ended after {ticks} ticks"
    level = OK if missing_answers == 0 else WARN
    return status_bytes(stamp_ns, level, RUN, words, {"ticks": str(ticks), "missing answers": str(missing_answers)})


def read_status(data: bytes) -> tuple[str, str, dict[str, str]]:
    """Subject, words and values of the first status in the bytes of a DiagnosticArray; empty ones if it has none."""
    statuses = type_store.deserialize("diagnostic_msgs/msg/DiagnosticArray", data).status
    if not statuses:
        return "", "", {}
    return statuses[0].name, statuses[0].message, {pair.key: pair.value for pair in statuses[0].values}
