"""Intervals that are as wide as a number differs between parts of the recordings."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.showing import FORM_WIDTH

# Log relative risks of 13 trials of the BCG vaccine and their variances: Colditz et al., JAMA 271 (1994) 698, as
# computed by Viechtbauer, Journal of Statistical Software 36 (2010) 3, who has Q = 152.23 and tau^2 = 0.3088 for the
# estimator of DerSimonian and Laird.
RISKS = [
    -0.8893, -1.5854, -1.3481, -1.4416, -0.2175, -0.7861, -1.6209, 0.0120, -0.4694, -1.3713, -0.3394, 0.4459, -0.0173
]  # fmt: skip
VARIANCES = [0.3256, 0.1946, 0.4154, 0.0200, 0.0512, 0.0069, 0.2230, 0.0040, 0.0564, 0.0730, 0.0124, 0.5325, 0.0714]

LINEAR = 0.02  # N s/m, of drag that the platform does not have


def shares(estimates: Any, variances: Any) -> tuple[Any, Any, Any]:
    """What each part adds to the common estimate, the variance of that, and the weight of the part."""
    weight = (1.0 / variances) / np.sum(1.0 / variances)
    return weight * (estimates - np.sum(weight * estimates)), weight**2 * variances, weight


def test_it_is_the_published_variance() -> None:
    """The variance between 13 trials is the one that was published."""
    from cocorosim_ros.diagnosis.showing.form_width import _variance

    assert _variance(*shares(np.array(RISKS), np.array(VARIANCES))) == pytest.approx(0.3088, abs=5e-4)


def test_the_mean_of_parts_has_the_variance_of_weighted_numbers() -> None:
    """With weights w, of numbers that differ by the published variance, the mean differs by sum(w^2) of that."""
    from cocorosim_ros.diagnosis.showing.form_width import Part, _variances

    precision = 1.0 / np.array(VARIANCES)
    weight = precision / precision.sum()
    off = np.array(RISKS) - np.sum(weight * np.array(RISKS))
    parts = [Part(np.array([p * o]), np.array([[p]]), frozenset({0})) for p, o in zip(precision, off, strict=True)]
    fit: Any = SimpleNamespace(unknowns=(SimpleNamespace(tracks=(0,)),))
    between, of_mean = _variances(fit, parts, np.array([[1.0 / precision.sum()]]))[:, 0]
    assert between == pytest.approx(0.3088, abs=5e-4)
    drawn = np.random.default_rng(1).normal(0.0, np.sqrt(0.3088), (20000, len(weight))) @ weight
    assert of_mean == pytest.approx(float(np.var(drawn)), rel=0.05)


def test_parts_that_agree_have_none() -> None:
    """Estimates that differ by their noise alone have a variance between them as rarely as the criterion asks."""
    from cocorosim_ros.diagnosis.showing.form_width import _variance

    rng = np.random.default_rng(20261123)
    variances = rng.uniform(0.1, 2.0, (2000, 8))
    estimates = rng.normal(0.0, np.sqrt(variances))
    found = [_variance(*shares(each, spread)) > 0.0 for each, spread in zip(estimates, variances, strict=True)]
    assert np.mean(found) < 0.004, "one in a thousand is asked for"


def test_one_part_alone_tells_nothing_of_a_difference() -> None:
    """An event that happens once has all its information in one part; noise elsewhere is no other estimate of it."""
    from cocorosim_ros.diagnosis.showing.form_width import _variance

    weight = np.array([1.0, 1e-3, 1e-3, 1e-3])
    assert _variance(np.array([0.0, 5.0, -5.0, 5.0]), np.array([1.0, 1e-2, 1e-2, 1e-2]), weight) == 0.0


def test_drag_of_another_form_has_a_wide_interval(swim: Any) -> None:
    """Where drag in truth is linear in part, one quadratic coefficient differs from speed to speed; else it does not.

    Beside d u the force D |V| u is that of a coefficient D + d / V: the interval reaches to that of the fastest eighth.
    """
    from cocorosim_ros.diagnosis.fitting.fit import covariance
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.showing.estimates import fitted
    from cocorosim_ros.diagnosis.showing.form_width import _speed, variances_between_parts
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of

    plain = load_platform("lily")
    unit = "N s/m"
    drag = {axis: Quantity(LINEAR, unit, dimension_of(unit)) for axis in ("surge", "sway", "heave")}
    other = replace(plain, effect_quantities={"linear_drag": drag})
    fits = [base_fit(swim(true, 600.0, seed=11, base=plain)) for true in (plain, other)]
    place = next(index for index, each in enumerate(fits[0].unknowns) if each.owner.parameter == "drag")
    even, uneven = map(variances_between_parts, fits)
    assert even.between[place] == even.of_mean[place] == 0.0
    assert uneven.between[place] > covariance(fits[1])[place, place]
    assert 0.0 < uneven.of_mean[place] < 0.5 * uneven.between[place]  # the mean of eight parts is surer than a part
    interval = fitted(fits[1])[place].estimate
    fast = float(np.quantile(_speed(smoothed_tracks(fits[1])[0].mean), 0.875))
    assert interval.holds(plain.drag + LINEAR / fast)


@pytest.mark.parametrize("logarithmic", [False, True])
def test_other_laws_of_a_kind_widen_a_number_by_their_share(logarithmic: bool) -> None:
    """By the share of the number that its effect's file has, whatever the number is fitted as; others stay."""
    from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
    from cocorosim_ros.diagnosis.showing.form_width import spread_of_other_forms
    from cocorosim_ros.world.effects import EFFECTS

    (share,) = [each.other_form for each in EFFECTS["battery_sag"].numbers if each.name == "fraction_lost"]
    assert share > 0.0
    owner = Owner("battery_sag", ("lily_01",), "fraction_lost", "1")
    sag = Unknown(owner, "battery_sag.fraction_lost", (0,), 0.1, 0.3, logarithmic)
    q = 0.7
    spread = spread_of_other_forms(sag, q)
    assert spread * abs(sag.slope(q)) == pytest.approx(share * sag.value(q))
    assert spread_of_other_forms(replace(sag, column="pressure_offset.offset"), q) == 0.0
    (share,) = [each.other_form for each in EFFECTS["anisotropic_drag"].numbers if each.name == "sway_ratio"]
    ratio = replace(sag, column="anisotropic_drag.sway_ratio", base=1.0)  # 1: drag that is the same on both axes
    spread = spread_of_other_forms(ratio, q)
    assert spread * abs(ratio.slope(q)) == pytest.approx(share * (ratio.value(q) - 1.0))
    assert spread_of_other_forms(replace(sag, column="surge.drag"), q) == 0.0
    gain = replace(ratio, column="own_gain.2", base=1.0, scale=0.3, logarithmic=True)
    assert spread_of_other_forms(gain, 1.0) == pytest.approx(FORM_WIDTH.thrusters / 0.3)  # of its logarithm, over 0.3
    assert spread_of_other_forms(replace(gain, on_top=True), 1.0) == spread_of_other_forms(gain, 1.0)
    assert spread_of_other_forms(replace(gain, column="own_gain.all"), 1.0) == 0.0


