"""Thresholds of a fleet: what drifts, what is alike, what is common to all (`fleet`)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class DriftCriteria:
    """Tests of numbers over the recordings of a robot (`fleet.drift`)."""

    sure: float = 0.01
    """[probability] of naming any robot of a fleet in which none drifts, by Holm's procedure over all robots and
    numbers together. Chosen, not measured; simulated fleets hold it (`test/diagnosis/fleet/test_drift.py`)."""
    fewest_recordings: int = 4
    """[recordings] of a robot with a date: fewer leave less than two degrees of freedom for their scatter. Chosen, not
    measured."""


@dataclass(frozen=True)
class LikenessCriteria:
    """Rules of groups of recordings (`fleet.alike`)."""

    apart: float = 0.01
    """[probability] that recordings of robots that do not differ fall into more than one group. Chosen, not
    measured."""
    most_compared: int = 4000
    """[recordings] whose every pair is compared; a matrix of more takes more than 64 MB. Chosen, not measured."""
    far: float = 10.0
    """[limits of likeness] between recordings with different effects: more than 1 is no group. Chosen, not measured."""


@dataclass(frozen=True)
class CommonCriteria:
    """Shares from which something is common to all (`fleet.in_common`)."""

    nearly_all: float = 0.9
    """[of the recordings, or of the robots] that share it. Chosen, not measured."""
    fewest: int = 3
    """[recordings] of which something can be common. Chosen, not measured."""


@dataclass(frozen=True)
class DateCriteria:
    """Dates of recordings (`fleet.dating`)."""

    first_ns: int = 946_684_800_000_000_000
    """[ns since 1970] the year 2000: stamps before it are of clocks that start with the machine or with the run.
    Chosen, not measured."""


@dataclass(frozen=True)
class ProcessCriteria:
    """Deaths of processes after which a recording, or the machine, is given up (`fleet.processes`)."""

    attempts: int = 2
    """[processes] that may die over one recording: the first may have met a moment without memory. Chosen, not
    measured."""
    deaths_in_a_row: int = 12
    """[processes] that die with nothing finished between them; then it is the machine. Chosen, not measured."""


@dataclass(frozen=True)
class FleetPageCriteria:
    """Room on the page of a fleet (`fleet.page`)."""

    most_pictures: int = 12
    """[numbers that drift] with a picture of their own. Chosen, not measured."""
    pictures_across: int = 3
    """[pictures] beside each other. Chosen, not measured."""
    points: int = 60
    """[points] of a line in a picture. Chosen, not measured."""
    most_robots: int = 60
    """[robots] in the picture of all drifts. Chosen, not measured."""
    most_groups: int = 40
    """[groups] in the table. Chosen, not measured."""
    most_effects: int = 40
    """[effects of one robot] in the table. Chosen, not measured."""
    most_names: int = 4
    """[names] of robots or recordings in a cell. Chosen, not measured."""
    least_chance: float = 1e-4
    """[probability] smaller ones are told as below it. Chosen, not measured."""
    most_words: int = 25
    """[words] of the headline, as of any report: more are not read at a glance. Chosen, not measured."""


DRIFT = DriftCriteria()
LIKENESS = LikenessCriteria()
COMMON = CommonCriteria()
DATE = DateCriteria()
PROCESSES = ProcessCriteria()
FLEET_PAGE = FleetPageCriteria()
