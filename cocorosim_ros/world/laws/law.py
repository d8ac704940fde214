"""Laws outside the catalogue: a force or an error of a reading in proportion to a product of powers of regressors.

Here alone stands how a law is written as text, and how such text is read. `u*u` is the square of u, `|u|*u` the square
with the sign of u, `|u|^0.5*u` the amount of u to the power 1.5 with the sign of u, `|u|^-1*u` the sign alone.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.units.unit_algebra import Powers, multiplied, powers_of, unit_of
from cocorosim_ros.world.laws.readings import READING, READING_CODE, readings_of
from cocorosim_ros.world.terms.equations import EQUATION, EQUATION_CODE
from cocorosim_ros.world.terms.regressors import REGRESSOR, REGRESSOR_CODE

UNKNOWN = "unknown:"
"""What the text of every law begins with."""
_MOST_FACTORS = 2


class Factor(NamedTuple):
    """A regressor to a power of its amount; `signed` keeps its sign."""

    name: str
    power: float = 1.0
    signed: bool = True

    @property
    def text(self) -> str:
        """The factor as a product is written."""
        if self.signed:
            beside = self.power - 1.0
            amount = f"|{self.name}|" if beside == 1.0 else f"|{self.name}|^{_number(beside)}"
            return f"{amount}*{self.name}" if beside else self.name
        if self.power == 2.0:  # an even power needs no bars
            return f"{self.name}*{self.name}"
        return f"|{self.name}|" if self.power == 1.0 else f"|{self.name}|^{_number(self.power)}"

    def of(self, values: Floats) -> Floats:
        """The factor where its regressor has these values."""
        size = np.abs(values) ** self.power
        return np.asarray(np.sign(values) * size if self.signed else size)


ONE = Factor("1")


@dataclass(frozen=True, eq=False)
class Product:
    """Two factors, the second one of which may be ONE. Equal products have the same factors in any order."""

    first: Factor
    second: Factor = ONE

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Product) and self._in_order == other._in_order

    def __hash__(self) -> int:
        return hash(self._in_order)

    @cached_property
    def _in_order(self) -> tuple[Factor, ...]:
        """The factors by name: a search for laws compares products tens of thousands of times."""
        return tuple(sorted(self.factors))

    @property
    def factors(self) -> tuple[Factor, ...]:
        """The factors that are not ONE."""
        return tuple(factor for factor in (self.first, self.second) if factor != ONE)

    @property
    def text(self) -> str:
        """The product in the contract's writing, amounts before what keeps its sign."""
        ordered = sorted(self.factors, key=lambda factor: factor.signed)
        return "*".join(factor.text for factor in ordered) or ONE.name

    @property
    def codes(self) -> dict[str, float]:
        """The factors as numbers of the simulator's effect."""
        numbers: dict[str, float] = {}
        for place, factor in enumerate((self.first, self.second), 1):
            numbers |= {
                f"regressor_{place}": float(REGRESSOR_CODE[factor.name]),
                f"power_{place}": factor.power,
                f"signed_{place}": float(factor.signed),
            }
        return numbers

    @property
    def unit(self) -> str:
        """The SI unit of the product, multiplied out."""
        powers: Powers = {}
        for factor in self.factors:
            powers = multiplied(powers, powers_of(REGRESSOR[factor.name].unit), factor.power)
        return unit_of(powers)

    def along(self, values: Mapping[str, Floats]) -> Floats:
        """The product, where these are the values of the regressors by name."""
        return self.first.of(values[self.first.name]) * self.second.of(values[self.second.name])

    def unit_of_coefficient(self, of: str) -> str:
        """`of`, the unit of what is in proportion, over the units of the factors, in plain text."""
        parts = []
        for factor in (self.first, self.second):
            unit = REGRESSOR[factor.name].unit
            if unit != "1" and factor.power:
                parts.append(f"({unit})" if factor.power == 1.0 else f"({unit})^{factor.power:g}")
        return f"{of}/({' '.join(parts)})" if parts else of

    @classmethod
    def parse(cls, text: str) -> Product:
        """The product that is written so: powers of one regressor add up, and its sign counts if it is left over.

        Raises CocorosimError for what is no regressor or power, and for more than two regressors.
        """
        powers: dict[str, float] = {}
        signs: dict[str, bool] = {}
        for written in text.split("*"):
            name, power, bars = _read_factor(written, text)
            powers[name] = powers.get(name, 0.0) + power
            signs[name] = signs.get(name, False) != (not bars and power % 2.0 == 1.0)
        found = [Factor(name, powers[name], signs[name]) for name in powers if name != ONE.name]
        if len(found) > _MOST_FACTORS:
            raise CocorosimError(f"'{text}' has {len(found)} regressors; a law has one or two, write two of them.")
        return cls(*found) if found else cls(ONE)


