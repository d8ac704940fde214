"""Words for laws outside the catalogue, as a mechanic says them: which force or error, in proportion to what."""

from __future__ import annotations

from cocorosim_ros.world.laws.law import Factor, Law, Product, is_law, subject_and_product
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.terms.equations import EQUATION
from cocorosim_ros.world.terms.regressors import REGRESSOR

READING_WORDS = {name: kind.words for name, kind in KINDS.items()}
"""Readings in words, by kind."""
_STREAM_WORDS = {"imu": "stream of the inertial sensor"}
_REGRESSOR_WORDS = {"r": "the turn rate"}
_POWERS = {2.0: "the square of", 3.0: "the cube of"}


def law_words(law: Law) -> str:
    """Words for a law, such as 'an unexplained force to the left in proportion to the speed forwards'."""
    subject = _subject(READING_WORDS[law.of]) if law.topic else _unexplained(EQUATION[law.of].meaning)
    return f"{subject} {_proportion(law.product)}"


def opposite_law_words(law: Law) -> str:
    """Words for a law of motion with a negative coefficient: its force to the right, and so on."""
    return f"{_unexplained(EQUATION[law.of].opposite)} {_proportion(law.product)}"


def short_law_words(law: Law) -> str:
    """Words for a law that leave out what it is in proportion to, and the direction, which depends on that."""
    return _subject(READING_WORDS[law.of]) if law.topic else _force(law.of)


def identifier_words(identifier: str) -> str:
    """Words for the identifier of a law, which says of a stream but not of which of its readings, and knows no sign."""
    subject, product = subject_and_product(identifier)
    kind = _force(subject) if subject in EQUATION else _subject(stream_words(subject))
    return f"{kind} {_proportion(product)}"


def short_words(identifier: str) -> str:
    """Words for an identifier of the catalogue or of a law, the fewest that tell it from most others."""
    if not is_law(identifier):
        return identifier.replace("_", " ").replace(":", ", ")
    subject, _ = subject_and_product(identifier)
    return _force(subject) if subject in EQUATION else _subject(stream_words(subject))


def product_words(product: Product) -> str:
    """Words for a product of powers of regressors."""
    return " times ".join(_factor_words(factor) for factor in product.factors)


def stream_words(topic: str) -> str:
    """Words for a stream, by topic."""
    return _STREAM_WORDS.get(topic, topic.replace("_", " "))


def regressor_words(name: str) -> str:
    """Words for a regressor, by name."""
    return _REGRESSOR_WORDS.get(name, REGRESSOR[name].meaning)


def _force(equation: str) -> str:
    return _unexplained(EQUATION[equation].either)


def _unexplained(force: str) -> str:
    return f"an unexplained {force.removeprefix('the ')}"


def _subject(reading: str) -> str:
    return f"an unexplained error of {reading}"


def _proportion(product: Product) -> str:
    return f"in proportion to {product_words(product)}" if product.factors else "that is constant"


def _factor_words(factor: Factor) -> str:
    """Words for a power of a regressor; those that keep a sign are told from amounts."""
    meaning = regressor_words(factor.name)
    odd = factor.power % 2.0 == 1.0
    if factor.power == 1.0:
        return meaning if factor.signed else f"the amount of {meaning}"
    if factor.power == 0.0 and factor.signed:
        return f"the sign of {meaning}"
    begin = _POWERS.get(factor.power)
    words = f"{begin} {meaning}" if begin else f"the power {factor.power:g} of {meaning}"
    if factor.signed == odd:
        return words
    return words.replace("the ", "the signed ", 1) if factor.signed else f"the amount of {words}"
