"""From a sea to its waves: the JONSWAP spectrum in components of their own frequency, length and phase.

S(omega) ~ omega^-5 exp(-5/4 (omega_p / omega)^4) gamma^exp(-(omega - omega_p)^2 / (2 sigma^2 omega_p^2)), sigma = 0.07
below the peak and 0.09 above (Hasselmann et al. 1973, Measurements of wind-wave growth and swell decay during the Joint
North Sea Wave Project, equation 2.4.1), scaled so that the significant height is 4 sqrt(m0).
Dispersion: omega^2 = g k tanh(k h) (Dean and Dalrymple, Water Wave Mechanics, 1991, equation 3.34).
Assumes: all waves go one way, of small steepness. Frequencies lie at random in equal intervals, so that the sea does
not repeat itself.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.waves import Waves

GRAVITY = 9.81  # m/s^2
COMPONENTS = 32
_BAND = (0.5, 4.0)  # of the peak's frequency; 0.9997 of the energy of a JONSWAP sea
_STEPS = 50
_STEEPEST = 0.142  # height over length at which waves break in deep water (Miche 1944)


def spectrum(omega: Floats, peak: float, peakedness: float) -> Floats:
    """The JONSWAP spectrum, of any scale, at frequencies [rad/s] with its peak at `peak` [rad/s]."""
    width = np.where(omega <= peak, 0.07, 0.09)
    nearness = np.exp(-((omega - peak) ** 2) / (2.0 * width**2 * peak**2))
    return np.asarray(omega**-5.0 * np.exp(-1.25 * (peak / omega) ** 4) * peakedness**nearness)


def wave_numbers(omega: Floats, depth: float) -> Floats:
    """k [rad/m] of waves of these frequencies [rad/s] in water of this depth [m], by Newton's method."""
    deep = omega**2 / GRAVITY
    k = deep / np.sqrt(np.tanh(deep * depth))  # Eckart's guess, within 5 %
    for _ in range(_STEPS):
        tanh = np.tanh(k * depth)
        k = k - (k * tanh - deep) / (tanh + k * depth * (1.0 - tanh**2))
    return np.asarray(k)


def sea_numbers(waves: Waves, depth: float, random: np.random.Generator) -> Floats:
    """The components of a sea in water of this depth [m], as water.currents.waves lays them out."""
    peak = 2.0 * math.pi / waves.period
    edges = peak * np.linspace(*_BAND, COMPONENTS + 1)
    omega = edges[:-1] + random.random(COMPONENTS) * np.diff(edges)
    phase = random.uniform(0.0, 2.0 * math.pi, COMPONENTS)
    energy = spectrum(omega, peak, waves.peakedness)
    amplitude = np.sqrt(2.0 * (waves.height / 4.0) ** 2 * energy / energy.sum())
    k = wave_numbers(omega, depth)
    along, across = math.cos(waves.direction), math.sin(waves.direction)
    rows = np.column_stack([amplitude, omega, k, k * along, k * across, phase])
    return np.concatenate([[depth], rows.ravel()])


def breaks(waves: Waves, depth: float) -> float | None:
    """The height [m] from which the sea's waves of peak period would break in this depth [m]; None if they do not."""
    k = float(wave_numbers(np.array([2.0 * math.pi / waves.period]), depth)[0])
    highest = _STEEPEST * 2.0 * math.pi / k * math.tanh(k * depth)
    return highest if waves.height > highest else None
