"""`make bench`: how fast the core is, side by side, with its conditions, and how far from what the machine can do.

Every row says AUV-ticks per second of wall clock, in brackets those if every thread had a processor to itself (from
processor time), and what one AUV-tick costs. Where others use the machine the first is too low.
"""

from __future__ import annotations

import os
import time

from conditions import conditions
from in_water import design_minutes, field_times, many_runs_in_patches, one_run_in_flow, one_run_in_patches
from machine import arithmetic, at_once, copy_bandwidth, triad_bandwidth
from swarms import Pace, batches, bytes_per_robot, pace_of, stages, swarm_of
from with_mujoco import mujoco_pace

from cocorosim_ros.environment.force_field.force_field import ForceField
from cocorosim_ros.experiments.batch import run_batch

CORES = 2
TICK = 0.5  # s
OPERATIONS_PER_PAIR = 8  # three differences, three squares, two sums
PAIRS_PER_ROBOT = 5  # of 11 robots, each pair once
ORIGINAL = "12 to 17 thousand AUV-ticks/s at N = 11, 2 to 4 thousand at N = 1,000, 12 with currents"
MILLION = 1e6


def main() -> None:
    """Print the whole table."""
    began = time.perf_counter()
    print("\n".join(conditions()))
    flops = arithmetic(CORES)
    print(f"machine     scalar arithmetic {flops / 1e9:.1f} G operations/s on {CORES} cores; {bandwidths()}\n")
    best = many_runs()
    with_metrics()
    for robots, ticks in ((100, 600), (1000, 60), (10_000, 10)):
        one_run(robots, ticks)
    field = in_patches()
    thousand_in_water()
    whole_designs()
    others()
    neighbours_and_the_machine(flops, best)
    field_and_the_machine(field)
    print(f"\ntook {time.perf_counter() - began:.0f} s, load {os.getloadavg()[0]:.1f} at the end")


def bandwidths() -> str:
    """What memory delivers."""
    copy, triad = copy_bandwidth(CORES) / 1e9, triad_bandwidth(CORES) / 1e9
    return f"memory: copy {copy:.0f}, triad {triad:.0f} GB/s"


def say(what: str, pace: Pace, conditions: str, least: float = 0.0, goal: float = 0.0) -> None:
    """One row; `least` and `goal` [AUV-ticks/s] where there are any."""
    rate = f"{pace.per_second / MILLION:7.3f} ({pace.undisturbed / MILLION:.3f}) M AUV-ticks/s"
    aim = "" if goal == 0.0 else f"; at least {least / MILLION:g} M {_met(pace.per_second, pace.undisturbed, least)}"
    aim += "" if goal == 0.0 else f", goal {goal / MILLION:g} M {_met(pace.per_second, pace.undisturbed, goal)}"
    print(f"{what:<44} {rate}, {pace.nanoseconds:.0f} ns of a processor each   {conditions}{aim}", flush=True)


def _met(found: float, undisturbed: float, aim: float) -> str:
    """Whether a figure by the clock, or at least by processor time, is an aim or beyond."""
    return "met" if found >= aim else ("met by processor time alone" if undisturbed >= aim else "NOT met")


def many_runs() -> Pace:
    """The first row of the goals, in both numerics; the pace in the accurate ones."""
    found = {}
    for numerics, words in (("accurate", "rk4, steps of 0.25 s"), ("paper", "semi-implicit Euler, 0.5 s")):
        found[numerics] = pace_of(batches(swarm_of(11, numerics), 400, CORES), 200)
        conditions = f"0.5 s ticks, BLSS, radio, avoidance, no currents; {words}; {CORES} threads"
        say("boids BLT, 400 runs of 11", found[numerics], conditions, 2e6, 5e6)
    return found["accurate"]


def with_metrics() -> None:
    """The same as an experiment does it, with every metric at every tick and the summary at the end."""
    scenario, spent = swarm_of(11), [0.0] * CORES
    run_batch(scenario, 0, 1)

    def work(number: int) -> None:
        began = time.thread_time()
        run_batch(scenario, 50 * number, 50)
        spent[number] = time.thread_time() - began

    pace = Pace(50 * CORES * 11 * scenario.ticks, at_once(work, CORES), sum(spent), CORES)
    say("the same with all metrics, 100 runs of 11", pace, f"rk4, 0.25 s; {CORES} threads; with building and summary")


def one_run(robots: int, ticks: int) -> None:
    """A single large swarm on one core, and what a robot costs in each stage."""
    (simulation,) = batches(swarm_of(robots), 1, 1)
    pace = pace_of([simulation], ticks)
    spent = stages(simulation, ticks)
    parts = ", ".join(f"{name} {1e9 * seconds / ticks / robots:.0f}" for name, seconds in spent.items())
    aims = (1e6, 3e6) if robots == 1000 else (0.0, 0.0)
    say(f"the same, one run of {robots:,}", pace, f"rk4, 0.25 s; 1 thread; {parts} ns", *aims)


