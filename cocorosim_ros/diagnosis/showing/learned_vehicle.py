"""Signs that the vehicle was not well: the hard stops, asked of the recordings that others are compared with.

What differs from a vehicle that was not well, or that the platform's file does not fit, says little of either: its name
stays, and is not sure.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.against.halves import Changed
from cocorosim_ros.diagnosis.evidence.intake import Intake
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.unseen import whole_tracks
from cocorosim_ros.diagnosis.showing.case import Case, Objection, Stop
from cocorosim_ros.diagnosis.showing.coloured_innovations import coloured_at_once, coloured_innovations
from cocorosim_ros.diagnosis.showing.framing import unexplained
from cocorosim_ros.diagnosis.showing.hard_stops import STOPS
from cocorosim_ros.diagnosis.showing.strayed_course import strayed_course, strayed_mostly
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot


def coloured_together(case: Case) -> Iterator[Objection]:
    """Object to predictions that err not at random on all tracks of a robot together.

    These are parts that recordings were cut into: of many short ones, one errs to one side by chance.
    """
    for robot, numbers in tracks_by_robot(case.final.tracks).items():
        passes = [case.final.passes[number] for number in numbers]
        yield from coloured_at_once(robot, [case.final.tracks[number] for number in numbers], passes)


_IN_ALL: Mapping[Stop, Stop] = {coloured_innovations: coloured_together, strayed_course: strayed_mostly}
OF_LEARNED = tuple(_IN_ALL.get(stop, stop) for stop in STOPS)
"""Stops that are asked of a learned vehicle: those that look at single tracks ask all, or most, tracks of a robot."""


def objection_to_learned(learned: Fit, well: Intake, changed: Sequence[Changed]) -> tuple[Objection, ...]:
    """One objection to a learned vehicle, with the first sentence of each stop that objects; () if none does.

    well: the recordings that it was learned from. changed: numbers that are others in their second half. Its effects
    have no names, so that stops against single effects have nothing to object to.
    """
    table = held_out_free_runs(whole_tracks(learned), learned).table
    case = replace(case_of_learned(learned), table=table)
    return in_one([_of_halves(changed), unexplained(well), *(tuple(stop(case)) for stop in OF_LEARNED)])


def case_of_learned(learned: Fit) -> Case:
    """Make a case of a learned vehicle, without free runs."""
    return Case(learned, (), (), smoothed_tracks(learned), {})


def _of_halves(changed: Sequence[Changed]) -> tuple[Objection, ...]:
    return tuple(
        Objection(
            f"The {each.name} of {each.robot} in their second half is {each.factor:.2g} times that in their first.",
            (each.robot,),
        )
        for each in changed
    )


def in_one(by_stop: Sequence[Sequence[Objection]]) -> tuple[Objection, ...]:
    """One objection for those of several stops, which concerns all their robots; () without any."""
    every = [each for of_stop in by_stop for each in of_stop]
    if not every:
        return ()
    of_all = any(not each.robots for each in every)
    robots = () if of_all else tuple(dict.fromkeys(name for each in every for name in each.robots))
    told = "; ".join(_as_clause(of_stop[0].sentence) for of_stop in by_stop if of_stop)
    return (
        Objection(
            "The recordings of --against are not those of a well vehicle, or the platform's file does not fit them: "
            f"{told}; diagnose them by themselves first.",
            robots,
        ),
    )


def _as_clause(sentence: str) -> str:
    return sentence[0].lower() + sentence[1:].rstrip(".")