def with_unknowns(fit: Any, unknowns: Any) -> Any:
    """The same stand-in of a fit with other unknowns."""
    return SimpleNamespace(unknowns=unknowns, q=fit.q[: len(unknowns)], tracks=fit.tracks, filled=fit.filled)


def test_a_place_errs_by_a_share_of_its_distance(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a cable's end 3, 4 and 12 m from where a robot swims on average each coordinate errs by a share of 13 m."""
    from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
    from cocorosim_ros.diagnosis.showing import form_width
    from cocorosim_ros.diagnosis.tracks.columns import COLUMN
    from cocorosim_ros.world.effects import EFFECTS

    share = {each.name: each.other_place for each in EFFECTS["tether_drag"].numbers}
    assert share["x"] == share["y"] > 0.0 and share["coefficient"] == share["z"] == 0.0
    course = np.zeros((5, 12))
    course[:, 0], course[:, 2] = np.linspace(0.0, 2.0, 5), -12.0
    row = np.zeros((1, len(COLUMN)))
    row[0, [COLUMN["tether_drag.x"], COLUMN["tether_drag.y"]]] = 4.0, -4.0
    numbers = (("coefficient", 1.0), ("x", 0.5), ("y", 2.0))
    unknowns = tuple(
        Unknown(Owner("tether_drag", ("rov",), name, "m"), f"tether_drag.{name}", (0,), 0.0, scale)
        for name, scale in numbers
    )
    fit = SimpleNamespace(unknowns=unknowns, q=np.array([1.0, 8.0, -2.0]), tracks=(None,), filled=row)
    monkeypatch.setattr(form_width, "smoothed_tracks", lambda fit: (SimpleNamespace(mean=course),))
    found = form_width.spreads_of_places(fit)
    assert found == pytest.approx([0.0, share["x"] * 13.0 / 0.5, share["y"] * 13.0 / 2.0])
    assert not form_width.spreads_of_places(with_unknowns(fit, unknowns[:1])).any()


def test_numbers_that_are_tied_to_one_of_another_form_are_as_wide_as_they_follow_it(swim: Any) -> None:
    """By how far the platform's drag moves if a linear drag is held a standard deviation off and all else fitted."""
    from cocorosim_ros.diagnosis.fitting.climbing import improved
    from cocorosim_ros.diagnosis.fitting.fit import evaluated
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.showing.form_width import spread_of_other_forms, variances_of_other_forms
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
    from cocorosim_ros.scenario.reading.ranges import Range

    plain, unit = load_platform("lily"), "N s/m"
    drag = {axis: Quantity(LINEAR, unit, dimension_of(unit)) for axis in ("surge", "heave")}
    ranges = {f"effects.linear_drag.{axis}": Range(0.0, 10.0 * LINEAR, unit) for axis in drag}
    own = replace(plain, effect_quantities={"linear_drag": drag}, ranges=ranges)
    fit = base_fit(swim(own, 300.0, seed=11))
    columns = [each.column for each in fit.unknowns]
    square, linear = columns.index("drag"), [columns.index(f"linear_drag.{axis}") for axis in drag]
    expected = 0.0
    for place in linear:
        unknowns, q = list(fit.unknowns), fit.q.copy()
        q[place] += spread_of_other_forms(unknowns[place], float(q[place]))
        unknowns[place] = replace(unknowns[place], bounds=(q[place], q[place]))
        held = improved(evaluated(replace(fit, unknowns=tuple(unknowns), q=q)), 10)
        expected += float(held.q[square] - fit.q[square]) ** 2
    declared = variances_of_other_forms(fit)
    assert declared[square] == 0.0, "of a drag that the file declares the form is known"
    named = list(fit.unknowns)
    for place in linear:
        named[place] = replace(named[place], owner=replace(named[place].owner, effect="linear_drag"))
    found = variances_of_other_forms(replace(fit, unknowns=tuple(named)))
    assert found[square] == pytest.approx(expected, rel=0.2)
    assert all(found[place] >= spread_of_other_forms(fit.unknowns[place], float(fit.q[place])) ** 2 for place in linear)
