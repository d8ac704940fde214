"""Commands that act late: what an actuator is told now was sent so long ago, and before the first command nothing was.

Where a delay is no whole number of ticks, the mean of the command over the tick acts: the older one for its share.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.past import Past


class LateCommands:
    """The commands of all robots, of which some act late."""

    def __init__(self, delay: Floats, tick: float) -> None:
        """`delay` (robots,) and the time between two commands, both [s]."""
        nothing = np.zeros(())
        self._past = {int(robot): Past(float(delay[robot]), tick, [nothing]) for robot in np.flatnonzero(delay)}

    def acting(self, command: Floats) -> Floats:
        """Return what acts (runs, robots, actuators) in the tick for which `command` was sent; once a tick, in order.

        The array is `command` itself where no command is late.
        """
        if not self._past:
            return command
        acting = command.copy()
        for robot, past in self._past.items():
            newer, older = past.about(command[:, robot])
            acting[:, robot] = newer if past.share == 0.0 else (1.0 - past.share) * newer + past.share * older
        return acting
