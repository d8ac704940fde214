"""`make bench`: how fast the core is, side by side, with its conditions, and how far from what the machine can do.

Every row says AUV-ticks per second of wall clock, in brackets those if every thread had a processor to itself (from
processor time), and what one AUV-tick costs. Where others use the machine the first is too low.
"""

from __future__ import annotations

import os
import time
from dataclasses import replace

from conditions import conditions
from in_water import design_minutes, field_times, many_runs_in_patches, one_run_in_flow, one_run_in_patches
from limits import Machine, measured_machine, of_field, of_neighbours
from machine import at_once
from swarms import Pace, batches, bytes_per_robot, pace_of, stages, swarm_of
from with_mujoco import mujoco_pace

from cocorosim_ros.foundation.processors import processors
from cocorosim_ros.study.experiments.batch import run_batch
from cocorosim_ros.world.tick.simulation import ROBOTS_FOR_THREADS
from cocorosim_ros.world.water.force_field.force_field import ForceField

CORES = 2
TICK = 0.5  # s
ORIGINAL = "12 to 17 thousand AUV-ticks/s at N = 11, 2 to 4 thousand at N = 1,000, 12 with currents"
MILLION = 1e6


def main() -> None:
    """Print the whole table."""
    began = time.perf_counter()
    print("\n".join(conditions()))
    machine = measured_machine()
    print(f"{machine}\n")
    many_runs(machine)
    with_metrics()
    for robots, ticks in ((100, 600), (1000, 60), (10_000, 10), (100_000, 3)):
        one_run(robots, ticks, machine)
    field = in_patches(machine)
    thousand_in_water(machine)
    whole_designs()
    others()
    what_stands_between()
    parts_of_the_field(field)
    print(f"\ntook {time.perf_counter() - began:.0f} s, load {os.getloadavg()[0]:.1f} at the end")


def say(what: str, pace: Pace, conditions: str, least: float = 0.0, goal: float = 0.0) -> None:
    """One row; `least` and `goal` [AUV-ticks/s] where there are any."""
    rate = f"{pace.per_second / MILLION:7.3f} ({pace.undisturbed / MILLION:.3f}) M AUV-ticks/s"
    aim = "" if goal == 0.0 else f"; at least {least / MILLION:g} M {_met(pace.per_second, pace.undisturbed, least)}"
    aim += "" if goal == 0.0 else f", goal {goal / MILLION:g} M {_met(pace.per_second, pace.undisturbed, goal)}"
    print(f"{what:<44} {rate}, {pace.nanoseconds:.0f} ns of a processor each   {conditions}{aim}", flush=True)


def remark(words: str) -> None:
    """A line that belongs to the row above."""
    print(f"{'':44} {words}", flush=True)


def _met(found: float, undisturbed: float, aim: float) -> str:
    """Whether a figure by the clock, or at least by processor time, is an aim or beyond."""
    return "met" if found >= aim else ("met by processor time alone" if undisturbed >= aim else "NOT met")


def many_runs(machine: Machine) -> None:
    """The first row of the goals, in both numerics."""
    for numerics, words in (("accurate", "rk4, steps of 0.25 s"), ("paper", "semi-implicit Euler, 0.5 s")):
        made = batches(swarm_of(11, numerics), 400, CORES)
        pace = pace_of(made, 200)
        conditions = f"0.5 s ticks, BLSS, radio, avoidance, no currents; {words}; {CORES} threads"
        say("boids BLT, 400 runs of 11", pace, conditions, 6e6, 10e6)
        remark(of_neighbours(made[0], machine, pace, CORES))


def with_metrics() -> None:
    """The same as an experiment does it, with every metric at every tick and the summary at the end."""
    scenario, spent = swarm_of(11), [0.0] * CORES
    run_batch(scenario, 0, 1)

    def work(number: int) -> None:
        began = time.thread_time()
        run_batch(scenario, 50 * number, 50)
        spent[number] = time.thread_time() - began

    pace = Pace(50 * CORES * 11 * scenario.ticks, at_once(work, CORES), sum(spent), CORES)
    conditions = f"rk4, 0.25 s; {CORES} threads; with building and summary"
    say("the same with all metrics, 100 runs of 11", pace, conditions, 4e6, 8e6)


def one_run(robots: int, ticks: int, machine: Machine) -> None:
    """A single large swarm, in as many threads as it takes, and what a robot costs in each stage."""
    (simulation,) = batches(swarm_of(robots), 1, 1)
    pace = pace_of([simulation], ticks)
    threads = processors() if robots >= ROBOTS_FOR_THREADS else 1
    if threads > 1:  # which wait for each other: the clock alone tells how fast they are together
        pace = replace(pace, threads=pace.processor_seconds / pace.seconds)
    spent = stages(simulation, ticks)
    parts = ", ".join(f"{name} {1e9 * seconds / ticks / robots:.0f}" for name, seconds in spent.items())
    aims = (4e6, 8e6) if robots >= 1000 else (0.0, 0.0)
    say(f"the same, one run of {robots:,}", pace, f"rk4, 0.25 s; threads: {threads}; {parts} ns of the first", *aims)
    remark(of_neighbours(simulation, machine, pace, threads))


