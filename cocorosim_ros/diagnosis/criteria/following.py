"""Thresholds of the check of what actuators report: when it tells how they follow, and when a name fits to it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FollowingCriteria:
    """Least that reports must show, and how far a following is looked for (`evidence.following`)."""

    fewest: int = 50
    """[reports] of an actuator at least: fewer are no more than a step or two. Chosen, not measured."""
    moved: float = 0.02
    """[of the maximum] by which commands have to differ; less is lost in backlash. Chosen, not measured."""
    changes: float = 4.0
    """[moments] of equal weight at which commands change and the report follows. Fewer have no scatter, and so no
    interval: it is what the moments differ by among themselves. Chosen, not measured."""
    follows: float = 0.5
    """[share of the report's variance] that commands explain; what explains less is another thing than the command,
    as the voltage of a battery is. Chosen, not measured."""
    usual: tuple[float, float] = (0.01, 0.99)
    """[1] quantiles between which nearly all reports lie. Chosen, not measured."""
    usual_span: float = 0.3
    """[of the range of the commands] between the same quantiles of the commands: less, and the far ones are what is
    rare and tells. Chosen, not measured."""
    beyond: float = 2.0
    """[of the span between these quantiles] beyond them a report is a fault. Chosen, not measured: a motor of a ferry
    between 290 and 460 rpm reported -1091 rpm for 0.8 s."""
    settling: float = 10.0
    """[s] from the first command of a stretch on that are left out, since what was commanded before is not known.
    Chosen, not measured."""
    most_settling: float = 0.25
    """[of a stretch] that is left out so at most. Chosen, not measured."""
    shortest_block: float = 4.0
    """[s] of a block, in which errors of the report may hang together. Chosen, not measured: dead time and lag of the
    servos of a ferry are 0.7 s together."""
    fewest_in_block: int = 20
    """[reports] of a block, which is longer where they are rare. Chosen, not measured."""
    memories: float = 14.0
    """[memories] of the residual, or of the actuator's lateness, in a block: less, and neighbours tell the same.
    Measured: with noise that hangs together over 1 s and over 4 s, 95 % intervals of the gain missed in 15 % and 20 %
    of sixty made recordings with blocks of 4 s, and in 7 % and 6 % of 150 with these."""
    fewest_blocks: float = 12.0
    """[blocks] of all recordings together, however long the memory is. Chosen, not measured."""
    delays: tuple[float, ...] = (0.0, 0.05, 0.1, 0.2, 0.3, 0.45, 0.65, 0.9, 1.2, 1.6, 2.2, 3.0, 4.0, 5.0)
    """[s] of dead time among which the search begins; the last is the longest. Chosen, not measured."""
    time_constants: tuple[float, ...] = (0.002, 0.02, 0.06, 0.15, 0.3, 0.6, 1.2, 2.5, 5.0, 10.0)
    """[s] of lag among which the search begins; between the first, which stands for none, and the last. Chosen, not
    measured."""
    first_step: float = 0.3
    """[of the logarithm of a number, or of the usual spacing of delays] of a search's first step. Chosen, not
    measured."""
    at_end: float = 0.98
    """[of the longest] from which a dead time or a lag stands at the end of the search. Chosen, not measured."""
    slews: tuple[float, ...] = (0.5, 0.8, 1.0, 1.3)
    """[of the swiftest reports] at which the search for a rate limit begins. Chosen, not measured."""
    swift: float = 0.98
    """[1] quantile of the rates of the reports that counts as the swiftest: faults of single reports are faster.
    Chosen, not measured."""
    better: float = 0.9
    """[of the misfit without it] that a rate limit has to come below to be told. Chosen, not measured."""
    limit_told: float = 0.5
    """[of the limit] half its interval at most, for it to be told. Chosen, not measured."""
    exact: float = 1e-6
    """[of the report's variance] below which nothing is left over for a limit to explain. Chosen, not measured."""
    turned_over: float = 10.0
    """[s] over which it is judged by how many full turns a report and its command differ: long beside any lag, so that
    a step of half a turn is none. Chosen, not measured."""
    as_large: tuple[float, float] = (0.5, 1.5)
    """[of the ordered angle] between which a reported one is that of its actuator and acts in its place; in other units
    or directions it is not. Chosen, not measured."""
    pause: float = 1.0
    """[s] between reports from which on it is not known where an actuator stands, and the order acts. Chosen, not
    measured."""


@dataclass(frozen=True)
class ToldByActuatorsCriteria:
    """Comparison of what actuators report with effects that have a name (`showing.actuators`)."""

    notable: float = 0.05
    """[s] of lateness that a sentence takes for late; recorders alone make a few hundredths. Chosen, not measured."""
    explains: tuple[float, float] = (0.5, 2.0)
    """[of the lateness of the actuators] between which a named one may be theirs: a model knows one number for all
    actuators, and forces are late by more than what moves them. Chosen, not measured: poses of a ferry are told to be
    0.71 s late whose servos follow by 0.65 to 0.8 s."""
    later: float = 0.02
    """[s] by which an actuator has to follow later than before to be told, however narrow the intervals. Chosen, not
    measured."""
    weaker: float = 0.02
    """[of the gain before] by which a gain has to differ to be told, likewise. Chosen, not measured."""


FOLLOWING = FollowingCriteria()
TOLD_BY_ACTUATORS = ToldByActuatorsCriteria()
