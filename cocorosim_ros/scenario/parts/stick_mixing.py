"""From sticks to the commands of actuators, by what a platform declares; the same for nodes, batches and logs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.allocation import smallest_forces
from cocorosim_ros.scenario.parts.mixing import Mixing, allocation_matrix, mixed_thrusters, table_matrix
from cocorosim_ros.scenario.parts.thrust_curve import command_for
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator, Thruster

_ROUNDING = 1e-9  # of the largest force of a moment: what the pseudo-inverse leaves of forces that should be none


class StickMixing:
    """What sticks do to actuators.

    A thruster's own `gain` has no part in it: an autopilot knows the thruster of the data sheet, not how far it is from
    it, and a gain that a diagnosis finds must not change what was commanded.
    """

    def __init__(self, mixing: Mixing, actuators: Sequence[Actuator]) -> None:
        """`actuators`: all of the platform, of which the mixing has been checked (`mixing.check_mixing`)."""
        self.sticks = mixing.sticks
        """The sticks that it takes, in the order of the axes."""
        self._thrusters: list[Thruster] = []
        if mixing.form == "table":
            self.driven: tuple[str, ...] = tuple(row.actuator for row in mixing.rows or ())
            """The actuators that follow the sticks."""
            self._matrix = table_matrix(mixing)
        else:
            self._thrusters = mixed_thrusters(actuators)
            self.driven = tuple(part.name for part in self._thrusters)
            amounts = np.array(list(mixing.full_sticks.amounts.values() if mixing.full_sticks else ()))
            self._matrix = amounts[:, None] * smallest_forces(allocation_matrix(mixing, actuators)).T
        self.names = (*self.sticks, *(part.name for part in actuators if part.name not in self.driven))
        """What a command by sticks names: these, and the actuators that they do not drive."""

    def commands(self, sticks: Floats) -> Floats:
        """(n, driven) fractions -1..1 at positions (n, sticks) of the sticks; a stick beyond -1..1 is at its end.

        What is more than an actuator can give is cut, for each by itself.
        """
        wanted = np.clip(sticks, -1.0, 1.0) @ self._matrix
        if self._thrusters:  # however small, a force is a command beyond the dead band of its curve
            wanted[np.abs(wanted) < _ROUNDING * np.abs(wanted).max(axis=1, keepdims=True)] = 0.0
        for column, part in enumerate(self._thrusters):
            wanted[:, column] = _command(part, wanted[:, column])
        return np.clip(wanted, -1.0, 1.0)

    def without_sticks(self, asked: Mapping[str, float]) -> dict[str, float]:
        """The commands of actuators by name, of commands by name among which there may be sticks; absent ones rest.

        Raises ValueError, with the end of a sentence, where sticks and what they drive are commanded at once.
        """
        given = [name for name in self.sticks if name in asked]
        if not given:
            return dict(asked)
        twice = [name for name in self.driven if name in asked]
        if twice:
            raise ValueError(f"the stick '{given[0]}' beside '{twice[0]}', which it drives; command one of them")
        mixed = self.commands(np.array([[asked.get(name, 0.0) for name in self.sticks]]))[0]
        others = {name: value for name, value in asked.items() if name not in self.sticks}
        return {**others, **{name: float(value) for name, value in zip(self.driven, mixed, strict=True)}}


def _command(thruster: Thruster, force: Floats) -> Floats:
    """The commands (n,) at which a thruster as its file has it gives forces (n,) [N], or as much of them as it can."""
    backwards = force / thruster.reverse if thruster.reverse > 0.0 else np.zeros_like(force)
    share = np.where(force >= 0.0, force / thruster.maximum, backwards)
    return command_for(thruster.curve, np.clip(share, -1.0, 1.0))
