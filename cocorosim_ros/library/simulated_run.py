"""One simulated run as arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.card import Card, Shown
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.library.shoal_statistics import ShoalStatistics, statistics_of
from cocorosim_ros.scenario.reading.arguments import Time, nanoseconds
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics.from_tracks import plan_samples
from cocorosim_ros.study.pictures.sketch import tracks_sketch
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.world.state.pose_track import PoseTrack

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, eq=False, repr=False)
class SimulatedRun(Shown):
    """One run of a scenario, tick by tick; the arrays cannot be written to.

    Row k of every array belongs to the moment k * tick, before the robots move under the command of that row.
    """

    scenario: Scenario
    run: int
    """The number of the run, which with the scenario's seed decides its random numbers."""
    robots: tuple[str, ...]
    """Names in the order of all arrays."""
    stamp_ns: Integers
    """(ticks,) [ns] since the start, exact."""
    position: Floats
    """(ticks, robots, 3) x, y, z [m; world], z negative below the surface."""
    yaw: Floats
    """(ticks, robots) heading [rad; world], counter-clockwise from +x, in [-pi, pi], as a recording gives it."""
    attitude: Floats
    """(ticks, robots, 4) unit quaternions x, y, z, w, from the body's axes to the world's; roll and pitch are zero
    but for platforms with six degrees of freedom."""
    velocity: Floats
    """(ticks, robots, 3) u, v, w over ground [m/s; body]."""
    yaw_rate: Floats
    """(ticks, robots) at which the heading changes [rad/s]."""
    command: Floats
    """(ticks, robots, actuators) fractions of each actuator's maximum, in the order of `actuators`; NaN where a robot
    has fewer."""
    actuators: tuple[tuple[str, ...], ...]
    """For each robot the names of its actuators."""
    readings: Mapping[str, Floats]
    """By name (ticks, robots, ...), with noise and faults if the scenario has some; NaN where not measured: compass
    [rad; world], pressure [Pa], angular_rate (3) [rad/s; body], specific_force (3) [m/s^2; body], velocity (4) u v w r
    through the water [m/s, rad/s; body], ground_velocity (3) u v w over ground [m/s; body], neighbour_range and
    obstacle_range (sensors) [m, +inf for none], illuminance [lx], concentration [kg/m^3]."""
    remarks: tuple[str, ...]
    """What the scenario's platforms know and the simulation leaves out, in sentences."""

    @property
    def time(self) -> Floats:
        """(ticks,) [s] since the start."""
        return read_only(np.asarray(self.stamp_ns / NANOSECONDS))

    @property
    def depth(self) -> Floats:
        """(ticks, robots) [m], positive below the surface."""
        return read_only(np.asarray(-self.position[..., 2]))

    def tracks(self) -> dict[str, PoseTrack]:
        """The poses robot by robot, by name: `stamp_ns` (ticks,), `position` (ticks, 3), `yaw` (ticks,)."""
        return {
            name: PoseTrack(
                self.stamp_ns, read_only(self.position[:, robot].copy()), read_only(self.yaw[:, robot].copy())
            )
            for robot, name in enumerate(self.robots)
        }

    def measure(self, interval: Time | None = None) -> ShoalStatistics:
        """The shoaling statistics: those of the run's recording, bit for bit.

        interval: measure every so often, such as '0.5 s' or 0.5 [s], by interpolation; left out, at every tick. Raises
        CocorosimError if it is no time.
        """
        every = None if interval is None else nanoseconds(interval, "interval")
        return statistics_of(plan_samples(self.tracks(), every), self.scenario.name)

    def to_frame(self) -> pd.DataFrame:
        """One row a robot and tick: time [s], robot, x, y, z, depth [m], yaw [rad], u, v, w [m/s], r [rad/s], commands.

        The commands are columns such as `command_left`, NaN for a robot without that actuator.
        """
        numbers = {name: self.position[..., place] for place, name in enumerate("xyz")}
        numbers |= {"depth": self.depth, "yaw": self.yaw}
        numbers |= {name: self.velocity[..., place] for place, name in enumerate("uvw")}
        numbers |= {"r": self.yaw_rate, **self._commands()}
        columns = {name: values.reshape(-1) for name, values in numbers.items()}
        return data_frame({**_long_columns(self.time, self.robots), **columns})

    def card(self) -> Card:
        """What was simulated, for how long, and where the robots are in the end."""
        facts = {
            "robots": str(len(self.robots)),
            "ticks": f"{len(self.stamp_ns)} of {self.scenario.tick:g} s",
            "seed": str(self.scenario.seed),
            "run": str(self.run),
        }
        rows = [
            (name, *(f"{part:.3f}" for part in self.position[-1, robot]), f"{self.yaw[-1, robot]:.3f}")
            for robot, name in enumerate(self.robots)
        ]
        headings = ("at the end", "x [m]", "y [m]", "z [m]", "yaw [rad]")
        return Card(f"simulation of {self.scenario.name}", facts, headings, rows, self.remarks)

    def sketch(self) -> str:
        """The ways of all robots from above."""
        return tracks_sketch({name: self.position[:, robot] for robot, name in enumerate(self.robots)})

    def _commands(self) -> dict[str, Floats]:
        """(ticks, robots) of each actuator that any robot has."""
        columns: dict[str, Floats] = {}
        for robot, names in enumerate(self.actuators):
            for place, name in enumerate(names):
                column = columns.setdefault(f"command_{name}", np.full(self.yaw.shape, np.nan))
                column[:, robot] = self.command[:, robot, place]
        return columns


def _long_columns(time: ArrayLike, robots: tuple[str, ...]) -> dict[str, ArrayLike]:
    """The columns `time` and `robot` of a long table: all robots of the first moment, then of the next."""
    moments = np.asarray(time)
    return {
        "time": np.repeat(moments, len(robots)),
        "robot": np.tile(np.array(robots, dtype=object), len(moments)),
    }
