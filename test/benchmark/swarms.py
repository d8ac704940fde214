"""The work that is timed: boids (BLT) with blue-light sensors, radio and avoidance, in tanks of equal density."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

import numpy as np
from machine import at_once

from cocorosim_ros.scenario.parts.swarm import StartBox
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

SETTLING = 20  # ticks before the clock starts


@dataclass(frozen=True)
class Pace:
    """What came out of one measurement."""

    auv_ticks: int
    seconds: float  # of wall clock
    processor_seconds: float  # of all threads
    threads: float = 1  # that went side by side

    @property
    def nanoseconds(self) -> float:
        """Of one processor per AUV-tick: what it costs, whatever else the machine does."""
        return 1e9 * self.processor_seconds / self.auv_ticks

    @property
    def per_second(self) -> float:
        """AUV-ticks per second of wall clock."""
        return self.auv_ticks / self.seconds

    @property
    def undisturbed(self) -> float:
        """AUV-ticks per second if every thread had a processor to itself all the time."""
        return self.auv_ticks * self.threads / self.processor_seconds


def swarm_of(robots: int, numerics: str = "accurate") -> Scenario:
    """Lilys at the density of the paper, 11 in 72 m^3, 2 m deep, spread over the whole tank if more than 11."""
    return in_tank_of(load_scenario("eleven_lilys" if numerics == "accurate" else "paper_lilys"), robots)


def in_tank_of(scenario: Scenario, robots: int) -> Scenario:
    """A scenario of eleven Lilys with another number in a tank that gives each as much water."""
    if robots == 11:
        return scenario
    side = round((robots / 11) ** 0.5 * 6.0, 1)
    (group,) = scenario.swarm
    box = StartBox(centre=(0.0, 0.0, -1.2), size=(side - 0.6, side - 0.6, 1.2))
    group = replace(group, count=robots, start=replace(group.start, box=box))
    return replace(scenario, swarm=(group,), tank=replace(scenario.tank, size=(side, side, 2.0)))


def batches(scenario: Scenario, runs: int, threads: int) -> list[Simulation]:
    """The runs of a scenario, split evenly into one batch per thread, a few ticks old."""
    share = runs // threads
    made = []
    for number in range(threads):
        starts = np.stack([start_poses(scenario, number * share + run) for run in range(share)])
        made.append(Simulation(build_world(scenario, share, number * share), starts))
    for batch in made:
        advance(batch, SETTLING)
    return made


def advance(simulation: Simulation, ticks: int) -> None:
    """Let a batch live for some ticks."""
    for _ in range(ticks):
        simulation.sense()
        simulation.decide()
        simulation.advance()


def pace_of(made: list[Simulation], ticks: int, repeats: int = 3) -> Pace:
    """The measurement with the least processor time, of all batches at once, each in a thread of its own."""
    robots = sum(batch.state.shape[0] * batch.state.shape[1] for batch in made)
    return min((_measured(made, ticks, robots) for _ in range(repeats)), key=lambda pace: pace.processor_seconds)


def _measured(made: list[Simulation], ticks: int, robots: int) -> Pace:
    began = time.process_time()
    seconds = at_once(lambda number: advance(made[number], ticks), len(made))
    return Pace(robots * ticks, seconds, time.process_time() - began, len(made))


def bytes_per_robot(simulation: Simulation) -> float:
    """Of all arrays that a tick reads or writes."""
    arrays = [simulation.state, simulation.command, simulation.said, simulation.memory]
    arrays += [*simulation.readings, *simulation.inbox]
    return sum(array.nbytes for array in arrays) / (simulation.state.shape[0] * simulation.state.shape[1])


def stages(simulation: Simulation, ticks: int) -> dict[str, float]:
    """Processor seconds of one thread in each stage of a tick."""
    spent = {"sense": 0.0, "decide": 0.0, "advance": 0.0}
    for _ in range(ticks):
        for name in spent:
            began = time.thread_time()
            getattr(simulation, name)()
            spent[name] += time.thread_time() - began
    return spent
