"""What can be wrong with a log of speed, be it over ground or through the water: its gain, its angle, its place.

Each function changes the faults and says what it hid: the name of the effect, its numbers, its form in words.
"""

from __future__ import annotations

import math

import numpy as np

from concealer.scene import Faults, Secret, direction, signed

TOPICS = {"speed_log": "velocity", "ground_log": "ground_velocity"}


def scale(rng: np.random.Generator, amount: float, fault: Faults, log: str, duration: float) -> Secret:
    """A factor that swings as the water warms and cools; the number is its mean."""
    fault.log_scale = signed(rng, amount)
    fault.log_warmth = float(duration / rng.integers(2, 5)), rng.uniform(-math.pi, math.pi)
    form = "1 + s (1 + 0.3 sin(2 pi t / T)), whole periods; scale: the mean"
    return Secret(f"{log}_scale", {"scale": 1.0 + fault.log_scale}, form, TOPICS[log])


def misalignment(rng: np.random.Generator, amount: float, fault: Faults, log: str) -> Secret:
    """Two beams that are turned nearly alike; the number is the mean of both angles."""
    angle, apart = signed(rng, amount), rng.uniform(-0.1, 0.1)
    fault.log_turn = angle * (1.0 + apart), angle * (1.0 - apart)
    return Secret(f"{log}_misalignment", {"angle": angle}, "each beam turned by itself; angle: the mean", TOPICS[log])


def lever(rng: np.random.Generator, amount: float, fault: Faults, log: str) -> Secret:
    """A log on a pole, which turns to one side lean outwards and those to the other inwards; the number is the mean."""
    fault.log_place, fault.log_swing = direction(rng, amount), rng.uniform(-0.15, 0.15)
    ahead, left = fault.log_place
    form = "(ahead, left) times 1 + s sign(r); ahead, left: the mean of both turns"
    return Secret(f"{log}_lever", {"ahead": ahead, "left": left}, form, TOPICS[log])
