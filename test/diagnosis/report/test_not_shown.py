"""What recordings cannot show is said of single streams and numbers too, with the sizes from which they would show."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis
from cocorosim_ros.diagnosis.report.json_file import diagnosis_json
from cocorosim_ros.diagnosis.report.not_shown import not_shown_context


def compared(example: Callable[[str], Diagnosis]) -> Diagnosis:
    """A comparison that is blind to the delay of one stream below 0.4 s, and to an offset altogether."""
    seen = {"sensor_latency:pressure": {"latency": 0.4}, "compass_distortion": {"sin": 0.02}}
    against = Comparison(("good",), (), (), seen_from=seen, in_doubt=("thruster_gain:left",))
    unseen = ("sensor_latency:pressure", "compass_distortion:offset", "wind")
    return replace(example("consistent"), not_shown=unseen, screened=(), against=against)


def test_streams_and_numbers_are_said_with_their_sizes(example: Callable[[str], Diagnosis]) -> None:
    """A delay of one stream with its size, an offset that never shows without one; what was not tried is left out."""
    blind = not_shown_context(compared(example))["blind"]
    assert [each["name"] for each in blind] == ["sensor latency, pressure", "compass distortion, offset"]
    assert blind[0]["least"].startswith("latency 400")
    assert blind[1]["least"] == ""


def test_sizes_and_doubts_are_in_the_file(example: Callable[[str], Diagnosis]) -> None:
    """By effect or effect:stream, and number."""
    tree = json.loads(diagnosis_json(compared(example)))
    assert tree["against_seen_from"]["sensor_latency:pressure"] == {"latency": 0.4}
    assert tree["against_in_doubt"] == ["thruster_gain:left"]
