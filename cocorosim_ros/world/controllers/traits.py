"""What a robot's controller asks for and how it speaks, whichever way it is written."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.controller_choice import AnyController
from cocorosim_ros.scenario.parts.controller_file import ControllerDescription
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.world.controllers import CONTROLLERS
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.plain.user_class import load_class


class Traits(NamedTuple):
    """What others must know of a controller."""

    needs: tuple[str, ...]  # topics of EXTRA_TOPICS that exist for it alone
    medium: str  # of MEDIA, over which it speaks
    speaks: bool  # it has a message at every tick, which may be empty


def traits_of(controller: AnyController) -> Traits:
    """The traits of a controller. Raises CocorosimError: no such behaviour, or no such class in the user's file."""
    if isinstance(controller, PythonController):
        user_class = load_class(controller)
        return Traits(user_class.needs(), user_class.medium(), speaks=True)
    behaviour = behaviour_of(controller)
    return Traits(behaviour.needs, behaviour.medium, behaviour.payload_length > 0)


def needs_sound(traits: Traits) -> bool:
    """Whether a controller speaks or hears by sound."""
    return traits.medium == "acoustic" or "acoustic_rx" in traits.needs


def behaviour_of(description: ControllerDescription) -> Controller:
    """The entry of CONTROLLERS that a controller file names. Raises CocorosimError if there is none."""
    if description.behaviour not in CONTROLLERS:
        raise CocorosimError(
            f"{description.origin}: 'behaviour' has '{description.behaviour}', which does not exist; "
            f"allowed: {', '.join(CONTROLLERS)}."
        )
    return CONTROLLERS[description.behaviour]
