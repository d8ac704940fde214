"""An effect whose size ends where such an effect can be no larger is no hypothesis."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.naming.natural_limits import is_at_its_limit
from cocorosim_ros.diagnosis.tracks.vehicle_size import LILY_SIZES


@pytest.mark.parametrize(
    ("effect", "values", "expected"),
    [
        ("added_mass", (0.0, 0.0, -0.22), True),  # half of a Lily's 0.44 kg: it would rise as if lighter than in air
        ("added_mass", (0.0, 0.0, -0.2), False),
        ("added_mass", (0.5, 0.0, 0.5), False),  # a flat hull drags along more than it weighs
        ("linear_drag", (0.0, 0.01, 0.0, 0.0), False),  # none along an axis is no limit, but absence
        ("anisotropic_drag", (0.1, 1.0), True),  # a ratio of a tenth, where looking ends
    ],
)
def test_limits_of_effects(effect: str, values: tuple[float, ...], expected: bool) -> None:
    """By hand, in SI units, for a Lily."""
    entry = next(each for each in ENTRIES if each.id == effect)
    candidate = Candidate(entry, ("lily",), ((0,),), sizes=LILY_SIZES)
    unknowns = candidate.amplitudes()
    q = np.array([(value - each.base) / each.scale for each, value in zip(unknowns, values, strict=True)])
    assert is_at_its_limit(candidate, SimpleNamespace(unknowns=unknowns, q=q)) is expected  # type: ignore[arg-type]
