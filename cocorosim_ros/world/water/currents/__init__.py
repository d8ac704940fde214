"""CURRENTS: the velocity fields that water can have. Several in one scenario add up, in its order."""

from __future__ import annotations

from cocorosim_ros.world.water.current import Current
from cocorosim_ros.world.water.currents.gridded import GRIDDED
from cocorosim_ros.world.water.currents.ocean import OCEAN
from cocorosim_ros.world.water.currents.sheared import SHEARED
from cocorosim_ros.world.water.currents.tidal import TIDAL
from cocorosim_ros.world.water.currents.uniform import UNIFORM
from cocorosim_ros.world.water.currents.vortex import VORTEX
from cocorosim_ros.world.water.currents.waves import WAVES

CURRENTS: dict[str, Current] = {
    "uniform": UNIFORM,
    "sheared": SHEARED,
    "tidal": TIDAL,
    "vortex": VORTEX,
    "gridded": GRIDDED,
    "ocean": OCEAN,
    "waves": WAVES,
}
