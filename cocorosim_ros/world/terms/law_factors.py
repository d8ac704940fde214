"""LAW_FACTORS: the part |phi_1|^power |phi_2|^power that laws outside the catalogue have, of motion and of readings."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter

LAW_FACTORS = (
    Parameter("regressor_1", "1", "code of the first regressor, in the order of terms.regressors.REGRESSORS"),
    Parameter("power_1", "1", "power of its amount", 1.0),
    Parameter("signed_1", "1", "1 if the power keeps its sign, else 0", 1.0),
    Parameter("regressor_2", "1", "code of the second regressor"),
    Parameter("power_2", "1", "power of its amount", 1.0),
    Parameter("signed_2", "1", "1 if the power keeps its sign, else 0", 1.0),
)
