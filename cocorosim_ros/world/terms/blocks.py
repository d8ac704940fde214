"""The two blocks of a robot's state in which derivatives of readings are taken: horizontal and vertical motion.

Each block holds pose and velocity, then the random force of the water and the gust that drives it.
"""

from __future__ import annotations

HX, HY, HYAW, HU, HV, HR, HFX, HFY, HN, HGX, HGY, HGN = range(12)
HORIZONTAL = 12
VZ, VW, VFZ, VGZ = range(4)
VERTICAL = 4
