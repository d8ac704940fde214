"""A spring towards a place: F = k (x0 - x), a cable or a thread that pulls."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import YAW, X, Y
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import MOVING_WATER
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength, spread


@kernel
def tether(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the pull, turned into the body."""
    stiffness, x, y = unpack(parameters, 3)
    pull_x = stiffness * (x - row[X])
    pull_y = stiffness * (y - row[Y])
    sine, cosine = sine_cosine(row[YAW])
    total[0] += pull_x * cosine + pull_y * sine
    total[1] += pull_y * cosine - pull_x * sine


def _places_along_x(scene: Scene) -> list[float]:
    reach = scene.upper[0] - scene.lower[0]
    return spread(scene.lower[0] - reach, scene.upper[0] + reach, 7)


def _places_along_y(scene: Scene) -> list[float]:
    reach = scene.upper[1] - scene.lower[1]
    return spread(scene.lower[1] - reach, scene.upper[1] + reach, 7)


def _three_pulls(values: Mapping[str, float]) -> list[tuple[dict[str, float], float]]:
    """-k (x - x0) is a sum of the pulls to three anchors."""
    x, y = values["x"], values["y"]
    anchors = (((0.0, 0.0), 1.0 - x - y), ((1.0, 0.0), x), ((0.0, 1.0), y))
    return [({**values, "x": place[0], "y": place[1]}, weight) for place, weight in anchors]


TETHER = Effect(
    summary="pull of a tether",
    equation="F = -k (place - anchor)",
    wrench=tether,
    parameters=(
        Number(
            "stiffness",
            "N/m",
            "pull per distance",
            multiplies="m",
            gives="N",
            search=Strength(large=8e-4, least=0.0),
            example=Example(3e-4, "spring balance"),
        ),
        Number(
            "x",
            "m",
            "the place, in the world",
            gives="m",
            search=Grid(_places_along_x),
            example=Example(0.5, "where it is fixed"),
        ),
        Number(
            "y",
            "m",
            "the place, in the world",
            gives="m",
            search=Grid(_places_along_y),
            example=Example(0.0, "where it is fixed"),
        ),
    ),
    search=Search(channel="surge", group=MOVING_WATER, manoeuvre="four_headings", basis=_three_pulls),
    check="A cable or line: see what it hangs on, and whether it lies at the place that is named.",
)
