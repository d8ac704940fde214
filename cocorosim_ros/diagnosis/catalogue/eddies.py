"""Eddies: water that turns about a place, a law of the water outside the catalogue.

A catalogue of uniform, sheared and swinging currents explains a part of any motion of the water. Without eddies among
the candidates, one of these currents would be named wrongly where the water turns.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Shape
from cocorosim_ros.diagnosis.criteria.catalogue import EDDIES
from cocorosim_ros.world.laws.law import Factor, Law, Product
from cocorosim_ros.world.terms.search import Scene

EDDY = "eddy"
"""Name of the simulator's effect; a model has one eddy at most."""
ALONG_X = Law("world_x", Product(Factor("y")))
"""Law under which an eddy is reported: of its two components the one along x."""
_AROUND = 9.94  # 2 pi / (1 - 1/e): circulation, divided by the core's radius and the velocity at its edge


def eddy_entry(scene: Scene) -> Entry:
    """Make the entry of an eddy whose centre lies in or a little beside the robots' range.

    Its amplitude is the circulation [m^2/s]; its shapes are centre [m; world] and radius of the core [m]. The velocity
    at a distance d is that of a Lamb-Oseen vortex: circulation / (2 pi d) (1 - exp(-d^2 / core^2)).
    """
    reach = max(scene.upper[0] - scene.lower[0], scene.upper[1] - scene.lower[1])
    large = _AROUND * EDDIES.fast * EDDIES.cores[-1] * reach
    return Entry(
        ALONG_X.text,
        "water that turns about a place",
        "V_c = c / (2 pi d) (1 - exp(-d^2 / core^2)) around (x, y) at the distance d",
        "surge",
        (Amplitude(f"{EDDY}.circulation", "coefficient", "m^2/s", large),),
        (
            Shape(f"{EDDY}.x", "x", "m", lambda here: _grid(here, 0)),
            Shape(f"{EDDY}.y", "y", "m", lambda here: _grid(here, 1)),
            Shape(
                f"{EDDY}.core", "core", "m", lambda here: [share * reach for share in EDDIES.cores], logarithmic=True
            ),
        ),
        water=True,
        law=EDDY,
        form=ALONG_X,
    )


def _grid(scene: Scene, axis: int) -> list[float]:
    """Places [m; world] of the centre to try along one axis, evenly spaced."""
    beside = EDDIES.beside * (scene.upper[axis] - scene.lower[axis])
    low, high = scene.lower[axis] - beside, scene.upper[axis] + beside
    return [low + (high - low) * (index + 0.5) / EDDIES.places for index in range(EDDIES.places)]
