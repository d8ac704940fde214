"""DIMENSIONS: every unit that is known, by dimension. All other tables of units are derived from this one.

What files may write, what reports show and what units products have is all here; a unit is added in one line.
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import NamedTuple

from cocorosim_ros.foundation.units.unit_algebra import leading_symbol

_RADIANS_PER_DEGREE = "0.01745329251994329576923690768"


class Unit(NamedTuple):
    """A unit by its symbol; `factor` times a number in it is the number in SI."""

    symbol: str
    factor: str = "1"  # decimal text, so that '440 cm^3' is the double nearest to 0.00044
    read: bool = True  # whether scenarios, platforms and maps may have it
    shown: bool = False  # whether reports choose it among the units of its dimension where the number is handy in it
    label: str = ""  # how reports write it, if not by its symbol

    @property
    def per_si(self) -> float:
        """How many of it are one SI unit."""
        return float(1 / Decimal(self.factor))


# The first unit of each row is SI; units that are shown stand from the largest to the smallest.
DIMENSIONS: Mapping[str, tuple[Unit, ...]] = {
    "length": (Unit("m"), Unit("cm", "0.01"), Unit("mm", "0.001")),
    "time": (
        Unit("s"), Unit("ms", "0.001"), Unit("us", "1e-6"), Unit("ns", "1e-9"), Unit("min", "60"), Unit("h", "3600"),
    ),
    "angle": (Unit("rad"), Unit("deg", _RADIANS_PER_DEGREE, shown=True, label="\u00b0")),
    "mass": (Unit("kg", shown=True), Unit("g", "0.001", shown=True), Unit("mg", "1e-6", read=False, shown=True)),
    "force": (Unit("N"), Unit("mN", "0.001")),
    "force rate": (Unit("N/s"),),
    "torque": (Unit("N m"), Unit("mN m", "0.001")),
    "torque rate": (Unit("N m/s"),),
    "moment of inertia": (Unit("kg m^2", shown=True), Unit("kg cm^2", "1e-4", read=False, shown=True)),
    "first moment of mass": (Unit("kg m"),),
    "quadratic drag": (Unit("kg/m", shown=True), Unit("g/m", "0.001", read=False, shown=True)),
    "quadratic yaw drag": (Unit("N m s^2"),),
    "linear drag": (Unit("N s/m"),),
    "linear yaw drag": (Unit("N m s"),),
    "linear drag of a coupling": (Unit("N s"),),
    "stiffness": (Unit("N/m"),),
    "area": (
        Unit("m^2", shown=True), Unit("cm^2", "1e-4", shown=True),
        Unit("mm^2", "1e-6", read=False, shown=True),
    ),
    "square of a speed": (
        Unit("m^2/s^2", read=False, shown=True), Unit("cm^2/s^2", "1e-4", read=False, shown=True),
        Unit("mm^2/s^2", "1e-6", read=False, shown=True),
    ),
    "volume": (Unit("m^3"), Unit("cm^3", "1e-6")),
    "density": (Unit("kg/m^3"), Unit("g/m^3", "0.001"), Unit("mg/m^3", "1e-6")),
    "pressure": (
        Unit("Pa"), Unit("hPa", "100"), Unit("mbar", "100"), Unit("kPa", "1000"), Unit("dbar", "1e4"),
        Unit("bar", "1e5"),
    ),
    "pressure rate": (Unit("Pa/s"),),
    "speed": (Unit("m/s"), Unit("cm/s", "0.01"), Unit("mm/s", "0.001")),
    "acceleration": (Unit("m/s^2"), Unit("g0", "9.80665")),
    "angular velocity": (
        Unit("rad/s"), Unit("deg/s", _RADIANS_PER_DEGREE, shown=True, label="\u00b0/s"),
        Unit("rev/s", "6.283185307179586476925286767"), Unit("rpm", "0.1047197551196597746154214461"),
    ),
    "frequency": (Unit("Hz"), Unit("kHz", "1000")),
    "bit rate": (Unit("bit/s"), Unit("kbit/s", "1000")),
    "level": (Unit("dB"),),
    "temperature": (Unit("degC"),),
    "salinity": (Unit("g/kg"),),
    "rate": (
        Unit("1/s", shown=True, label="m/s per m"),
        Unit("mm/s per m", "0.001", read=False, shown=True),
    ),
    "clock rate": (Unit("s/s"), Unit("ppm", "1e-6", read=False, shown=True)),
    "slowness": (Unit("s/m", shown=True),),  # a slope of 0.3 s/m, not of 300 ms/m
    "area rate": (Unit("m^2/s"), Unit("cm^2/s", "1e-4")),
    "mass rate": (Unit("kg/s"), Unit("g/s", "0.001"), Unit("mg/s", "1e-6")),
    "voltage": (Unit("V"), Unit("mV", "0.001")),
    "inverse voltage": (Unit("1/V"),),
    "electric current": (Unit("A"), Unit("mA", "0.001")),
    "inverse angle": (Unit("1/rad"),),
    "inverse angular velocity": (Unit("s/rad", shown=True),),  # as slowness
    "inverse acceleration": (Unit("s^2/m"),),
    "illuminance": (Unit("lx"), Unit("klx", "1000")),
    "pure number": (Unit("1"), Unit("%", "0.01")),
}  # fmt: skip
PREFIXES: Mapping[str, str] = {"k": "1000", "": "1", "m": "0.001", "\u00b5": "1e-6", "n": "1e-9"}
"""Factors of the prefixes that reports use, the largest first."""
PREFIXED: Mapping[str, tuple[str, ...]] = {
    "N": ("k", "", "m", "\u00b5", "n"), "Pa": ("k", "", "m"), "m": ("", "m", "\u00b5"), "s": ("", "m", "\u00b5"),
}  # fmt: skip
"""Which prefixes reports put before a unit that begins with this symbol."""


EQUAL: Mapping[str, str] = {"N s^2/m": "kg", "N s^2/m^2": "kg/m", "N s^2": "kg m"}
"""Units of force over motion as people write them: a force in proportion to an acceleration is by a mass."""


def units_in_files() -> dict[str, dict[str, str]]:
    """By dimension: factors to SI, as decimal text, of the units that files may have; the first one is SI."""
    found = {
        dimension: {unit.symbol: unit.factor for unit in units if unit.read} for dimension, units in DIMENSIONS.items()
    }
    return {dimension: units for dimension, units in found.items() if units}


def units_shown(unit: str) -> tuple[Unit, ...]:
    """The units in which reports show a number of this SI unit, the largest first; empty if any prefix will do."""
    return _SHOWN.get(EQUAL.get(unit, unit), ())


def prefixed(unit: str) -> tuple[Unit, ...]:
    """The SI unit with every prefix that reports put before its first symbol, the largest first."""
    unit = EQUAL.get(unit, unit)
    return tuple(Unit(prefix + unit, PREFIXES[prefix]) for prefix in PREFIXED.get(leading_symbol(unit), ("",)))


_SHOWN = {units[0].symbol: tuple(unit for unit in units if unit.shown) for units in DIMENSIONS.values()}
