"""Number of shoals: connected components of the graph that joins robots within 0.5 m.

The paper gives no definition of a shoal; a robot alone counts as one here, and in the variant it does not.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.metric import READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import Swarms


@kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    shoal = swarms.shoal
    for run in range(shoal.shape[0]):
        shoals, accompanied = 0, 0
        for root in range(shoal.shape[1]):
            size = 0
            for i in range(root, shoal.shape[1]):
                size += shoal[run, i] == root
            shoals += size > 0
            accompanied += size > 1
        values[run, column] = shoals if shoals > 0 else np.nan
        values[run, column + 1] = accompanied if shoals > 0 else np.nan
    return column + 2


FAMILY = Family(
    metrics=(
        Metric(
            "shoals",
            "1",
            "number of connected components of robots within 0.5 m of each other",
            READ,
            paper=True,
        ),
        Metric("shoals_of_two", "1", "number of these components with two robots or more", READ),
    ),
    measure=_measure,
)
