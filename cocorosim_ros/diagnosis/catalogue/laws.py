"""Laws outside the catalogue: force on an equation in proportion to products and powers of regressors, typed by units.

Each is looked for as an entry of the catalogue is, with the simulator's effect `law` behind it, and has to beat the
catalogue clearly, since there are many of them.
"""

from __future__ import annotations

import math
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.catalogue import PUMP_TICK
from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.diagnosis.catalogue.law_forms import (
    amount,
    both,
    given,
    signed_power,
    single,
    square,
    typical_size,
)
from cocorosim_ros.diagnosis.catalogue.phases import phased, phases
from cocorosim_ros.diagnosis.criteria.catalogue import CATALOGUE
from cocorosim_ros.world.laws.law import Factor, Law, Product
from cocorosim_ros.world.terms.equations import EQUATION
from cocorosim_ros.world.terms.regressors import REGRESSORS


def _powers(name: str) -> tuple[Product, ...]:
    """A speed's powers other than one and two, which are linear and quadratic drag."""
    return (
        signed_power(name, 0.0),
        signed_power(name, 1.5),
        signed_power(name, 3.0),
        amount(name),
    )


def _elsewhere(name: str) -> tuple[Product, ...]:
    """A drag that changes with place or in time."""
    return tuple(both(name, where) for where in ("x", "y", "z", "t"))


PLACE = tuple(single(name) for name in ("x", "y", "z"))
SQUARED_PLACE = (square("x"), square("y"), both("x", "y"))
EVERYTHING = tuple(regressor.name for regressor in REGRESSORS if regressor.from_own_course)
# What the platform's own numbers or the catalogue hold already, under other names.
COVERED: dict[str, tuple[str, ...]] = {
    "surge": ("u", "thrust", "speed"),
    "sway": ("v",),
    "heave": ("1", "z", "w", "pump"),
    "yaw": ("1", "r", "thrust", "yaw_command"),
}


def _all_but(equation: str) -> tuple[Product, ...]:
    return tuple(single(name) for name in EVERYTHING if name not in COVERED[equation])


LAWS_OF: dict[str, tuple[Product, ...]] = {
    "surge": (
        *_all_but("surge"),
        *_powers("u"),
        both("v", "r"),
        square("r"),
        *_elsewhere("u"),
        signed_power("thrust", 2.0),
        amount("yaw_command"),
    ),
    "sway": (
        *_all_but("sway"),
        *_powers("v"),
        *_elsewhere("v"),
        both("u", "r"),
        both("u", "v"),
        both("u", "x"),
        both("u", "y"),
        signed_power("r", 2.0),
    ),
    "heave": (
        *_all_but("heave"),
        *_powers("w"),
        *_elsewhere("w"),
        square("u"),
        square("z"),
        square("r"),
        signed_power("pump", 2.0),
    ),
    "yaw": (
        *_all_but("yaw"),
        *_powers("r"),
        signed_power("u", 2.0),
        signed_power("yaw_command", 2.0),
        both("sin_yaw", "cos_yaw"),
        *_elsewhere("r"),
        Product(Factor("v"), Factor("u", 1.0, False)),
        both("u", "r"),
        both("x", "y"),
    ),
    "world_x": (*PLACE, single("t"), *SQUARED_PLACE, signed_power("x", 3.0), single("speed")),
    "world_y": (*PLACE, single("t"), *SQUARED_PLACE, signed_power("y", 3.0), single("speed")),
}
ROUNDINGS = (0.03, 0.1, 0.3)
SWINGING = ("world_x", "world_y", "surge", "sway", "heave", "yaw")
PUMP_BEHIND = Law("heave", single("pump_rate"))
TURNING_AXES = (Law("surge", both("v", "r")), Law("sway", both("u", "r")))


def law_entries(scene: Scene, place: str) -> list[Entry]:
    """All laws of motion, each as the simulator's effect at this place of LAWS."""
    plain = [
        Law(equation, product)
        for equation, products in LAWS_OF.items()
        for product in products
        if scene.scales[product.first.name] > 0.0 and scene.scales[product.second.name] > 0.0
    ]
    return [
        *(_entry(place, law, scene) for law in plain),
        *(_swinging(place, equation, scene) for equation in SWINGING),
    ]


def _entry(place: str, law: Law, scene: Scene) -> Entry:
    force, product = EQUATION[law.of].symbol, law.product
    size = typical(scene, law)
    negligible = _negligible(size, scene, law)
    return Entry(
        law.text,
        f"a law outside the catalogue: {force} in proportion to {product.text}",
        f"{force} = c {product.text}",
        "surge" if law.of.startswith("world") else law.of,
        (Amplitude(f"{place}.coefficient", "coefficient", law.unit, size, negligible=negligible),),
        _roundings(place, product, scene),
        fixed=given(place, law.codes),
        of_pump=law.of == "heave" and _follows_pump(product),
        law=place,
        form=law,
    )


def _negligible(size: float, scene: Scene, law: Law) -> tuple[float, float]:
    """Coefficients that are not believed: a pump's lag by another name, and what turning axes leave of a mass.

    size: the coefficient that is `typical`.
    """
    least = CATALOGUE.least_force / CATALOGUE.large_share * size
    if law == PUMP_BEHIND:
        return -PUMP_TICK, least
    if law in TURNING_AXES:
        least = max(least, CATALOGUE.turning * scene.scales["mass"])
    return -least, least


def _follows_pump(product: Product) -> bool:
    """Whether it is about what a depth controller moves in answer to the water: the pump, the dive speed."""
    return not {product.first.name, product.second.name}.isdisjoint(("pump", "pump_rate", "w"))


def _roundings(place: str, product: Product, scene: Scene) -> tuple[Shape, ...]:
    """Where a law that is steep at zero is rounded off: unlike shares of its regressor's size."""
    if product.first.power >= 1.0:
        return ()
    size = scene.scales[product.first.name]
    return (Shape(f"{place}.round_1", "round_1", "1", lambda here: [share * size for share in ROUNDINGS], fixed=True),)


def _swinging(place: str, equation: str, scene: Scene) -> Entry:
    """Force that swings in time, at the periods that stand out of the residual."""
    omega, phase = f"{place}.omega", f"{place}.phase"
    return replace(
        _entry(place, Law(equation, single("sin_t")), scene),
        equation=f"{EQUATION[equation].symbol} = c sin(omega t + phase)",
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


def typical(scene: Scene, law: Law) -> float:
    """Coefficient with which the law is a tenth of the equation's full force."""
    force = scene.scales[
        {"heave": "heave_force", "world_z": "heave_force", "yaw": "yaw_force"}.get(law.of, "surge_force")
    ]
    return CATALOGUE.large_share * force / typical_size(law.product, scene)
