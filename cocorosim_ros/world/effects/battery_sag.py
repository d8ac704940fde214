"""Thrust that falls as the battery empties: F (1 - fraction_lost t / duration), and no further after `duration`.

Assumes: the charge is used evenly, and the thrust follows it in a straight line.
"""

from __future__ import annotations

import math
from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.curve import is_thruster
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.search import Given, Search, Strength


@kernel
def battery_sag(share: Floats, fitting: Any, time: float, parameters: Floats) -> None:
    """Weaken the thrusters by what is lost by `time` [s]."""
    fraction_lost, duration = unpack(parameters, 2)
    used = min(max(time / duration, 0.0), 1.0)
    for actuator in range(share.shape[0]):
        if is_thruster(fitting.is_pump, fitting.curve, actuator):
            share[actuator] *= 1.0 - fraction_lost * used


BATTERY_SAG = Effect(
    summary="thrust that falls during the recording",
    opposite="thrust that rises during the recording",
    equation="T (1 - fraction_lost t / duration)",
    thrust=battery_sag,
    parameters=(
        Number(
            "fraction_lost",
            "1",
            "of the thrust, at the end",
            multiplies="N",
            gives="N",
            search=Strength(large=0.2),
            between=(-math.inf, 1.0),  # below zero where the thrust rises
            example=Example(0.1, "log of the voltage"),
            other_form=0.12,  # discharge curves bend
        ),
        Number(
            "duration",
            "s",
            "from the start to the end",
            neutral=600.0,
            sign="positive",
            needed=True,
            multiplies="1/s",
            gives="1",
            search=Given(lambda scene: scene.duration),
            example=Example(600.0, "length of the run"),
        ),
    ),
    search=Search(channel="surge", manoeuvre="repeat_at_end"),
    check="Log the battery's voltage; repeat the first manoeuvre at the end.",
)
