"""All metrics of many swarms at one moment: one compiled function for live use, recordings and batches."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.study.metrics import FAMILIES, METRICS
from cocorosim_ros.study.metrics.memory import Memory
from cocorosim_ros.study.metrics.populations import fill_centres, fill_distances, fill_populations, fill_shoals
from cocorosim_ros.study.metrics.presence import fill_headings, fill_presence, fill_travel, remember
from cocorosim_ros.study.metrics.swarms import new_swarms

_measure_families = compile_lines(
    "measure_families",
    "swarms, values",
    ["column = 0", *(f"column = family_{number}(swarms, values, column)" for number in range(len(FAMILIES)))],
    {f"family_{number}": family.measure for number, family in enumerate(FAMILIES)},
)


@allocating_kernel
def _measure_swarms(
    position: Floats,
    yaw: Floats,
    present: Flags,
    elapsed_ns: Integers,
    memory: Memory,
    values: Floats,
) -> None:
    swarms = new_swarms(position, elapsed_ns, memory)
    fill_presence(swarms, yaw, present)
    fill_headings(swarms, yaw)
    fill_travel(swarms)
    fill_distances(swarms)
    fill_shoals(swarms)
    fill_populations(swarms)
    fill_centres(swarms)
    _measure_families(swarms, values)
    remember(swarms)


def measure_tick(
    position: Floats,
    yaw: Floats,
    present: Flags,
    elapsed_ns: Integers,
    memory: Memory,
    values: Floats,
) -> None:
    """Every metric of every run at this tick is in `values`, and `memory` holds this tick.

    position: (runs, robots, 3) [m; world]; yaw: (runs, robots) [rad]; present: (runs, robots), robots with
    a pose that is not finite count as absent; elapsed_ns: (runs,) time since the previous tick [ns];
    memory: of `new_memory`; values: (runs, len(METRICS)), NaN where a metric is undefined. All arrays
    C-contiguous. The values of a run depend on that run alone: one run at a time and thousands at once are
    bit-equal.
    """
    if values.shape != (yaw.shape[0], len(METRICS)) or memory.present.shape != yaw.shape:
        sizes = f"values {values.shape} and memory {memory.present.shape} do not fit yaw {yaw.shape}"
        raise ValueError(sizes)
    _measure_swarms(position, yaw, present, elapsed_ns, memory, values)
