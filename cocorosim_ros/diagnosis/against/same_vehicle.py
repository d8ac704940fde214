"""Signs that recordings are not of the vehicle that they are compared with, before anything is fitted.

Commands name the actuators of a vehicle. A recording of the simulator has the scenario that it was made from, and with
it hull, mass and actuators of its robots; those of real vehicles say nothing of the kind, and are asked for how hard
they were driven too. Rates of readings are a setting of the recorder, and say nothing of the vehicle.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.against import SAME_VEHICLE
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.checks.loading import parse_scenario


class MadeOf(NamedTuple):
    """A recording, and the platform that one of its robots had in the scenario that it was made from."""

    origin: str
    platform: Platform


def check_same_vehicle(bad: Evidence, good: Evidence, pairs: Mapping[str, str]) -> None:
    """Raise CocorosimError where recordings say themselves that they are of another vehicle, or of another use of it.

    pairs: by the name of each robot to be judged, the name that it had in the recordings that it is compared with, and
    has in their scenarios still.
    """
    judged, before = _made_of(bad), _made_of(good)
    for mine, theirs in pairs.items():
        for here, there in itertools.product(judged.get(mine, ()), before.get(theirs, ())):
            if _is_another(here.platform, there.platform):
                raise CocorosimError(
                    f"--against has {there.origin}, made with {_in_words(there.platform)} as {theirs}, and "
                    f"{here.origin} was made with {_in_words(here.platform)} as {mine}; give recordings of the same "
                    "vehicle."
                )
        _check_actuators(_commanded(bad, mine), _commanded(good, mine))
    _check_commands(bad, good)


def _made_of(evidence: Evidence) -> dict[str, list[MadeOf]]:
    """List by name what each robot was in the scenarios of its recordings; one that cannot be read says nothing."""
    found: dict[str, list[MadeOf]] = {}
    for recording in evidence.recordings:
        for name, platform in _platforms(recording.made_from, recording.origin):
            found.setdefault(name, []).append(MadeOf(recording.origin, platform))
    return found


def _platforms(scenario: str, origin: str) -> Iterator[tuple[str, Platform]]:
    if not scenario:
        return
    try:
        robots = parse_scenario(scenario, origin).robots
    except CocorosimError:  # of another version, or damaged
        return
    for robot in robots:
        yield robot.name, robot.platform


def _is_another(one: Platform, other: Platform) -> bool:
    sizes = zip(_sizes(one), _sizes(other), strict=True)
    return _both_lack(one.actuator_names, other.actuator_names) or any(
        max(pair) > SAME_VEHICLE.declared_ratio * min(pair) for pair in sizes
    )


def _both_lack(these: Collection[str], those: Collection[str]) -> bool:
    """Tell whether each of two sets of actuators has one that the other lacks; one alone may have lost some."""
    return bool(set(these) - set(those)) and bool(set(those) - set(these))


def _sizes(platform: Platform) -> tuple[float, ...]:
    hull = platform.hull
    return hull.length, hull.width, hull.height, platform.mass


def _in_words(platform: Platform) -> str:
    *sides, mass = _sizes(platform)
    size = f"{' x '.join(f'{side:g}' for side in sides)} m, {mass:g} kg"
    return f"'{platform.name}' ({size}, actuators {', '.join(platform.actuator_names)})"


def _commanded(evidence: Evidence, name: str) -> dict[str, None]:
    """Names of the actuators that a robot's commands name in any of its recordings, in their order."""
    logs = [log for recording in evidence.recordings for log in recording.robots if log.name == name]
    return dict.fromkeys(each for log in logs for each in log.commanded)


def _check_actuators(mine: Collection[str], theirs: Collection[str]) -> None:
    if _both_lack(mine, theirs):
        raise CocorosimError(
            f"--against has commands of the actuators {', '.join(theirs)}, and the recordings to be judged of "
            f"{', '.join(mine)}; give recordings of the same vehicle, or name the same actuators alike in both."
        )


def _check_commands(bad: Evidence, good: Evidence) -> None:
    mine, theirs = _command_size(bad), _command_size(good)
    low, high = sorted((mine, theirs))
    if high > SAME_VEHICLE.command_ratio * low > 0.0:
        raise CocorosimError(
            f"--against has commands up to {theirs:.3g} of full, and the recordings to be judged up to {mine:.3g} "
            f"({SAME_VEHICLE.command_quantile:.0%} are below); give recordings of the same vehicle in similar use."
        )


def _command_size(evidence: Evidence) -> float:
    """Amount of the strongest actuator's command that few commands exceed; of all recordings together."""
    rows = [log.command for recording in evidence.recordings for log in recording.robots if len(log.command)]
    if not rows:
        return 0.0
    commands = np.abs(np.concatenate(rows))
    return float(np.nanquantile(commands, SAME_VEHICLE.command_quantile, axis=0).max())
