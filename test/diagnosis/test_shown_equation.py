"""Equations of effects have a part for each of their numbers, and tell of those alone that were shown to act."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
from cocorosim_ros.diagnosis.showing.estimates import Fitted, found_effects
from cocorosim_ros.diagnosis.tracks.columns import NAMES

SEVERAL = [entry for entry in ENTRIES if len(entry.amplitudes) > 1]


def entry_of(identifier: str) -> Entry:
    """The first entry of that name."""
    return next(entry for entry in ENTRIES if entry.id == identifier)


def told(entry: Entry, *shown: str) -> str:
    """The equation where only these amplitudes lie clearly off the value at which they do nothing."""
    estimates = {
        each.name: Estimate(each.neutral + 2.0, each.neutral + (1.0 if each.name in shown else -1.0),
                            each.neutral + 3.0, each.unit)
        for each in entry.amplitudes
    }  # fmt: skip
    return entry.shown_equation(estimates)


@pytest.mark.parametrize("entry", SEVERAL, ids=lambda entry: entry.id)
def test_each_number_has_its_part(entry: Entry) -> None:
    """All parts stand in the whole; each alone leaves out those of the others; none shown leaves the whole."""
    parts = {each.name: each.part for each in entry.amplitudes}
    assert all(parts.values()) and len(set(parts.values())) == len(parts)
    assert all(part in entry.whole_equation for part in parts.values())
    for name, part in parts.items():
        alone = told(entry, name)
        assert part in alone and not alone.startswith((",", " "))
        assert not any(other in alone for other in set(parts.values()) - {part})
    assert told(entry) == entry.whole_equation == told(entry, *parts)


@pytest.mark.parametrize(
    ("effect", "shown", "equation"),
    [
        ("linear_drag", ["sway"], "Y = -d_v v"),
        ("linear_drag", ["sway", "yaw"], "Y = -d_v v, N = -d_r r"),
        ("added_mass", ["heave_minus_surge"], "inertia against heave"),  # and no Munk moment
        ("compass_distortion", ["sin"], "reading = yaw + sin * sin(yaw)"),
        ("compass_distortion", ["offset", "cos"], "reading = yaw + offset + cos * cos(yaw)"),
        ("pressure_drift", ["rate"], "reading = pressure + rate t"),
        ("steady_current", ["y"], "u, v through the water: V - V_c, V_cy = y"),
        ("thruster_lag", [], "tau dT/dt = T_command - T"),
    ],
)
def test_what_may_be_nothing_is_left_out(effect: str, shown: list[str], equation: str) -> None:
    """As where a hovercraft has clear linear drag sideways alone."""
    assert told(entry_of(effect), *shown) == equation


def test_a_number_that_was_not_fitted_is_left_out() -> None:
    """What is not known was not shown either."""
    entry = entry_of("linear_drag")
    assert entry.shown_equation({"surge": Estimate(0.02, 0.01, 0.03, "N s/m")}) == "X = -d_u u"


def test_a_found_effect_has_the_equation_of_what_was_shown() -> None:
    """Drag sideways is 0.04 N s/m, give or take 0.004; ahead it is as much as its doubt."""
    entry = entry_of("linear_drag")
    numbers = [fitted(name, q, 0.2) for name, q in (("surge", 0.2), ("sway", 2.0))]
    candidate = SimpleNamespace(
        entry=entry, sharers=[SimpleNamespace(names=("boat",))], owns=lambda unknown: True, everybody=(0,), known=False
    )
    effect: Any = SimpleNamespace(
        candidate=candidate, nats=50.0, rivals=(), held_out=SimpleNamespace(p=1e-4, total=20.0)
    )
    fit: Any = SimpleNamespace(rows=np.zeros((1, len(NAMES))))
    (found,) = found_effects(fit, [effect], numbers)
    assert found.equation == "Y = -d_v v"
    assert set(found.parameters) == {"surge", "sway"}


@pytest.mark.parametrize(
    ("known", "over", "other"), [((), (), False), (((0.03,),), (), True), (((0.03,),), ("linear_drag.surge",), False)]
)
def test_an_effect_that_the_file_has_is_told_as_another(known: Any, over: Any, other: bool) -> None:
    """Its numbers are not those of the file; what differs from a learned vehicle is told as that alone."""
    candidate = SimpleNamespace(
        entry=entry_of("linear_drag"), sharers=[SimpleNamespace(names=("boat",))], owns=lambda unknown: True,
        everybody=(0,), known=known, over=frozenset(over),
    )  # fmt: skip
    effect: Any = SimpleNamespace(
        candidate=candidate, nats=50.0, rivals=(), held_out=SimpleNamespace(p=1e-4, total=20.0)
    )
    fit: Any = SimpleNamespace(rows=np.zeros((1, len(NAMES))))
    (found,) = found_effects(fit, [effect], [fitted("sway", 2.0, 0.2)])
    assert found.name.endswith(", other than in the platform's file") is other


def fitted(name: str, q: float, spread: float) -> Fitted:
    """A number of linear drag, in units of 0.02 N s/m."""
    owner = Owner("linear_drag", ("boat",), name, "N s/m")
    return Fitted(Unknown(owner, f"linear_drag.{name}", (0,), 0.0, 0.02), q, spread)