def _read_factor(written: str, text: str) -> tuple[str, float, bool]:
    """Regressor, power, and whether it stands between bars, of one factor of `text`."""
    amount, hat, power = written.strip().partition("^")
    bars = len(amount) > 1 and amount[0] == amount[-1] == "|"
    name = amount[1:-1] if bars else amount
    if name not in REGRESSOR_CODE:
        raise CocorosimError(f"'{text}' has the factor '{written}', no regressor; write {', '.join(REGRESSOR_CODE)}.")
    try:
        return name, float(power) if hat else 1.0, bars
    except ValueError:
        raise CocorosimError(f"'{text}' has the power '{power}'; write a number, as in '|u|^0.5*u'.") from None


def _number(value: float) -> str:
    """The shortest text that gives the number back."""
    return repr(value).removesuffix(".0")


@dataclass(frozen=True)
class Law:
    """What is in proportion, a name of EQUATIONS or READINGS, and to which product. Raises CocorosimError otherwise."""

    of: str
    product: Product

    def __post_init__(self) -> None:
        if self.of not in EQUATION and self.of not in READING:
            known = ", ".join((*EQUATION, *READING))
            raise CocorosimError(f"A law is of '{self.of}', neither an equation nor a reading; write one of {known}.")

    @property
    def topic(self) -> str | None:
        """The stream whose reading is in error; None for a law of motion."""
        return READING[self.of].topic if self.of in READING else None

    @property
    def text(self) -> str:
        """The identifier by which the law is reported; of a reading it names the topic alone."""
        return f"{UNKNOWN}{self.topic or self.of}~{self.product.text}"

    @property
    def codes(self) -> dict[str, float]:
        """The law as numbers of the simulator's effect."""
        if self.of in READING:
            return {"reading": float(READING_CODE[self.of]), **self.product.codes}
        return {"equation": float(EQUATION_CODE[self.of]), **self.product.codes}

    @property
    def unit(self) -> str:
        """The unit of the coefficient in plain text."""
        table = READING if self.of in READING else EQUATION
        return self.product.unit_of_coefficient(table[self.of].unit)

    @classmethod
    def parse(cls, text: str, reading: str | None = None) -> Law:
        """The law that is written so; `reading` says which one of a topic that has several.

        Raises CocorosimError for other text, and where the reading is missing or not one of the topic.
        """
        subject, product = subject_and_product(text)
        of_topic = readings_of(subject)
        if not of_topic:
            return cls(subject, product)
        if len(of_topic) > 1 and reading not in of_topic:
            raise CocorosimError(f"'{text}' may be of several readings; add which one: {', '.join(of_topic)}.")
        return cls(reading or of_topic[0], product)


def is_law(text: str) -> bool:
    """Whether an identifier is that of a law outside the catalogue."""
    return text.startswith(UNKNOWN)


def subject_and_product(text: str) -> tuple[str, Product]:
    """The equation or topic that a law's text names, and its product. Raises CocorosimError for other text."""
    subject, tilde, product = text.removeprefix(UNKNOWN).partition("~")
    if not is_law(text) or not tilde or not (subject in EQUATION or readings_of(subject)):
        raise CocorosimError(f"'{text}' is no law; write it as 'unknown:heave~u*u', with an equation or topic.")
    return subject, Product.parse(product)
