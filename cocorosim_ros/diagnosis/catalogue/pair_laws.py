"""Laws in proportion to a product of two regressors: every pair, far more laws than the open set has.

A law that no list foresaw has its own regressors and powers; the pair nearest to it takes most of its evidence.
"""

from __future__ import annotations

import itertools

from cocorosim_ros.diagnosis.catalogue.law_forms import amount, occurs, signed_power, single, square
from cocorosim_ros.diagnosis.catalogue.laws import COVERED, EVERYTHING, LAWS_OF, plain_laws
from cocorosim_ros.world.laws.law import ONE, Factor, Law, Product
from cocorosim_ros.world.terms.search import Scene

SIGNED_SPEEDS = ("u", "v", "w", "r")
WITHOUT_SIGN = ("speed", "wall_distance", "t")  # regressors that are never negative
EQUATIONS = tuple(LAWS_OF)
IN_PAIRS = tuple(name for name in EVERYTHING if name not in (ONE.name, "pump_rate"))
"""Regressors of pairs. A rate of the pump tells when the pump acts, by parts of a tick, and so of the clocks."""
WATER_PUSHES = ("1",)  # along axes of the world: what a current does


def pair_laws(scene: Scene) -> list[Law]:
    """Make all laws of one or two regressors that occur in the scene, without those of the open set."""
    occurring = [product for product in _products() if occurs(product, scene)]
    return [
        Law(equation, product)
        for equation in EQUATIONS
        for product in occurring
        if product not in LAWS_OF[equation] and product not in _covered(equation)
    ]


def laws_of_open_set(scene: Scene) -> list[Law]:
    """Make the laws of motion of the open set that occur in the scene and have the regressors of pairs."""
    known = {ONE.name, *IN_PAIRS}
    return [law for law in plain_laws(scene) if {law.product.first.name, law.product.second.name} <= known]


def _covered(equation: str) -> list[Product]:
    """List the products to which the platform's own numbers or the catalogue make a force proportional."""
    return [single(name) for name in COVERED.get(equation, WATER_PUSHES)]


def _products() -> list[Product]:
    """List all products of two factors, and of one that is squared, in a fixed order."""
    factors = [ONE, *map(Factor, IN_PAIRS)]
    amounts = [amount(name).first for name in SIGNED_SPEEDS]
    pairs = [Product(other, one) for one, other in itertools.combinations(factors, 2)]
    pairs += [Product(one, other) for one in amounts for other in factors if other.name != one.name]
    pairs += [square(name) for name in IN_PAIRS]
    pairs += [signed_power(name, 2.0) for name in IN_PAIRS if name not in WITHOUT_SIGN]
    return pairs
