"""Evidence that a candidate needs beside effects that the platform's file has already, of which nothing is fitted."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.naming import needed_evidence
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.naming.needed_evidence import is_like, needed_nats
from cocorosim_ros.world.laws.law import Law, Product

LARGE = 2000.0


ALIKE = 0.01
"""Likeness of any two candidates here."""


@pytest.fixture(autouse=True)
def hardly_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    """No fit has slopes here."""
    monkeypatch.setattr(needed_evidence, "likeness", lambda fit, candidate, other: ALIKE)


def candidate(name: str, group: str | None, channel: str, law: str | None = None) -> Any:
    """A candidate of which a fit has no unknowns."""
    form = Law(channel, Product.parse(name.partition("~")[2])) if law else None
    entry = SimpleNamespace(id=name, group=group, channel=channel, law=law, form=form, topic=None)
    return SimpleNamespace(entry=entry, key=(name, None, ("a",)), places_among=lambda unknowns: [])


@pytest.mark.parametrize(
    ("asked", "of_found", "of_declared"),
    [
        (candidate("unknown:sway~v", None, "sway", "sway"), NAMING.law_form, NAMING.law_rest),
        (candidate("unknown:sway~sin_t", None, "sway", "sway"), NAMING.law_form, ALIKE),
        (candidate("linear_drag", "drag", "surge"), NAMING.law_form, ALIKE),
        (candidate("torque_bias", "turning", "yaw"), NAMING.form_share, ALIKE),
        (candidate("buoyancy_trim", "drag", "heave"), 0.0, 0.0),
    ],
)
def test_what_may_be_a_rest_of_a_known_effect_needs_more(asked: Any, of_found: float, of_declared: float) -> None:
    """A law, or an entry confused with it, needs more if a diagnosis found that; what acts upright is no rest of it.

    Beside numbers that the file has from elsewhere, likeness counts, but for laws of motion, which fill what any form
    leaves: a force that swings by the clock does not.
    """
    declared = NamedEffect(candidate("anisotropic_drag", "drag", "sway"), LARGE, (), HeldOutGain(np.zeros(0), 1.0))
    fit: Any = SimpleNamespace(unknowns=())
    for known, share in ((declared, of_declared), (replace(declared, found_before=True), of_found)):
        assert needed_nats((known,), asked, fit) == pytest.approx(max(NAMING.threshold, share * LARGE))


@pytest.mark.parametrize(("explained", "times"), [(0.0, 1.0), (0.5, 2.0), (0.9, 10.0), (1.0, math.inf)])
def test_beside_declared_inertia_the_threshold_is_left_of_the_evidence(
    monkeypatch: pytest.MonkeyPatch, explained: float, times: float
) -> None:
    """What errors of the file's added mass leave of the nats has to be enough, however large that mass' own are.

    A force of 5.4 N that swings, of 1,924 nats of which they explain a twelfth, was asked for 25,000. All explained
    is a rest of the added mass as of any effect.
    """
    monkeypatch.setattr(needed_evidence, "share_of_declared_errors", lambda fit, candidate, other: explained)
    mass = NamedEffect(candidate("added_mass", None, "sway"), LARGE, (), HeldOutGain(np.zeros(0), 1.0))
    swings: Any = candidate("unknown:sway~sin_t", None, "sway", "sway")
    fit: Any = SimpleNamespace(unknowns=())
    most = NAMING.law_rest * LARGE
    assert needed_nats((mass,), swings, fit) == pytest.approx(min(times * NAMING.threshold, most))


def test_an_entry_of_the_same_group_needs_more_than_another(monkeypatch: pytest.MonkeyPatch) -> None:
    """Beside a hull that gives way a layer is confused with it, and a trim of another group is not."""
    monkeypatch.setattr(needed_evidence, "likeness", lambda fit, candidate, other: 1.0)
    hull = NamedEffect(candidate("hull_compressibility", "weight", "heave"), LARGE, (), HeldOutGain(np.zeros(0), 1.0))
    fit: Any = SimpleNamespace(unknowns=())
    needed = [needed_nats((hull,), candidate("layer", group, "heave"), fit) for group in ("weight", "trim", None)]
    assert needed == pytest.approx([NAMING.group_share * LARGE, NAMING.form_share * LARGE, NAMING.form_share * LARGE])
    assert NAMING.group_share > NAMING.form_share


def test_a_clock_beside_late_commands_needs_a_share_of_theirs(monkeypatch: pytest.MonkeyPatch) -> None:
    """What comes late may be a rest of what else does; an offset of a gauge, of no group, needs no more than alone."""
    monkeypatch.setattr(needed_evidence, "likeness", lambda fit, candidate, other: 1.0)
    delay = NamedEffect(candidate("command_delay", "late", "surge"), LARGE, (), HeldOutGain(np.zeros(0), 1.0))
    fit: Any = SimpleNamespace(unknowns=())
    skew, offset = candidate("clock_skew", "late", "clock"), candidate("pressure_offset", "", "pressure")
    assert needed_nats((delay,), skew, fit) == pytest.approx(NAMING.group_share * LARGE)
    assert needed_nats((delay,), offset, fit) == NAMING.threshold


def test_a_force_that_swings_by_the_clock_stands_for_no_entry_of_the_catalogue() -> None:
    """Other laws of the same side may; and one that swings may stand for another law there."""
    lag, swing = candidate("thruster_lag", "late", "surge"), candidate("unknown:sway~sin_t", None, "sway", "sway")
    law = candidate("unknown:sway~v", None, "sway", "sway")
    assert is_like(law, lag) and not is_like(swing, lag)
    assert is_like(swing, law) and not is_like(swing, candidate("unknown:heave~w", None, "heave", "heave"))
