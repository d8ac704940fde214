"""Claim S22: by blue light the robots perceive the shoal's centre nearer than it is.

In runs of BLT both offsets are taken of the same robot at the same moment: the exact one that Vanilla steers by (to the
coordinate-wise median of all neighbours within 0.5 m) and the one that BLT steers by (the sum, over its sensors, of the
range along the sensor's axis, where it is trusted). Both in metres, without weights. Moments and robots of one run
depend on each other, so intervals are taken over runs.
Source: Read et al. 2013, section 5 ("boids thus perceiving swarm centres to be closer than they in fact are").
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.claims.answers import DASH, NO_RUNS, Answer, above, all_of
from cocorosim_ros.study.experiments.design import Cell, load_design
from cocorosim_ros.study.metrics.swarms import CONTACT_RANGE
from cocorosim_ros.study.results.bootstrap import bootstrap_interval
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.state import YAW, X, Z
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

_RUNS, _TICKS, _EVERY = 20, 3000, 25


@dataclass(frozen=True)
class PerceivedCentre:
    """Lengths [m] of both offsets and how often the perceived one is the shorter, run by run."""

    exact: Floats  # (runs,) median over robots and moments
    perceived: Floats  # (runs,)
    nearer: Floats  # (runs,) share


def perceived_centres(cell: Cell, runs: int = _RUNS, ticks: int = _TICKS) -> PerceivedCentre:
    """What the robots of a cell perceive, every 12.5 s of some runs; moments without neighbours are left out."""
    scenario = cell.scenario
    trust = float(scenario.robots[0].controller.parameters["neighbour_trust"].value)
    starts = np.stack([start_poses(scenario, run) for run in range(runs)])
    simulation = Simulation(build_world(scenario, runs), starts)
    pairs = []
    for tick in range(ticks):
        readings = simulation.sense()
        if tick % _EVERY == 0:
            pairs.append(
                (exact_length(simulation.state), perceived_length(simulation, readings.neighbour_range, trust))
            )
        simulation.decide()
        simulation.advance()
    exact, perceived = (np.hstack(lengths) for lengths in zip(*pairs, strict=True))
    return run_by_run(exact, perceived)


def run_by_run(exact: Floats, perceived: Floats) -> PerceivedCentre:
    """The offsets [m] (runs, moments) summed up; runs in which nobody ever saw anybody are left out."""
    seen = np.isfinite(exact) & (perceived > 0.0)
    told = [(exact[run][there], perceived[run][there]) for run, there in enumerate(seen) if there.any()]
    shares = np.array([np.mean(theirs < ours) for ours, theirs in told])
    ours, theirs = (np.array([np.median(pair[side]) for pair in told]) for side in (0, 1))
    return PerceivedCentre(ours, theirs, shares)


def exact_length(state: Floats) -> Floats:
    """(runs, robots) distance [m] to the coordinate-wise median of the neighbours [body axes], NaN without any."""
    place, yaw = state[..., X : Z + 1], state[..., YAW]
    offset = place[:, None, :, :] - place[:, :, None, :]
    cosine, sine = np.cos(yaw)[..., None], np.sin(yaw)[..., None]
    ahead = offset[..., 0] * cosine + offset[..., 1] * sine
    left = offset[..., 1] * cosine - offset[..., 0] * sine
    body = np.stack([ahead, left, offset[..., 2]], axis=-1)
    near = np.linalg.norm(offset, axis=-1) <= CONTACT_RANGE
    near &= ~np.eye(place.shape[1], dtype=bool)
    masked = np.ma.array(body, mask=np.repeat(~near[..., None], 3, axis=-1))
    middle = np.ma.median(masked, axis=2).filled(np.nan)  # type: ignore[no-untyped-call]
    length: Floats = np.linalg.norm(middle, axis=-1)
    return length


def perceived_length(simulation: Simulation, ranges: Floats, trust: float) -> Floats:
    """(runs, robots) length [m] of the sum of `ranges` (runs, robots, sensors) along the axes; 0 without any."""
    trusted = np.where(ranges < trust, ranges, 0.0)
    total = np.einsum("ijk,jkl->ijl", trusted, simulation.world.crew.sensor_axis)
    length: Floats = np.linalg.norm(total, axis=-1)
    return length


def mechanism_answers() -> Iterator[Answer]:
    """S22 in both kinds of numerics of the design `boids`."""
    for cell in load_design("boids", groups=["BLT"]).cells:
        yield mechanism_answer(perceived_centres(cell), cell.numerics)


def mechanism_answer(found: PerceivedCentre, numerics: str) -> Answer:
    """S22: the perceived offset is the shorter one, on average over runs, and is so in most moments."""
    subject, paper = "BLT: offset to the centre, perceived and exact", "perceived nearer"
    if found.nearer.size == 0:
        return Answer("S22", subject, paper, numerics, DASH, NO_RUNS)
    gap = found.exact - found.perceived
    by, often = (bootstrap_interval([values], _mean) for values in (gap, found.nearer))
    ours = (
        f"{found.perceived.mean():.3f} m instead of {found.exact.mean():.3f} m, nearer by {gap.mean():.3f} m "
        f"({by[0]:.3f} to {by[1]:.3f}); nearer in {100 * found.nearer.mean():.0f} % of all moments "
        f"({100 * often[0]:.0f} to {100 * often[1]:.0f} %)"
    )
    return Answer("S22", subject, paper, numerics, ours, all_of((above(0.0, *by), above(0.5, *often))))


def _mean(values: Floats) -> Floats:
    mean: Floats = values.mean(axis=-1)
    return mean
