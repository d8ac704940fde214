"""Laws of two regressors: which there are, which of them what is left of the force resembles."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.laws import LAWS_OF
from cocorosim_ros.diagnosis.catalogue.pair_laws import pair_laws
from cocorosim_ros.diagnosis.criteria.naming import PAIR_LAWS
from cocorosim_ros.diagnosis.naming.choice import can_be_law
from cocorosim_ros.diagnosis.naming.promising_laws import _Sums, leading, promising_laws
from cocorosim_ros.diagnosis.tracks.passes import FORCE_X
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.regressors import REGRESSORS

EVERYWHERE: Any = SimpleNamespace(scales={each.name: 1.0 for each in REGRESSORS})
STEP = 0.25  # s


def test_every_law_is_there_once_and_not_in_the_open_set() -> None:
    """By text; those that the open set has are left out, and so are laws of what does not occur."""
    laws = pair_laws(EVERYWHERE)
    texts = [law.text for law in laws]
    assert len(set(texts)) == len(texts) > 1000
    known = {Law(of, product).text for of, products in LAWS_OF.items() for product in products}
    assert known.isdisjoint(texts)
    assert {"unknown:sway~r*w", "unknown:world_x~|w|", "unknown:sway~|v|*thrust", "unknown:yaw~|z|*z"} <= set(texts)
    assert "unknown:surge~u" not in texts and "unknown:world_x~1" not in texts
    dry: Any = SimpleNamespace(scales={**EVERYWHERE.scales, "pump": 0.0})
    assert not any("pump" in {law.product.first.name, law.product.second.name} for law in pair_laws(dry))


def course(rng: np.random.Generator, seconds: float) -> tuple[Any, Course]:
    """A smoothed course without force, with speeds and places that wander, and the same as laws see it."""
    count = round(seconds / STEP)
    time = STEP * np.arange(count)
    mean = np.zeros((count, 12))
    for column in range(8):
        mean[:, column] = np.interp(time, time[::12], rng.standard_normal(len(time[::12])))
    still = np.zeros((count, 3))
    water = np.full(3, -9.0), np.array([9.0, 9.0, 0.0])
    seen = Course(
        time, mean, np.zeros((count, 4)), still, still, np.zeros(3, dtype=bool), water, np.zeros((1, 0, 5)), -1
    )
    return SimpleNamespace(time=time, mean=mean), seen


@pytest.mark.parametrize(("platform", "robots"), [("lily", 1), ("lily", 2), ("kvlcc2_hsva", 1)])
def test_the_law_that_the_force_follows_is_among_the_first(platform: str, robots: int) -> None:
    """A force along x of twice the amount of w, on the last robot alone, in noise of the same size.

    In as many seconds of a ship, which coasts for longer than an eighth of them, it is looked for too.
    """
    rng = np.random.default_rng(11)
    made = [course(rng, 400.0) for _ in range(robots)]
    smoothed, seen = zip(*made, strict=True)
    vehicle = vehicle_model(load_platform(platform))
    push = 2.0 * np.abs(smoothed[-1].mean[:, 6])
    for each in smoothed:
        each.mean[:, FORCE_X] = 2.0 * rng.standard_normal(len(each.time))
    smoothed[-1].mean[:, FORCE_X] += push
    tracks = [
        SimpleNamespace(
            name=str(number), vehicle=vehicle, actuation=SimpleNamespace(course_along=lambda _, row: seen[int(row[0])])
        )
        for number in range(robots)
    ]
    fit: Any = SimpleNamespace(tracks=tracks, filled=np.arange(robots, dtype=np.float64)[:, None])
    found = promising_laws(pair_laws(EVERYWHERE), fit, smoothed)
    texts = [law.text for law in found]
    assert "unknown:world_x~|w|" in texts[:6]  # beside it what is nearly the same, as a force forwards by |w|*cos_yaw
    assert len(found) <= PAIR_LAWS.most


def test_sums_by_hand() -> None:
    """Products of 1, 1, 1 and 3 over four parts: half of the parts are too few."""
    products = np.array([[1.0], [1.0], [1.0], [3.0]])
    sums = _Sums(np.tile(products, (2, 1)), np.full((8, 1), 2.0), np.full((8, 1), 3.0))
    assert sums.clearness[0] == pytest.approx(12.0 / np.sqrt(24.0))
    assert sums.likeness[0] == pytest.approx(12.0**2 / (16.0 * 24.0))
    assert _Sums(products, products, products).clearness.tolist() == [0.0]


def test_only_far_more_than_the_catalogue_leads() -> None:
    """So many laws find something everywhere: one that is a little better than the best entry is not asked."""
    entry, much, little = (
        SimpleNamespace(nats=nats) for nats in (20.0, 20.0 * PAIR_LAWS.lead + 1.0, 20.0 * PAIR_LAWS.lead - 1.0)
    )
    pairs: Any = [much, little]
    tested: Any = [entry]
    assert leading(pairs, tested) == [much]
    assert leading(pairs, []) == pairs


def test_no_law_of_readings_beside_errors_that_last() -> None:
    """Of the robots that have these; laws of motion, and other robots, are asked."""
    motion, reading = (
        SimpleNamespace(entry=SimpleNamespace(channel=channel), robots=("a", "b")) for channel in ("sway", "imu")
    )
    asked: Any = [motion, reading]
    assert [can_be_law(each, ["b"]) for each in asked] == [True, False]
    assert [can_be_law(each, ["c"]) for each in asked] == [True, True]


def test_a_law_that_no_list_has_is_named(swim: Any) -> None:
    """A force along x with the amount of the diving speed; beside it nothing is named."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.law_text import LawText

    plain = load_platform("lily")
    pushed = replace(plain, effect_quantities={"law_1": {"world_x": LawText(0.02, "|w|")}})
    found = diagnose(swim(pushed, 200.0, seed=12, base=plain), lambda words, share: None)
    assert [each.id for each in found.effects] == ["unknown:world_x~|w|"]
    assert found.effects[0].parameters["coefficient"].value == pytest.approx(0.02, rel=0.2)
