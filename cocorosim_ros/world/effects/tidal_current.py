"""A current that swings in time, as this robot feels it: (x, y) sin(2 pi t / period + phase).

The velocity itself is that of currents.tidal.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import MOVING_WATER
from cocorosim_ros.world.terms.phases import phased, phases
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength
from cocorosim_ros.world.water.currents.tidal import tidal


def _periods(scene: Scene) -> list[float]:
    return list(scene.periods["current"])


TIDAL_CURRENT = Effect(
    summary="current that swings",
    water=tidal,
    parameters=(
        Number(
            "x",
            "m/s",
            "amplitude along x of the world",
            gives="m/s",
            part="V_cx = x sin(2 pi t / period + phase)",
            search=Strength(large=0.007),
            example=Example(0.004, "drift"),
        ),
        Number(
            "y",
            "m/s",
            "amplitude along y of the world",
            gives="m/s",
            part="V_cy = y sin(2 pi t / period + phase)",
            search=Strength(large=0.007),
            example=Example(0.001, "drift"),
        ),
        Number(
            "period",
            "s",
            "time of one swing",
            neutral=60.0,
            sign="positive",
            needed=True,
            multiplies="1/s",
            gives="1",
            search=Grid(_periods, logarithmic=True, swing=True),
            example=Example(120.0, "drift"),
        ),
        Number(
            "phase",
            "rad",
            "phase at time zero",
            gives="rad",
            search=Grid(phases, periodic=True),
            example=Example(0.5, "drift"),
        ),
    ),
    search=Search(channel="surge", water=True, group=MOVING_WATER, manoeuvre="four_headings", basis=phased("phase")),
    check="A pump that cycles, a tide, a seiche of the tank: compare the period with what runs near by.",
)
