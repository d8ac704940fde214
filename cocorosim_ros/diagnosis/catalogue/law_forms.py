"""Forms of laws outside the catalogue: products of regressors, and their typical sizes."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from cocorosim_ros.world.laws.law import Factor, Product
from cocorosim_ros.world.terms.search import Scene


def typical_size(product: Product, scene: Scene) -> float:
    """Typical size of a product in these recordings, SI units; 0 where a factor does not occur in them."""
    size = 1.0
    for factor in (product.first, product.second):
        scale = scene.scales[factor.name]
        size *= scale**factor.power if scale > 0.0 else 0.0
    return size


def occurs(product: Product, scene: Scene) -> bool:
    """Tell whether both factors of a product occur in the recordings."""
    return all(scene.scales[factor.name] > 0.0 for factor in (product.first, product.second))


def single(name: str) -> Product:
    """Product of one regressor alone."""
    return Product(Factor(name))


def amount(name: str) -> Product:
    """Product of the amount of a regressor, without its sign: |x|."""
    return Product(Factor(name, 1.0, False))


def square(name: str) -> Product:
    """Product of the square of a regressor: x^2."""
    return Product(Factor(name, 2.0, False))


def signed_power(name: str, power: float) -> Product:
    """Product of a power of the amount of a regressor, with its sign: sign(x) |x|^power."""
    return Product(Factor(name, power))


def both(first: str, second: str) -> Product:
    """Product of two regressors."""
    return Product(Factor(first), Factor(second))


def given(place: str, numbers: Mapping[str, float]) -> dict[str, Callable[[Scene], float]]:
    """Fixed numbers of an entry that are the same for every scene, by column PLACE.NAME."""
    return {f"{place}.{name}": _constant(value) for name, value in numbers.items()}


def _constant(value: float) -> Callable[[Scene], float]:
    """Make a function of the scene that always returns `value`."""
    return lambda scene: value
