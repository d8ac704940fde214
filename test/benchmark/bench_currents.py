"""How long a tick with the paper's currents takes, part by part, beside a plain copy of the same field.

Prints microseconds a tick (tenth of the ticks from below, so that other work on the machine counts little), AUV-ticks
per second and core, and how far spreading is from what memory can deliver.

Usage: python test/benchmark/bench_currents.py [SCENARIO]
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import numpy as np

from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.water.force_field.cold_spots import new_places
from cocorosim_ros.world.water.force_field.pulls import pull_water

REPEATS = 500


def microseconds(work: Callable[[], object]) -> float:
    """What `work` takes when nothing comes between: the lowest tenth of REPEATS times."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return sorted(times)[REPEATS // 10] * 1e6


def main(name: str) -> None:
    """Measure one scenario with force currents."""
    scenario = load_scenario(name)
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])

    def tick() -> None:
        simulation.sense()
        simulation.decide()
        simulation.advance()

    for _ in range(60):
        tick()
    water = simulation.water.fields[0]
    other = np.empty_like(water.water)
    parts = {"whole tick": microseconds(tick)}
    parts["copy of the field"] = microseconds(lambda: np.copyto(other, water.water))
    parts["diffusion and decay"] = microseconds(water.spread)
    settings, pulling = water.settings.cold_spots, water.pulling()
    if settings is not None and pulling is not None:
        parts["drawing cold spots"] = microseconds(lambda: new_places(settings, water.patches, water._random))
        parts["pull of cold spots"] = microseconds(lambda: pull_water(water.water, pulling))
        parts["spreading and pull in one"] = microseconds(lambda: water.spread_and_pull(pulling))
    parts["sensing"] = microseconds(simulation.sense)
    parts["deciding"] = microseconds(simulation.decide)
    robots = len(scenario.robots)
    print(
        f"{name}: {robots} robots, {water.patches.total:,} patches, {water.spots_alive} cold spots, "
        f"tick {scenario.tick} s"
    )
    for part, value in parts.items():
        print(f"  {part:22s} {value:8.1f} us")
    copied = parts["copy of the field"]
    print(f"  AUV-ticks per second and core: {robots / parts['whole tick'] * 1e6:,.0f}")
    print(
        f"  copy: {2 * other.nbytes / copied / 1e3:.0f} GB/s; "
        f"diffusion takes {parts['diffusion and decay'] / copied:.1f} copies"
    )


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "turbulence_T5e-4")
