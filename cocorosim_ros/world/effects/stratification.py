"""A layer of density: below it the buoyancy differs by a force, above it does not.

The step is a cubic within 0.02 m above and below the layer, for water mixes and the hull has a height.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment

HALF_WIDTH = 0.02  # m


@kernel
def stratification(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force of the water below the layer."""
    share = (-row[Z] - parameters[0] + HALF_WIDTH) / (2.0 * HALF_WIDTH)
    share = min(max(share, 0.0), 1.0)
    total[2] += parameters[1] * share * share * (3.0 - 2.0 * share)


STRATIFICATION = Effect(
    summary="buoyancy that steps at a layer of density",
    wrench=stratification,
    parameters=(
        Parameter("depth", "m", "of the layer, positive down", 0.0, needed=True),
        Parameter("force", "N", "below against above, up positive"),
    ),
)
