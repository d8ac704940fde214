"""Laws of readings outside the catalogue: the errors that they add to each reading along a robot's smoothed course.

The regressors of such a law, place or speed, are known far better than its effect, because the camera sees them. So
they are taken from the smoothed course as given, and the filter itself knows nothing of such laws.
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
    """Copy a row (columns,) with the numbers of all laws of readings at their neutral values."""
    plain = row.copy()
    chosen = [COLUMN[name] for name in READING_LAWS]
    plain[chosen] = NEUTRAL[chosen]
    return plain


def law_shift(row: Floats, readings: Readings, course: Callable[[], Course]) -> Floats | None:
    """Errors (m,) that the laws in `row` add to the readings, in the order and units of these; None without laws.

    course: returns the quantities along the smoothed course; called once, and only if there is a law.
    """
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
    """Decode a factor of a law from the three numbers by which a row holds it."""
    return Factor(REGRESSORS[int(code)].name, power, signed != 0.0)


def factor_at(seen: Course, at: Floats, factor: Factor) -> Floats:
    """Values (n,) of one factor of a law of readings at moments `at` (n,) [s] within the course, SI units."""
    if factor.name == "t":
        return factor.of(at)
    regressor = REGRESSOR[factor.name]
    along = regressor.along if factor.signed or regressor.effort is None else regressor.effort
    # The force of an actuator is a mean from each grid point to the next, and belongs to the middle between them.
    late = 0.5 * (seen.time[1] - seen.time[0]) if regressor.from_actuators else 0.0
    return factor.of(np.interp(at, seen.time + late, along(seen, np.zeros(len(seen.time)))))
