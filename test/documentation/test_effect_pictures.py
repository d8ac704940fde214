"""Pictures of the page of effects: each effect has one or says why not, and they show what the functions compute."""

from __future__ import annotations

import re

import numpy as np
import pytest
from site_builder.circumstances import cruising
from site_builder.curves import Curve, examples
from site_builder.effect_curves import effect_curve
from site_builder.effect_pictures import curve_of, picture
from site_builder.effects import catalogue
from site_builder.plain_python import plain

from cocorosim_ros.diagnosis.report.figure_style import AFTER
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import BASIC_EFFECTS, CATALOGUE_EFFECTS
from cocorosim_ros.world.effects.wind import WIND, wind
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search

ON_THE_PAGE = [name for name, each in {**CATALOGUE_EFFECTS, **ERRORS}.items() if each.numbers]
WITHOUT = {
    "net_buoyancy",  # a Lily weighs 0.44 kg and displaces 440 cm^3
    "patch_force",  # there are no patches in still water
    "wash_loss",  # none of a Lily's thrusters stands in the jet of another one
    "sensor_latency",  # of when readings come, not of what they are
    "clock_skew",
    "command_delay",  # of when a command acts
}


def shown(name: str) -> Curve:
    """The curve of an effect that has one."""
    curve = curve_of(name)
    assert curve is not None
    return curve


def drawn(svg: str) -> Floats:
    """(vertices, 2) the line in the accent colour, in points of the picture, downwards positive."""
    (path,) = [each for each in re.findall(r"<path\s[^>]*>", svg) if AFTER in each]
    return np.array(re.findall(r"[ML] (\S+) (\S+)", path), dtype=float)


def test_each_effect_has_a_picture_or_a_sentence() -> None:
    """Each part of the page has one of the two; a picture has its text for those that cannot see it."""
    page = catalogue()
    parts = dict(re.findall(r"^### (\w+)$(.*?)(?=^##|\Z)", page, re.DOTALL | re.MULTILINE))
    assert list(parts) == ON_THE_PAGE
    for name, text in parts.items():
        found = re.search(r'<figure [^>]*>\n<svg role="img" aria-label="[^"]+: [^"]+, over [^"]+" ', text)
        assert (found is None) == (name in WITHOUT), name
        assert ("No picture: " in text) == (name in WITHOUT), name
    of_every_robot = page.partition("## Of the motion")[0]
    assert of_every_robot.count("<svg") == 1
    assert of_every_robot.count("No picture: ") == len(BASIC_EFFECTS) - 1


@pytest.mark.parametrize("name", [*BASIC_EFFECTS, *ON_THE_PAGE])
def test_a_curve_shows_something(name: str) -> None:
    """The two lines of a picture differ, and both are finite."""
    curve = curve_of(name)
    assert (curve is None) == (name in WITHOUT)
    if curve is not None:
        assert curve.shows
        assert np.isfinite([curve.with_it, curve.without]).all()


def test_a_centre_ahead_resists_a_turn_under_way() -> None:
    """N = -m x_g u r of a Lily of 0.44 kg at full speed, with the example's 0.01 m: nothing where it does not turn."""
    curve = shown("offset_centre")
    assert curve.axis.name == "r"
    np.testing.assert_allclose(curve.with_it, -0.44 * 0.01 * cruising().u * curve.axis.values, rtol=1e-9, atol=1e-18)
    assert not curve.without.any()


def test_quadratic_drag_is_the_parabola_of_the_paper() -> None:
    """A Lily feels 0.01 N at 0.075 m/s (Read et al. 2013, equation 6) and a quarter of it at half the speed."""
    curve = shown("quadratic_drag")
    speed = curve.axis.values
    assert curve.axis.name == "u"
    np.testing.assert_allclose(speed[[0, -1]], [-0.075, 0.075], rtol=1e-4)
    np.testing.assert_allclose(curve.with_it, -0.01 * np.abs(speed) * speed / 0.075**2, rtol=1e-4)
    assert not curve.without.any()


