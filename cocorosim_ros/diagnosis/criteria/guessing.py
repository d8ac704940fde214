"""Thresholds of guesses about logs that no map is written for."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class GuessingCriteria:
    """Limits by which numbers without a unit are given one, and columns a meaning (`guessing`)."""

    full_turn: float = 6.4
    """[rad] a heading that goes beyond a full turn and a bit is in degrees. Chosen, not measured."""
    fast_turn: float = 10.0
    """[rad/s] no vehicle turns so fast: the rate is in degrees. Chosen, not measured."""
    longest_tick: float = 20.0
    """[s] between rows, median: more than that is another unit of time. Chosen, not measured."""
    shortest_tick: float = 5e-4
    """[s] between rows, median: less than that is another unit of time. Chosen, not measured."""
    pulse_low: float = 800.0
    """[us] servo pulses are 1000 to 2000 us long, a bit more on either side. Known of servos; chosen, not measured."""
    pulse_high: float = 2200.0
    """[us] the other end of the same range. Chosen, not measured."""
    epoch: float = 1e8
    """[s] since 1970, between 1973 and 5138 with a thousandth and a thousand of it: a unit follows from the size of a
    time. Follows from the calendar; chosen, not measured."""
    later: float = 1e11
    """[s] the other end of that range. Follows from the calendar; chosen, not measured."""
    head_lines: int = 20
    """[lines] of a text that tell how it is written. Chosen, not measured."""
    under_way: float = 0.3
    """[of the highest speed] below it a direction of travel means nothing. Chosen, not measured."""
    turned_enough: float = 1.0
    """[rad] by which a heading must have changed before its sense of turning shows. Chosen, not measured."""
    rising: float = 1e-2
    """[share of the rows] at which a column may run backwards and still be a time. Chosen, not measured."""
    standing: float = 1e-9
    """[1] spread relative to size below which a column stands still: no command. Chosen, not measured."""
    most_listed: int = 32
    """[numbers] a longer list in a message is no list of actuators. Chosen, not measured."""


GUESSING = GuessingCriteria()