def in_patches(machine: Machine) -> ForceField:
    """Eleven Lilys in the paper's currents; the field of one of the runs."""
    pace, simulation = many_runs_in_patches(CORES)
    field = simulation.water.fields[0]
    conditions = f"{field.patches.total:,} patches, {field.spots_alive} cold spots, wakes; rk4, 0.25 s; {CORES} threads"
    say("boids BLT in currents, 6 runs of 11", pace, conditions, 1.5e5, 4e5)
    remark(of_field(simulation, machine, pace))
    return field


def thousand_in_water(machine: Machine, robots: int = 1000) -> None:
    """One large swarm with sensing and currents, as often as real time."""
    in_forces, simulation = one_run_in_patches(robots)
    patches, spots = simulation.water.fields[0].patches.total, simulation.water.fields[0].spots_alive
    words = f"forces on {patches:,} patches, {spots:,} cold spots, wakes"
    in_flow, calmer = one_run_in_flow(robots)
    rows = (
        (in_forces, words, f"parts of the water on {CORES} cores", of_field(simulation, machine, in_forces), 40.0),
        (in_flow, "velocities: a vortex and a tide", "1 thread", of_neighbours(calmer, machine, in_flow, 1), 10.0),
    )
    for pace, what, how, distance, least in rows:
        found, alone = (rate / robots * TICK for rate in (pace.per_second, pace.undisturbed))
        say(f"{robots:,} Lilys with sensing and currents", pace, f"{what}; rk4, 0.25 s; {how}")
        remark(
            f"{found:7.1f} ({alone:.1f}) x real time; at least {least:g} x {_met(found, alone, least)}, "
            f"goal 100 x {_met(found, alone, 100.0)}"
        )
        remark(distance)


def whole_designs() -> None:
    """Both designs with 400 runs a group, from samples."""
    minutes = {name: design_minutes(name, CORES) for name in ("boids", "turbulence")}
    parts = ", ".join(f"{name} {value:.1f}" for name, value in minutes.items())
    total = sum(minutes.values())
    aims = f"at most 15 {_met(-total, -total, -15.0)}, goal 6 {_met(-total, -total, -6.0)}"
    print(f"both designs whole, all metrics               {total:6.1f} min on {CORES} cores ({parts}); {aims}")
    remark("from the processor time of 100 ticks of every cell, no other work on the machine")


def others() -> None:
    """Others at the same work, as far as they are here."""
    print(f"\nCoCoRoSim on NetLogo (the authors' model): {ORIGINAL}")
    for robots, ticks in ((11, 2000), (100, 400), (1000, 60)):
        pace = mujoco_pace(robots, ticks)
        if pace is None:
            print("MuJoCo is not installed: 'pip install --editable .[bench]' adds its rows.")
            return
        say(
            f"MuJoCo, ellipsoid fluid, k-d tree, {robots:,}", pace, "implicitfast, 0.25 s; 1 thread; simpler controller"
        )


def what_stands_between() -> None:
    """Why robots take longer than their pairs."""
    size = bytes_per_robot(batches(swarm_of(11), 1, 1)[0])
    print(
        "\nBetween a tick and the arithmetic of its pairs stand the equations of motion (nine evaluations a tick),\n"
        "four robots at a time; cones, steering and boids, one robot at a time: divisions, roots and arc tangents\n"
        "that wait for each other.\n"
        f"A robot is {size / 1e3:.1f} kB with readings and inbox; the caches hold what a batch needs."
    )


def parts_of_the_field(field: ForceField) -> None:
    """Where the time of the paper's currents goes."""
    times = field_times(field)
    size = field.field.nbytes
    parts = ", ".join(f"{name} {1e6 * seconds:.0f}" for name, seconds in times.items())
    spread = times["diffusion and decay"]
    print(
        f"\nThe field is {size / 1e6:.1f} MB, more than a core's own cache; its parts take (us, one core): {parts}.\n"
        f"Diffusion and decay read and write it once: {2 * size / spread / 1e9:.0f} GB/s, {spread / times['copy']:.1f} "
        "times what a plain copy takes.\nIn between stand seven reads and three writes a patch, in the first cache or "
        "the second;\ncold spots add eight vectors in each slab that they reach."
    )


if __name__ == "__main__":
    main()
