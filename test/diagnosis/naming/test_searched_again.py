"""What a search finds is kept where a later one, over free runs of another length, finds less."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import pytest

from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, seconds_of_free_runs, unseen_parts
from cocorosim_ros.diagnosis.naming.named_effect import Naming, Refused
from cocorosim_ros.diagnosis.naming.naming import name_effects
from cocorosim_ros.diagnosis.naming.searched_again import better_foretelling


class Searched(NamedTuple):
    """A search that found what is there, one over the same recordings that found nothing, and longer free runs."""

    found: Naming
    nothing: Naming
    longer: Unseen


@pytest.fixture(scope="module")
def searched(swim: Any) -> Searched:
    """A Lily that water drags in proportion to its speed, of which its platform's file knows nothing."""
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
    from cocorosim_ros.world.effects import EFFECTS

    plain = load_platform("lily")
    sizes = {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 3e-5}
    units = {each.name: each.unit for each in EFFECTS["linear_drag"].parameters}
    drag = {name: Quantity(size, units[name], dimension_of(units[name])) for name, size in sizes.items()}
    base = base_fit(swim(replace(plain, effect_quantities={"linear_drag": drag}), 240.0, seed=3, base=plain))
    found = name_effects(base, lambda words, share: None, unseen_parts(base))
    nothing = Naming(base, base, (), found.screened, found.laws)
    return Searched(found, nothing, unseen_parts(base, 1.5 * seconds_of_free_runs(base)))


def _ids(naming: Naming) -> list[str]:
    return [each.candidate.entry.id for each in naming.named]


def test_what_foretells_longer_runs_stays(searched: Searched) -> None:
    """The drag holds over runs of any length, so that a second search that misses it is not believed."""
    better = better_foretelling(searched.found, searched.nothing, searched.longer)
    assert _ids(better) == ["linear_drag"]
    assert better.fit.log_likelihood > searched.nothing.fit.log_likelihood + 100.0


def test_a_later_search_that_finds_more_is_believed(searched: Searched) -> None:
    """A first search that found nothing takes nothing from it, and one that found the same does not either."""
    assert better_foretelling(searched.nothing, searched.found, searched.longer) is searched.found
    assert better_foretelling(searched.found, searched.found, searched.longer) is searched.found


def test_what_longer_runs_lose_by_does_not_stay(searched: Searched) -> None:
    """With the drag turned round, free runs are far worse than without any."""
    turned = evaluated(replace(searched.found.fit, q=-searched.found.fit.q))
    wrong = replace(searched.found, fit=turned)
    assert better_foretelling(wrong, searched.nothing, searched.longer) is searched.nothing


def test_what_is_named_again_is_not_told_as_taken_back(searched: Searched) -> None:
    """The search that missed the drag had taken it back; what the other one took back is told with its effects."""
    (drag,) = searched.found.named
    lost = replace(searched.nothing, harmful=(Refused(searched.found.fit, drag),))
    assert better_foretelling(searched.found, lost, searched.longer).harmful == ()
    other = Refused(searched.found.fit, replace(drag, nats=9.0))
    kept = better_foretelling(replace(searched.found, harmful=(other,)), searched.nothing, searched.longer)
    assert kept.harmful == (other,)
