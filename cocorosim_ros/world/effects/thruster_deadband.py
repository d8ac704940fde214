"""No thrust below a command: static friction of the motor, or the threshold of its driver.

Beyond it the thrust jumps to what the command asks for, or with `ramp` 1 grows from nothing: |c| - width.
Source: Bessa, Dutra and Kreuzer, Robotics and Autonomous Systems 58 (2010) 16, for the second.
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.curve import is_thruster
from cocorosim_ros.world.terms.effect import SHARE, Effect, Example, Number
from cocorosim_ros.world.terms.search import Grid, Search, Strength

WIDTHS = (0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2.0)
"""Widths from which a search begins, in `large` amounts: each command that a width passes makes a step in likelihood.

A vehicle that hovers with a fortieth of its thrust shows such a width within a few thousandths alone.
"""


@kernel
def thruster_deadband(fraction: Floats, fitting: Any, time: float, parameters: Floats) -> None:
    """Switch off the thrusters whose command is too small to move them."""
    width, ramp = unpack(parameters, 2)
    for actuator in range(fraction.shape[0]):
        if not is_thruster(fitting.is_pump, fitting.curve, actuator):
            continue
        if abs(fraction[actuator]) < width:
            fraction[actuator] = 0.0
        elif ramp != 0.0:
            fraction[actuator] -= width if fraction[actuator] > 0.0 else -width


THRUSTER_DEADBAND = Effect(
    summary="dead band of the thrusters",
    equation="T = 0 for |command| < width",
    command=thruster_deadband,
    parameters=(
        Number(
            "width",
            "1",
            "fraction of the largest command",
            sign="not negative",
            gives="1",
            other_form=0.04,  # thresholds that are rounded
            search=Strength(large=0.1, step=0.5, least=0.0, searched=WIDTHS),
            between=SHARE,
            example=Example(0.05, "slow ramp"),
        ),
        Number(
            "ramp",
            "1",
            "jump or 0: beyond it the whole command counts, ramp or 1: what exceeds it",
            sign="not negative",
            gives="1",
            search=Grid(lambda scene: [0.0, 1.0], fixed=True),
            example=Example(0.0, "slow ramp"),
        ),
    ),
    search=Search(channel="surge", manoeuvre="ramps_through_zero"),
    check="Raise each thruster's command slowly from zero, and note when the propeller starts.",
)
