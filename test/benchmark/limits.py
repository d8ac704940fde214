"""How fast a row could be if nothing stood in between: arithmetic of its neighbours, memory for its field."""

from __future__ import annotations

from dataclasses import dataclass

from machine import copy_bandwidth, scalar_arithmetic, triad_bandwidth, vector_arithmetic
from scipy.spatial import cKDTree
from swarms import Pace

from cocorosim_ros.world.tick.simulation import Simulation

OPERATIONS_PER_PAIR = 8  # three differences, three squares, two sums
REACH = 0.5  # m, of radio and of blue light
IN_SHARED_CACHE = 16_000_000  # bytes; fields that are larger come from memory
GIGA = 1e9


@dataclass(frozen=True)
class Machine:
    """What was measured, each on one core and on two."""

    scalar: dict[int, float]  # operations per second
    vector: dict[int, float]
    copied: dict[int, float]  # bytes per second, of arrays that no cache holds

    def __str__(self) -> str:
        pairs = (("scalar", self.scalar), ("vector", self.vector))
        arithmetic = ", ".join(f"{name} {of[1] / GIGA:.0f} and {of[2] / GIGA:.0f}" for name, of in pairs)
        copied = f"copied {self.copied[1] / GIGA:.0f} and {self.copied[2] / GIGA:.0f} GB/s"
        return f"machine     on one core and on two: {arithmetic} G operations/s; memory {copied}"


def measured_machine() -> Machine:
    """This one, now."""
    return Machine(*({cores: of(cores) for cores in (1, 2)} for of in (scalar_arithmetic, vector_arithmetic, copied)))


def copied(cores: int) -> float:
    """Bytes per second that memory delivers, the better of two patterns."""
    return max(copy_bandwidth(cores), triad_bandwidth(cores))


def pairs_per_robot(simulation: Simulation) -> float:
    """Pairs within reach, each counted once, of the places where the robots are now."""
    runs = simulation.state[..., :3]
    return sum(len(cKDTree(run).query_pairs(REACH)) for run in runs) / (runs.shape[0] * runs.shape[1])


def of_neighbours(simulation: Simulation, machine: Machine, pace: Pace, cores: int) -> str:
    """How far a pace on so many cores is from measuring the pairs in reach and doing nothing else."""
    pairs = pairs_per_robot(simulation)
    rates = [of[cores] / (OPERATIONS_PER_PAIR * pairs) for of in (machine.scalar, machine.vector)]
    shares = [100.0 * pace.per_second / rate for rate in rates]
    return (
        f"{shares[0]:.2g} % of what scalar, {shares[1]:.2g} % of what vector arithmetic would allow "
        f"its neighbours ({pairs:.1f} pairs a robot)"
    )


def of_field(simulation: Simulation, machine: Machine, pace: Pace) -> str:
    """How far a pace is from reading and writing the field of patches once a tick and doing nothing else."""
    size = simulation.water.fields[0].field.nbytes
    robots = simulation.state.shape[1]
    near = size <= IN_SHARED_CACHE
    bandwidth = triad_bandwidth(pace.threads, pace.threads * size // 8 // 3) if near else machine.copied[pace.threads]
    rate = robots * bandwidth / (2.0 * size)
    where = "the caches" if near else "memory"
    return (
        f"{100.0 * pace.per_second / rate:.2g} % of what {where} would allow a field of {size / 1e6:.1f} MB "
        f"({bandwidth / GIGA:.0f} GB/s on {pace.threads} cores)"
    )