def in_patches() -> ForceField:
    """Eleven Lilys in the paper's currents; the field of one of the runs."""
    pace, simulation = many_runs_in_patches(CORES)
    field = simulation.water.fields[0]
    conditions = f"{field.patches.total:,} patches, {field.spots_alive} cold spots, wakes; rk4, 0.25 s; {CORES} threads"
    say("boids BLT in currents, 6 runs of 11", pace, conditions, 5e4, 2e5)
    return field


def thousand_in_water(robots: int = 1000) -> None:
    """One large swarm with sensing and currents, as often as real time."""
    in_forces, simulation = one_run_in_patches(robots)
    patches, spots = simulation.water.fields[0].patches.total, simulation.water.fields[0].spots_alive
    words = f"forces on {patches:,} patches, {spots:,} cold spots, wakes"
    rows = (
        (in_forces, words, f"components of the force on {CORES} cores"),
        (one_run_in_flow(robots), "velocities: a vortex and a tide", "1 thread"),
    )
    for pace, what, how in rows:
        found, alone = (rate / robots * TICK for rate in (pace.per_second, pace.undisturbed))
        say(f"{robots:,} Lilys with sensing and currents", pace, f"{what}; rk4, 0.25 s; {how}")
        print(
            f"{'':44} {found:7.1f} ({alone:.1f}) x real time; at least 10 x {_met(found, alone, 10.0)}, "
            f"goal 100 x {_met(found, alone, 100.0)}"
        )


def whole_designs() -> None:
    """Both designs with 400 runs a group, from samples."""
    minutes = {name: design_minutes(name, CORES) for name in ("boids", "turbulence")}
    parts = ", ".join(f"{name} {value:.1f}" for name, value in minutes.items())
    total = sum(minutes.values())
    aims = f"at most 60 {_met(-total, -total, -60.0)}, goal 15 {_met(-total, -total, -15.0)}"
    print(f"both designs whole, all metrics               {total:6.1f} min on {CORES} cores ({parts}); {aims}")
    print(f"{'':44} from the processor time of 100 ticks of every cell, no other work on the machine")


def others() -> None:
    """Others at the same work, as far as they are here."""
    print(f"\nCoCoRoSim on NetLogo (the authors' model): {ORIGINAL}")
    for robots, ticks in ((11, 2000), (100, 400), (1000, 60)):
        pace = mujoco_pace(robots, ticks)
        if pace is None:
            print("MuJoCo is not installed: 'pip install .[bench]' adds its rows.")
            return
        say(
            f"MuJoCo, ellipsoid fluid, k-d tree, {robots:,}", pace, "implicitfast, 0.25 s; 1 thread; simpler controller"
        )


def neighbours_and_the_machine(flops: float, best: Pace) -> None:
    """What the arithmetic of neighbours, and memory, would allow, against what is reached."""
    operations = OPERATIONS_PER_PAIR * PAIRS_PER_ROBOT
    ideal = flops / operations
    size = bytes_per_robot(batches(swarm_of(11), 1, 1)[0])
    reached = 100 * best.per_second / ideal
    print(
        f"\nThe neighbours of 11 robots are {operations} operations per AUV-tick: {ideal / 1e6:.0f} M AUV-ticks/s at\n"
        f"this machine's scalar arithmetic, of which the whole tick reaches {reached:.1f} %. In between stand the\n"
        "equations of motion (nine evaluations a tick), cones, steering and boids: divisions, roots and arc tangents\n"
        f"that wait for each other, one robot at a time. A robot is {size / 1e3:.1f} kB with readings and inbox;\n"
        "the caches hold what a batch needs."
    )


def field_and_the_machine(field: ForceField) -> None:
    """What caches would allow the field of the paper's currents, against what is reached."""
    times = field_times(field)
    size = field.field.nbytes
    near = triad_bandwidth(1, 3 * size // 8 // 3) / 1e9
    parts = ", ".join(f"{name} {1e6 * seconds:.0f}" for name, seconds in times.items())
    spread = times["diffusion and decay"]
    print(
        f"\nThe field is {size / 1e6:.1f} MB, more than a core's own cache; its parts take (us, one core): {parts}.\n"
        f"Diffusion and decay read and write it once: {2 * size / spread / 1e9:.0f} GB/s, {spread / times['copy']:.1f} "
        f"times what a plain copy takes\n(triad on arrays of this size: {near:.0f} GB/s). In between stand ten reads "
        "and three writes of sums a patch,\nwhich the second cache serves, not the first; cold spots add three "
        "vectors for each plane that they reach."
    )


if __name__ == "__main__":
    main()
