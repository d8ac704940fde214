"""Recordings in which all happens slower: the same course and commands, of a vehicle whose forces are so much weaker.

Where all times are k times as long, lengths, masses and drag coefficients [kg/m] are the same, speeds and turn rates
are one k-th, forces and moments one k^2-th: by the dimensions of the numbers alone (Buckingham's theorem). So it needs
no second simulation.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import yaml

POWER_OF_TIME = {
    "N": -2, "N m": -2, "m/s^2": -2, "N s/m": -1, "N m s": -1, "m/s": -1, "rad/s": -1, "1/s": -1, "s": 1, "s/m": 1,
    "kg": 0, "kg m^2": 0, "kg/m": 0, "kg/m^3": 0, "N m s^2": 0, "m": 0, "1": 0, "rad": 0,
}  # fmt: skip
"""By unit: the power of k by which a number is multiplied."""


def slowed(evidence: Any, file: Path, k: float) -> Any:
    """Evidence of which all times are k times as long; file: that of its platform."""
    return replace(
        evidence,
        platform=slow_platform(file, k),
        recordings=tuple(_slow_recording(recording, k) for recording in evidence.recordings),
    )


def slow_platform(file: Path, k: float) -> Any:
    """The platform of a file, of which all times are k times as long."""
    from cocorosim_ros.scenario.parts.platform import read_platform_file

    path = file.with_name(f"{file.stem}_{k:g}.yaml")
    path.write_text(yaml.safe_dump(_scaled(yaml.safe_load(file.read_text()), k), sort_keys=False))
    return read_platform_file(path)


def _scaled(part: Any, k: float) -> Any:
    """A part of a platform's file with its quantities multiplied."""
    if isinstance(part, list):
        return [_scaled(each, k) for each in part]
    if not isinstance(part, dict):
        return part
    if "unit" not in part:
        return {key: _scaled(each, k) for key, each in part.items()}
    factor = k ** POWER_OF_TIME[part["unit"]]
    return {key: _times(each, factor) if key in ("value", "range") else each for key, each in part.items()}


def _times(value: Any, factor: float) -> Any:
    return [factor * each for each in value] if isinstance(value, list) else factor * value


def _slow_recording(recording: Any, k: float) -> Any:
    robots = tuple(
        replace(
            log,
            command_time=k * log.command_time,
            streams={name: replace(each, time=k * each.time) for name, each in log.streams.items()},
        )
        for log in recording.robots
    )
    return replace(recording, duration=k * recording.duration, robots=robots)
