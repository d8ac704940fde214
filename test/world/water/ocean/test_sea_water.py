"""The equation of state of sea water by the check values of its own publication."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.world.water.ocean.sea_water import density

# UNESCO technical papers in marine science 44 (1983), page 19: salinity, temperature [degC], pressure [bar], kg/m^3.
CHECKED = [
    (0.0, 5.0, 0.0, 999.96675),
    (0.0, 25.0, 0.0, 997.04796),
    (35.0, 5.0, 0.0, 1027.67547),
    (35.0, 25.0, 0.0, 1023.34306),
    (0.0, 5.0, 1000.0, 1044.12802),
    (0.0, 25.0, 1000.0, 1037.90204),
    (35.0, 5.0, 1000.0, 1069.48914),
    (35.0, 25.0, 1000.0, 1062.53817),
]


@pytest.mark.parametrize(("salinity", "temperature", "bar", "published"), CHECKED)
def test_published_values(salinity: float, temperature: float, bar: float, published: float) -> None:
    """To the last digit that is printed."""
    ours = density(*(np.array([number]) for number in (temperature, salinity, bar)))
    assert ours[0] == pytest.approx(published, abs=6e-6)
