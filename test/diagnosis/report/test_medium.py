"""Pages about vehicles in the air speak of air, those about all others of water."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import Diagnosis, Unrecorded
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.scenario.parts.platform import load_platform

Example = Callable[[str], Diagnosis]


def told(found: Diagnosis, platform: str) -> str:
    """The words of a page."""
    page = render_report(found, Origin(load_platform(platform), ("hall",), ("lily_01",), 600.0))
    return re.sub(r"<svg.*?</svg>|<style.*?</style>", "", page, flags=re.DOTALL)


@pytest.mark.parametrize("effect", ["steady_current", "sheared_current", "tidal_current", "linear_drag"])
def test_a_vehicle_in_the_air_has_no_water(example: Example, effect: str) -> None:
    """A current that moves it is a draught; of a ship all is as it was."""
    (munk,) = example("mismatch").effects
    entry = next(each for each in ENTRIES if each.id == effect)
    named = replace(munk, id=effect, name=entry.name, equation=entry.whole_equation, ambiguous_with=())
    found = replace(example("mismatch"), effects=(named,), screened=(), not_shown=())
    air, water = told(found, "rgblimp"), told(found, "kvlcc2_hsva")
    for words in ("water", "ilter pumps", "inflow", "floats", "tide, a seiche"):
        assert words not in air, words
    assert "random force of the air" in air and "Noise of air and sensors" in air
    assert "random force of the water" in water and "Noise of water and sensors" in water
    if effect == "steady_current":
        assert "draughts, fans, convection: let a balloon drift" in air
        assert "filter pumps, inflows, convection: let a float drift" in water


def test_captions_name_what_is_drawn(example: Example) -> None:
    """No height where none is known; an interval of a single window, whose ends are equal, is none."""
    found = example("mismatch")
    assert "by heading, speed, height z, thrust command and torque command, with" in told(found, "lily")
    assert "by heading, speed, thrust command and torque command, with" in told(
        replace(found, unrecorded=Unrecorded(depth=True)), "lily"
    )
    single = replace(found.fit["position"], intervals={"nominal": (0.537, 0.537), "augmented": (0.01, 0.02)})
    page = told(replace(found, fit={**found.fit, "position": single}), "lily")
    assert "537" not in page and "10.0 to 20.0" in page
