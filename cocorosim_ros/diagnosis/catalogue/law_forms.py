"""Forms of laws outside the catalogue: a product of two powers of regressors, its name, codes and units."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.entry import Scene
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE, REGRESSORS

UNITS = {regressor.name: regressor.unit for regressor in REGRESSORS}


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

    @property
    def codes(self) -> dict[str, float]:
        """Its factors as numbers of the simulator's effect."""
        return {
            "regressor_1": float(REGRESSOR_CODE[self.first.name]),
            "power_1": self.first.power,
            "signed_1": float(self.first.signed),
            "regressor_2": float(REGRESSOR_CODE[self.second.name]),
            "power_2": self.second.power,
            "signed_2": float(self.second.signed),
        }

    def size(self, scene: Scene) -> float:
        """Typical size of the product, in SI units; 0 where a recording does not show a factor."""
        size = 1.0
        for factor in (self.first, self.second):
            scale = scene.scales[factor.name]
            size *= scale**factor.power if scale > 0.0 else 0.0
        return size

    def unit(self, of: str) -> str:
        """Unit of the coefficient: that of what is in proportion, over those of the factors, in plain text."""
        parts = []
        for factor in (self.first, self.second):
            unit = UNITS[factor.name]
            if unit != "1" and factor.power:
                parts.append(f"({unit})" if factor.power == 1.0 else f"({unit})^{factor.power:g}")
        return f"{of}/({' '.join(parts)})" if parts else of


def single(name: str) -> Law:
    """In proportion to one regressor."""
    return Law(name, Factor(name))


def amount(name: str) -> Law:
    """In proportion to the amount of a regressor."""
    return Law(f"|{name}|", Factor(name, 1.0, False))


def square(name: str) -> Law:
    """In proportion to the square."""
    return Law(f"{name}*{name}", Factor(name, 2.0, False))


def signed_square(name: str) -> Law:
    """In proportion to the square, with the sign of the regressor."""
    return Law(f"|{name}|*{name}", Factor(name, 2.0))


def product(first: str, second: str) -> Law:
    """In proportion to two regressors."""
    return Law(f"{first}*{second}", Factor(first), Factor(second))


def given(place: str, numbers: Mapping[str, float]) -> dict[str, Callable[[Scene], float]]:
    """Numbers of a place as an entry gives them, whatever the scene."""
    return {f"{place}.{name}": _constant(value) for name, value in numbers.items()}


def _constant(value: float) -> Callable[[Scene], float]:
    return lambda scene: value
