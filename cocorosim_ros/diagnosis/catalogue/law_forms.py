"""Forms of laws outside the catalogue: products of regressors that are tried, and how large they typically are."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from cocorosim_ros.diagnosis.catalogue.entry import Scene
from cocorosim_ros.world.laws.law import Factor, Product


def typical_size(product: Product, scene: Scene) -> float:
    """Typical size of the product, in SI units; 0 where a recording does not show a factor."""
    size = 1.0
    for factor in (product.first, product.second):
        scale = scene.scales[factor.name]
        size *= scale**factor.power if scale > 0.0 else 0.0
    return size


def single(name: str) -> Product:
    """In proportion to one regressor."""
    return Product(Factor(name))


def amount(name: str) -> Product:
    """In proportion to the amount of a regressor."""
    return Product(Factor(name, 1.0, False))


def square(name: str) -> Product:
    """In proportion to the square."""
    return Product(Factor(name, 2.0, False))


def signed_power(name: str, power: float) -> Product:
    """In proportion to a power of the amount of a regressor, with its sign."""
    return Product(Factor(name, power))


def both(first: str, second: str) -> Product:
    """In proportion to two regressors."""
    return Product(Factor(first), Factor(second))


def given(place: str, numbers: Mapping[str, float]) -> dict[str, Callable[[Scene], float]]:
    """Numbers of a place as an entry gives them, whatever the scene."""
    return {f"{place}.{name}": _constant(value) for name, value in numbers.items()}


def _constant(value: float) -> Callable[[Scene], float]:
    return lambda scene: value
