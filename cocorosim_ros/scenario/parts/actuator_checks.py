"""Whether the actuators of a platform fit together, beyond what each says alone."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.parts.steering import Azimuth, Rudder
from cocorosim_ros.scenario.parts.thrust_curve import check_ends
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator, Thruster
from cocorosim_ros.scenario.reading.entry import Entry, nearest

MOST_RUDDERS = 2
MOST_FINS = 4
_LEVEL = 1e-9  # of a direction of unit length: so little of it may point up


def check_actuators(section: Entry, actuators: Sequence[Actuator], six_degrees: bool) -> None:
    """Nothing, if all are in order; section: their list in the file. Raises CocorosimError otherwise.

    six_degrees: whether the platform rolls and pitches.
    """
    turned: dict[str, str] = {}
    _check_degrees(section, actuators, six_degrees)
    for entry, actuator in zip(section.items(), actuators, strict=True):
        if isinstance(actuator, Thruster) and actuator.curve is not None:
            check_ends(entry, actuator.curve, actuator.maximum, actuator.reverse)
        if isinstance(actuator, Rudder):
            _check_propeller(entry, actuator, actuators)
        if isinstance(actuator, Azimuth):
            _check_turned(entry, actuator, actuators, turned)
    _check_number(section, "rudders", MOST_RUDDERS, sum(isinstance(part, Rudder) for part in actuators))
    if not six_degrees:
        _check_number(section, "fins", MOST_FINS, sum(isinstance(part, Fin) for part in actuators))


def _check_number(section: Entry, what: str, most: int, count: int) -> None:
    if count > most:
        raise section.problem(
            f"has {count} {what}; {most} are the most. {what.capitalize()} that turn together count as one of all "
            "their area."
        )


def _check_degrees(section: Entry, actuators: Sequence[Actuator], six_degrees: bool) -> None:
    for entry, actuator in zip(section.items(), actuators, strict=True):
        if six_degrees and not isinstance(actuator, (Thruster, Fin, SlidingMass)):
            raise entry.problem(
                f"has the kind '{actuator.kind}', and with 'six_degrees' only thrusters, fins and sliding masses are "
                "known; replace it."
            )
        if not six_degrees and isinstance(actuator, SlidingMass):
            raise entry.problem(
                "is a sliding mass, which acts in motion with 'six_degrees' alone; add these, or leave it out: where "
                "roll and pitch are recorded, what it does is in them."
            )


def _check_propeller(entry: Entry, rudder: Rudder, actuators: Sequence[Actuator]) -> None:
    section = entry.mapping()
    if rudder.propeller is None:
        for key in ("propeller_diameter", "acceleration", "coverage"):
            if key in section:
                raise section[key].problem("belongs to a jet, and no 'propeller' is named; name it, or leave this out.")
        return
    _thruster(section["propeller"], rudder.propeller, actuators)
    if rudder.propeller_diameter is None:
        raise entry.problem(f"lacks 'propeller_diameter', that of '{rudder.propeller}', in m.")


def _check_turned(entry: Entry, azimuth: Azimuth, actuators: Sequence[Actuator], turned: dict[str, str]) -> None:
    place = entry.mapping()["thruster"]
    thruster = _thruster(place, azimuth.thruster, actuators)
    if abs(thruster.direction[2]) > _LEVEL:
        raise place.problem(f"has '{thruster.name}', which does not push horizontally; only such a one can be turned.")
    if thruster.name in turned:
        raise place.problem(f"has '{thruster.name}', which '{turned[thruster.name]}' turns already; leave one out.")
    turned[thruster.name] = azimuth.name


def _thruster(place: Entry, name: str, actuators: Sequence[Actuator]) -> Thruster:
    """The thruster of that name. Raises CocorosimError, at the place that names it, if there is none."""
    thrusters = {actuator.name: actuator for actuator in actuators if isinstance(actuator, Thruster)}
    if name not in thrusters:
        raise place.problem(f"has '{name}', which is no thruster of this platform{nearest(name, list(thrusters))}.")
    return thrusters[name]
