"""A defect of the authors' released model: its drag is split between the plane and the vertical by a wrong root.

The drag k U^2 (U the total speed) should go against the motion. There it is split by the angle between the vertical
speed w and a horizontal "speed" whose root closes after x squared, |x| + y^2 instead of sqrt(x^2 + y^2), x and y along
the axes of the world [m/s]. A robot that moves along y while it rises has an angle near 90 degrees and hardly any
horizontal drag; along x, or at constant depth, nothing is wrong.
With `share` s: F = -k U^2 ((1 - s) v / U + s (cos(a) e, sin(a) sign(w))), a = atan2(|w|, |x| + y^2), e the direction in
the plane. Off unless a platform asks for it: no water does this.
Source: the released model run beside ours, cocorosim-facts 8, item 4; that the split is by an angle follows from
straight runs along y being right.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.moment import Moment


@kernel
def misplaced_root_drag(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take back a share of the drag against the motion, and add the same share of the drag by the wrong split."""
    (share,) = unpack(parameters, 1)
    u, v, w = relative[0], relative[1], relative[2]
    level, speed = math.sqrt(u * u + v * v), math.sqrt(u * u + v * v + w * w)
    sine, cosine = sine_cosine(row[YAW])
    x, y = u * cosine - v * sine, u * sine + v * cosine
    supposed = abs(x) + y * y
    length = math.sqrt(supposed * supposed + w * w)
    if length == 0.0:
        return
    force = share * moment.drag * speed
    along = force * (1.0 - speed * supposed / (length * level)) if level > 0.0 else 0.0
    total[0] += along * u
    total[1] += along * v
    total[2] += force * (w - speed * w / length)


MISPLACED_ROOT_DRAG = Effect(
    summary="drag of the released model, whose root closes too early",
    equation="F = -k U^2 ((1 - s) v / U + s (cos(a) e, sin(a) sign(w))), a = atan2(|w|, |x| + y^2)",
    wrench=misplaced_root_drag,
    parameters=(
        Number(
            "share",
            "1",
            "1: the defect whole, 0: none",
            sign="not negative",
            multiplies="N",  # k U^2
            gives="N",
            example=Example(1.0, "lily_released"),
        ),
    ),
)
