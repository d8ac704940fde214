"""What recordings cannot show is said of single streams and numbers too, with the sizes from which they would show."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, NotLookedFor
from cocorosim_ros.diagnosis.report.json_file import diagnosis_json
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.not_shown import not_shown_context
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.scenario.parts.platform import load_platform


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


def test_what_was_not_looked_for_is_said_with_the_lacking_number(example: Callable[[str], Diagnosis]) -> None:
    """On the page and in the file; nothing of the kind where nothing lacks."""
    lacking = (NotLookedFor("tether_drag", "drag of a towed cable", ("hull.cable_diameter",)),)
    told = "Not looked for, since the platform does not give hull.cable_diameter: drag of a towed cable."
    found, origin = example("consistent"), Origin(load_platform("lily"), ("bags/tank_7",), ("lily_01",), 600.0)
    short_of = replace(found, not_looked_for=lacking)
    assert f"<p>{told}</p>" in render_report(short_of, origin)
    assert "Not looked for" not in render_report(found, origin)
    tree = json.loads(diagnosis_json(short_of))
    assert tree["not_looked_for"] == [{"id": "tether_drag", "lacks": ["hull.cable_diameter"], "because": told}]
    assert json.loads(diagnosis_json(found))["not_looked_for"] == []


def test_a_long_list_of_numbers_ends_early(example: Callable[[str], Diagnosis]) -> None:
    """Four keys, and how many more; the file has all."""
    keys = tuple(f"actuators.{name}.diameter" for name in "abcdef")
    short_of = replace(example("consistent"), not_looked_for=(NotLookedFor("wash_loss", "loss in jets", keys),))
    (sentence,) = not_shown_context(short_of)["not_looked_for"]
    assert sentence.endswith("actuators.d.diameter and 2 more: loss in jets.")
    assert json.loads(diagnosis_json(short_of))["not_looked_for"][0]["lacks"] == list(keys)
