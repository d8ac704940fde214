"""What a behaviour asks for when it sees and hears what a test says."""

from __future__ import annotations

from collections.abc import Callable
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
    from cocorosim_ros.controllers import CONTROLLERS
    from cocorosim_ros.controllers.conduct import blank_memory
    from cocorosim_ros.controllers.request import REQUEST_SIZE
    from cocorosim_ros.signals.observation import blank_observation

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
