"""Laws that no catalogue has, drawn by a grammar: equation ~ product of powers of regressors with scales."""

from __future__ import annotations

from typing import Any

import numpy as np

from concealer import layout as at
from concealer.forms import COEFFICIENT, EQUATIONS, FIRST, REGRESSORS, SECOND, product
from concealer.laws import law as understood
from concealer.layout import FloatArray
from concealer.scene import Secret
from concealer.twins import TOO_FEW, nats, remainder

EVERY = 5  # rows: 0.1 s
NEARLY = 0.1  # share of the squared force that an entry of the table may leave and still describe it nearly as well
# What the platform or an entry of the table has already; such a draw is made again.
KNOWN = (
    "surge~u surge~|u|*u surge~thrust surge~u*thrust surge~|thrust| surge~v*r surge~sin_yaw surge~cos_yaw sway~v "
    "sway~|v|*v sway~thrust sway~u*r sway~sin_yaw sway~cos_yaw heave~w heave~|w|*w heave~pump heave~z yaw~r yaw~|r|*r "
    "yaw~thrust yaw~u*v world_x~x world_y~y world_x~y world_y~x world_x~z world_y~z"
).split()
LAWS_KNOWN = {understood(f"unknown:{name}") for name in KNOWN}


def _factor(name: str, power: float, signed: bool) -> str:
    """A factor as names of laws have it: `u`, `|u|^0.5*u`, `|u|^1.5`."""
    if not signed:
        return f"|{name}|^{power:g}" if power != 1.0 else f"|{name}|"
    if power == 1.0:
        return name
    return f"|{name}|^{power - 1.0:g}*{name}" if power != 2.0 else f"|{name}|*{name}"


def _draft(rng: np.random.Generator, grammar: dict[str, Any]) -> tuple[FloatArray, str]:
    """(11,) numbers of a law with the coefficient 1, and its name."""
    equation = str(rng.choice(list(grammar["equations"])))
    count = 2 if rng.random() < grammar["second"] else 1
    names = rng.choice(list(grammar["regressors"]), count, replace=False)
    numbers, words = np.zeros(11), []
    numbers[:3] = EQUATIONS.index(equation), 1.0, 2.0 * np.pi / grammar["period"]
    for begin, name in zip((FIRST, SECOND), names, strict=False):
        factor = grammar["regressors"][str(name)]
        power, signed = float(rng.choice(factor["powers"])), bool(rng.random() < 0.75)
        numbers[begin : begin + 4] = REGRESSORS.index(str(name)), factor["scale"], power, float(signed)
        words.append(_factor(str(name), power, signed))
    return numbers, f"unknown:{equation}~{'*'.join(words)}"


def draw(rng: np.random.Generator, grammar: dict[str, Any]) -> tuple[FloatArray, Secret]:
    """A law that neither the platform nor the table has: numbers (11,) with the coefficient 1, and what is sealed."""
    while True:
        numbers, name = _draft(rng, grammar)
        if understood(name) not in LAWS_KNOWN:
            break
    numbers[COEFFICIENT] = rng.choice([-1.0, 1.0])
    return numbers, Secret(name, {}, "drawn by the grammar", acceptable=(name,))


def series(law: FloatArray, rows: FloatArray, commands: FloatArray) -> FloatArray:
    """(n,) the factors of a law along a trajectory (rows, ROW) in 0.1 s."""
    out = []
    for tick, command in enumerate(commands):
        row = rows[EVERY * tick]
        out.append(product(law, row, command, (row[at.THROUGH_U], row[at.THROUGH_V]), tick * at.TICK))
    return np.array(out)


def _columns(rows: FloatArray, commands: FloatArray) -> dict[str, FloatArray]:
    """What the laws of the platform and the table are made of, in 0.1 s."""
    some = rows[: EVERY * len(commands) : EVERY]
    u, v, w, r = some[:, at.THROUGH_U], some[:, at.THROUGH_V], some[:, at.W], some[:, at.R]
    left, right = commands[:, 0], commands[:, 1]
    speed = np.sqrt(u * u + v * v + w * w)
    return {
        "u": u, "v": v, "w": w, "r": r, "x": some[:, at.X], "y": some[:, at.Y], "z": some[:, at.Z],
        "1": np.ones_like(u),
        "Vu": speed * u, "Vv": speed * v, "Vw": speed * w, "vv": np.abs(v) * v, "ww": np.abs(w) * w,
        "rr": np.abs(r) * r, "uT": u * (left + right), "ur": u * r, "vr": v * r, "uv": u * v, "T": left + right,
        "|T|": np.abs(left) + np.abs(right), "D": right - left, "pump": some[:, at.PLAY],
        "tT": np.arange(len(u)) * (left + right),
        "sin": np.sin(some[:, at.YAW]), "cos": np.cos(some[:, at.YAW]),
    }  # fmt: skip


BASE = {
    "surge": "Vu T vr", "sway": "Vv ur", "heave": "Vw pump", "yaw": "rr D", "world_x": "1", "world_y": "1",
}  # fmt: skip
ENTRIES = {
    "surge": {"linear_drag": "u", "advance_loss": "uT", "reverse_loss": "|T|", "battery_sag": "tT",
              "steady_current": "sin cos", "thruster_asymmetry": "D"},
    "sway": {"linear_drag": "v", "anisotropic_drag": "vv", "thruster_misalignment": "T", "steady_current": "sin cos"},
    "heave": {"linear_drag": "w", "anisotropic_drag": "ww", "buoyancy_trim": "1", "hull_compressibility": "1 z"},
    "yaw": {"linear_drag": "r", "torque_bias": "1", "thruster_asymmetry": "T", "thruster_misalignment": "T",
            "added_mass": "uv"},
    "world_x": {"tether": "x", "sheared_current": "y z"}, "world_y": {"tether": "y", "sheared_current": "x z"},
}  # fmt: skip


def settle(secret: Secret, law: FloatArray, rows: FloatArray, commands: FloatArray, water: tuple[float, float]) -> None:
    """Fills in the coefficient, the nats that the platform's own laws leave of it, twins, and what is tolerated."""
    equation = EQUATIONS[int(law[0])]
    force = law[COEFFICIENT] * series(law, rows, commands)
    if equation == "yaw":
        force = force * at.FULL_THRUST / at.FULL_TORQUE
    columns = _columns(rows, commands)
    base = [columns[name] for name in BASE[equation].split()]
    left = remainder(force, *base)
    secret.parameters = {"coefficient": float(law[COEFFICIENT]), "nats": nats(left, *water)}
    by_entry = {
        name: remainder(force, *base, *(columns[key] for key in more.split()))
        for name, more in ENTRIES[equation].items()
    }
    secret.twins = tuple(name for name, rest in by_entry.items() if nats(rest, *water) < TOO_FEW)
    most = NEARLY * float(np.sum(left**2))
    secret.tolerated = tuple(name for name, rest in by_entry.items() if float(np.sum(rest**2)) < most)
