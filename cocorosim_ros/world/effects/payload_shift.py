"""Weight that is lost or gained at a moment: a force upwards from then on."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def payload_shift(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force from its time on."""
    if moment.time >= parameters[0]:
        total[2] += parameters[1]


PAYLOAD_SHIFT = Effect(
    summary="weight that jumps at a moment",
    wrench=payload_shift,
    parameters=(
        Parameter("time", "s", "when it jumps, from the start", 0.0, needed=True),
        Parameter("force", "N", "from then on, up positive"),
    ),
)
