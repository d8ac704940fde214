"""A current that changes linearly with place, as this robot feels it.

The velocity itself is that of currents.sheared.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import MOVING_WATER
from cocorosim_ros.world.terms.search import Search, Strength
from cocorosim_ros.world.water.currents.sheared import sheared

SHEARED_CURRENT = Effect(
    summary="current that changes with place",
    water=sheared,
    parameters=(
        Number(
            "x",
            "m/s",
            "velocity along x at the world's origin",
            gives="m/s",
            part="V_cx = x at the origin",
            search=Strength(large=0.005),
            example=Example(0.003, "drift"),
        ),
        Number(
            "y",
            "m/s",
            "velocity along y at the world's origin",
            gives="m/s",
            part="V_cy = y at the origin",
            search=Strength(large=0.005),
            example=Example(0.0, "drift"),
        ),
        Number(
            "dx_dy",
            "1/s",
            "change of x along y",
            multiplies="m",
            gives="m/s",
            part="dV_cx / dy = dx_dy",
            search=Strength(large=0.005),
            example=Example(0.002, "drift"),
            other_form=0.08,  # profiles bend
        ),
        Number(
            "dx_dz",
            "1/s",
            "change of x upwards",
            multiplies="m",
            gives="m/s",
            part="dV_cx / dz = dx_dz",
            search=Strength(large=0.005),
            example=Example(0.001, "drift"),
            other_form=0.08,  # profiles bend
        ),
        Number(
            "dy_dx",
            "1/s",
            "change of y along x",
            multiplies="m",
            gives="m/s",
            part="dV_cy / dx = dy_dx",
            search=Strength(large=0.005),
            example=Example(-0.002, "drift"),
            other_form=0.08,  # profiles bend
        ),
        Number(
            "dy_dz",
            "1/s",
            "change of y upwards",
            multiplies="m",
            gives="m/s",
            part="dV_cy / dz = dy_dz",
            search=Strength(large=0.005),
            example=Example(0.0, "drift"),
            other_form=0.08,  # profiles bend
        ),
    ),
    search=Search(channel="surge", water=True, group=MOVING_WATER, manoeuvre="four_headings"),
    check="An inflow or a wall near by: let floats drift at several places and depths.",
)
