"""Evidence that a candidate needs beside effects that the platform's file has already, of which nothing is fitted."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.naming.needed_evidence import needed_nats

LARGE = 2000.0


def candidate(name: str, group: str | None, channel: str, law: str | None = None) -> Any:
    """A candidate of which a fit has no unknowns."""
    entry = SimpleNamespace(id=name, group=group, channel=channel, law=law, topic=None)
    return SimpleNamespace(entry=entry, key=(name, None, ("a",)), places_among=lambda unknowns: [])


@pytest.mark.parametrize(
    ("asked", "of_found", "of_declared"),
    [
        (candidate("unknown:sway~v", None, "sway", "sway"), NAMING.law_form, NAMING.law_rest),
        (candidate("linear_drag", "drag", "surge"), NAMING.law_form, NAMING.form_share),
        (candidate("torque_bias", "turning", "yaw"), NAMING.form_share, NAMING.form_share),
        (candidate("buoyancy_trim", "drag", "heave"), 0.0, 0.0),
    ],
)
def test_what_may_be_a_rest_of_a_known_effect_needs_more(asked: Any, of_found: float, of_declared: float) -> None:
    """A law, or an entry confused with it, needs more if a diagnosis found that; what acts upright is no rest of it."""
    declared = NamedEffect(candidate("anisotropic_drag", "drag", "sway"), LARGE, (), HeldOutGain(np.zeros(0), 1.0))
    fit: Any = SimpleNamespace(unknowns=())
    for known, share in ((declared, of_declared), (replace(declared, found_before=True), of_found)):
        assert needed_nats((known,), asked, fit) == pytest.approx(max(NAMING.threshold, share * LARGE))
