"""The parts of a trial: what the prior draws, and more of what the table asks 200 of."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from trial.provenance import ROOT

VEHICLES = {"rov": "a second vehicle: an ROV", "slender": "a third vehicle: a slender AUV"}
"""Those with six degrees of freedom, in words."""


@dataclass(frozen=True)
class Part:
    """Recordings made with the same wishes: words of `concealer conceal`, and how many; and what they are of."""

    name: str
    count: int
    words: tuple[str, ...] = ()
    platform: str = "lily"  # name of a platform or path of its file, as `cocorosim diagnose` takes it


def parts(count: int, wanted: list[str]) -> list[Part]:
    """Parts of a trial whose main part has `count` recordings: shares that make 200 each of nulls out of 400."""
    every = [
        Part("main", count),
        Part("nothing", round(0.25 * count), ("--kind", "nothing")),
        Part("recalibration", round(0.4 * count), ("--kind", "recalibration")),
        Part("medium_1", round(0.15 * count), ("--kind", "single", "--size", "0.5", "--noise", "0.01")),
        Part("medium_3", round(0.15 * count), ("--kind", "single", "--size", "0.5", "--noise", "0.03")),
    ]
    return [part for part in every if part.count and (not wanted or part.name in wanted)]


def families_parts(count: int, word: str) -> list[Part]:
    """Parts of a trial of families of a public word: what the prior draws, medium effects whose form is drawn, laws."""
    words = ("--families", word)
    medium = ("--kind", "single", "--formed", "--size", "0.5", "--noise", "0.01")
    every = [
        Part("families", count, words),
        Part("families_forms", round(0.5 * count), (*words, *medium)),
        Part("families_outside", round(0.25 * count), (*words, "--kind", "outside")),
    ]
    return [part for part in every if part.count]


def platform_of(vehicle: str) -> Path:
    """Path of the platform file that the tool is given of one of VEHICLES."""
    return ROOT / "test" / "trial" / f"{vehicle}_platform.yaml"


def vehicle_parts(vehicle: str, count: int) -> list[Part]:
    """The one part of a trial of one of VEHICLES: what its prior draws."""
    prior = ROOT / "test" / "concealer" / "six_degrees" / f"{vehicle}.yaml"
    return [Part(vehicle, count, ("--prior", str(prior)), str(platform_of(vehicle)))]
