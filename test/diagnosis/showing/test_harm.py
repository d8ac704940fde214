"""What makes free runs worse is taken back, and only if it clearly does."""

from __future__ import annotations

import pytest

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.showing.harm import _is_worse


@pytest.mark.parametrize(("spread", "taken_back"), [(0.0, False), (0.001, True)])
def test_one_free_run_takes_no_name_back(spread: float, taken_back: bool) -> None:
    """Of several runs an error that is clearly greater takes it back; of a single one the interval is a point."""
    errors = {"nominal": 0.03, "recalibrated": 0.015, "augmented": 0.03}
    intervals = {name: (error - spread, error + spread) for name, error in errors.items()}
    row = HeldOut(**errors, noise_floor=0.015, unit="rad", intervals=intervals)
    assert _is_worse("heading", row) == taken_back
