"""The curve of an effect of the motion. The axis follows from the function: the first over which its values change.

First come what few effects depend on (neighbours, walls, height, time, place, heading), then the velocity of the
equation's own axis, the others, thrusts and commands. What changes over none of them is drawn over time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import BASIC_EFFECTS
from cocorosim_ros.world.motion.actuation import Fitting
from cocorosim_ros.world.state.state import MEMORY_SIZE
from cocorosim_ros.world.terms.curve import thrust_share
from cocorosim_ros.world.terms.effect import Effect
from cocorosim_ros.world.terms.equations import EQUATION_CODE, EQUATIONS
from site_builder.axes import axis_of
from site_builder.circumstances import Circumstances, cruising
from site_builder.curves import Curve, examples, neutrals, varies
from site_builder.lily import lily
from site_builder.plain_python import plain

PECULIAR = ("neighbour_distance", "wall_distance", "z", "t", "x", "y", "yaw")
OWN_SPEED = ("u", "v", "w", "r")  # in the order of X, Y, Z, N
OTHERS = ("v", "u", "w", "r", "thrust", "side_thrust", "command")
DIVING = 0.5  # of the full speed, upwards: for effects that a level robot does not have
Outcome = Callable[[Effect, Floats, Circumstances], Floats]


def effect_curve(name: str, effect: Effect) -> Curve | None:
    """The curve of an effect of EFFECTS at work on a Lily; None where it does nothing."""
    numbers = basic_numbers(effect) if name in BASIC_EFFECTS else examples(effect)
    if effect.response is not None:
        return _step_response(effect, numbers)
    outcome = next((each for hook, each in OUTCOMES.items() if getattr(effect, hook) is not None), None)
    if outcome is None:
        return None
    tried = (cruising(), cruising(w=DIVING * lily().speed))
    curves = (_along(effect, numbers, outcome, part, around) for around in tried for part in _parts(effect))
    return next((curve for curve in curves if curve.shows), None)


def basic_numbers(effect: Effect) -> Floats:
    """(numbers,) of a Lily, for an effect that every robot has."""
    return np.array([lily().number(number.name) for number in effect.parameters])


def pushed(effect: Effect, numbers: Floats, now: Circumstances) -> Floats:
    """(4,) X, Y, Z [N], N [N m; body] that an effect adds to the forces on the hull."""
    total = np.zeros(4)
    moment = () if effect in BASIC_EFFECTS.values() else (now.moment,)
    plain(effect.wrench)(now.row, now.relative, *moment, numbers, total)
    return total


def flowing(effect: Effect, numbers: Floats, now: Circumstances) -> Floats:
    """(3,) velocity of the water [m/s; world]."""
    total = np.zeros(3)
    plain(effect.water)(now.row[:3], now.t, numbers, total)
    return total


def driven(effect: Effect, numbers: Floats, now: Circumstances) -> Floats:
    """(4,) wrench of the thrusters at one command for all of them [N, N m; body]."""
    robot = lily()
    share = np.where(robot.is_pump, 0.0, now.command)
    if effect.command is not None:
        plain(effect.command)(share, _fitting(), now.t, numbers)
    if robot.curve.shape[1]:
        share = np.array([plain(thrust_share)(*each) for each in zip(robot.curve, share, strict=True)])
    if effect.thrust is not None:
        plain(effect.thrust)(share, _fitting(), now.t, numbers)
    return robot.pushed(share * np.where(share >= 0.0, robot.limit[:, 0], robot.limit[:, 1]))


def swung(effect: Effect, numbers: Floats, now: Circumstances) -> Floats:
    """(4,) X, Y, Z [N], N [N m; body] by which mass off the origin resists a turn at constant speed and rate."""
    place = np.zeros(2)
    plain(effect.centre)(numbers, place)
    ahead, left = lily().number("mass") * place
    about_origin = -now.r * (ahead * now.u + left * now.v)
    return np.array([ahead * now.r**2, left * now.r**2, 0.0, about_origin])


OUTCOMES: dict[str, Outcome] = {
    "water": flowing,
    "command": driven,
    "thrust": driven,
    "wrench": pushed,
    "centre": swung,
}
"""Functions of what is drawn, by the hook that an effect has."""


def _parts(effect: Effect) -> Iterator[int]:
    """The place of what is drawn in an outcome: the equation that shows the effect, else each, the first first."""
    if effect.search is not None and effect.water is None:
        yield EQUATION_CODE[effect.search.channel]
    else:
        yield from range(3 if effect.water else 4)


def _along(effect: Effect, numbers: Floats, outcome: Outcome, part: int, around: Circumstances) -> Curve:
    """One number of the outcome along the first axis over which it changes, all else as it is `around`."""
    what, unit, meaning = _words(effect, part)
    for name in (*PECULIAR, OWN_SPEED[part], *OTHERS, "t"):
        axis = axis_of(name, effect.numbers if name != "command" or effect.command else ())
        moments = [replace(around, **{name: float(value)}) for value in axis.values]
        values = np.array([outcome(effect, numbers, now)[part] for now in moments])
        if varies(values):
            break
    without = np.array([outcome(effect, neutrals(effect), now)[part] for now in moments])
    rising = f" of a robot that rises at {around.w:.2g} m/s" if around.w else ""
    caption = f"{meaning}{rising}, over {axis.meaning}"
    return Curve(axis, what, unit, caption, values, without)


def _words(effect: Effect, part: int) -> tuple[str, str, str]:
    """Symbol, unit and meaning of what is drawn."""
    if effect.water is not None:
        axis = "xyz"[part]
        return f"V_{axis}", "m/s", f"The velocity of the water along {axis} of the world"
    equation = EQUATIONS[part]
    adds = "What it adds to" if effect.wrench is not None or effect.centre is not None else "By the thrusters:"
    return equation.symbol, equation.unit, f"{adds} {equation.meaning}"


def _fitting() -> Fitting:
    robot = lily()
    return Fitting(robot.is_pump, robot.curve, robot.wrench[:, 3], robot.limit)


def _step_response(effect: Effect, numbers: Floats) -> Curve:
    """The answer of actuators to a step from nothing to the full command, as a share of it."""
    axis = axis_of("t", effect.numbers)
    with_it, without = (_after_a_step(effect, each, axis.values) for each in (numbers, neutrals(effect)))
    caption = "What an actuator gives after a step to the full command, over the time since then"
    return Curve(axis, "share of the command", "1", caption, with_it, without)


def _after_a_step(effect: Effect, numbers: Floats, times: Floats) -> Floats:
    """(points,) share of its full force that the actuator gives that is behind the most."""
    full = lily().limit[:, 0]
    memory = np.zeros(MEMORY_SIZE * len(full))
    shares = []
    for duration in np.diff(times, prepend=times[0]):
        force = full.copy()
        plain(effect.response)(full.copy(), memory, _fitting(), float(duration), numbers)
        plain(effect.response)(force, memory, _fitting(), 0.0, numbers)  # a mean over no time is that of the moment
        shares.append((force / full).min())
    return np.array(shares)
