"""Words for the numbers of a platform that a diagnosis fits, by the names that findings give them."""

from __future__ import annotations

_SECTIONS = ("effects.", "actuators.")


def parameter_words(name: str) -> str:
    """Words for a number, such as 'yaw drag', 'gain of rudder' (actuators.rudder.gain), 'yaw of linear drag'."""
    for section in _SECTIONS:
        name = name.removeprefix(section)
    whole, _, number = name.rpartition(".")
    return f"{number} of {whole}".replace("_", " ") if whole else number.replace("_", " ")
