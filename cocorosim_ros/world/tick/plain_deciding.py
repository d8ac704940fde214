"""The plain Python controllers of a simulation: called one after the other, before the compiled part of a decision."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.plain.plain_controller import PlainController, plain_of
from cocorosim_ros.world.controllers.request import REQUEST_SIZE
from cocorosim_ros.world.tick.deciding import observe_plainly
from cocorosim_ros.world.tick.perception import Perception


class PlainCrew:
    """One controller for each of some robots in each of some runs, made when they are asked for the first time.

    A simulation whose controllers are nodes of their own therefore makes none.
    """

    def __init__(self, robots: Mapping[int, RobotDescription], seed: int, runs: range) -> None:
        """`robots`: those with a plain Python controller, by their number in the swarm."""
        self._robots = robots
        self._source = (seed, runs)
        self._controllers: dict[tuple[int, int], PlainController] = {}

    def ask(self, time: float, perception: Perception, memory: Floats, said: Floats) -> None:
        """Let them answer at `time` [s], into `memory` (runs, robots, MEMORY_SIZE) and `said`. Raises ControllerError.

        `said` (runs, robots, MESSAGE_SIZE). What they ask for is carried out by `deciding.decide`.
        """
        if not self._controllers:
            self._make()
        for (run, robot), controller in self._controllers.items():
            observation = observe_plainly(time, perception, run, robot, np.empty(3))
            controller.ask(observation, memory[run, robot, :REQUEST_SIZE], said[run, robot])

    def _make(self) -> None:
        seed, runs = self._source
        for place, run in enumerate(runs):
            for number, robot in self._robots.items():
                if (named := plain_of(robot)) is not None:
                    self._controllers[place, number] = PlainController(robot, named, seed, run)
