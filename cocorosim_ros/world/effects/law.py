"""A law that no catalogue has: force or moment on one equation = coefficient phi_1 phi_2 with powers of regressors.

The form in which `unknown:<equation>~<regressor>` is simulated (terms.law turns text into these numbers and back). The
equation and the regressors are codes (terms.equations, terms.regressors); a power is |phi|^power, or
sign(phi) |phi|^power where `signed` is one. Where a regressor is infinite (no neighbour anywhere) the law is nothing. A
power below one is steep at zero, as dry friction is; below the amount `round_1` of its regressor it is rounded off,
lest forces change their sign at every step.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.equations import EQUATION_CODE
from cocorosim_ros.world.terms.law_factors import LAW_FACTORS
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.regressors import REGRESSOR_COUNT, fill_regressors

HEAVE, WORLD_X, WORLD_Z = EQUATION_CODE["heave"], EQUATION_CODE["world_x"], EQUATION_CODE["world_z"]


@kernel
def _power(value: float, power: float, signed: float, rounding: float) -> float:
    """|value|^power, with the sign of value if `signed`; the first power of a small value where it is below one."""
    if power < 1.0 and rounding > 0.0:
        size = math.sqrt(value * value + rounding * rounding)
        return value * size ** (power - 1.0) if signed != 0.0 else size**power  # type: ignore[no-any-return]
    size = abs(value) if power == 1.0 else abs(value) ** power
    return -size if signed != 0.0 and value < 0.0 else size


@kernel
def law(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add coefficient phi_1 phi_2 to its equation."""
    (
        coefficient,
        equation,
        regressor_1,
        power_1,
        signed_1,
        regressor_2,
        power_2,
        signed_2,
        omega,
        phase,
        round_1,
    ) = unpack(parameters, 11)
    values = stack_array(REGRESSOR_COUNT)
    fill_regressors(row, relative, moment, omega * moment.time + phase, values)
    first = _power(values[int(regressor_1)], power_1, signed_1, round_1)
    second = _power(values[int(regressor_2)], power_2, signed_2, 0.0)
    force, code = coefficient * first * second, int(equation)
    if not math.isfinite(force):
        return
    if code < WORLD_X:
        total[code] += force
    elif code == WORLD_Z:
        total[HEAVE] += force
    else:
        sine, cosine = sine_cosine(row[YAW])
        total[0] += force * (cosine if code == WORLD_X else sine)
        total[1] += force * (-sine if code == WORLD_X else cosine)


LAW = Effect(
    summary="a law that no catalogue has, found in a recording",
    wrench=law,
    parameters=(
        Parameter("coefficient", "*", "in N or N m over the units of the regressors"),
        Parameter("equation", "1", "code of the equation, in the order of terms.equations.EQUATIONS"),
        *LAW_FACTORS,
        Parameter("omega", "rad/s", "of sin_t and cos_t"),
        Parameter("phase", "rad", "of sin_t and cos_t"),
        Parameter("round_1", "1", "amount of the first regressor, SI units, below which a power under one is rounded"),
    ),
)
