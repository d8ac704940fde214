"""Thrusters that are weaker backwards than the platform says: F (1 - loss) for commands below zero."""

from __future__ import annotations

import math
from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.curve import is_thruster
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def reverse_loss(share: Floats, fitting: Any, time: float, parameters: Floats) -> None:
    """Weaken the thrusters that run backwards."""
    (loss,) = unpack(parameters, 1)
    for actuator in range(share.shape[0]):
        if is_thruster(fitting.is_pump, fitting.curve, actuator) and share[actuator] < 0.0:
            share[actuator] *= 1.0 - loss


REVERSE_LOSS = Effect(
    summary="thrust that is weaker backwards",
    opposite="thrust that is stronger backwards",
    equation="T (1 - loss) for command < 0",
    thrust=reverse_loss,
    parameters=(
        Number(
            "loss",
            "1",
            "fraction of the thrust that is lost",
            multiplies="N",
            gives="N",
            other_form=0.05,  # losses that set in with the speed or the thrust
            search=Strength(large=0.2),
            between=(-math.inf, 1.0),  # below zero where it pushes harder backwards
            example=Example(0.15, "bollard pull"),
        ),
    ),
    search=Search(channel="surge", manoeuvre="reverse_steps"),
    check="Propellers push less backwards: weigh the thrust in both directions.",
)
