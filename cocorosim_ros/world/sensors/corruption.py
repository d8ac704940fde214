"""Corruption of readings: noise, bias, quantisation, dropout, delay, in the order in which the scenario lists them.

Works on the arrays of all runs between measuring and deciding, so that a single run, a batch and the physics node
show the same readings bit for bit; what is not listed is not touched. A reading that is missing is +inf where it
is a range and NaN elsewhere (REP 117). Headings stay in (-pi, pi], ranges do not fall below zero.
Source: what each kind does stands in parts.corruption; the released model multiplies blue-light ranges by a
number drawn evenly from 0.8 to 1.0 (range_factor), which is biased short by a tenth.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.corruption import RANGES, SENSOR_CHANNELS, Corruption
from cocorosim_ros.world.seeding.corruption_at_work import CorruptionAtWork, Swarms, corruptions_at_work
from cocorosim_ros.world.sensors.readings import FIELDS, Readings
from cocorosim_ros.world.sensors.sensor import Field

# Channel to the field of Readings and the columns of it.
_PLACES: dict[str, tuple[Field, slice | None]] = {
    channel: (field, columns) for field in FIELDS.values() for channel, columns in field.channels.items()
}


def channel_values(readings: Readings, channel: str) -> Floats:
    """(runs, robots, width) the readings of a channel, as a view."""
    field, columns = _PLACES[channel]
    values: Floats = getattr(readings, field.name)
    return values[..., None] if columns is None else values[..., columns]


class CorruptedChannel(CorruptionAtWork):
    """One corruption at work on one channel of some robots."""

    def __init__(self, corruption: Corruption, purpose: str, swarms: Swarms) -> None:
        super().__init__(corruption, purpose, swarms)
        self._missing = np.inf if corruption.channel in RANGES else np.nan
        self._past: Floats | None = None

    def apply(self, tick: int, readings: Readings) -> None:
        """Corrupt the readings of this tick in place."""
        values = channel_values(readings, self.channel)
        changed = getattr(self, f"_{self._kind}")(tick, values[:, self._chosen])
        if _PLACES[self.channel][0].angle:
            changed = _wrapped(changed)
        elif self.channel in RANGES:
            changed = np.maximum(changed, 0.0)
        values[:, self._chosen] = changed

    def _noise(self, tick: int, values: Floats) -> Floats:
        return values + self._numbers["sd"] * self._blocks(values.shape[2], normal=True).at(tick)

    def _bias(self, tick: int, values: Floats) -> Floats:
        return values + self._numbers["offset"]

    def _quantisation(self, tick: int, values: Floats) -> Floats:
        step = self._numbers["step"]
        return np.round(values / step) * step

    def _range_factor(self, tick: int, values: Floats) -> Floats:
        least, most = self._numbers["least"], self._numbers["most"]
        factor = least + (most - least) * self._blocks(values.shape[2], normal=False).at(tick)
        # Nobody within range stays nobody, though the factor be zero.
        return np.multiply(values, factor, out=values.copy(), where=np.isfinite(values))

    def _dropout(self, tick: int, values: Floats) -> Floats:
        width = values.shape[2] if self.channel in RANGES else 1
        lost = self._blocks(width, normal=False).at(tick) < self._numbers["probability"]
        return np.where(lost, self._missing, values)

    def _delay(self, tick: int, values: Floats) -> Floats:
        length = int(self._numbers["ticks"]) + 1
        if self._past is None:
            self._past = np.full((length, *values.shape), self._missing)
        self._past[tick % length] = values
        shown: Floats = self._past[(tick + 1) % length]
        return shown


def corrupted_channels(corruptions: Sequence[Corruption], swarms: Swarms) -> list[CorruptedChannel]:
    """The corruptions of sensors at work, in their order; those of links are left to links.imperfect_links."""
    return corruptions_at_work(CorruptedChannel, SENSOR_CHANNELS, corruptions, swarms)


def _wrapped(angle: Floats) -> Floats:
    """The same directions in (-pi, pi]; those that are there already stay bit for bit."""
    outside = (angle > np.pi) | (angle <= -np.pi)
    return np.where(outside, np.pi - (np.pi - angle) % (2.0 * np.pi), angle)
