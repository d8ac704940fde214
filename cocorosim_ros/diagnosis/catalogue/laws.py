"""Laws outside the catalogue: force on an equation in proportion to products and powers of regressors, typed by units.

Each is looked for as an entry of the catalogue is, and one of the simulator's effects in LAWS acts for it. It has to
beat the catalogue clearly, since there are many laws.
"""

from __future__ import annotations

import math
from dataclasses import replace

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Shape
from cocorosim_ros.diagnosis.catalogue.law_forms import (
    amount,
    both,
    given,
    occurs,
    signed_power,
    single,
    square,
    typical_size,
)
from cocorosim_ros.diagnosis.catalogue.law_words import identifier_words, law_words, opposite_law_words
from cocorosim_ros.diagnosis.criteria.catalogue import CATALOGUE, LAWS
from cocorosim_ros.world.effects.pump_lag import PUMP_TICK
from cocorosim_ros.world.laws.law import Factor, Law, Product
from cocorosim_ros.world.terms.equations import EQUATION
from cocorosim_ros.world.terms.phases import phased, phases
from cocorosim_ros.world.terms.regressors import REGRESSORS
from cocorosim_ros.world.terms.search import Scene


def _powers(name: str) -> tuple[Product, ...]:
    """Powers of a speed other than one and two; those two are linear and quadratic drag."""
    return (
        signed_power(name, 0.0),
        signed_power(name, 1.5),
        signed_power(name, 3.0),
        amount(name),
    )


def _elsewhere(name: str) -> tuple[Product, ...]:
    """Drag, in proportion to a speed, that changes with place or in time."""
    return tuple(both(name, where) for where in ("x", "y", "z", "t"))


PLACE = tuple(single(name) for name in ("x", "y", "z"))
SQUARED_PLACE = (square("x"), square("y"), both("x", "y"))
EVERYTHING = tuple(regressor.name for regressor in REGRESSORS if regressor.from_own_course)
# By equation: regressors to which the platform's own numbers or the catalogue make a force proportional already.
COVERED: dict[str, tuple[str, ...]] = {
    "surge": ("u", "thrust", "speed"),
    "sway": ("v",),
    "heave": ("1", "z", "w", "pump"),
    "yaw": ("1", "r", "thrust", "yaw_command"),
}


def _all_but(equation: str) -> tuple[Product, ...]:
    """Products of one regressor each, those left out that COVERED has for the equation."""
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
SWINGING = ("world_x", "world_y", "surge", "sway", "heave", "yaw")
PUMP_BEHIND = Law("heave", single("pump_rate"))
TURNING_AXES = (Law("surge", both("v", "r")), Law("sway", both("u", "r")))


def law_entries(scene: Scene, place: str) -> list[Entry]:
    """Make entries of all laws of motion whose regressors occur in the scene.

    place: one of LAWS, the simulator's effect that acts for them.
    """
    return [
        *(law_entry(place, law, scene) for law in plain_laws(scene)),
        *(_swinging(place, equation, scene) for equation in SWINGING),
    ]


def plain_laws(scene: Scene) -> list[Law]:
    """Make all laws of motion whose regressors occur in the scene, but those that swing."""
    return [
        Law(equation, product)
        for equation, products in LAWS_OF.items()
        for product in products
        if occurs(product, scene)
    ]


def law_entry(place: str, law: Law, scene: Scene) -> Entry:
    """Make the entry of one law; its amplitude is the coefficient, with `typical` as the large value."""
    force, product = EQUATION[law.of].symbol, law.product
    size = typical(scene, law)
    negligible = _negligible(size, scene, law)
    return Entry(
        law.text,
        law_words(law),
        f"{force} = c {product.text}",
        "surge" if law.of.startswith("world") else law.of,
        (Amplitude(f"{place}.coefficient", "coefficient", law.unit, size, negligible=negligible),),
        _roundings(place, product, scene),
        fixed=given(place, law.codes),
        of_pump=law.of == "heave" and _follows_pump(product),
        law=place,
        opposite=opposite_law_words(law),
        form=law,
    )


def _negligible(size: float, scene: Scene, law: Law) -> tuple[float, float]:
    """Lower and upper end of the coefficients that are too small to be believed, in the unit of the law.

    A force of -T times the pump's rate is that of a pump that is late by T; less than PUMP_TICK is not believed. Forces
    in proportion to v r and u r, as of a mass in turning axes, may come from errors of the filter's steps; less than a
    share of the mass is not believed.
    size: the `typical` coefficient.
    """
    least = CATALOGUE.least_force / CATALOGUE.large_share * size
    if law == PUMP_BEHIND:
        return -PUMP_TICK, least
    if law in TURNING_AXES:
        least = max(least, CATALOGUE.turning * scene.scales["mass"])
    return -least, least


def _follows_pump(product: Product) -> bool:
    """Tell whether a product has a factor that a depth controller moves in answer to the water: pump, dive speed."""
    return not {product.first.name, product.second.name}.isdisjoint(("pump", "pump_rate", "w"))


def _roundings(place: str, product: Product, scene: Scene) -> tuple[Shape, ...]:
    """Shapes for the rounding of a law that is steep at zero: shares of its regressor's size; () for other laws."""
    if product.first.power >= 1.0:
        return ()
    size = scene.scales[product.first.name]
    return (
        Shape(f"{place}.round_1", "round_1", "1", lambda here: [share * size for share in LAWS.roundings], fixed=True),
    )


def _swinging(place: str, equation: str, scene: Scene) -> Entry:
    """Make the entry of a force c sin(omega t + phase), with the periods at which the residual swings most as grid."""
    omega, phase, law = f"{place}.omega", f"{place}.phase", Law(equation, single("sin_t"))
    return replace(
        law_entry(place, law, scene),
        name=identifier_words(law.text),
        opposite="",
        equation=f"{EQUATION[equation].symbol} = c sin(omega t + phase)",
        shapes=(
            Shape(
                omega,
                "omega",
                "rad/s",
                lambda here: [2.0 * math.pi / period for period in here.periods[equation]],
                logarithmic=True,
                swing=True,
            ),
            Shape(phase, "phase", "rad", phases, periodic=True),
        ),
        basis=phased(phase),
    )


def typical(scene: Scene, law: Law) -> float:
    """Coefficient with which a law typically has a tenth of the equation's full force, in the unit of the law."""
    force = scene.scales[
        {"heave": "heave_force", "world_z": "heave_force", "yaw": "yaw_force"}.get(law.of, "surge_force")
    ]
    return CATALOGUE.large_share * force / typical_size(law.product, scene)
