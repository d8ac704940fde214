"""What a number of an effect is called, in which unit, and what it is where nobody gives it."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.scenario.reading.quantity import Sign


@dataclass(frozen=True)
class Parameter:
    """One number of an effect, in SI units; the unit of one that depends on a law is '*'.

    neutral: its value where nobody gives one; with all its parameters neutral an effect does nothing.
    needed: it has no value that would do for everybody, so whoever names the effect must give it.
    """

    name: str
    unit: str
    meaning: str
    neutral: float = 0.0
    sign: Sign = "any"
    needed: bool = False
