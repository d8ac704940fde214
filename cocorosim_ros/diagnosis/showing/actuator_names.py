"""Sentences on effects with a name that actuators explain by what they report, or that they contradict."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from cocorosim_ros.diagnosis.against.numbers import DELAY
from cocorosim_ros.diagnosis.against.twins import LATE_READINGS
from cocorosim_ros.diagnosis.criteria.following import TOLD_BY_ACTUATORS
from cocorosim_ros.diagnosis.findings import ActuatorReport, FoundEffect
from cocorosim_ros.diagnosis.showing.actuator_sentences import MEANT_TO_FOLLOW
from cocorosim_ros.wire.topics.actuator_feedback import FRACTION

LAG = "thruster_lag"
_TIMES = {LAG: "time_constant", LATE_READINGS: "latency", DELAY: "delay"}
"""Effects by which forces come late, or seem to, and their number [s]."""
MOTORS = ("rotation", FRACTION)
"""Quantities that tell how a thruster's motor follows."""


@dataclass(frozen=True)
class Late:
    """Lateness of actuators of one kind, by what they report: the least and the most of them [s]."""

    quantity: str
    least: float
    most: float

    @property
    def middle(self) -> float:
        """The middle of both [s]."""
        return 0.5 * (self.least + self.most)

    @property
    def words(self) -> str:
        """Words like 'by 0.66 to 0.77 s (angle)'."""
        between = f"{self.least:.2f} to {self.most:.2f}" if self.least < self.most else f"{self.most:.2f}"
        return f"by {between} s ({self.quantity})"


def name_sentences(
    effects: Sequence[FoundEffect], reports: Sequence[ActuatorReport], *, compared: bool
) -> Iterator[str]:
    """Sentences on late forces, commands or readings that have a name, and that actuators tell of too.

    compared: whether effects are differences from other recordings; then that is asked by which reports differ.
    """
    for found in effects:
        number = found.parameters.get(_TIMES.get(found.id, ""))
        if number is None or number.value < TOLD_BY_ACTUATORS.notable:
            continue
        late = _lateness(reports, found, compared=compared)
        if not late:
            continue
        nearest = min(late, key=lambda each: abs(each.middle - number.value))
        low, high = TOLD_BY_ACTUATORS.explains
        if low * nearest.middle <= number.value <= high * nearest.middle:
            yield _explained(found, number.value, nearest, compared=compared)
        elif all(high * each.most < number.value for each in late):
            yield _contradicted(found, number.value, late, compared=compared)


def _lateness(reports: Sequence[ActuatorReport], found: FoundEffect, *, compared: bool) -> list[Late]:
    """Lateness of the actuators of the effect's robots, by quantity; of differences, how much it has grown."""
    told = [each for each in reports if each.robot in found.robots and each.numbers and (each.before or not compared)]
    asked = MOTORS if found.id == LAG else MEANT_TO_FOLLOW
    values: dict[str, list[float]] = {}
    for each in told:
        if each.quantity in asked:
            grown = each.before["lateness"].value if compared else 0.0
            values.setdefault(each.quantity, []).append(each.numbers["lateness"].value - grown)
    return [Late(quantity, min(late), max(late)) for quantity, late in values.items()]


def _subject(found: FoundEffect, seconds: float) -> str:
    """Words on an effect and its number."""
    if found.id == LATE_READINGS:
        return f"Readings of {found.topic} of {', '.join(found.robots)} are told to be {seconds:.2f} s late"
    word = "a lag of the thrust" if found.id == LAG else "commands that act late"
    return f"For {', '.join(found.robots)} {word}, {seconds:.2f} s, is named"


def _explained(found: FoundEffect, seconds: float, late: Late, *, compared: bool) -> str:
    more = " more than before" if compared else ""
    start = f"{_subject(found, seconds)}, and its actuators report that they follow their commands {late.words}{more}"
    if found.id == LATE_READINGS:
        return f"{start}: late actuators look like late readings, so that the readings may well be in time."
    return f"{start}: this is where the lateness arises."


def _contradicted(found: FoundEffect, seconds: float, late: Sequence[Late], *, compared: bool) -> str:
    words = " and ".join(each.words for each in late)
    more = " more than before" if compared else ""
    start = f"{_subject(found, seconds)}, but its actuators report that they follow their commands {words} only{more}"
    if found.id == LATE_READINGS:
        return f"{start}: they do not explain it."
    return f"{start}: look for it behind them, in what the propellers do, or in clocks and readings that are late."
