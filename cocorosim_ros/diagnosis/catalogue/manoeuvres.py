"""MANOEUVRES: what to drive so that a recording shows what this one leaves open."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect

MANOEUVRES: dict[str, str] = {
    "coast_down": "drive at three speeds and let it coast to rest after each",
    "zig_zag": "zig-zag at three speeds, turning both ways",
    "four_headings": "drive to all four headings over the whole tank, and drift with the motors off",
    "along_wall": "repeat the same straight run close to a wall and in the middle of the tank",
    "follow_neighbour": "follow another robot closely, then repeat the run alone",
    "steps": "step the commands of the thrusters up and down many times, with a fast gyro",
    "ramps_through_zero": "ramp each thruster slowly through zero while the other is off",
    "thrust_staircase": "climb a staircase of thrust with equal commands left and right",
    "reverse_steps": "drive forwards and backwards on the same line with equal commands",
    "repeat_at_end": "drive the same programme at the beginning and at the end of a long recording",
    "depth_staircase": "hold five depths from the surface to the floor, twice up and down",
    "pump_triangle": "sweep the pump up and down in triangles of several widths",
    "slow_turns": "turn slowly through full circles both ways",
    "surface_touch": "touch the surface at the beginning and at the end",
    "rest": "lie still for a minute before and after",
    "ruler": "put a ruler, or two marks of known distance, into the water at the depth of the run",
}


def manoeuvre_of(effect: str) -> str | None:
    """The name of the manoeuvre that shows an effect."""
    return next((entry.manoeuvre for entry in ENTRIES if entry.id == effect and entry.manoeuvre), None)


def advised(effects: Sequence[FoundEffect], unseen: Sequence[str]) -> tuple[str, ...]:
    """Names of up to three manoeuvres: they separate the rivals of what was found, or else show what was not seen."""
    open_effects = [rival.id for effect in effects for rival in effect.ambiguous_with] + [
        effect.id for effect in effects if effect.ambiguous_with
    ]
    names = [name for name in (manoeuvre_of(effect) for effect in dict.fromkeys(open_effects or unseen)) if name]
    return tuple(sorted(dict.fromkeys(names), key=lambda name: -names.count(name))[:3])


def in_words(manoeuvres: Sequence[str]) -> str | None:
    """Manoeuvres, given by name, as a sentence; None if there are none."""
    words = "; ".join(MANOEUVRES[name] for name in manoeuvres)
    return f"{words[0].upper()}{words[1:]}." if words else None
