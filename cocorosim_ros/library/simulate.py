"""Simulations whose results are arrays: the core of the simulator, without ROS and without a recording."""

from __future__ import annotations

import os
from collections.abc import Iterator

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.library.scenario import scenario_to_run
from cocorosim_ros.library.simulated_run import SimulatedRun
from cocorosim_ros.scenario.reading.arguments import Place, Seed, Time, whole_number
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.sensors.pose import yaw_of_quaternions
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.state.state import YAW_RATE, X, Z
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.vehicle_model.platform_effects import not_simulated

_NUMBERS_KEPT = 67  # for each robot and tick, about


def simulate(
    scenario: Place | Scenario, *, seed: Seed | None = None, duration: Time | None = None, run: int = 0
) -> SimulatedRun:
    """Simulate one run of a scenario: the run that `cocorosim run --in-process` records, bit for bit.

    scenario: a name in config/scenarios, a file, or a record of `load_scenario`. seed, duration: instead of the
    scenario's own, see `load_scenario`. run: which of the runs of this seed, from 0; `cocorosim run` takes run 0.

    Returns arrays with the leading axes (ticks, robots), in SI units and the axes of REP 103. Raises CocorosimError for
    whatever is wrong with the scenario, if a controller is left to somebody else, and if a motion runs away.

    Example: `simulate("five_lilys", seed=7, duration="60 s").position[:, 0]` is the way of the first robot.
    """
    number = whole_number(run, "run", 0)
    return next(iter(_simulated(scenario_to_run(scenario, seed, duration), number, 1)))


def simulate_runs(
    scenario: Place | Scenario, runs: int, *, seed: Seed | None = None, duration: Time | None = None, first: int = 0
) -> tuple[SimulatedRun, ...]:
    """Simulate many runs of a scenario at once, which differ in start and random numbers alone.

    runs: how many, at least 1. first: the number of the first of them. The other arguments are those of `simulate`.
    Much faster than one after the other, and bit for bit the same. A run keeps about 70 numbers for each robot and
    tick; for statistics of very many runs `run_design` keeps no arrays.

    Returns the runs in their order. Raises CocorosimError as `simulate` does.

    Example: `[each.measure().values["polarisation"] for each in simulate_runs("five_lilys", 10)]`.
    """
    count, number = whole_number(runs, "runs"), whole_number(first, "first", 0)
    return tuple(_simulated(scenario_to_run(scenario, seed, duration), number, count))


def _simulated(scenario: Scenario, first: int, count: int) -> Iterator[SimulatedRun]:
    _check_memory(scenario, count)
    course = _Course(scenario, first, count)
    actuators = tuple(robot.platform.actuator_names for robot in scenario.robots)
    for robot, names in enumerate(actuators):
        course.command[:, :, robot, len(names) :] = np.nan
    # As messages carry it: a recording knows the heading by its quaternion alone.
    yaw = yaw_of_quaternions(course.attitude.reshape(-1, 4)).reshape(course.attitude.shape[:-1])
    platforms = {robot.name: robot.platform for robot in scenario.robots}
    remarks = tuple(not_simulated(platforms))
    for run in range(count):
        state = course.state[run]
        yield SimulatedRun(
            scenario,
            first + run,
            tuple(platforms),
            read_only(np.arange(scenario.ticks, dtype=np.int64) * scenario.tick_ns),
            read_only(state[..., X : Z + 1]),
            read_only(yaw[run]),
            read_only(course.attitude[run]),
            read_only(course.velocity[run]),
            read_only(state[..., YAW_RATE]),
            read_only(course.command[run]),
            actuators,
            {name: read_only(values[run]) for name, values in course.readings.items()},
            remarks,
        )


def _check_memory(scenario: Scenario, count: int) -> None:
    """Nothing, if this machine has room for so many runs. Raises CocorosimError otherwise."""
    size = float(count) * scenario.ticks * len(scenario.robots) * _NUMBERS_KEPT * 8
    room = float(os.sysconf("SC_PAGE_SIZE")) * os.sysconf("SC_PHYS_PAGES")
    if size > room:
        words = (
            f"{count} runs of {scenario.ticks} ticks take {size / 1e9:.3g} GB, more than the {room / 1e9:.3g} GB here"
        )
        raise ArgumentError(f"{words}; give a shorter 'duration' or fewer 'runs'.", "duration", "runs")


class _Course:
    """What happened in so many runs: state and command (runs, ticks, robots, columns), readings the same by name."""

    def __init__(self, scenario: Scenario, first: int, count: int) -> None:
        starts = np.stack([start_poses(scenario, run) for run in range(first, first + count)])
        simulation = Simulation(build_world(scenario, count, first), starts)
        self.state = self._room(simulation.state[..., : YAW_RATE + 1], scenario.ticks)
        self.attitude = self._room(simulation.attitude, scenario.ticks)
        self.velocity = self._room(simulation.velocity, scenario.ticks)
        self.command = self._room(simulation.command, scenario.ticks)
        blank = simulation.readings
        self.readings = {name: self._room(getattr(blank, name), scenario.ticks) for name in Readings._fields}
        for tick in range(scenario.ticks):
            self.state[:, tick] = simulation.state[..., : YAW_RATE + 1]
            self.attitude[:, tick], self.velocity[:, tick] = simulation.attitude, simulation.velocity
            readings = simulation.sense()
            simulation.decide()
            self.command[:, tick] = simulation.command
            for name, values in self.readings.items():
                values[:, tick] = getattr(readings, name)
            simulation.advance()

    @staticmethod
    def _room(values: Floats, ticks: int) -> Floats:
        """(runs, ticks, ...) for values (runs, ...)."""
        return np.empty((values.shape[0], ticks, *values.shape[1:]))
