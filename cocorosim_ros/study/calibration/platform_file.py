"""Writes what a fit has found as a platform file that is based on the one it began with."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.scenario.parts.platform import Platform, platform_tree
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
    for found, key in KEYS.items():
        if found in numbers:
            tree[key] = _sourced(numbers[found].value, numbers[found].unit, recording, numbers[found])
    tree["actuators"] = [_actuator(part, platform, numbers, recording) for part in platform_tree(platform)["actuators"]]
    return tree


def _actuator(part: dict[str, Any], platform: Platform, numbers: dict[str, Fitted], recording: str) -> dict[str, Any]:
    """One actuator with its strength as fitted, everything else as it was."""
    described: dict[str, Any] = {"name": part["name"], "kind": part["kind"]}
    for key, text in part.items():
        if key in described:
            continue
        if isinstance(text, list):
            values, unit = [_number(each) for each in text], _unit(text[0])
            described[key] = {"value": values, "unit": unit, "source": f"platform '{platform.name}'"}
            continue
        value, number = _scaled(key, _number(text), platform, numbers)
        if number is None:
            described[key] = {"value": value, "unit": _unit(text), "source": f"platform '{platform.name}'"}
        else:
            described[key] = _sourced(value, _unit(text), recording, number)
    return described


def _scaled(key: str, value: float, platform: Platform, numbers: dict[str, Fitted]) -> tuple[float, Fitted | None]:
    """A number of an actuator with what was found, and by which number of the fit."""
    if key.startswith("maximum") and "thrust_gain" in numbers:
        return value * numbers["thrust_gain"].value, numbers["thrust_gain"]
    if key == "volume_range" and "buoyancy_gain" in numbers:
        return value * numbers["buoyancy_gain"].value, numbers["buoyancy_gain"]
    if key == "neutral_volume" and "buoyancy_trim" in numbers:
        weight = platform.mass + numbers["buoyancy_trim"].value / platform.gravity
        return weight / platform.water_density, numbers["buoyancy_trim"]
    return value, None


def _sourced(value: float, unit: str, recording: str, number: Fitted) -> dict[str, Any]:
    interval = f"95 % of {number.name}: {number.low:.6g} to {number.high:.6g} {number.unit}"
    return {
        "value": value,
        "unit": unit,
        "source": f"cocorosim calibrate {recording}",
        "confidence": "measured",
        "note": interval,
    }


def _number(text: str) -> float:
    return float(str(text).split(" ", maxsplit=1)[0])


def _unit(text: str) -> str:
    _, _, unit = str(text).partition(" ")
    return unit or "1"
