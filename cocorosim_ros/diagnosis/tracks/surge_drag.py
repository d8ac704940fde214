"""Drag ahead alone, as a factor: a bracket or a fouled bow slows a hull ahead and leaves it as it was to the side.

In rows of models the drag is that ahead, and ratios have that of the other axes: so these fall as it rises. Motion
along another axis then feels what it felt before, in all forms of the drag; motion along two at once does so too, but
for the forms that add to the drag by the total speed what goes with each axis' own (`effects.anisotropic_drag`).
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.tracks.columns import COLUMN, OWN_SURGE_DRAG
from cocorosim_ros.foundation.arrays import Floats

_FACTOR, _DRAG = COLUMN[OWN_SURGE_DRAG], COLUMN["drag"]
_RATIOS = [COLUMN["anisotropic_drag.sway_ratio"], COLUMN["anisotropic_drag.heave_ratio"]]


def with_surge_drag(row: Floats) -> Floats:
    """Row (columns,) whose drag and ratios are those that its factor of the drag ahead makes of them."""
    factor = row[_FACTOR]
    if factor == 1.0:
        return row
    changed = row.copy()
    changed[_DRAG] *= factor
    changed[_RATIOS] /= factor
    return changed
