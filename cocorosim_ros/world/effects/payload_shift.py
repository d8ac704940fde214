"""Weight that is lost or gained at a moment: a force upwards from then on."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import WEIGHT
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength, spread


@kernel
def payload_shift(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force from its time on."""
    time, force = unpack(parameters, 2)
    if moment.time >= time:
        total[2] += force


def _times(scene: Scene) -> list[float]:
    return sorted({*spread(0.03 * scene.duration, 0.97 * scene.duration, 24), *scene.changes})


PAYLOAD_SHIFT = Effect(
    summary="trim that jumps",
    equation="Z steps by force at a moment",
    wrench=payload_shift,
    parameters=(
        Number(
            "time",
            "s",
            "when it jumps, from the start",
            needed=True,
            gives="s",
            search=Grid(_times, once=True),
            example=Example(120.0, "when the coin falls"),
        ),
        Number(
            "force",
            "N",
            "from then on, up positive",
            gives="N",
            search=Strength(large=1e-3),
            example=Example(1e-3, "the coin"),
        ),
    ),
    search=Search(channel="heave", group=WEIGHT, manoeuvre="depth_staircase"),
    check="What came loose, leaked or was added at that moment.",
)
