"""Words for the manoeuvre to drive next, and for the part of a course that most evidence of a mismatch comes from."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.findings import Concentration, Regime

MANOEUVRES: dict[str, str] = {
    "coast_down": "drive at three speeds and let it coast to rest after each",
    "zig_zag": "zig-zag at three speeds, turning both ways",
    "four_headings": "drive to all four headings over the whole area, and drift with the motors off",
    "along_wall": "repeat the same straight run close to a wall and far from any",
    "follow_neighbour": "follow another robot closely, then repeat the run alone",
    "steps": "step the commands of the thrusters up and down many times",
    "ramps_through_zero": "ramp each thruster by itself slowly over its whole range",
    "thrust_staircase": "climb a staircase of thrust, all thrusters alike",
    "reverse_steps": "drive forwards and backwards on the same line with equal commands",
    "crash_stops": "stop from full speed with full reverse thrust, ahead and astern, at several thrusts",
    "repeat_at_end": "drive the same programme at the beginning and at the end of a long recording",
    "depth_staircase": "hold five depths from the surface to the floor, twice up and down",
    "pump_triangle": "sweep the pump up and down in triangles of several widths",
    "slow_turns": "turn slowly through full circles both ways",
    "surface_touch": "touch the surface at the beginning and at the end",
    "rest": "lie still for a minute before and after",
    "ruler": "put a ruler, or two marks of known distance, where the vehicle drives",
}
"""Manoeuvres by name, each as an instruction: they show what a recording leaves open."""

REGIME_WORDS: dict[Regime, str] = {
    "turning": "mostly when turning",
    "straight": "mostly when turning slowly or not",
    "fast": "mostly at speed",
    "slow": "mostly when slow",
    "deep": "mostly when deep",
    "shallow": "mostly when shallow",
    "climbing": "mostly when diving or rising",
    "east": "mostly in the eastern half",
    "west": "mostly in the western half",
    "north": "mostly in the northern half",
    "south": "mostly in the southern half",
}


def manoeuvre_words(manoeuvres: Sequence[str]) -> str | None:
    """Manoeuvres, given by name, as a sentence; None if there are none."""
    words = "; ".join(MANOEUVRES[name] for name in manoeuvres)
    return f"{words[0].upper()}{words[1:]}." if words else None


def where_words(where: Concentration | None) -> str:
    """Words for the part of a course that most evidence comes from, and its share; None: from all of the course."""
    if where is None:
        return "throughout"
    return f"{REGIME_WORDS[where.regime]} ({min(where.share, 1.0):.0%} of the evidence)"
