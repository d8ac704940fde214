"""Water that turns about a place: a law of the water outside the catalogue.

Where something is wrong with the water, a catalogue of uniform, sheared and swinging currents explains a part of any
motion that it has, and the first of them would be blamed for it.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.world.laws.law import Factor, Law, Product

EDDY = "eddy"
"""The simulator's effect, of which a model has one."""
ALONG_X = Law("world_x", Product(Factor("y")))
"""As what it is reported: of its two halves the one along x."""
_PLACES = 6  # along each axis
_BESIDE = 0.25  # of the robots' range along an axis: how far beside it the axis of an eddy may stand
_CORES = (0.2, 0.6)  # of how far the robots have been
_FAST = 0.005  # m/s at the edge of the core in a bad case
_AROUND = 9.94  # 2 pi / (1 - 1/e): circulation over core and velocity at its edge


def eddy_entry(scene: Scene) -> Entry:
    """An eddy where the robots have been or a little beside; its coefficient is the circulation."""
    reach = max(scene.upper[0] - scene.lower[0], scene.upper[1] - scene.lower[1])
    large = _AROUND * _FAST * _CORES[-1] * reach
    return Entry(
        ALONG_X.text,
        "a law outside the catalogue: water that turns about a place, along x in proportion to y and along y to x",
        "V_c = c / (2 pi d) (1 - exp(-d^2 / core^2)) around (x, y) at the distance d",
        "surge",
        (Amplitude(f"{EDDY}.circulation", "coefficient", "m^2/s", large),),
        (
            Shape(f"{EDDY}.x", "x", "m", lambda here: _grid(here, 0)),
            Shape(f"{EDDY}.y", "y", "m", lambda here: _grid(here, 1)),
            Shape(f"{EDDY}.core", "core", "m", lambda here: [share * reach for share in _CORES], logarithmic=True),
        ),
        water=True,
        law=EDDY,
        form=ALONG_X,
    )


def _grid(scene: Scene, axis: int) -> list[float]:
    beside = _BESIDE * (scene.upper[axis] - scene.lower[axis])
    low, high = scene.lower[axis] - beside, scene.upper[axis] + beside
    return [low + (high - low) * (index + 0.5) / _PLACES for index in range(_PLACES)]
