"""Laws outside the catalogue: force on an equation in proportion to products and powers of regressors, typed by units.

Each is looked for as an entry of the catalogue is, with the simulator's effect `law` behind it, and has to beat the
catalogue clearly, since there are many of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.diagnosis.catalogue.law_forms import (
    Factor,
    Law,
    amount,
    given,
    product,
    signed_square,
    single,
    square,
)
from cocorosim_ros.diagnosis.catalogue.phases import phased, phases
from cocorosim_ros.diagnosis.criteria.catalogue import CATALOGUE
from cocorosim_ros.world.terms.law_places import EQUATIONS


def _powers(name: str) -> tuple[Law, ...]:
    """A speed's powers other than one and two, which are linear and quadratic drag."""
    return (
        Law(f"|{name}|^-1*{name}", Factor(name, 0.0)),
        Law(f"|{name}|^0.5*{name}", Factor(name, 1.5)),
        Law(f"|{name}|^2*{name}", Factor(name, 3.0)),
        Law(f"|{name}|", Factor(name, 1.0, False)),
    )


def _elsewhere(name: str) -> tuple[Law, ...]:
    """A drag that changes with place or in time."""
    return tuple(product(name, where) for where in ("x", "y", "z", "t"))


PLACE = tuple(single(name) for name in ("x", "y", "z"))
SQUARED_PLACE = (*(Law(f"{name}*{name}", Factor(name, 2.0, False)) for name in ("x", "y")), product("x", "y"))
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
    return tuple(single(name) for name in EVERYTHING if name not in COVERED[equation])


LAWS_OF: dict[str, tuple[Law, ...]] = {
    "surge": (
        *_all_but("surge"),
        *_powers("u"),
        product("v", "r"),
        square("r"),
        *_elsewhere("u"),
        signed_square("thrust"),
        amount("yaw_command"),
    ),
    "sway": (
        *_all_but("sway"),
        *_powers("v"),
        *_elsewhere("v"),
        product("u", "r"),
        product("u", "v"),
        product("u", "x"),
        product("u", "y"),
        signed_square("r"),
    ),
    "heave": (
        *_all_but("heave"),
        *_powers("w"),
        *_elsewhere("w"),
        square("u"),
        square("z"),
        square("r"),
        signed_square("pump"),
    ),
    "yaw": (
        *_all_but("yaw"),
        *_powers("r"),
        signed_square("u"),
        signed_square("yaw_command"),
        product("sin_yaw", "cos_yaw"),
        *_elsewhere("r"),
        Law("|u|*v", Factor("v"), Factor("u", 1.0, False)),
        product("u", "r"),
        product("x", "y"),
    ),
    "world_x": (*PLACE, single("t"), *SQUARED_PLACE, Law("|x|^2*x", Factor("x", 3.0)), single("speed")),
    "world_y": (*PLACE, single("t"), *SQUARED_PLACE, Law("|y|^2*y", Factor("y", 3.0)), single("speed")),
}
ROUNDINGS = (0.03, 0.1, 0.3)
SYMBOLS = dict(zip(EQUATIONS, ("X", "Y", "Z", "N", "F_x", "F_y", "F_z"), strict=True))
SWINGING = ("world_x", "world_y", "surge", "sway", "heave", "yaw")


def law_entries(scene: Scene, place: str) -> list[Entry]:
    """All laws of motion, each as the simulator's effect at this place of LAWS."""
    plain = [
        (equation, law)
        for equation, laws in LAWS_OF.items()
        for law in laws
        if scene.scales[law.first.name] > 0.0 and scene.scales[law.second.name] > 0.0
    ]
    return [
        *(_entry(place, equation, law, scene) for equation, law in plain),
        *(_swinging(place, equation, scene) for equation in SWINGING),
    ]


def _entry(place: str, equation: str, law: Law, scene: Scene) -> Entry:
    force = SYMBOLS[equation]
    size = typical(scene, equation, law)
    negligible = _negligible(size, scene, equation, law)
    amplitude = Amplitude(f"{place}.coefficient", "coefficient", _unit(equation, law), size, negligible=negligible)
    return Entry(
        f"unknown:{equation}~{law.regressor}",
        f"a law outside the catalogue: {force} in proportion to {law.regressor}",
        f"{force} = c {law.regressor}",
        "surge" if equation.startswith("world") else equation,
        (amplitude,),
        _roundings(place, law, scene),
        fixed=_codes(place, equation, law),
        of_pump=equation == "heave" and _follows_pump(law),
        law=place,
    )


def _negligible(size: float, scene: Scene, equation: str, law: Law) -> tuple[float, float]:
    """Coefficients that are not believed: a pump's lag by another name, and what turning axes leave of a mass.

    size: the coefficient that is `typical`.
    """
    least = CATALOGUE.least_force / CATALOGUE.large_share * size
    if (equation, law.regressor) == ("heave", "pump_rate"):
        return -CATALOGUE.pump_tick, least
    if (equation, law.regressor) in (("surge", "v*r"), ("sway", "u*r")):
        least = max(least, CATALOGUE.turning * scene.scales["mass"])
    return -least, least


def _follows_pump(law: Law) -> bool:
    """Whether it is about what a depth controller moves in answer to the water: the pump, the dive speed."""
    return not {law.first.name, law.second.name}.isdisjoint(("pump", "pump_rate", "w"))


def _roundings(place: str, law: Law, scene: Scene) -> tuple[Shape, ...]:
    """Where a law that is steep at zero is rounded off: unlike shares of its regressor's size."""
    if law.first.power >= 1.0:
        return ()
    size = scene.scales[law.first.name]
    return (Shape(f"{place}.round_1", "round_1", "1", lambda here: [share * size for share in ROUNDINGS], fixed=True),)


def _swinging(place: str, equation: str, scene: Scene) -> Entry:
    """Force that swings in time, at the periods that stand out of the residual."""
    omega, phase = f"{place}.omega", f"{place}.phase"
    return replace(
        _entry(place, equation, single("sin_t"), scene),
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
    return given(place, {"equation": float(EQUATIONS.index(equation)), **law.codes})


def typical(scene: Scene, equation: str, law: Law) -> float:
    """Coefficient with which the law is a tenth of the equation's full force."""
    force = scene.scales[
        {"heave": "heave_force", "world_z": "heave_force", "yaw": "yaw_force"}.get(equation, "surge_force")
    ]
    return CATALOGUE.large_share * force / law.size(scene)


def _unit(equation: str, law: Law) -> str:
    return law.unit("N m" if equation == "yaw" else "N")
