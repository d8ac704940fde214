"""Where the puffs of a scenario's plume are while a run goes on; they depend on no robot."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Integers
from cocorosim_ros.scenario.parts.plume import Plume
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.scene.moving_water import MOST_MOMENTS
from cocorosim_ros.study.scene.scene import DriftingPlume
from cocorosim_ros.world.tick.assembly import build_tank
from cocorosim_ros.world.tick.water import Ticking, advance_puffs
from cocorosim_ros.world.water.current_numbers import scenario_currents
from cocorosim_ros.world.water.flow import make_flow
from cocorosim_ros.world.water.plume import no_puffs


class LeakingPlume:
    """The puffs of a scenario's plume, tick after tick, shown at the ends of some of the ticks."""

    def __init__(self, scenario: Scenario, plume: Plume, ticks: int) -> None:
        """`ticks`: how long it will be looked at, of which no more than MOST_MOMENTS are shown."""
        self._plume, self._tank, self._tick_ns = plume, build_tank(scenario), scenario.tick_ns
        self._flow = make_flow(scenario_currents(scenario))
        self._every = max(1, -(-ticks // MOST_MOMENTS))
        self._puffs, self._tick = no_puffs(), 0

    def until(self, stamp_ns: int) -> DriftingPlume:
        """What there is to show after the last call, until this time since the start of the run [ns]."""
        moments, centres, narrowness = [], [np.zeros((0, 3))], [np.zeros(0)]
        while (self._tick + 1) * self._tick_ns <= stamp_ns:
            ticking = Ticking(self._tick, self._tick_ns)
            self._puffs = advance_puffs(self._puffs, self._plume, self._flow, self._tank, ticking)
            self._tick += 1
            if self._tick % self._every == 0:
                moments.append(self._tick * self._tick_ns)
                centres.append(self._puffs.centre.copy())
                narrowness.append(self._plume.initial_size / np.sqrt(self._puffs.variance))
        return DriftingPlume(
            self._plume.source,
            np.array(moments, dtype=np.int64),
            np.array([len(each) for each in centres[1:]], dtype=np.int64),
            np.concatenate(centres),
            np.concatenate(narrowness),
        )


def leaking_plume(scenario: Scenario | None, ticks: int) -> LeakingPlume | None:
    """The plume of a scenario, to be shown for so many ticks; None where there is none."""
    if scenario is None or scenario.water is None or scenario.water.plume is None:
        return None
    return LeakingPlume(scenario, scenario.water.plume, ticks)


def drifting_plume(scenario: Scenario | None, stamp_ns: Integers) -> DriftingPlume | None:
    """The plume at the ends of some of the ticks until the last of the moments (t,) [ns]; None without a plume.

    Moments count from the start of the run.
    """
    if scenario is None or not stamp_ns.size:
        return None
    last_ns = int(stamp_ns.max())
    plume = leaking_plume(scenario, last_ns // scenario.tick_ns)
    return None if plume is None else plume.until(last_ns)
