"""EQUATIONS: what a law outside the catalogue can act on. The place in the table is the code that a law carries."""

from __future__ import annotations

from typing import NamedTuple


class Equation(NamedTuple):
    """An equation of motion, and what stands on its left side."""

    name: str
    symbol: str
    unit: str
    meaning: str
    opposite: str  # the meaning where the number is negative
    either: str  # the meaning without a direction


EQUATIONS: tuple[Equation, ...] = (
    Equation("surge", "X", "N", "the force forwards", "the force backwards", "the force ahead or astern"),
    Equation("sway", "Y", "N", "the force to the left", "the force to the right", "the force to one side"),
    Equation("heave", "Z", "N", "the force upwards", "the force downwards", "the force up or down"),
    Equation(
        "yaw",
        "N",
        "N m",
        "the moment that turns to the left",
        "the moment that turns to the right",
        "the turning moment",
    ),
    Equation(
        "world_x",
        "F_x",
        "N",
        "the force along x of the world",
        "the force against x of the world",
        "the force along or against x of the world",
    ),
    Equation(
        "world_y",
        "F_y",
        "N",
        "the force along y of the world",
        "the force against y of the world",
        "the force along or against y of the world",
    ),
    Equation(
        "world_z",
        "F_z",
        "N",
        "the force along z of the world",
        "the force against z of the world",
        "the force along or against z of the world",
    ),
)
EQUATION_CODE = {equation.name: code for code, equation in enumerate(EQUATIONS)}
EQUATION = {equation.name: equation for equation in EQUATIONS}
