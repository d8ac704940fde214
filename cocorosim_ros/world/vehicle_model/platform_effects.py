"""From a platform's effects and calibrated numbers to the rows of the simulation, and what of them it has not."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.platform_checks import check_effects, check_sensors
from cocorosim_ros.scenario.reading.worded_numbers import word_of
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS, LAWS
from cocorosim_ros.world.effects.anisotropic_drag import ADDING, FORM_BY_NAME, REPLACING
from cocorosim_ros.world.laws.laws_of_platform import effects_of, in_codes
from cocorosim_ros.world.laws.readings import READINGS
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors import ERROR_COLUMNS, ERRORS, NEUTRAL, is_simulated
from cocorosim_ros.world.sensors.errors.sensor_latency import LATE_TOPICS
from cocorosim_ros.world.sensors.faults import Faults
from cocorosim_ros.world.sensors.law import NO_REGRESSORS_OF_READINGS, SENSOR_LAWS
from cocorosim_ros.world.terms.equations import EQUATIONS
from cocorosim_ros.world.terms.regressors import REGRESSORS
from cocorosim_ros.world.vehicle_model.fins import fin_numbers, fins_of
from cocorosim_ros.world.vehicle_model.jets import without_jets
from cocorosim_ros.world.vehicle_model.plausible_body import check_body, displaced_mass
from cocorosim_ros.world.vehicle_model.rudders import rudder_numbers, rudders_of
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS, neutral_row

EVERYWHERE = EFFECT_BIT["quadratic_drag"] | EFFECT_BIT["net_buoyancy"]  # effects of every robot in every water


def _of_recordings(name: str, parameters: tuple[Parameter, ...]) -> tuple[Parameter, ...]:
    return tuple(part for part in parameters if not is_simulated(name, part))


RECORDING_EFFECTS: dict[str, tuple[Parameter, ...]] = {
    **{name: parts for name, error in ERRORS.items() if (parts := _of_recordings(name, error.parameters))},
    **SENSOR_LAWS,
}
"""Effects of cameras and clocks of a recording and laws of readings, which a diagnosis finds; a simulation has none."""


def _known_effects() -> Mapping[str, Mapping[str, Parameter]]:
    tables: dict[str, dict[str, Parameter]] = {}
    described = [(name, effect.parameters) for name, effect in CATALOGUE_EFFECTS.items()]
    described += [(name, error.parameters) for name, error in ERRORS.items() if error.parameters]
    for name, parameters in (*described, *SENSOR_LAWS.items()):
        tables[name] = {part.name: part for part in parameters}
    return MappingProxyType(tables)


_SIMULATED_ERRORS = {
    f"{name}.{part.name}": ERROR_COLUMNS[f"{name}.{part.name}"]
    for name, error in ERRORS.items()
    for part in error.parameters
    if error.changes and is_simulated(name, part)
}
KNOWN_EFFECTS: Mapping[str, Mapping[str, Parameter]] = _known_effects()
"""Every effect that a platform file can name, with its parameters by name."""


def _or_else(number: float | None, otherwise: float) -> float:
    return otherwise if number is None else number


def _net_buoyancy(platform: Platform) -> float:
    """Buoyancy less weight with the pumps at their neutral volume [N]; a vehicle without a pump is trimmed neutral."""
    displaced = displaced_mass(platform)
    return 0.0 if displaced == 0.0 else (displaced - platform.mass) * platform.gravity


def turning_gain(platform: Platform) -> float:
    """Share of their thrust with which thrusters turn the vehicle [1]: that of pushing it unless it has its own."""
    return _or_else(platform.yaw_torque_gain, _or_else(platform.thrust_gain, 1.0))


_NUMBERS: dict[str, Callable[[Platform], float]] = {
    "mass": lambda platform: platform.mass,
    "yaw_inertia": lambda platform: platform.yaw_inertia,
    "drag": lambda platform: platform.drag,
    "yaw_drag": lambda platform: platform.yaw_drag,
    "net_buoyancy": _net_buoyancy,
    "thrust_gain": lambda platform: _or_else(platform.thrust_gain, 1.0),
    "yaw_torque_gain": turning_gain,
    "buoyancy_gain": lambda platform: _or_else(platform.buoyancy_gain, 1.0),
}


DRAG_FORM, STRIP_LENGTH = "anisotropic_drag.form", "anisotropic_drag.length"


def _drag_form(platform: Platform) -> dict[str, float]:
    """The numbers, by column, that make the drag of the basic physics into the form that the platform declares."""
    if platform.drag_form in (None, "total_speed"):
        return {}
    return {DRAG_FORM: FORM_BY_NAME[platform.drag_form], STRIP_LENGTH: platform.hull.length}


def _check_drag_form(platform: Platform) -> None:
    """Refuse a form of the drag that an effect of the same platform contradicts."""
    form = effects_of(platform).get("anisotropic_drag", {}).get("form")
    if form is None:
        return
    declared = platform.drag_form
    whole = None if declared is None else FORM_BY_NAME[declared]
    allowed = [*ADDING, *REPLACING] if whole is None else [whole] if whole in REPLACING else [*ADDING]
    if form not in allowed:
        of_what = "drag" if declared is None else f"'drag_form: {declared}'"
        words = " or ".join(str(word_of(DRAG_FORM, each)) for each in allowed)
        found = word_of(DRAG_FORM, form) or f"{form:g}"
        raise CocorosimError(
            f"{platform.origin}: 'effects.anisotropic_drag.form' has '{found}', which is no form of {of_what}; write "
            f"{words}, or leave it out."
        )


def _check_code(place: str, name: str, value: float) -> None:
    """Refuse what is no code of a law's equation or regressor."""
    counts = {"equation": len(EQUATIONS), "reading": len(READINGS)}
    count = len(REGRESSORS) if name.startswith("regressor") else counts.get(name)
    if count is not None and value not in range(count):
        raise CocorosimError(f"{place} has '{value:g}'; write a whole number from 0 to {count - 1}.")
    of_reading = "sensor_law" in place and name.startswith("regressor")
    if of_reading and REGRESSORS[int(value)].name in NO_REGRESSORS_OF_READINGS:
        raise CocorosimError(
            f"{place} has '{value:g}', {REGRESSORS[int(value)].name}, of which no reading has a law; write another one."
        )


