"""Groups of recordings that look alike, and what is common to all."""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fleet.findings import fleet_findings
from cocorosim_ros.diagnosis.fleet.rows import rows_of

Make = Callable[..., Any]


def findings(outcomes: Any) -> Any:
    """Findings about a fleet."""
    return fleet_findings(rows_of(outcomes))


def effect(name: str, value: float, robot: str, tier: str = "confirmed") -> dict[str, Any]:
    """A named effect with one number and its interval."""
    estimate = {"value": value, "ci95": [value - 0.02, value + 0.02], "unit": "1"}
    return {
        "id": name, "name": name, "equation": "", "robots": [robot], "tier": tier, "because": [],
        "parameters": {"size": estimate}, "nats": 50.0, "ambiguous_with": [],
    }  # fmt: skip


def test_equal_robots_are_one_group(drawn_fleet: Make) -> None:
    """20 fleets of 40 recordings of robots with the same numbers: at most one falls apart, expected is 0.2."""
    rng = np.random.default_rng(5)
    apart = [len(findings(drawn_fleet(rng, 8, 5, own=0.0)).groups.groups) > 1 for _ in range(20)]
    assert sum(apart) <= 1


def test_two_kinds_of_robots_are_two_groups(outcome: Make) -> None:
    """30 % more drag sets half of them apart, and so does an effect; any two of a group are alike."""
    rng = np.random.default_rng(6)
    made = []
    for robot in range(6):
        for week in range(5):
            name, off = f"lily_{robot}", 0.26 if robot >= 3 else 0.0
            effects = [effect("thruster_asymmetry", 0.1, name)] if robot == 5 else []
            numbers = {"drag": (off + 0.004 * rng.standard_normal(), 0.003), "thrust_gain": (0.0, 0.003)}
            made.append(outcome(f"w{week}/{name}", name, 7.0 * week, numbers, effects))
    groups = findings(made).groups
    assert [(len(each.rows), each.robots, each.effects) for each in groups.groups] == [
        (15, ("lily_0", "lily_1", "lily_2"), ()),
        (10, ("lily_3", "lily_4"), ()),
        (5, ("lily_5",), ("thruster_asymmetry",)),
    ]
    for group in groups.groups:
        drags = [math.log(row.numbers[0].estimate.value) for row in group.rows]
        assert max(drags) - min(drags) < groups.limit * math.sqrt(2.0) * math.hypot(0.003, groups.scatter["drag"])


def test_suspected_effects_set_nothing_apart(outcome: Make) -> None:
    """An effect that is suspected in one of two recordings leaves them alike."""
    made = [
        outcome("a", "a", 0.0, {"drag": (0.0, 0.01)}, [effect("tether", 0.1, "a", "suspected")]),
        outcome("b", "b", 0.0, {"drag": (0.0, 0.01)}),
    ]
    assert [len(each.rows) for each in findings(made).groups.groups] == [2]


def test_nothing_to_compare(outcome: Make) -> None:
    """Rows without numbers are counted and in no group; a single recording is a group of its own."""
    groups = findings([outcome("a", "a", 0.0, {}), outcome("b", "b", 0.0, {"drag": (0.0, 0.01)})]).groups
    assert (len(groups.groups), groups.not_compared) == (1, 1)
    assert findings([]).groups.groups == ()


def test_too_many_for_a_matrix(drawn_fleet: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    """Beyond the criterion no pairs are compared, and all are counted as that."""
    module = import_module("cocorosim_ros.diagnosis.fleet.alike")
    monkeypatch.setattr(module, "LIKENESS", module.LIKENESS.__class__(most_compared=10))
    groups = findings(drawn_fleet(np.random.default_rng(7), 4, 3)).groups
    assert (groups.groups, groups.not_compared) == ((), 12)


def test_an_effect_of_nearly_all_is_common(outcome: Make) -> None:
    """19 of 20 have it, one of which is suspected; the pooled number has the scatter of all in its interval."""
    rng = np.random.default_rng(8)
    sizes = 0.3 + 0.05 * rng.standard_normal(19)
    made = [
        outcome(
            f"r{k:02d}",
            f"l{k % 4}",
            None,
            {},
            [effect("drag_x", size, f"l{k % 4}", "suspected" if k == 0 else "confirmed")],
        )
        for k, size in enumerate(sizes)
    ]
    made.append(outcome("r99", "l0", None, {"drag": (0.5, 0.01)}))
    (common,) = findings(made).common.effects
    assert (common.id, common.found, common.able, common.confirmed) == ("drag_x", 19, 20, 18)
    pooled = common.parameters["size"]
    assert pooled.value == pytest.approx(sizes.mean(), rel=0.01)
    assert pooled.high - pooled.low == pytest.approx(2 * 2.1 * sizes.std(ddof=1) / math.sqrt(19), rel=0.05)


def test_recordings_that_could_not_show_an_effect_do_not_count(outcome: Make) -> None:
    """Half of them lack it because they could not have shown it: it is common to those that could."""
    blind = {"not_shown_by_this_recording": ["tether"]}
    made = [outcome(f"b{k}", "a", None, {"drag": (0.1 * k, 0.01)}, diagnosis=blind) for k in range(4)]
    seen = {"not_shown_by_this_recording": []}
    made += [outcome(f"s{k}", "a", None, {}, [effect("tether", 0.1, "a")], diagnosis=seen) for k in range(4)]
    (common,) = findings(made).common.effects
    assert (common.found, common.able) == (4, 4)
    made += [outcome(f"t{k}", "a", None, {"drag": (0.1 * k, 0.01)}, diagnosis=seen) for k in range(4)]
    assert findings(made).common.effects == ()


def test_a_shift_of_nearly_all_robots_is_common(drawn_fleet: Make, outcome: Make) -> None:
    """20 % more drag in ten robots with deviations of 5 %: pooled over robots; the others are off by chance."""
    rng = np.random.default_rng(9)
    made = drawn_fleet(rng, 10, 4)
    shifted = []
    for each in made:
        for number in each.found["numbers"]:
            if number["parameter"] == "drag":
                number |= {key: 1.2 * number[key] for key in ("value",)}
                number["ci95"] = [1.2 * end for end in number["ci95"]]
        shifted.append(each)
    (shift,) = findings(shifted).common.shifts
    assert (shift.parameter, shift.nominal, shift.same_side, shift.robots) == ("drag", 1.7778, 10, 10)
    assert shift.pooled.holds(1.2 * 1.7778) or abs(shift.pooled.value / (1.2 * 1.7778) - 1.0) < 0.03
    assert not findings(drawn_fleet(np.random.default_rng(10), 10, 4)).common.shifts
