"""Writes what a fit has found as a platform file that is based on the one it began with."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.scenario.parts.platform import Platform, platform_tree
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator, BuoyancyPump, Thruster
from cocorosim_ros.scenario.reading.yaml_file import yaml_text
from cocorosim_ros.study.calibration.fit import Fit, Fitted

KEYS = {"drag": "drag", "yaw_drag": "yaw_drag", "inertia": "yaw_inertia"}


def write_platform(out: Path, platform: Platform, fit: Fit, recording: str, *, force: bool = False) -> None:
    """Write the fitted platform to `out`; whole or not at all.

    Raises CocorosimError if the file is there (without `force`) or cannot be written.
    """
    check_file(out, force=force)
    text = yaml_text(fitted_tree(out.stem, platform, fit, recording))
    partial = out.with_name(out.name + ".partial")
    try:
        partial.write_text(text, "utf-8")
        os.replace(partial, out)
    except OSError as error:
        raise CocorosimError(f"{out} cannot be written: {error.strerror}; give another --out.") from error


def fitted_tree(name: str, platform: Platform, fit: Fit, recording: str) -> dict[str, Any]:
    """The platform file as nested plain values."""
    numbers = {number.name: number for number in fit.numbers}
    tree: dict[str, Any] = {
        "name": platform.name,
        "description": f"{platform.description}; fitted to {recording}",
        "based_on": str(Path(platform.origin).resolve()),
    }
    for name_of_fit, key in KEYS.items():
        if name_of_fit in numbers:
            number = numbers[name_of_fit]
            tree[key] = _sourced(number.value, number.unit, recording, number)
    trees, found = platform_tree(platform)["actuators"], _Found(platform, numbers, recording)
    tree["actuators"] = [_actuator(part, texts, found) for part, texts in zip(platform.actuators, trees, strict=True)]
    return tree


@dataclass(frozen=True)
class _Found:
    """What was found of a platform, by name, and in which recording."""

    platform: Platform
    numbers: Mapping[str, Fitted]
    recording: str


def _actuator(part: Actuator, texts: Mapping[str, Any], found: _Found) -> dict[str, Any]:
    """One actuator as it was, with its strength as fitted.

    That of a thruster is its `gain`. Its `maximum` stays: by it sticks become commands (StickMixing), which were those
    of the recording, and with it the forces in the table of a curve.
    """
    described = _as_it_was(part, texts, found.platform)
    for key, (value, number) in _fitted(part, found).items():
        unit = described[key]["unit"] if key in described else "1"
        described[key] = _sourced(value, unit, found.recording, number)
    return described


def _as_it_was(record: Any, texts: Mapping[str, Any], platform: Platform) -> dict[str, Any]:
    """The keys of a record, its `record_tree`, with every number as a mapping that has unit and source."""
    source, described = f"platform '{platform.name}'", dict[str, Any]()
    for key, text in texts.items():
        kept = getattr(record, key)
        if isinstance(kept, str):
            described[key] = text
        elif isinstance(text, Mapping):
            described[key] = _as_it_was(kept, text, platform)
        elif isinstance(text, list):
            described[key] = {"value": list(kept), "unit": _unit(text[0]), "source": source}
        else:
            described[key] = {"value": kept, "unit": _unit(text), "source": source}
    return described


def _fitted(part: Actuator, found: _Found) -> dict[str, tuple[float, Fitted]]:
    """The numbers of an actuator that were fitted, by key: its value now, and by which number of the fit."""
    numbers, fitted = found.numbers, dict[str, tuple[float, Fitted]]()
    if isinstance(part, Thruster) and "thrust_gain" in numbers:
        gain = 1.0 if part.gain is None else part.gain
        fitted["gain"] = gain * numbers["thrust_gain"].value, numbers["thrust_gain"]
    if isinstance(part, BuoyancyPump) and "buoyancy_gain" in numbers:
        fitted["volume_range"] = part.volume_range * numbers["buoyancy_gain"].value, numbers["buoyancy_gain"]
    if isinstance(part, BuoyancyPump) and "buoyancy_trim" in numbers:
        weight = found.platform.mass + numbers["buoyancy_trim"].value / found.platform.gravity
        fitted["neutral_volume"] = weight / found.platform.water_density, numbers["buoyancy_trim"]
    return fitted


def _sourced(value: float, unit: str, recording: str, number: Fitted) -> dict[str, Any]:
    interval = f"95 % of {number.name}: {number.low:.6g} to {number.high:.6g} {number.unit}"
    return {
        "value": value,
        "unit": unit,
        "source": f"cocorosim calibrate {recording}",
        "confidence": "measured",
        "note": interval,
    }


def _unit(text: str) -> str:
    _, _, unit = str(text).partition(" ")
    return unit or "1"
