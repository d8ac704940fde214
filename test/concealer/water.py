"""Random forces of the water: Gaussian processes with a Matern-3/2 spectrum.

    dx = v dt,  dv = -(k^2 x + 2 k v) dt + sqrt(4 k^3) rms dB,   k = 2 / T

The autocovariance is rms^2 (1 + k|t|) exp(-k|t|); its integral over all times is 2 T rms^2, so T is the correlation
time (for an Ornstein-Uhlenbeck process too). Rasmussen & Williams 2006, eq. 4.17; Hartikainen & Sarkka 2010.
"""

from __future__ import annotations

import math

import numpy as np

from concealer.layout import FloatArray


def transition(step: float, correlation: float) -> tuple[FloatArray, FloatArray]:
    """Exact (2, 2) transition of (x, v) over a step [s], and the Cholesky factor of its noise, for rms 1."""
    k = 2.0 / correlation
    decay = math.exp(-k * step)
    move = decay * np.array([[1.0 + k * step, step], [-k * k * step, 1.0 - k * step]])
    stationary = np.diag([1.0, k * k])
    noise = stationary - move @ stationary @ move.T
    return move, np.linalg.cholesky(noise + 1e-15 * stationary)


def matern(rng: np.random.Generator, shape: tuple[int, int], step: float, correlation: float) -> FloatArray:
    """(n, series) independent processes of rms 1, n samples `step` apart; it starts in its stationary state."""
    from scipy.signal import lfilter

    count, series = shape
    move, root = transition(step, correlation)
    start = rng.standard_normal((2, series)) * np.array([[1.0], [2.0 / correlation]])
    kicks = root @ rng.standard_normal((count, 2, series)).transpose(1, 0, 2).reshape(2, -1)
    kicks = kicks.reshape(2, count, series)
    # Elimination of v leaves x as an ARMA(2, 1) of the kicks, which a filter runs without a loop.
    trace, determinant = float(np.trace(move)), float(np.linalg.det(move))
    driven = kicks[0].copy()
    driven[1:] += move[0, 1] * kicks[1][:-1] - move[1, 1] * kicks[0][:-1]
    driven[0] += move[0] @ start
    driven[1] += move[0, 1] * (move[1] @ start) + move[0, 0] * (move[0] @ start) - trace * (move[0] @ start)
    return np.asarray(lfilter([1.0], [1.0, -trace, determinant], driven, axis=0), dtype=np.float64)
