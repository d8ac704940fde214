"""The hard stops look at the recordings of --against too, and say in one sentence what speaks against these."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.comparable import in_parts
from cocorosim_ros.diagnosis.against.halves import Changed
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.diagnosis.showing.learned_vehicle import (
    coloured_together,
    in_one,
    objection_to_learned,
)
from cocorosim_ros.diagnosis.showing.strayed_course import strayed_course, strayed_mostly

BEGIN = "The recordings of --against are not those of a well vehicle, or the platform's file does not fit them: "
END = "; diagnose them by themselves first."


KNOWN = """
drag_form: own_speed
effects:
  anisotropic_drag: {sway_ratio: {value: 2, unit: "1", range: RANGE, source: made}}
  linear_drag: {yaw: {value: 0.3, unit: N m s, source: made}}
  thruster_lag: {time_constant: {value: 0.35, unit: s, source: made}}
"""


@pytest.fixture
def driven(tmp_path: Path) -> Callable[..., Any]:
    """Function of the range of a boat's drag sideways over that ahead, which is 3: a drive of 60 s."""
    return lambda limits="[1, 6]": boats.recorded(
        boats.platform(tmp_path, KNOWN.replace("RANGE", limits)), boats.Truth(), 60.0, 3
    )


def objections(evidence: Any, *mixups: Mixup, changed: tuple[Changed, ...] = ()) -> Any:
    """What is said of the vehicle that is fitted to recordings."""
    return objection_to_learned(settled(first_fit(evidence), 10), Intake(evidence, mixups, ()), changed)


def test_nothing_is_said_of_a_well_vehicle(driven: Callable[..., Any]) -> None:
    """Its numbers are within the ranges of the file, and it follows its readings."""
    assert objections(driven()) == ()


def test_a_number_that_leaves_the_range_of_the_file_is_said(driven: Callable[..., Any]) -> None:
    """A ratio of 3 is fitted at the end of a range up to 2.5."""
    (found,) = objections(driven("[1, 2.5]"))
    assert re.match(
        rf"{BEGIN}the fit of sway ratio of \S+ drag of boat stands at the end of its range, 2\.50;", found.sentence
    )
    assert found.sentence.endswith(END)
    assert (found.robots, found.effect) == (("boat",), None)


def test_repeated_readings_and_contradictory_streams_are_said(driven: Callable[..., Any]) -> None:
    """Both in one sentence, a clause each."""
    evidence = driven()
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {"pose": replace(log.streams["pose"], filled_in=("x", "y"))}
    repeated = replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))
    hopeless = FrameCorrection("imu", "it is no rate of the yaw", "they were compared", 50.0, None, np.zeros(4))
    (found,) = objections(repeated, Mixup(("boat",), hopeless))
    first, second, *_ = found.sentence.removeprefix(BEGIN).removesuffix(END).split("; many readings ")
    assert first.startswith("the imu of boat contradicts other readings (it is no rate of the yaw)")
    assert second.startswith("of x, y of boat/pose were interpolated or repeated")


def test_a_number_that_is_another_one_in_the_second_half_is_said(driven: Callable[..., Any]) -> None:
    """By its name and the factor."""
    (found,) = objections(driven(), changed=(Changed("boat", "thrust of left", 0.512),))
    told = "the thrust of left of boat in their second half is 0.51 times that in their first"
    assert (found.sentence, found.robots) == (f"{BEGIN}{told}{END}", ("boat",))


@pytest.mark.parametrize(("away", "said"), [((0,), 0), ((0, 2), 1)])
def test_a_course_that_leaves_most_parts_is_said(driven: Callable[..., Any], away: tuple[int, ...], said: int) -> None:
    """Two parts of three whose smoothed course is 10 cm off readings that are exact to 5 mm; a single one is not."""
    fit = settled(first_fit(in_parts(driven())), 3)
    courses = list(smoothed_tracks(fit))
    for number in away:
        courses[number] = replace(courses[number], mean=courses[number].mean + 0.1)
    found = list(strayed_mostly(Case(fit, (), (), courses, {})))
    assert len(found) == said
    told = "in 2 of its 3 recordings, at most: the pose along x by 10"
    assert all(told in each.sentence and " mm, " in each.sentence for each in found)
    (every,) = strayed_course(Case(fit, (), (), courses, {}))  # one sentence for all recordings of a robot
    assert f"in {len(away)} of its 3 recordings" in every.sentence


def test_predictions_are_weighed_in_all_parts_together(driven: Callable[..., Any]) -> None:
    """Innovations that err to one side in a third of the parts have a third of the correlation; in all, all of it."""
    fit = settled(first_fit(in_parts(driven())), 3)

    def said(count: int) -> int:
        slow = replace(fit, passes=tuple(map(one_sided, fit.tracks[:count], fit.passes)) + fit.passes[count:])
        return len(list(coloured_together(Case(slow, (), (), (), {}))))

    def one_sided(track: Any, passed: Any) -> Any:
        first = track.timeline.kind == track.timeline.kind[0]
        slow = np.sin(np.arange(np.count_nonzero(first)) / 10.0)
        innovation = passed.innovation.copy()
        innovation[first] = slow * np.sqrt(passed.variance[first])
        return replace(passed, innovation=innovation)

    assert [said(count) for count in (0, 1, 3)] == [0, 0, 1]


def test_one_sentence_has_the_first_of_each_stop_and_all_their_robots() -> None:
    """Of parts of a recording the same stop says the same again; what concerns all robots does so still."""
    strayed = (Objection("The course of a leaves.", ("a",)), Objection("The course of b leaves.", ("b",)))
    coloured = (Objection("What is foretold of a errs.", ("a",)),)
    (found,) = in_one((strayed, coloured))
    assert found == Objection(f"{BEGIN}the course of a leaves; what is foretold of a errs{END}", ("a", "b"))
    (found,) = in_one((coloured, (Objection("The fit has collapsed."),)))
    assert found.robots == ()
    assert in_one(()) == ()
