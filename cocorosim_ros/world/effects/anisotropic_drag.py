"""Quadratic drag that differs from axis to axis; k is the drag of the basic physics, a and b the ratios to surge.

What pure motion along an axis feels is agreed, what mixed motion feels is not; so there are several forms. Three of
them add to the drag -k U V, U the total speed, that is the same in all directions:
total speed: Y = -k (a - 1) U v, Z = -k (b - 1) U w;
own speed: Y = -k (a - 1) |v| v, Z = -k (b - 1) |w| w;
strips: as own speed, but each strip of a hull of `length` meets the water sideways at its own v + x r, which couples
sway and yaw: Y = -k (a - 1) / L integral |v + x r| (v + x r) dx, N the same with x; turning on the spot, which the yaw
drag holds already, is left out.
Two more replace that drag, so that no axis feels another one's speed; a and b are then whole coefficients over surge's:
each axis: X = -k |u| u, Y = -k a |v| v, Z = -k b |w| w;
each axis, strips: the same with the strips' integral in place of |v| v.
Source: Fossen (2021), section 6.4, with the total speed of Read et al. 2013, equation (1); strips: his section 6.4.3 on
cross-flow drag.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength

TOTAL_SPEED, OWN_SPEED, STRIPS = 0.0, 1.0, 2.0  # in the order of scenario.reading.worded_numbers
EACH_AXIS, EACH_AXIS_STRIPS = 3.0, 4.0
ADDING, REPLACING = (TOTAL_SPEED, OWN_SPEED, STRIPS), (EACH_AXIS, EACH_AXIS_STRIPS)
STILL = 1e-4  # rad/s, below which strips all move alike


@kernel
def _strip_force(aside: float, turn: float, length: float) -> float:
    """1 / L integral |v + x r| (v + x r) dx over the length [m^2/s^2]."""
    if abs(turn) < STILL:
        return abs(aside) * aside
    stern, bow = aside - 0.5 * turn * length, aside + 0.5 * turn * length
    return (abs(bow) ** 3 - abs(stern) ** 3) / (3.0 * turn * length)


@kernel
def _strip_moment(aside: float, turn: float, length: float) -> float:
    """1 / L integral x |v + x r| (v + x r) dx over the length [m^3/s^2]."""
    if abs(turn) < STILL:
        return 2.0 * abs(aside) * turn * length * length / 12.0
    stern, bow = aside - 0.5 * turn * length, aside + 0.5 * turn * length
    fourth = 0.25 * (abs(bow) * bow**3 - abs(stern) * stern**3)
    return (fourth - aside * (abs(bow) ** 3 - abs(stern) ** 3) / 3.0) / (turn * turn * length)


@kernel
def _replace_drag(relative: Floats, drag: float, total: Floats) -> None:
    """Take back the drag by the total speed, and put in surge's by its own."""
    speed = math.sqrt(relative[0] ** 2 + relative[1] ** 2 + relative[2] ** 2)
    for axis in range(3):
        total[axis] += drag * speed * relative[axis]
    total[0] -= drag * abs(relative[0]) * relative[0]


@kernel
def anisotropic_drag(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add what the ratios add to the drag that is the same in all directions."""
    sway_ratio, heave_ratio, form, length = unpack(parameters, 4)
    sway, heave = sway_ratio - 1.0, heave_ratio - 1.0
    u, v, w, r = relative[0], relative[1], relative[2], relative[3]
    if form >= EACH_AXIS:
        _replace_drag(relative, moment.drag, total)
        sway, heave = sway + 1.0, heave + 1.0
    if form == TOTAL_SPEED:
        speed = math.sqrt(u**2 + v**2 + w**2)
        total[1] -= sway * moment.drag * speed * v
        total[2] -= heave * moment.drag * speed * w
        return
    total[2] -= heave * moment.drag * abs(w) * w
    if form in (OWN_SPEED, EACH_AXIS) or length <= 0.0:
        total[1] -= sway * moment.drag * abs(v) * v
        return
    total[1] -= sway * moment.drag * _strip_force(v, r, length)
    total[3] -= sway * moment.drag * (_strip_moment(v, r, length) - _strip_moment(0.0, r, length))


FORM_BY_NAME = {"total_speed": TOTAL_SPEED, "own_speed": EACH_AXIS, "strips": EACH_AXIS_STRIPS}
"""Form of the whole drag by the word that a platform file has for it."""


def _forms(scene: Scene) -> list[float]:
    """The forms of a difference between axes that fit the form of the drag itself."""
    return [scene.drag_form] if scene.drag_form in REPLACING else [*ADDING]


def _lengths(scene: Scene) -> list[float]:
    return [0.6 * scene.hull, scene.hull, 1.6 * scene.hull]


ANISOTROPIC_DRAG = Effect(
    summary="drag that differs between axes",
    wrench=anisotropic_drag,
    parameters=(
        Number(
            "sway_ratio",
            "1",
            "coefficient sideways over that forwards",
            neutral=1.0,
            sign="not negative",
            multiplies="kg m/s^2",  # k U v
            gives="N",
            part="Y = -k_v U v with k_v unlike k_u",
            other_form=0.16,  # powers of the speed from 1.5 to 2.5, at other speeds
            search=Strength(large=2.0, least=-0.45),
            example=Example(2.0, "towing"),
        ),
        Number(
            "heave_ratio",
            "1",
            "coefficient upwards over that forwards",
            neutral=1.0,
            sign="not negative",
            multiplies="kg m/s^2",  # k U v
            gives="N",
            part="Z = -k_w U w with k_w unlike k_u",
            other_form=0.12,  # powers of the speed from 1.5 to 2.5, at other speeds
            search=Strength(large=2.0, least=-0.45),
            example=Example(1.5, "towing"),
        ),
        Number(
            "form",
            "1",
            "total_speed or 0: by the total speed, added_own_speed or 1: what is added by each axis' own speed, "
            "added_strips or 2: by strips, own_speed or 3: all by each axis' own speed, strips or 4: all by own speed "
            "and strips",
            sign="not negative",
            gives="1",
            search=Grid(_forms, fixed=True),
            example=Example(2.0, "the hull is long"),
        ),
        Number(
            "length",
            "m",
            "of the hull, for strips",
            sign="not negative",
            multiplies="rad/s",
            gives="m/s",  # x r beside v
            search=Grid(_lengths, logarithmic=True),
            example=Example(0.13, "ruler"),
        ),
    ),
    search=Search(channel="sway", group=DRAG, manoeuvre="zig_zag"),
    check="A hull whose side or top resists more than its bow: compare pushes sideways and ahead.",
)
