"""Density of sea water by temperature, salinity and pressure: the equation of state of 1980 (EOS-80).

Source: Fofonoff and Millard, Algorithms for computation of fundamental properties of seawater, UNESCO technical papers
in marine science 44 (1983), pages 15 to 19.
Assumes: practical salinity; temperatures in place, for which the potential ones of ocean models are taken (they differ
by 0.01 degC per 100 m, which is 0.002 kg/m^3).
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats

BAR_PER_METRE = 0.1006  # of sea water of 1025 kg/m^3


def _polynomial(value: Floats, *coefficients: float) -> Floats:
    """The sum of coefficients times rising powers of a value."""
    return np.asarray(np.polynomial.polynomial.polyval(value, coefficients), dtype=np.float64)


def density(temperature: Floats, salinity: Floats, bar: Floats) -> Floats:
    """Density [kg/m^3] at temperatures [degC, -2 to 40], practical salinities [0 to 42], pressures [bar above air's].

    Arrays of one shape, or of shapes that go together.
    """
    t, s, root = temperature, salinity, np.sqrt(salinity) * salinity
    fresh = _polynomial(t, 999.842594, 6.793952e-2, -9.095290e-3, 1.001685e-4, -1.120083e-6, 6.536332e-9)
    by_salt = _polynomial(t, 0.824493, -4.0899e-3, 7.6438e-5, -8.2467e-7, 5.3875e-9)
    by_root = _polynomial(t, -5.72466e-3, 1.0227e-4, -1.6546e-6)
    at_surface = fresh + by_salt * s + by_root * root + 4.8314e-4 * s * s
    modulus = _polynomial(t, 19652.21, 148.4206, -2.327105, 1.360477e-2, -5.155288e-5)
    modulus += s * _polynomial(t, 54.6746, -0.603459, 1.09987e-2, -6.1670e-5)
    modulus += root * _polynomial(t, 7.944e-2, 1.6483e-2, -5.3009e-4)
    linear = _polynomial(t, 3.239908, 1.43713e-3, 1.16092e-4, -5.77905e-7)
    linear += s * _polynomial(t, 2.2838e-3, -1.0981e-5, -1.6078e-6) + 1.91075e-4 * root
    squared = _polynomial(t, 8.50935e-5, -6.12293e-6, 5.2787e-8) + s * _polynomial(t, -9.9348e-7, 2.0816e-8, 9.1697e-10)
    return np.asarray(at_surface / (1.0 - bar / (modulus + linear * bar + squared * bar * bar)))
