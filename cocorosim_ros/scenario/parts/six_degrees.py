"""What a platform says of its motion in six degrees of freedom, beyond what four need."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of, read_any_quantity, read_list, si_unit
from cocorosim_ros.scenario.reading.records import choice, list_of, quantity, stored, vector

Vector3 = tuple[float, float, float]
AXES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
COUPLED = ("added_mass", "linear_damping", "quadratic_damping", "lift")
_UNITS = {
    "added_mass": ("kg", "kg m", "kg m^2"),
    "linear_damping": ("N s/m", "N s", "N m s"),
    "quadratic_damping": ("kg/m", "kg m", "kg", "N m s^2"),
    "lift": ("kg/m", "kg", "kg", "kg m"),
}


def unit_of(matrix: str, force: str, motion: str) -> str:
    """The unit of an entry of a matrix of COUPLED: what `motion` (one of AXES) makes along or about `force`."""
    turned, turns = AXES.index(force) > 2, AXES.index(motion) > 2
    units = _UNITS[matrix]
    if len(units) == 3:  # both couplings of a force and a turn have the same
        return units[int(turned) + int(turns)]
    return units[2 * int(turned) + int(turns)]


def _read_inertia(entry: Entry) -> tuple[float, ...]:
    numbers = read_list(entry, "moment of inertia")
    if len(numbers) not in (3, 6):
        raise entry.problem(f"has {entry.found()}; write the moments [xx, yy, zz], or [xx, yy, zz, xy, xz, yz].")
    xx, yy, zz = numbers[:3]
    if min(xx, yy, zz) <= 0.0 or 2.0 * max(xx, yy, zz) > (xx + yy + zz) * (1 + 1e-9):
        raise entry.problem(
            f"has {entry.found()}, which no body has; moments of inertia are greater than zero, and none is "
            "greater than the sum of the two others."
        )
    return numbers


def _inertia_tree(numbers: tuple[float, ...]) -> list[str]:
    return [f"{number!r} kg m^2" for number in numbers]


def _number_text(number: Quantity) -> str:
    return f"{number.value!r} {number.unit}"


@dataclass(frozen=True)
class Coupling:
    """An entry of a matrix beside its diagonal: what a motion along or about one axis makes along or about another.

    number: in the unit that `unit_of` gives. Of added mass the mirrored entry is the same, and is not written.
    """

    matrix: str = field(metadata=choice(*COUPLED))
    force: str = field(metadata=choice(*AXES))
    motion: str = field(metadata=choice(*AXES))
    number: Quantity = field(metadata=stored(read_any_quantity, _number_text, form="number with its unit"))


@dataclass(frozen=True)
class SixDegrees:
    """Numbers of a platform that rolls and pitches; everything about the origin of its body axes.

    inertia: xx, yy, zz, or these and xy, xz, yz, entries of the matrix about the centre of gravity [kg m^2]. volume
    [m^3] of the water that it displaces. centre_of_gravity, centre_of_buoyancy [m; body]. Diagonals along surge, sway,
    heave and about roll, pitch, yaw: added_mass [kg], added_inertia [kg m^2], linear_damping [N s/m],
    linear_turn_damping [N m s], quadratic_damping [kg/m] and quadratic_turn_damping [N m s^2], each axis by itself.
    """

    inertia: tuple[float, ...] = field(
        metadata=stored(_read_inertia, _inertia_tree, form="list of 3 or 6: moment of inertia [kg m^2]")
    )
    volume: float = field(metadata=quantity("volume", "positive"))
    centre_of_gravity: Vector3 = field(metadata=vector("length", 3))
    centre_of_buoyancy: Vector3 = field(metadata=vector("length", 3))
    added_mass: Vector3 = field(metadata=vector("mass", 3, "not negative"))
    added_inertia: Vector3 = field(metadata=vector("moment of inertia", 3, "not negative"))
    linear_damping: Vector3 = field(metadata=vector("linear drag", 3, "not negative"))
    linear_turn_damping: Vector3 = field(metadata=vector("linear yaw drag", 3, "not negative"))
    quadratic_damping: Vector3 = field(metadata=vector("quadratic drag", 3, "not negative"))
    quadratic_turn_damping: Vector3 = field(metadata=vector("quadratic yaw drag", 3, "not negative"))
    couplings: tuple[Coupling, ...] = field(default=(), metadata=list_of(Coupling))


def check_couplings(section: Entry, couplings: tuple[Coupling, ...]) -> None:
    """Nothing, if every coupling has the unit of its place and stands there alone; section: their list in the file."""
    met: set[tuple[str, ...]] = set()
    for entry, coupling in zip(section.items(), couplings, strict=True):
        place = entry.mapping()["number"]
        if coupling.force == coupling.motion and coupling.matrix != "lift":
            raise entry.problem(
                f"has '{coupling.matrix}' of {coupling.motion} on itself; write it in the platform's diagonal of it."
            )
        unit = unit_of(coupling.matrix, coupling.force, coupling.motion)
        if coupling.number.dimension != dimension_of(unit):
            raise place.problem(
                f"has the unit '{coupling.number.unit}', and '{coupling.matrix}' of {coupling.motion} on "
                f"{coupling.force} is a {dimension_of(unit)}; write it in {si_unit(dimension_of(unit))}."
            )
        axes = tuple(sorted((coupling.force, coupling.motion))) if coupling.matrix == "added_mass" else (
            coupling.force, coupling.motion)  # fmt: skip
        if (coupling.matrix, *axes) in met:
            raise entry.problem(
                f"has '{coupling.matrix}' between {listed(axes, 'and')} a second time; leave one of them out."
            )
        met.add((coupling.matrix, *axes))


def check_six_degrees(entry: Entry, six: SixDegrees, others: dict[str, Any]) -> None:
    """Nothing, if the numbers fit; others: what the platform has beside them that only four degrees know, by key."""
    section = entry.mapping()
    if "couplings" in section:
        check_couplings(section["couplings"], six.couplings)
    for key, value in others.items():
        if value:
            raise entry.problem(
                f"stands beside '{key}', which has no part yet in motion with six degrees of freedom; leave one out."
            )
