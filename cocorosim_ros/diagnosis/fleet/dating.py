"""The moment at which a recording was made, and what tells it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Literal

from cocorosim_ros.diagnosis.criteria.fleet import DATE
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

DatedBy = Literal["stamps", "log times", "name", "nothing"]
# As `ros2 bag record` names a folder that is given no name, in the recording machine's own time.
_IN_NAME = re.compile(r"(\d{4})_(\d{2})_(\d{2})-(\d{2})_(\d{2})_(\d{2})")


@dataclass(frozen=True)
class Dated:
    """Start of a recording [ns since 1970, UTC], None if nothing tells it."""

    start_ns: int | None
    by: DatedBy


def dated(stamp_ns: int, log_ns: int, name: str) -> Dated:
    """Date a recording by its first stamp, else by its first log time, else by a date in its name.

    Stamps and log times of a simulation, or of a clock that was never set, count from zero and are no dates. A date in
    the name (rosbag2_2026_03_01-14_05_00) is taken as UTC: it may be off by the hours of a time zone.
    """
    if stamp_ns >= DATE.first_ns:
        return Dated(stamp_ns, "stamps")
    if log_ns >= DATE.first_ns:
        return Dated(log_ns, "log times")
    found = _IN_NAME.findall(name)
    try:
        moment = datetime(*map(int, found[-1]), tzinfo=UTC) if found else None  # type: ignore[arg-type, misc]
    except ValueError:
        moment = None
    return Dated(int(moment.timestamp()) * NANOSECONDS, "name") if moment else Dated(None, "nothing")
