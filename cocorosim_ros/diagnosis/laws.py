"""Laws outside the catalogue: force on an equation in proportion to products and powers of regressors, typed by units.

Each is looked for as an entry of the catalogue is, with the simulator's effect `law` behind it, and has to beat the
catalogue clearly, since there are many of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.diagnosis.phases import phased, phases
from cocorosim_ros.physics.effects import LAWS
from cocorosim_ros.physics.laws import EQUATIONS
from cocorosim_ros.physics.regressors import REGRESSOR_CODE, REGRESSORS

LARGE_SHARE = 0.1  # of the full force of an equation


class Factor(NamedTuple):
    """A regressor to a power; `signed` keeps its sign."""

    name: str
    power: float = 1.0
    signed: bool = True


ONE = Factor("1")


class Law(NamedTuple):
    """Its name in the contract's writing, and its factors."""

    regressor: str
    first: Factor
    second: Factor = ONE


def _single(name: str) -> Law:
    return Law(name, Factor(name))


def _powers(name: str) -> tuple[Law, ...]:
    """A speed's powers other than one and two, which are linear and quadratic drag."""
    return (
        Law(f"|{name}|^-1*{name}", Factor(name, 0.0)),
        Law(f"|{name}|^0.5*{name}", Factor(name, 1.5)),
        Law(f"|{name}|^2*{name}", Factor(name, 3.0)),
        Law(f"|{name}|", Factor(name, 1.0, False)),
    )


def _product(first: str, second: str) -> Law:
    return Law(f"{first}*{second}", Factor(first), Factor(second))


PLACE = tuple(_single(name) for name in ("x", "y", "z"))
SQUARED_PLACE = (*(Law(f"{name}*{name}", Factor(name, 2.0, False)) for name in ("x", "y")), _product("x", "y"))
EVERYTHING = (
    "1", "x", "y", "z", "t", "u", "v", "w", "r", "speed", "thrust", "yaw_command", "pump", "pump_rate", "sin_yaw",
    "cos_yaw", "wall_distance",
)  # fmt: skip
# What the platform's own numbers or the catalogue hold already, under other names.
COVERED: dict[str, tuple[str, ...]] = {
    "surge": ("u", "thrust", "speed"),
    "sway": ("v",),
    "heave": ("1", "z", "w", "pump"),
    "yaw": ("1", "r", "thrust", "yaw_command"),
}


def _all_but(equation: str) -> tuple[Law, ...]:
    return tuple(_single(name) for name in EVERYTHING if name not in COVERED[equation])


def _square(name: str) -> Law:
    return Law(f"{name}*{name}", Factor(name, 2.0, False))


LAWS_OF: dict[str, tuple[Law, ...]] = {
    "surge": (*_all_but("surge"), *_powers("u"), _product("v", "r"), _square("r"), _product("u", "z")),
    "sway": (*_all_but("sway"), *_powers("v"), _product("u", "r"), _product("u", "v"), Law("|r|*r", Factor("r", 2.0))),
    "heave": (*_all_but("heave"), *_powers("w"), _square("u"), _square("z"), _square("r")),
    "yaw": (
        *_all_but("yaw"),
        *_powers("r"),
        Law("|u|*u", Factor("u", 2.0)),
        Law("|u|*v", Factor("v"), Factor("u", 1.0, False)),
        _product("u", "r"),
        _product("x", "y"),
    ),
    "world_x": (*PLACE, _single("t"), *SQUARED_PLACE, Law("|x|^2*x", Factor("x", 3.0)), _single("speed")),
    "world_y": (*PLACE, _single("t"), *SQUARED_PLACE, Law("|y|^2*y", Factor("y", 3.0)), _single("speed")),
}
SYMBOLS = dict(zip(EQUATIONS, ("X", "Y", "Z", "N", "F_x", "F_y", "F_z"), strict=True))
SWINGING = ("world_x", "world_y", "heave", "yaw")
UNITS = {regressor.name: regressor.unit for regressor in REGRESSORS}


def law_entries(scene: Scene, taken: int) -> list[Entry]:
    """All laws in the first free place of the simulator; none if all are taken by laws already found."""
    if taken >= len(LAWS):
        return []
    place = list(LAWS)[taken]
    plain = [
        (equation, law)
        for equation, laws in LAWS_OF.items()
        for law in laws
        if scene.scales[law.first.name] > 0.0 and scene.scales[law.second.name] > 0.0
    ]
    many = math.log(len(plain) + len(SWINGING))
    return [
        *(_entry(place, equation, law, scene, many) for equation, law in plain),
        *(_swinging(place, equation, scene, many) for equation in SWINGING),
    ]


def _entry(place: str, equation: str, law: Law, scene: Scene, against: float) -> Entry:
    force = SYMBOLS[equation]
    amplitude = Amplitude(f"{place}.coefficient", "coefficient", _unit(equation, law), typical(scene, equation, law))
    return Entry(
        f"unknown:{equation}~{law.regressor}",
        f"a law outside the catalogue: {force} in proportion to {law.regressor}",
        f"{force} = c {law.regressor}",
        "surge" if equation.startswith("world") else equation,
        (amplitude,),
        fixed=_codes(place, equation, law),
        prior_nats=against,
        law=place,
    )


def _swinging(place: str, equation: str, scene: Scene, against: float) -> Entry:
    """Force that swings in time, at the periods that stand out of the residual."""
    omega, phase = f"{place}.omega", f"{place}.phase"
    return replace(
        _entry(place, equation, Law("sin_t", Factor("sin_t")), scene, against),
        equation=f"{SYMBOLS[equation]} = c sin(omega t + phase)",
        shapes=(
            Shape(
                omega,
                "omega",
                "rad/s",
                lambda here: [2.0 * math.pi / period for period in here.periods[equation]],
                logarithmic=True,
            ),
            Shape(phase, "phase", "rad", phases, periodic=True),
        ),
        basis=phased(phase),
    )


def _codes(place: str, equation: str, law: Law) -> dict[str, Callable[[Scene], float]]:
    numbers = {
        "equation": float(EQUATIONS.index(equation)),
        "regressor_1": float(REGRESSOR_CODE[law.first.name]),
        "power_1": law.first.power,
        "signed_1": float(law.first.signed),
        "regressor_2": float(REGRESSOR_CODE[law.second.name]),
        "power_2": law.second.power,
        "signed_2": float(law.second.signed),
    }
    return {f"{place}.{name}": _constant(value) for name, value in numbers.items()}


def _constant(value: float) -> Callable[[Scene], float]:
    return lambda scene: value


def typical(scene: Scene, equation: str, law: Law) -> float:
    """Coefficient with which the law is a tenth of the equation's full force."""
    force = scene.scales[
        {"heave": "heave_force", "world_z": "heave_force", "yaw": "yaw_force"}.get(equation, "surge_force")
    ]
    size = 1.0
    for factor in (law.first, law.second):
        size *= scene.scales[factor.name] ** factor.power
    return LARGE_SHARE * force / size


def _unit(equation: str, law: Law) -> str:
    """Unit of the coefficient: that of the force over those of the factors, in plain text."""
    force = "N m" if equation == "yaw" else "N"
    parts = []
    for factor in (law.first, law.second):
        unit = UNITS[factor.name]
        if unit != "1" and factor.power:
            parts.append(f"({unit})" if factor.power == 1.0 else f"({unit})^{factor.power:g}")
    return f"{force}/({' '.join(parts)})" if parts else force
