"""Search for robots that a model does not follow: its most likely course leaves their readings by far.

The platform's file of another vehicle makes that, whatever numbers are fitted, and so do columns that are none of the
readings that they are taken for. No number and no name of such a fit means anything. The courses of right models of
real vehicles leave their readings by 7 times their noise at most.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.showing.case import Case
from cocorosim_ros.diagnosis.showing.strayed_course import Left, distances, in_words
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.world.sensors import KINDS

_OF_PLACE = ("m", "Pa")  # units of readings that tell a place


def lost_robots(case: Case) -> tuple[str, ...]:
    """Sentences on the robots that are lost on more than half of their tracks, one of each; () without any."""
    return tuple(_lost(case))


def _lost(case: Case) -> Iterator[str]:
    for robot, numbers in tracks_by_robot(case.final.tracks).items():
        hull = case.final.tracks[numbers[0]].vehicle.hull
        by_track = [[each for each in found if _is_far(each, hull)] for found in distances(case, numbers).values()]
        lost = [found for found in by_track if found]
        if 2 * len(lost) > len(numbers):
            yield (
                f"The model does not follow the readings of {robot}: its most likely course leaves {in_words(lost)}. "
                "Check that the platform's file is of this vehicle, and the units and columns of the map."
            )


def _is_far(left: Left, hull: float) -> bool:
    """Tell whether a course is farther from readings than any noise, and than the hull is long or an angle small.

    From headings that are off by more than a quarter of a turn a course takes nothing, however large their noise seems.
    """
    unit = KINDS[left.kind].unit
    if unit == "rad":
        return left.off > (HARD_STOPS.lost_angle if left.ratio > HARD_STOPS.lost else HARD_STOPS.no_heading)
    length = hull * HARD_STOPS.pascals_per_metre if unit == "Pa" else hull
    return unit in _OF_PLACE and left.ratio > HARD_STOPS.lost and left.off > length
