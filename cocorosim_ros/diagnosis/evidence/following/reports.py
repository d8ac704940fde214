"""Reports of actuators, told against their commands: gain, dead time, lag, or why nothing is told."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.following import FOLLOWING
from cocorosim_ros.diagnosis.evidence.following.interval import Spread, spread_of
from cocorosim_ros.diagnosis.evidence.following.misfit import Following
from cocorosim_ros.diagnosis.evidence.following.search import (
    DEAD_TIME,
    GAIN,
    RATE,
    TIME_CONSTANT,
    best_lateness,
    best_limited,
)
from cocorosim_ros.diagnosis.evidence.following.stretches import Stretch, command_scale, full_turn, stretches_of
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RobotLog
from cocorosim_ros.diagnosis.findings import ActuatorReport, Estimate
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator
from cocorosim_ros.wire.topics.actuator_feedback import OF_COMMAND, QUANTITIES


def actuator_reports(evidence: Evidence, quantities: Iterable[str] = QUANTITIES) -> tuple[ActuatorReport, ...]:
    """Tell how each number that an actuator reports follows its commands, in all recordings of a robot together.

    In the order of robots, of the platform's actuators and of `quantities`; () without any report.
    """
    logs = [log for recording in evidence.recordings for log in recording.robots if log.feedback]
    return tuple(
        report
        for robot in sorted({log.name for log in logs})
        for column, actuator in enumerate(evidence.platform.actuators)
        for quantity in quantities
        for report in _of_actuator([log for log in logs if log.name == robot], column, actuator, quantity)
    )


def _of_actuator(logs: Sequence[RobotLog], column: int, actuator: Actuator, quantity: str) -> Iterator[ActuatorReport]:
    """Tell it of one actuator and quantity; nothing where no log holds it."""
    given = [(log, each) for log in logs for each in log.feedback
             if (each.actuator, each.quantity) == (actuator.name, quantity)]  # fmt: skip
    if given:
        stretches = tuple(part for log, each in given for part in stretches_of(log, column, actuator, each))
        yield _told(ActuatorReport(logs[0].name, actuator.name, quantity), stretches, actuator)


def _told(blank: ActuatorReport, stretches: tuple[Stretch, ...], actuator: Actuator) -> ActuatorReport:
    """Fill a report in: how it follows, or why that is not told."""
    scale, turn = command_scale(actuator, blank.quantity), full_turn(actuator, blank.quantity)
    if because := _too_little(stretches, scale or 1.0):
        return replace(blank, because=because)
    following, lateness = _best(stretches, blank.quantity, turns=turn is not None)
    spread = spread_of(following, lateness)
    if because := _not_told(following, lateness, spread):
        return replace(blank, because=because)
    unit = "1" if scale is not None else QUANTITIES[blank.quantity].unit
    numbers = _numbers(following, lateness, spread, unit)
    if turn is not None and np.isfinite(lateness[RATE]):
        numbers["rate_limit"] = _rate_limit(abs(numbers["gain"].value), lateness[RATE], spread, 2.0 * math.pi / turn)
    return replace(blank, numbers=numbers, of_amount=following.of_amount)


def _too_little(stretches: Sequence[Stretch], scale: float) -> str:
    """Say why these stretches cannot tell anything, whatever the fit; empty if they may."""
    count = sum(int(np.count_nonzero(each.settled)) for each in stretches)
    if count < FOLLOWING.fewest:
        return f"it has {count} reports beside its commands, and {FOLLOWING.fewest} are needed"
    command = np.concatenate([each.command for each in stretches])
    if np.ptp(command) < FOLLOWING.moved * scale:
        return "its command hardly changes"
    reported = np.concatenate([each.reported[each.settled] for each in stretches])
    return "" if np.ptp(reported) > 0.0 else "what it reports never changes, though its command does"


def _best(stretches: tuple[Stretch, ...], quantity: str, *, turns: bool) -> tuple[Following, Floats]:
    """The following with the least misfit, and its lateness (3,); an angle may turn at a limited rate."""
    options = [Following(stretches)]
    if quantity not in OF_COMMAND:
        options.append(Following(stretches, of_amount=True))
    solved = [(each, best_lateness(each)) for each in options]
    following, lateness = min(solved, key=lambda each: each[0].line(each[1]).misfit)
    misfit = following.line(lateness).misfit
    if turns and misfit > FOLLOWING.exact * _variation(following):
        limited = best_limited(following, lateness)
        if following.line(limited).misfit < FOLLOWING.better * misfit:
            spread = spread_of(following, limited)
            if spread.half_width(_weights(RATE), spread.changes) < FOLLOWING.limit_told * limited[RATE]:
                return following, limited
    return following, lateness


def _variation(following: Following) -> float:
    """The sum of the squares of the reports, less their mean."""
    reported = following.reported
    return float(((reported - reported.mean()) ** 2).sum())


def _not_told(following: Following, lateness: Floats, spread: Spread) -> str:
    """Say why a solution tells nothing; empty if it does."""
    if spread.changes < FOLLOWING.changes:
        return "its command changes too seldom to tell by when it follows"
    share = 1.0 - following.line(lateness).misfit / _variation(following)
    if share < FOLLOWING.follows:
        return f"it does not follow its command, which explains {max(share, 0.0):.0%} of what it reports"
    longest = FOLLOWING.delays[-1], FOLLOWING.time_constants[-1]
    if lateness[DEAD_TIME] > FOLLOWING.at_end * longest[0] or lateness[TIME_CONSTANT] > FOLLOWING.at_end * longest[1]:
        return f"it follows by more than a dead time of {longest[0]:g} s and a lag of {longest[1]:g} s"
    return ""


def _numbers(following: Following, lateness: Floats, spread: Spread, unit: str) -> dict[str, Estimate]:
    """The numbers of a solution with their intervals."""
    gain = following.line(lateness).gain
    delay, time_constant = lateness[[DEAD_TIME, TIME_CONSTANT]].tolist()

    def time(value: float, weights: Floats) -> Estimate:
        return _estimate(value, spread.half_width(weights, spread.changes), "s")

    return {
        "gain": _estimate(gain, spread.half_width(_weights(GAIN), spread.levels), unit, least=-np.inf),
        "delay": time(delay, _weights(DEAD_TIME)),
        "time_constant": time(time_constant, _weights(TIME_CONSTANT)),
        "lateness": time(delay + time_constant, _weights(DEAD_TIME) + _weights(TIME_CONSTANT)),
    }


def _rate_limit(gain: float, rate: float, spread: Spread, radians: float) -> Estimate:
    """The limit of an angle's rate [rad/s]; radians: of one unit of the report."""
    width = spread.half_width(gain * _weights(RATE) + rate * _weights(GAIN), spread.changes)
    return _estimate(radians * gain * rate, radians * width, "rad/s")


def _estimate(value: float, half_width: float, unit: str, least: float = 0.0) -> Estimate:
    return Estimate(value, max(value - half_width, least), value + half_width, unit)


def _weights(place: int) -> Floats:
    return np.asarray(np.eye(GAIN + 1)[place])
