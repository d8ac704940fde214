"""Horizontal axes and directions of turning in which the streams were recorded: the fewest changes that make all agree.

Five sources can be turned or mirrored: the positions, the yaw of the poses, the compass, the gyroscope and the
commands. Each has a few candidates: with directions as complex numbers v, i^k v, or i^k conj(v) for a mirrored source.
Relations hold between any two of the five: the course follows the yaw under thrust, the compass shows the yaw, rates
have one sign. All combinations are compared by the nats by which the relations fail, plus a price for every change.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AGREEMENT, ORIENTATION
from cocorosim_ros.diagnosis.evidence.frames.agreement import (
    alignment,
    both_given,
    correlation,
    independent,
    nats_behind,
)
from cocorosim_ros.diagnosis.evidence.frames.motion import Courses, ShownMotion
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, SAME, SWAPPED, Turned
from cocorosim_ros.foundation.arrays import Floats

# Changes that conventions and mountings make, the most usual first.
USUAL_POSITIONS: tuple[Turned, ...] = (SWAPPED, Turned(1, 0), Turned(1, 2))
USUAL_ANGLES: tuple[Turned, ...] = (SWAPPED, Turned(1, 0), Turned(0, 1), Turned(0, 3), Turned(0, 2))
USUAL_POSES: tuple[Turned, ...] = (SWAPPED, Turned(1, 0))
EXCHANGED_COMMANDS = (Turned(1, 0), Turned(0, 2), Turned(1, 2))
"""Changes of commands: the yaw moment reversed, forwards and backwards exchanged, both."""


@dataclass(frozen=True)
class Orientation:
    """A change for each of the five sources; SAME and False for a source that is right.

    nats: gain of all relations together by these changes, less the price of the changes. or_commands: change of
    the commands that makes all agree as well in place of that of the one stream; SAME if none does.
    """

    position: Turned = SAME
    yaw: Turned = SAME
    compass: Turned = SAME
    gyro: bool = False
    command: Turned = SAME
    nats: float = 0.0
    or_commands: Turned = SAME


def best_orientation(motion: ShownMotion, beside: ShownMotion | None = None, *, upside_down: bool) -> Orientation:
    """The changes that make the streams agree; none if the data do not clearly ask for a change.

    beside: motion of the same robot in recordings that are right. upside_down: z was found to point down, which makes
    north-east-down poses likelier.
    """
    relations = _Relations(motion, beside)
    nothing = relations.nats(Orientation())
    if nothing < ORIENTATION.price + ORIENTATION.margin:
        return Orientation()
    best, cost = Orientation(), nothing
    for candidate in _candidates(relations):
        total = relations.nats(candidate) + ORIENTATION.price * _changes(candidate, upside_down)
        if total < cost - ORIENTATION.least_step:
            best, cost = candidate, total
    gain = nothing - cost
    if gain < ORIENTATION.margin:
        return Orientation()
    return replace(best, nats=gain, or_commands=SAME if upside_down else _commands_instead(relations, best))


def _commands_instead(relations: _Relations, best: Orientation) -> Turned:
    """Find the change of the commands that explains as much as that of a single stream; SAME if none does.

    Poses alone do not tell a mirrored world from thrusters that are exchanged.
    """
    streams = (best.position != SAME or best.yaw != SAME) + (best.compass != SAME) + best.gyro
    if streams != 1 or best.command != SAME or not relations.has_command:
        return SAME
    exchange = min(EXCHANGED_COMMANDS, key=lambda command: relations.nats(Orientation(command=command)))
    reached = relations.nats(Orientation(command=exchange)) < relations.nats(best) + ORIENTATION.margin
    return exchange if reached else SAME


def _candidates(relations: _Relations) -> Iterator[Orientation]:
    position = ALL_TURNED if relations.has_course else (SAME,)
    yaw = ALL_TURNED if relations.has_yaw else (SAME,)
    compass = ALL_TURNED if relations.has_compass else (SAME,)
    gyro = (False, True) if relations.has_gyro else (False,)
    command = (SAME, *EXCHANGED_COMMANDS) if relations.has_command else (SAME,)
    for chosen in product(position, yaw, compass, gyro, command):
        yield Orientation(*chosen)


def _changes(candidate: Orientation, upside_down: bool) -> float:
    """Sum of the prices of all changes; the unit is the price of a turned yaw."""
    price = 0.0
    if candidate.position == candidate.yaw != SAME:
        less = ORIENTATION.north_east_down if upside_down and candidate.yaw == SWAPPED else 0.0
        price += ORIENTATION.pose + _rarity(candidate.yaw, USUAL_POSES) - less
    elif SAME not in (candidate.position, candidate.yaw):
        price += ORIENTATION.both
    elif candidate.position != SAME:
        price += ORIENTATION.position + _rarity(candidate.position, USUAL_POSITIONS)
    elif candidate.yaw != SAME:
        price += ORIENTATION.yaw + _rarity(candidate.yaw, USUAL_ANGLES)
    if candidate.compass != SAME:
        price += ORIENTATION.compass + _rarity(candidate.compass, USUAL_ANGLES)
    return price + candidate.gyro * ORIENTATION.gyro + (candidate.command != SAME) * ORIENTATION.command


def _rarity(turned: Turned, usual: tuple[Turned, ...]) -> float:
    """Additional price of a change that conventions and mountings seldom make."""
    return ORIENTATION.rank * (usual.index(turned) / len(usual) if turned in usual else ORIENTATION.unusual)


class _Relations:
    """Tables of the nats by which the relations between the streams fail, for every combination of changes."""

    def __init__(self, motion: ShownMotion, beside: ShownMotion | None) -> None:
        self.has_yaw, self.has_compass = _given(motion.yaw), _given(motion.heading)
        self.has_course, self.has_gyro = _given(motion.course.real), _given(motion.gyro)
        self.has_command = _given(motion.spin)
        rates = _rates(motion)
        self._course = {
            "yaw": _course_table(motion, motion.by_yaw),
            "compass": _course_table(motion, motion.by_compass),
        }
        self._headings = _heading_table(motion)
        pairs = [(a, b) for a in rates for b in rates if a < b and {a, b} != {"yaw", "compass"}]
        self._rates = {(a, b): _rate_table(rates[a], rates[b], motion.weight) for a, b in pairs}
        if beside is not None:
            for name, known in _rates(beside).items():
                if name != "command":
                    elsewhere = _Turning(beside.spin, known)
                    self._rates["command", name] += elsewhere.table(motion.spin, rates[name], motion.weight)

    def nats(self, turned: Orientation) -> float:
        """Nats by which the relations fail under these changes, each against its own best combination."""
        total = 0.0
        for name, angle in (("yaw", turned.yaw), ("compass", turned.compass)):
            table = self._course[name]
            place = (turned.position.mirrored, angle.mirrored, turned.command.mirrored, self._quarter(turned, angle))
            total += table[place]
        quarter = (turned.yaw.quarters - turned.compass.quarters) % 4
        total += self._headings[turned.yaw.mirrored, turned.compass.mirrored, quarter]
        mirrored = {"yaw": turned.yaw.mirrored, "compass": turned.compass.mirrored, "gyro": int(turned.gyro)}
        mirrored["command"] = turned.command.mirrored
        for (a, b), table in self._rates.items():
            total += table[(mirrored[a] + mirrored[b]) % 2]
        return float(total)

    def _quarter(self, turned: Orientation, angle: Turned) -> int:
        return (turned.position.quarters - angle.quarters - turned.command.quarters) % 4


def _given(values: Floats) -> bool:
    return bool(np.isfinite(values).any())


def _course_table(motion: ShownMotion, expected: Courses) -> Floats:
    """Nats (2, 2, 2, 4) by mirrored course, mirrored angle, mirrored commands, and quarter turns between them.

    The quarter turns are those of the course against angle and commands. Under a mirrored angle the expected course is
    the mirror image of the course with left and right exchanged. Of a hull that slips and one that is led, the one
    counts that fits better: a vehicle that is led, in a turn, is a quarter ahead of one that slips.
    """
    scores = np.zeros((2, 2, 2, 4))
    for course, heading, command in product((0, 1), repeat=3):
        left = np.conj(motion.course) if course else motion.course
        of_hulls = [
            correlation(left, np.conj(right) if heading else right)
            for right in expected.under(1 - command if heading else command)
        ]
        scores[course, heading, command] = [
            max((found * 1j**quarter).real for found in of_hulls) for quarter in range(4)
        ]
    count = independent(motion.course, expected.commanded, motion.weight)
    return nats_behind(np.square(np.maximum(scores, 0.0)), float(scores.max(initial=0.0)) ** 2, count)


def _heading_table(motion: ShownMotion) -> Floats:
    """Nats (2, 2, 4) by mirrored yaw, mirrored compass, and quarter turns of the yaw against the compass."""
    scores = np.zeros((2, 2, 4))
    for yaw, compass in product((0, 1), repeat=2):
        found = alignment(-motion.yaw if yaw else motion.yaw, -motion.heading if compass else motion.heading)
        scores[yaw, compass] = [(found * 1j**quarter).real for quarter in range(4)]
    return nats_behind(scores, float(scores.max()), independent(motion.yaw, motion.heading, motion.weight))


def _rates(motion: ShownMotion) -> dict[str, Floats]:
    """Rates (n,) at which each source says that the robot turns."""
    return {"yaw": motion.turn, "compass": motion.swing, "gyro": motion.gyro, "command": motion.spin}


class _Turning(NamedTuple):
    """Turning of a stream under commands, in recordings that are right: expected spins (n,) and its rates (n,).

    Where a robot is commanded the same throughout each recording, the correlation of two rates, without their means,
    shows no sign; how it turned elsewhere does.
    """

    spin: Floats
    rate: Floats

    def table(self, spin: Floats, rate: Floats, weight: float) -> Floats:
        """Nats (2,) by which rates as they are, and of the other sign, fail to turn as elsewhere."""
        given = both_given(self.spin, self.rate)
        seen = both_given(spin, rate)
        count = independent(spin, rate, weight)
        if min(float(given.sum()), count) < AGREEMENT.fewest:
            return np.zeros(2)
        known = np.column_stack([np.ones(int(given.sum())), self.spin[given]])
        rest, per_spin = np.linalg.lstsq(known, self.rate[given], rcond=None)[0]
        expected = rest + per_spin * spin[seen]
        left: Floats = np.array([np.mean((sign * rate[seen] - expected) ** 2) for sign in (1.0, -1.0)])
        least = max(float(left.min()), AGREEMENT.finest * float(left.max()))
        return np.asarray(0.5 * count * np.log(np.maximum(left, least) / least)) if least > 0.0 else np.zeros(2)


def _rate_table(left: Floats, right: Floats, weight: float) -> Floats:
    """Nats (2,) for equal and for opposite signs of two rates."""
    found = correlation(left, right).real
    scores = np.array([found, -found])
    return nats_behind(np.square(np.maximum(scores, 0.0)), found**2, independent(left, right, weight))