def test_the_line_in_the_picture_is_that_parabola() -> None:
    """Places of the line in the SVG, scaled to its ends, lie on -|u| u to a hundredth of the picture."""
    x, y = drawn(picture("quadratic_drag")).T
    speed = 2.0 * (x - x[0]) / (x[-1] - x[0]) - 1.0
    force = 2.0 * (y - y[-1]) / (y[0] - y[-1]) - 1.0
    assert len(x) > 10
    assert y[0] < y[-1]  # upwards is less there: the force is positive at negative speed
    np.testing.assert_allclose(force, -np.abs(speed) * speed, atol=0.01)


def test_a_compass_is_wrong_by_a_sine() -> None:
    """The example's 0.03 rad and 0.1 rad times the sine: 0.13 rad too much at a quarter turn."""
    curve = shown("compass_distortion")
    assert curve.axis.name == "yaw"
    np.testing.assert_allclose(curve.with_it, 0.03 + 0.1 * np.sin(curve.axis.values), atol=1e-12)
    assert not curve.without.any()


def test_a_density_layer_is_a_step() -> None:
    """The example's 1 mN below 1 m, half of it in the middle of the layer, and nothing above it."""
    curve = shown("stratification")
    assert curve.axis.name == "z"
    np.testing.assert_allclose(np.interp([-2.0, -1.0, -0.5], curve.axis.values, curve.with_it), [1e-3, 5e-4, 0.0])


def test_a_lag_is_an_exponential() -> None:
    """After a step, 1 - exp(-t / 0.3 s) with the example's time constant; at once without a lag."""
    curve = shown("thruster_lag")
    np.testing.assert_allclose(curve.with_it, 1.0 - np.exp(-curve.axis.values / 0.3), atol=1e-12)
    np.testing.assert_array_equal(curve.without, 1.0)


def test_the_wrong_split_of_the_released_drag() -> None:
    """Along y the released model takes y^2 for the speed over ground, so that a rising robot loses nearly all of X.

    At u = 0.075 m/s, w = u / 2 and heading 90 degrees it keeps sin and cos of atan2(w, u^2): X loses k U (u - U c),
    with c = u^2 / sqrt(u^4 + w^2).
    """
    curve = shown("misplaced_root_drag")
    u, w = 0.075, 0.0375
    total = np.hypot(u, w)
    expected = 0.01 / 0.075**2 * total * (u - total * u**2 / np.hypot(u**2, w))
    at_a_quarter_turn = np.interp(0.5 * np.pi, curve.axis.values, curve.with_it)
    assert curve.axis.name == "yaw"
    assert at_a_quarter_turn == pytest.approx(expected, rel=1e-3)


def test_a_new_effect_has_its_picture_from_its_own_function() -> None:
    """The leak of CONTRIBUTING.md is drawn over time, in heave, without a line about it anywhere."""

    def leak(row: object, relative: object, moment: Moment, parameters: Floats, total: Floats) -> None:
        total[2] -= parameters[0] * moment.time

    number = Number("rate", "N/s", "weight of the water that comes in", gives="N", example=Example(5e-6, "scales"))
    search = Search(channel="heave", manoeuvre="depth_staircase")
    curve = effect_curve("leak", Effect(summary="leak", wrench=leak, parameters=(number,), search=search))
    assert curve is not None
    assert (curve.axis.name, curve.label) == ("t", "Z")
    np.testing.assert_allclose(curve.with_it, -5e-6 * curve.axis.values)


def test_plain_python_is_what_is_compiled() -> None:
    """A function with a square root, sine and cosine gives the same bits either way."""
    now, force, in_python = cruising(yaw=0.7, v=0.01), np.zeros(4), np.zeros(4)
    wind(now.row, now.relative, now.moment, examples(WIND), force)
    plain(wind)(now.row, now.relative, now.moment, examples(WIND), in_python)
    assert force[1] != 0.0
    np.testing.assert_array_equal(in_python, force)


def test_a_picture_is_the_same_each_time() -> None:
    """No date and no random names are in it, and nothing that would reach beyond it."""
    assert picture("wind") == picture("wind")
    assert "<style" not in picture("wind")
    assert "\n\n" not in picture("wind")  # would end the HTML inside the page
