"""A page has no number that no vehicle can have."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, Recalibrated, ScreenedEffect
from cocorosim_ros.diagnosis.report.not_shown import not_shown_context
from cocorosim_ros.diagnosis.report.shift_figure import shifts

Example = Callable[[str], Diagnosis]
BLIND_DRAG = Recalibrated("drag", 0.055, Estimate(0.001, 1e-25, 3.6e22, "kg/m"), ("boat",))
GAIN = Recalibrated("thrust_gain", 1.0, Estimate(0.95, 0.9, 1.0, "1"), ("boat",))


def test_a_size_that_nothing_can_have_is_no_size(example: Example) -> None:
    """What could not be seen has no size, and the number beside it, which could, keeps its own."""
    screened = (
        ScreenedEffect("pressure_drift", 0.0, {"rate": 0.3, "offset": 1.4e14}),
        ScreenedEffect("battery_sag", 0.0, {"fraction_lost": 22.7}),
    )
    found = replace(example("consistent"), screened=screened, not_shown=("battery_sag",))
    context = not_shown_context(found)
    assert context["blind"] == [{"name": "battery sag", "least": ""}]
    least = {each["name"]: each["least"].replace("\u00a0", " ") for each in context["detectable"]}
    assert least == {"battery sag": "", "pressure drift": "rate 300 mPa/s"}


def test_an_end_that_is_not_told_is_not_drawn() -> None:
    """The other numbers keep their room: no label of the axis has more than three digits."""
    labels = [
        text for text in re.findall(r"<text[^>]*>([^<]*)</text>", shifts([BLIND_DRAG, GAIN])) if text[-1].isdigit()
    ]
    assert labels and all(len(re.sub(r"\D", "", label)) <= 3 for label in labels)