def check_platform(platform: Platform) -> None:
    """Nothing, if a platform and those of its robots that differ can be one body, with effects known and in order.

    Raises CocorosimError otherwise.
    """
    for each in (platform, *platform.robots.values()):
        check_body(each)
        in_numbers = in_codes(each)
        check_effects(in_numbers, KNOWN_EFFECTS)
        check_sensors(each, SENSORS)
        _check_drag_form(each)
        for place in (*LAWS, *SENSOR_LAWS):
            for name, value in in_numbers.effects.get(place, {}).items():
                _check_code(f"{each.origin}: 'effects.{place}.{name}'", name, value)


def parameter_row(platform: Platform) -> Floats:
    """(parameters,) the numbers of one robot of this kind by PARAMETER_COLUMNS."""
    row = neutral_row()
    for name, number in _NUMBERS.items():
        row[PARAMETER_COLUMNS[name]] = number(platform)
    of_actuators = rudder_numbers(platform) | fin_numbers(platform)
    for name, value in (_drag_form(platform) | of_actuators | _chosen(platform, PARAMETER_COLUMNS)).items():
        row[PARAMETER_COLUMNS[name]] = value
    return row


def active_bits(platform: Platform) -> int:
    """The effects that act on a robot of this kind: one bit of EFFECT_BIT for each."""
    bits = EVERYWHERE
    of_actuators = [effect for effect, _ in (*rudders_of(platform), *fins_of(platform))]
    for effect in (*effects_of(platform), *of_actuators):
        bits |= EFFECT_BIT.get(effect, 0)
    return bits | (EFFECT_BIT["anisotropic_drag"] if _drag_form(platform) else 0)


def build_faults(platforms: Sequence[Platform]) -> Faults | None:
    """What is wrong with the instruments of one robot per platform; None if nothing is."""
    neutral = np.tile(NEUTRAL, (len(platforms), 1))
    faults = Faults(neutral.copy(), np.zeros((len(platforms), len(LATE_TOPICS))))
    for robot, platform in enumerate(platforms):
        for name, value in _chosen(platform, _SIMULATED_ERRORS).items():
            faults.error[robot, ERROR_COLUMNS[name]] = value
        for topic, value in effects_of(platform).get("sensor_latency", {}).items():
            if topic in LATE_TOPICS:
                faults.latency[robot, LATE_TOPICS.index(topic)] = value
    return faults if (faults.error != neutral).any() or faults.latency.any() else None


def build_delays(platforms: Sequence[Platform]) -> Floats:
    """(robots,) by how much the commands of one robot per platform act late [s]."""
    return np.array([effects_of(platform).get("command_delay", {}).get("delay", 0.0) for platform in platforms])


def not_simulated(robots: Mapping[str, Platform]) -> list[str]:
    """One sentence for each effect of these platforms that is the recording's, or for which they lack a number."""
    who: dict[str, list[str]] = {}
    for robot, platform in robots.items():
        found = [
            f"{effect} of {name}" if effect in ("sensor_latency", "clock_skew") else effect
            for effect, parameters in effects_of(platform).items()
            for name in parameters
            if name in {part.name for part in RECORDING_EFFECTS.get(effect, ())}
        ]
        found += [f"frame_mixup of {topic}" for topic in platform.frame_corrections]
        for words in found:
            who.setdefault(words, []).append(robot)
    return [
        f"{effect} belongs to a recording's camera and clocks or to an instrument, not to the robot's motion: "
        f"it is not simulated (platform of {names[0] if len(names) == 1 else f'{names[0]} and {len(names) - 1} more'})."
        for effect, names in who.items()
    ] + without_jets(robots.values())


def _chosen(platform: Platform, columns: Mapping[str, int]) -> dict[str, float]:
    """The numbers of the platform's effects that have a column, by its name."""
    numbers = {
        f"{effect}.{name}": value
        for effect, parameters in effects_of(platform).items()
        for name, value in parameters.items()
    }
    return {name: value for name, value in numbers.items() if name in columns}
