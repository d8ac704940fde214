"""The number of a law of the table that comes nearest to a concealed force of another form, along a recording.

Least squares over the whole recording of the difference of the two forces, each axis over full thrust or full torque,
by the parameters of the law alone: the platform's own numbers stay the true ones.
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import numpy as np
from scipy.optimize import least_squares

from concealer import layout as at
from concealer.compiled import compiled
from concealer.forms import BLOCK, GAIN, HYSTERETIC, SCALE_X, block_force, form_force
from concealer.layout import FloatArray

EVERY = 5  # rows: 0.1 s
UNIT = np.array([at.FULL_THRUST, at.FULL_THRUST, at.FULL_THRUST, at.FULL_TORQUE])

# Where the Concealer has the parameters of the table's law, with what is to be added to them.
PLACES: dict[str, dict[str, tuple[tuple[int, ...], float]]] = {
    "linear_drag": {
        "surge": ((at.LINEAR_SURGE,), 0.0), "sway": ((at.LINEAR_SWAY,), 0.0),
        "heave": ((at.LINEAR_HEAVE,), 0.0), "yaw": ((at.LINEAR_YAW,), 0.0),
    },
    "anisotropic_drag": {"sway_ratio": ((at.CROSS_SWAY,), 1.0), "heave_ratio": ((at.CROSS_HEAVE,), 1.0)},
    "tether": {"stiffness": ((at.TETHER,), 0.0), "x": ((at.TETHER_X,), 0.0), "y": ((at.TETHER_Y,), 0.0)},
    "thruster_deadband": {"width": ((at.DEAD_CONTINUOUS, at.DEAD_JUMP), 0.0)},
    "thruster_asymmetry": {"difference": ((at.ASYMMETRY,), 0.0)},
    "thruster_misalignment": {"angle": ((at.MISALIGNMENT,), 0.0)},
    "reverse_loss": {"loss": ((at.REVERSE_LOSS,), 0.0)},
    "advance_loss": {"slope": ((at.ADVANCE,), 0.0)},
    "torque_bias": {"torque": ((at.TORQUE_BIAS,), 0.0)},
    "buoyancy_trim": {"force": ((at.TRIM,), 0.0)},
    "payload_shift": {"force": ((at.PAYLOAD_FORCE,), 0.0)},
    "hull_compressibility": {"gradient": ((at.SHRINK,), 0.0)},
    "stratification": {"depth": ((at.LAYER_DEPTH,), 0.0), "force": ((at.LAYER_FORCE,), 0.0)},
}  # fmt: skip
# What makes the Concealer's own law the table's: no softening, no bend, no gas law, strips without length.
LIMITS = {
    "tether": {at.TETHER_SOFT: 1e9}, "advance_loss": {at.ADVANCE_CURVE: 0.0},
    "hull_compressibility": {at.SHRINK_SCALE: 1e9}, "anisotropic_drag": {at.STRIP_LENGTH: 0.0},
}  # fmt: skip


@compiled
def force_series(p: FloatArray, rows: FloatArray, commands: FloatArray, k: int, plain: bool) -> FloatArray:
    """(ticks, 4) force of block k of a robot's numbers (WIDE,) along a trajectory (rows, ROW), plain or by its form."""
    out = np.zeros((commands.shape[0], 4))
    for tick in range(commands.shape[0]):
        row = rows[EVERY * tick]
        if plain:
            out[tick] = block_force(p, row, commands[tick], tick * at.TICK, k)
        else:
            out[tick] = form_force(p, row, commands[tick], tick * at.TICK, k)
    return out


def fit_scale(p: FloatArray, rows: FloatArray, commands: FloatArray, k: int) -> FloatArray:
    """(4,) rms of the plain force of a block on each axis; 1 where there is none."""
    rms = np.sqrt(np.mean(force_series(p, rows, commands, k, True) ** 2, axis=0))
    return np.where(rms > 1e-12, rms, 1.0)


def fit_gain(p: FloatArray, rows: FloatArray, commands: FloatArray, k: int) -> float:
    """The gain with which the plain force, fitted to what the form makes of it, has the coefficient 1."""
    plain = force_series(p, rows, commands, k, True) / UNIT
    made = force_series(p, rows, commands, k, False) / UNIT
    return float(np.sum(plain**2) / np.sum(plain * made)) if plain.any() else 1.0


def nearest(
    effect: str, p: FloatArray, rows: FloatArray, commands: FloatArray, k: int
) -> tuple[dict[str, float], float]:
    """Parameters of the table's law that are fitted, and the share of the concealed force's rms that they leave.

    None where the recording never feels the force: then the numbers that were put in are as good as any.
    """
    hidden = force_series(p, rows, commands, k, False) / UNIT
    if not hidden.any():
        return {}, 0.0
    wide, begin = p.copy(), at.SIZE + k * BLOCK
    for place, value in LIMITS.get(effect, {}).items():
        wide[begin + place] = value
    laws = {
        name: (begin + place, offset)
        for name, (places, offset) in PLACES[effect].items()
        for place in places
        if p[begin + place] != 0.0
    }
    where = [place for place, _ in laws.values()]
    start = p[where]

    def left(factors: FloatArray) -> FloatArray:
        wide[where] = factors * start
        return np.asarray(force_series(wide, rows, commands, k, True) / UNIT - hidden).ravel()

    # Steps of a hundredth: the width of a dead band moves the force in steps of the commands' resolution.
    found = least_squares(left, np.ones(len(where)), diff_step=1e-2)
    numbers = {name: float(x * s + o) for x, s, (name, (_, o)) in zip(found.x, start, laws.items(), strict=True)}
    return numbers, float(np.sqrt(2.0 * found.cost / max(float(np.sum(hidden**2)), 1e-30)))


def normalise(robots: FloatArray, victim: int, rows: FloatArray, commands: FloatArray, k: int, kind: int) -> None:
    """Writes scales, kind and gain of a block of all robots (robots, WIDE), by a plain run of the victim.

    A play operator keeps the gain 1: what it gives depends on the way that the force came.
    """
    form = at.SIZE + k * BLOCK + at.SIZE
    robots[:, form + SCALE_X : form + SCALE_X + 4] = fit_scale(robots[victim], rows, commands, k)
    robots[:, form] = float(kind)
    robots[:, form + GAIN] = 1.0 if kind == HYSTERETIC else fit_gain(robots[victim], rows, commands, k)
