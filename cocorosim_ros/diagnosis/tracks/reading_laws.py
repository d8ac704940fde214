"""Laws of readings that no catalogue has: what they add to each reading along the course that a robot has swum.

What a law depends on is known far better than what the law does, because the camera sees it: it is taken from the
smoothed course as given, so that the filter has nothing to know of such laws.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.filter.records import Readings
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL, READING_LAWS
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.laws.law import Factor
from cocorosim_ros.world.laws.readings import READINGS
from cocorosim_ros.world.sensors.law import LAW_OF_READING, SENSOR_LAWS
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.regressors import REGRESSOR, REGRESSORS

_PARTS = len(LAW_OF_READING)
_FIRST = tuple(COLUMN[f"{place}.coefficient"] for place in SENSOR_LAWS)
_KIND = np.array([KIND_NAMES.index(reading.name) for reading in READINGS])


def without_laws(row: Floats) -> Floats:
    """The numbers of a model that has no laws of readings."""
    plain = row.copy()
    chosen = [COLUMN[name] for name in READING_LAWS]
    plain[chosen] = NEUTRAL[chosen]
    return plain


def law_shift(row: Floats, readings: Readings, course: Callable[[], Course]) -> Floats | None:
    """(m,) what the laws in `row` add to the readings, in their order; None if it has none. `course` is asked once."""
    laws = [row[first : first + _PARTS] for first in _FIRST if row[first] != 0.0]
    if not laws:
        return None
    seen = course()
    point = np.repeat(np.arange(len(readings.first) - 1), np.diff(readings.first))
    moment = readings.begin + point * readings.step + readings.after
    shift = np.zeros(len(moment))
    for coefficient, kind, *factors in laws:
        chosen = readings.kind == _KIND[int(kind)]
        at = np.clip(moment[chosen], seen.time[0], seen.time[-1])
        law = coefficient * factor_at(seen, at, _factor(*factors[:3])) * factor_at(seen, at, _factor(*factors[3:]))
        shift[chosen] += np.where(np.isfinite(law), law, 0.0)
    return shift


def _factor(code: float, power: float, signed: float) -> Factor:
    """The factor that a model's row says by numbers."""
    return Factor(REGRESSORS[int(code)].name, power, signed != 0.0)


def factor_at(seen: Course, at: Floats, factor: Factor) -> Floats:
    """One factor of a law of readings at these moments [s], which lie within the course."""
    if factor.name == "t":
        return factor.of(at)
    regressor = REGRESSOR[factor.name]
    along = regressor.along if factor.signed or regressor.effort is None else regressor.effort
    # What actuators deliver is a mean from each grid point to the next.
    late = 0.5 * (seen.time[1] - seen.time[0]) if regressor.from_actuators else 0.0
    return factor.of(np.interp(at, seen.time + late, along(seen, np.zeros(len(seen.time)))))
