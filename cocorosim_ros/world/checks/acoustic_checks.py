"""Whether the sound of a scenario fits its tank, its tick, its controllers, and the law of absorption."""

from __future__ import annotations

import math
from collections.abc import Mapping

from cocorosim_ros.scenario.parts.acoustic import VALIDITY, Acoustic
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.controllers.traits import needs_sound, traits_of

MOST_TICKS = 1000  # that a message may be under way


def check_acoustic(scenario: Scenario, sections: Mapping[str, Entry]) -> None:
    """Nothing, if the sound fits; CocorosimError names what does not.

    sections: the entries of the scenario's keys, for the place in the sentence. Controllers in plain Python are not
    loaded for this (see controllers.plain).
    """
    if scenario.acoustic is None:
        _check_nobody_needs_it(scenario, sections["swarm"])
        return
    entry = sections["acoustic"]
    section = entry.mapping()
    for name, valid in VALIDITY.items():
        value = getattr(scenario.acoustic, name)
        if not valid.least <= value <= valid.most:
            limits = " to ".join(f"{limit * valid.factor:g}" for limit in (valid.least, valid.most))
            raise section[name].problem(
                f"has {section[name].found()}, for which no absorption is known; the law that is used holds from "
                f"{limits} {valid.unit}."
            )
    _check_range(scenario, scenario.acoustic, section["range"])
    _check_times(scenario, scenario.acoustic, entry)


def _check_nobody_needs_it(scenario: Scenario, swarm: Entry) -> None:
    for group, entry in zip(scenario.swarm, swarm.items(), strict=True):
        if not isinstance(group.controller, PythonController) and needs_sound(traits_of(group.controller)):
            raise entry.mapping()["controller"].problem(
                f"has '{group.controller.name}', which speaks or hears by sound, but the scenario has no 'acoustic'; "
                "add 'acoustic: {range: ...}'."
            )


def _check_range(scenario: Scenario, acoustic: Acoustic, entry: Entry) -> None:
    diagonal = math.hypot(*scenario.tank.size)
    if acoustic.range > diagonal:
        raise entry.problem(
            f"has {entry.found()}, farther than the {diagonal:.4g} m from corner to corner of the tank; choose a "
            "range within the tank, or a larger tank."
        )


def _check_times(scenario: Scenario, acoustic: Acoustic, entry: Entry) -> None:
    section, tick = entry.mapping(), scenario.tick_ns
    lasts = acoustic.duration_ns + math.ceil(acoustic.range / acoustic.sound_speed * 1e9)
    if lasts > MOST_TICKS * tick:
        raise entry.problem(
            f"lets a message take {lasts / 1e9:.4g} s, more than {MOST_TICKS} ticks of '{nanoseconds_text(tick)}'; "
            "choose a shorter range or duration, or a faster 'sound_speed'."
        )
    if acoustic.bandwidth > 2.0 * acoustic.frequency:
        raise section.get("bandwidth", entry).problem(
            f"has a bandwidth of {acoustic.bandwidth:g} Hz around {acoustic.frequency:g} Hz, which reaches below zero; "
            "choose a smaller one."
        )
    if acoustic.slot_ns is None:
        return
    if acoustic.slot_ns % tick:
        raise section["slot"].problem(
            f"has '{nanoseconds_text(acoustic.slot_ns)}', which is not a whole number of ticks of "
            f"'{nanoseconds_text(tick)}'; choose a multiple of the tick."
        )
    if acoustic.slot_ns < lasts:
        raise section["slot"].problem(
            f"has '{nanoseconds_text(acoustic.slot_ns)}', in which a message of "
            f"'{nanoseconds_text(acoustic.duration_ns)}' does not reach {acoustic.range:g} m before the next begins; "
            f"choose a slot of {lasts / 1e9:.4g} s or more."
        )
