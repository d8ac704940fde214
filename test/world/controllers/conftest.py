"""What a behaviour asks for when it sees and hears what a test says."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest


@pytest.fixture(scope="session")
def decide_once(blue_light: SimpleNamespace) -> Callable[..., Any]:
    """Function of (controller, settings, request or None, and fields of the observation): the request afterwards.

    `ranges` are neighbour ranges by sensor; `light` and `heard` lists of velocities; `places` and `velocities` the
    exact neighbours.
    """
    from cocorosim_ros.world.controllers import CONTROLLERS
    from cocorosim_ros.world.controllers.conduct import blank_memory
    from cocorosim_ros.world.controllers.request import REQUEST_SIZE
    from cocorosim_ros.world.state.observation import blank_observation

    def ask(controller: str, settings: Any, request: Any = None, **seen: Any) -> Any:
        observation = blank_observation(5, 8)
        for sensor, distance in seen.pop("ranges", {}).items():
            observation.neighbour_range[sensor] = distance
        for name in ("heard", "light"):
            velocities = seen.pop(name, ())
            for index, velocity in enumerate(velocities):
                getattr(observation, name)[index, :4] = (3.0, *velocity)
            seen[f"{name}_count"] = len(velocities)
        places, velocities = np.reshape(seen.pop("places", []), (-1, 3)), seen.pop("velocities", None)
        observation.neighbour_offset[: len(places)] = places
        if velocities is not None:
            observation.neighbour_velocity[: len(places)] = velocities
        seen = {"compass": 0.0, "neighbour_count": len(places), **seen}
        if request is None:
            request = blank_memory(1, 1)[0, 0, :REQUEST_SIZE].copy()
        settings = np.asarray(settings, dtype=float)
        CONTROLLERS[controller].decide(observation._replace(**seen), blue_light.axes, settings, request)
        return request

    return ask


@pytest.fixture(scope="session")
def nearest_to_the_leak() -> Callable[..., Any]:
    """Function of a steering: how near 20 Lilys came to the leak of the scenario plume_tracking in ten minutes (20,).

    They start up to 9 m downstream and 2 m aside; the leak has run for 15 minutes before; its puffs are larger and
    fewer, which is quicker. A steering, called at every tick with its number and the simulation, gives their headings
    (20,) [rad]; without one they surge and cast.
    """
    from cocorosim_ros.world.checks.loading import load_scenario
    from cocorosim_ros.world.controllers.plume_tracking import ARRIVAL, THRESHOLD, UPSTREAM
    from cocorosim_ros.world.tick.assembly import build_world
    from cocorosim_ros.world.tick.simulation import Simulation

    def swim(steering: Callable[[int, Any], Any] | None = None) -> Any:
        scenario = load_scenario("plume_tracking")
        assert scenario.water is not None and scenario.water.plume is not None
        plume = replace(scenario.water.plume, interval_ns=10_000_000_000, initial_size=0.1)
        scenario = replace(
            scenario, water=replace(scenario.water, plume=plume), swarm=(replace(scenario.swarm[0], count=20),)
        )
        draw = np.random.default_rng(7)
        low, high = (-5.0, -2.0, -1.0, -math.pi), (3.0, 2.0, -1.0, math.pi)
        simulation = Simulation(build_world(scenario), draw.uniform(low, high, (1, 20, 4)))
        for tick in range(1800):
            simulation.water.advance(tick, simulation.state, simulation.world.tank, scenario.tick_ns)
        settings = simulation.world.crew.settings
        if steering is not None:
            settings[:, THRESHOLD], settings[:, ARRIVAL] = 0.0, math.inf  # they surge at every smell, on and on
        nearest = np.full(20, np.inf)
        for tick in range(1200):
            simulation.sense()
            if steering is not None:
                settings[:, UPSTREAM] = steering(tick, simulation)
            simulation.decide()
            simulation.advance()
            nearest = np.minimum(nearest, np.linalg.norm(simulation.state[0, :, :3] - plume.source, axis=1))
        return nearest

    return swim
