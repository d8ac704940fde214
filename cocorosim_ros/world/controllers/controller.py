"""What a controller is: two small compiled functions and the names of its settings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH

# Topics of a robot that exist only where its controller asks for them.
EXTRA_TOPICS = ("illuminance", "concentration", "blue_light_rx", "neighbours", "acoustic_rx")
MEDIA = ("radio", "blue_light", "acoustic")


@kernel
def stay_silent(observation: Observation, settings: Floats, message: Floats) -> None:
    """Say nothing."""
    message[MESSAGE_LENGTH] = 0.0


@dataclass(frozen=True)
class Controller:
    """One behaviour.

    `decide(observation, sensor_axis, settings, request)` changes `request` (controllers.request), which keeps
    its values from tick to tick; `sensor_axis` (sensors, 3) are the cone axes of the robot's own blue-light
    sensors. `speak(observation, settings, message)` writes what is said over its medium (state.radio).
    `settings` are the numbers of the controller's YAML file in the order of `settings` below, SI units.
    """

    summary: str
    settings: tuple[str, ...]
    decide: Callable[..., Any]
    speak: Callable[..., Any] = stay_silent
    payload_length: int = 0  # numbers per message
    medium: Literal["radio", "blue_light", "acoustic"] = "radio"  # over which it speaks
    needs: tuple[str, ...] = ()  # what its robot senses and hears for it alone, of EXTRA_TOPICS
