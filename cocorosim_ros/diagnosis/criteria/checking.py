"""Thresholds of the first look at any robot's recording: what is so odd that a sentence is due."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CheckingCriteria:
    """Limits beyond which a recording of whatever robot has something wrong with it (`checking`)."""

    fewest: int = 20
    """[messages] fewer show neither a rate nor noise. Chosen, not measured."""
    largest_message: int = 4096
    """[bytes] on average; larger ones are pictures and clouds, of which the times alone are looked at. Chosen."""
    frozen_messages: int = 20
    """[messages] in a row that say the same. Chosen, not measured."""
    frozen_seconds: float = 2.0
    """[s] that these last at least. Chosen, not measured."""
    usual_repeats: float = 5.0
    """[usual runs of equal readings] a slow instrument repeats itself; this is more than that. Chosen, not measured."""
    noisy: float = 0.3
    """[share of the steps] whose sign differs from that of the step before: two thirds in white noise, hardly any in
    a smooth motion without noise, which may rest by itself. Reckoned for white noise, the limit chosen."""
    even: float = 0.35
    """[of the usual interval] by which intervals of a topic that has a rate differ, median. Chosen, not measured."""
    slower: float = 1.6
    """[times the usual interval] over `slow_in_a_row` messages: the rate has dropped. Chosen, not measured."""
    slow_in_a_row: int = 10
    """[messages] over which a rate is taken. Chosen, not measured."""
    covariance_off: float = 1e-6
    """[of the largest element] by which a covariance may miss symmetry, and an eigenvalue zero. Chosen: single numbers
    of four bytes are off by 1e-7."""
    unit_quaternion: float = 1e-2
    """[1] by which the length of a quaternion may miss 1: rounded to two decimals it still fits. Chosen."""
    lying: float = 1.05
    """[rad] of roll or pitch, median: 60 degrees, at which no vehicle travels. Chosen, not measured."""
    related: float = 0.8
    """[1] correlation of two numbers that show the same motion. Chosen, not measured."""
    ratio: float = 1.6
    """[1] by which two sizes of the same motion may differ, either way. Chosen, not measured."""
    moving: float = 0.02
    """[rad/s, or m/s] standard deviation below which there is no motion to compare. Chosen, not measured."""
    over: float = 0.5
    """[s] over which motions are averaged before they are compared: noise of derivatives falls. Chosen."""
    smallest_air: float = 5.0e4
    """[Pa] the pressure of the air at 5500 m; less is no absolute pressure in Pa. Standard atmosphere, ISO 2533."""

    largest_pressure: float = 1.2e8
    """[Pa] 12 000 m deep, more than any sea. Reckoned."""


CHECKING = CheckingCriteria()
GRAVITY = 9.80665
"""[m/s^2] standard gravity: what an accelerometer at rest shows."""
ACCELERATIONS = {"m/s^2": (8.5, 11.5), "g": (0.85, 1.15)}
"""Median length of the acceleration, by the unit that it then has. Chosen: thrust and waves move it by less."""
