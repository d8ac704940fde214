"""Thresholds of the first look at any robot's recording: what is so odd that a sentence is due."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CheckingCriteria:
    """Limits beyond which a recording of whatever robot has something wrong with it (`checking`)."""

    fewest: int = 20
    """[messages] fewer show neither a rate nor noise. Chosen, not measured."""
    largest_message: int = 4096
    """[bytes] on average; of larger ones, pictures and clouds, the times alone are looked at. Chosen, not measured."""
    frozen_messages: int = 20
    """[messages] in a row that say the same. Chosen, not measured."""
    frozen_seconds: float = 2.0
    """[s] that these last at least. Chosen, not measured."""
    usual_repeats: float = 5.0
    """[usual runs of equal readings] a slow instrument repeats itself; this is more than that. Chosen, not measured."""
    noisy: float = 0.3
    """[share of the steps] whose sign differs from that of the step before: two thirds in white noise, hardly any in
    a smooth motion without noise, which may rest by itself. Chosen, not measured."""
    even: float = 0.35
    """[of the usual interval] by which intervals of a topic that has a rate differ, median. Chosen, not measured."""
    slower: float = 1.6
    """[times the usual interval] over `slow_in_a_row` messages: the rate has dropped. Chosen, not measured."""
    slow_in_a_row: int = 10
    """[messages] over which a rate is taken. Chosen, not measured."""
    covariance_off: float = 1e-6
    """[of the largest element] by which a covariance may miss symmetry, and an eigenvalue zero: numbers of four
    bytes are off by 1e-7. Chosen, not measured."""
    unit_quaternion: float = 1e-2
    """[1] by which the length of a quaternion may miss 1, as by two decimals. Chosen, not measured."""
    lying: float = 1.05
    """[rad] of roll or pitch, median: 60 degrees, at which no vehicle travels. Chosen, not measured."""
    related: float = 0.8
    """[1] correlation of two numbers that show the same motion. Chosen, not measured."""
    ratio: float = 1.6
    """[1] by which two sizes of the same motion may differ, either way. Chosen, not measured."""
    moving: float = 0.02
    """[rad/s, or m/s] standard deviation below which there is no motion to compare. Chosen, not measured."""
    over: float = 0.5
    """[s] over which motions are averaged, since derivatives are noisy. Chosen, not measured."""
    upside_down: float = -0.5
    """[cosine of the tilt, or share of the acceleration] below it up is down. Chosen, not measured."""
    named: int = 3
    """[names] of frames in one sentence. Chosen, not measured."""
    shortest_step: float = 1e-9
    """[s] between stamps, which are whole nanoseconds. Follows from them; chosen, not measured."""
    smallest_air: float = 5.0e4
    """[Pa] the pressure of the air at 5500 m; less is no absolute pressure in Pa. Known of the
    standard atmosphere, ISO 2533; chosen, not measured."""

    largest_pressure: float = 1.2e8
    """[Pa] 12 000 m deep, more than any sea. Chosen, not measured."""


CHECKING = CheckingCriteria()
ACCELERATIONS = {"m/s^2": (8.5, 11.5), "g": (0.85, 1.15)}
"""Median length of the acceleration, by the unit that it then has. Chosen: thrust and waves move it by less."""
