"""Where the puffs of a scenario's plume are while a run goes on; they depend on no robot."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Integers
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.scene.scene import DriftingPlume
from cocorosim_ros.world.tick.assembly import build_tank
from cocorosim_ros.world.tick.water import Ticking, advance_puffs
from cocorosim_ros.world.water.current_numbers import scenario_currents
from cocorosim_ros.world.water.flow import make_flow
from cocorosim_ros.world.water.plume import no_puffs

_MOST_MOMENTS = 200


def drifting_plume(scenario: Scenario | None, stamp_ns: Integers) -> DriftingPlume | None:
    """The plume at the ends of some of the ticks until the last of the moments (t,) [ns]; None without a plume.

    Moments count from the start of the run.
    """
    if scenario is None or scenario.water is None or scenario.water.plume is None or not stamp_ns.size:
        return None
    plume, tank = scenario.water.plume, build_tank(scenario)
    flow = make_flow(scenario_currents(scenario))
    ticks = int(stamp_ns.max()) // scenario.tick_ns
    every = max(1, -(-ticks // _MOST_MOMENTS))
    puffs, moments, centres, narrowness = no_puffs(), [], [], []
    for tick in range(ticks):
        puffs = advance_puffs(puffs, plume, flow, tank, Ticking(tick, scenario.tick_ns))
        if (tick + 1) % every == 0:
            moments.append((tick + 1) * scenario.tick_ns)
            centres.append(puffs.centre.copy())
            narrowness.append(plume.initial_size / np.sqrt(puffs.variance))
    empty = np.zeros((0, 3)), np.zeros(0)
    return DriftingPlume(
        plume.source,
        np.array(moments, dtype=np.int64),
        np.array([len(each) for each in centres], dtype=np.int64),
        np.concatenate([empty[0], *centres]),
        np.concatenate([empty[1], *narrowness]),
    )
