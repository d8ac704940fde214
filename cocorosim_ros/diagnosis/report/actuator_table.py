"""Rows of a table of what actuators report, for the page and the terminal."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.findings import ActuatorReport, Estimate
from cocorosim_ros.diagnosis.report.number_text import estimate_words
from cocorosim_ros.foundation.units.quantity_text import NONE
from cocorosim_ros.scenario.reading.quantity import UNITS

NUMBERS = ("lateness", "delay", "time_constant", "gain", "rate_limit")
_HEADINGS = ("follows by", "dead time", "lag", "gain", "rate limit")


def reported_headings(reports: Sequence[ActuatorReport]) -> tuple[str, ...]:
    """Headings of the columns: the numbers, and by how much was followed before where that is known."""
    return ("actuator", "of", *_HEADINGS, *(["before"] if _is_compared(reports) else []))


def reported_rows(reports: Sequence[ActuatorReport]) -> list[tuple[str, ...]]:
    """A row for each number that actuators report, each cell a value with its 95 % interval."""
    several = len({each.robot for each in reports}) > 1
    rows = []
    for each in reports:
        name = f"{each.robot}/{each.actuator}" if several else each.actuator
        quantity = f"{each.quantity} (amount)" if each.of_amount else each.quantity
        cells = [_cell(each.numbers, number) for number in NUMBERS]
        if not each.numbers:
            cells[0] = f"not told: {each.because}"
        rows.append((name, quantity, *cells, *([_cell(each.before, NUMBERS[0])] if _is_compared(reports) else [])))
    return rows


def _is_compared(reports: Sequence[ActuatorReport]) -> bool:
    return any(each.before for each in reports)


def _cell(numbers: Mapping[str, Estimate], name: str) -> str:
    if name not in numbers:
        return NONE
    value, interval = estimate_words(_as_read(numbers[name], name))
    return f"{value} ({interval})"


def _as_read(estimate: Estimate, name: str) -> Estimate:
    """The gain of a motor in rpm at full command, as its data sheet has it; all else as it is."""
    if name != "gain" or estimate.unit != "rad/s":
        return estimate
    rpm = float(UNITS["angular velocity"]["rpm"])
    return Estimate(estimate.value / rpm, estimate.low / rpm, estimate.high / rpm, "rpm")
