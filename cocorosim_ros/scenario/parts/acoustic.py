"""Sound as a link between robots: what a scenario says of modem and water. Without it robots have no acoustic modem."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from cocorosim_ros.scenario.reading.quantity import nanoseconds_text, read_nanoseconds
from cocorosim_ros.scenario.reading.records import TIME_FORM, quantity, stored

_TIME = (read_nanoseconds, nanoseconds_text)


class Validity(NamedTuple):
    """From where to where a number is covered by the law of absorption."""

    least: float
    most: float
    unit: str
    factor: float = 1.0  # from SI to the unit in which it is told


# Ainslie and McColm: 100 Hz to 1 MHz, 7.7 < pH < 8.3, -6 < T < 35 degC, 5 < S < 50. Without salt what is left is the
# absorption of the water itself, to which the formula tends.
VALIDITY = {
    "frequency": Validity(100.0, 1e6, "kHz", 1e-3),
    "temperature": Validity(-6.0, 35.0, "degC"),
    "salinity": Validity(0.0, 50.0, "g/kg"),
    "acidity": Validity(7.7, 8.3, "(pH)"),
}


@dataclass(frozen=True)
class Acoustic:
    """One kind of modem on every robot, and the water between them.

    range: as far as anything is heard [m]; sound_speed [m/s]. duration_ns: how long every message is on air [ns];
    slot_ns: robots send in turn, each for so long [ns]; None: each at once. source_level: of a sending modem [dB re
    1 uPa at 1 m]; noise_level: of the water [dB re 1 uPa^2/Hz]; frequency: the middle of the band [Hz], bandwidth [Hz],
    bit_rate [bit/s]. spreading: 2 in open water, 1 between surface and floor, 1.5 for what is usual. temperature
    [degC], salinity [g/kg] and acidity (pH) of the water decide what it absorbs. timing_error: standard deviation of
    one clock against another [s].
    """

    range: float = field(metadata=quantity("length", "positive"))
    sound_speed: float = field(default=1500.0, metadata=quantity("speed", "positive"))
    duration_ns: int = field(default=100_000_000, metadata=stored(*_TIME, key="duration", form=TIME_FORM))
    slot_ns: int | None = field(default=None, metadata=stored(*_TIME, key="slot", form=TIME_FORM))
    source_level: float = field(default=160.0, metadata=quantity("level"))
    noise_level: float = field(default=50.0, metadata=quantity("level"))
    frequency: float = field(default=25_000.0, metadata=quantity("frequency", "positive"))
    bandwidth: float = field(default=4000.0, metadata=quantity("frequency", "positive"))
    bit_rate: float = field(default=1000.0, metadata=quantity("bit rate", "positive"))
    spreading: float = field(default=1.5, metadata=quantity("pure number", "positive"))
    temperature: float = field(default=10.0, metadata=quantity("temperature"))
    salinity: float = field(default=35.0, metadata=quantity("salinity", "not negative"))
    acidity: float = field(default=8.0, metadata=quantity("pure number", "positive"))
    timing_error: float = field(default=0.0, metadata=quantity("time", "not negative"))
