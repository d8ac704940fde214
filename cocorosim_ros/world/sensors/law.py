"""SENSOR_LAWS: places for laws of readings that no catalogue has: reading less truth = coefficient phi_1 phi_2.

The form in which `unknown:<topic>~<regressor>` stands in a platform file. The reading and the regressors are codes
(laws.readings, terms.regressors); powers are as in effects.law, but `thrust` without its sign is what all
thrusters deliver, each by its own amount: what their motors draw. A diagnosis knows these laws; a simulation has none.
"""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.terms.law_factors import LAW_FACTORS
from cocorosim_ros.world.terms.regressors import REGRESSORS

NO_REGRESSORS_OF_READINGS = tuple(regressor.name for regressor in REGRESSORS if not regressor.from_own_course)
LAW_OF_READING = (
    Parameter("coefficient", "*", "in the unit of the reading over the units of the regressors"),
    Parameter("reading", "1", "code of the reading, in the order of laws.readings.READINGS"),
    *LAW_FACTORS,
)
SENSOR_LAWS: dict[str, tuple[Parameter, ...]] = {"sensor_law_1": LAW_OF_READING, "sensor_law_2": LAW_OF_READING}
