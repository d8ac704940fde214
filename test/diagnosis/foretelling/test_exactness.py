"""Free runs that are off by what the filter's steps err by."""

from __future__ import annotations

import pytest

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.exactness import is_exact


def row(nominal: float, recalibrated: float) -> HeldOut:
    """A row of the table of free runs."""
    return HeldOut(nominal, recalibrated, recalibrated, nominal, "rad")


@pytest.mark.parametrize(
    ("nominal", "recalibrated", "exact"),
    [
        (0.9e-3, 0.1e-3, True),  # below what steps err by: a better model is none
        (1.5e-3, 1.51e-3, True),  # a little more, and a fitted number is of no use
        (1.5e-3, 1.2e-3, False),  # of use
        (3.5e-3, 3.6e-3, False),  # not of steps
    ],
)
def test_headings_of_a_clean_recording(nominal: float, recalibrated: float, exact: bool) -> None:
    """Steps err by a milliradian."""
    assert is_exact({"heading": row(nominal, recalibrated)}) is exact


def test_every_channel_counts_and_streams_do_not() -> None:
    """Without a channel that free runs show nothing is exact."""
    assert is_exact({"heading": row(0.5e-3, 0.5e-3), "compass": row(1.0, 1.0)})
    assert not is_exact({"heading": row(0.5e-3, 0.5e-3), "depth": row(1.0, 1.0)})
    assert not is_exact({"compass": row(0.0, 0.0)})
