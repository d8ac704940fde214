"""The sentence of a diagnosis: handy units, rivals, what is gained."""

from __future__ import annotations

import math
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, HeldOut, Recalibrated, Rival
from cocorosim_ros.diagnosis.report.sentence import sentence_of

DRAG = Recalibrated("yaw_drag", 1.14e-4, Estimate(1.25e-4, 1.2e-4, 1.3e-4, "N m s^2"), ("lily_01",))
LAG = FoundEffect(
    "thruster_lag", "a lag of the thrust", "", ("lily_01",), "confirmed",
    {"time_constant": Estimate(0.3143, 0.3012, 0.3274, "s")}, 90.0, (Rival("sensor_latency", 1.2),),
)  # fmt: skip


def plain(text: str) -> str:
    """With usual spaces."""
    return text.replace("\u00a0", " ")


def test_a_mismatch_names_effect_size_rival_and_gain() -> None:
    """Every number in the unit that makes it handy."""
    table = {"position": HeldOut(0.05, 0.11, 0.00535, 0.0055, "m")}
    assert plain(sentence_of("mismatch", [LAG], [], table)) == (
        "Missing from the model of lily_01: a lag of the thrust (time constant 314 ms; or else sensor latency); "
        "with it the error of position on unseen data is 5.35 mm instead of 110 mm (floor 5.50 mm)."
    )


def test_a_gain_is_told_of_the_channel_that_has_one() -> None:
    """No gain in position: that in heading is told; none at all: nothing."""
    none = HeldOut(0.1, 0.1, 0.1, math.nan, "m")
    heading = HeldOut(0.2, math.pi / 18, math.pi / 180, math.nan, "rad")
    told = plain(sentence_of("mismatch", [LAG], [], {"position": none, "heading": heading}))
    assert "error of heading on unseen data is 1.00\u00b0 instead of 10.0\u00b0" in told
    assert sentence_of("mismatch", [LAG], [], {"position": none}).endswith("sensor latency).")


def test_shifted_numbers_stand_beside_the_nominal_ones() -> None:
    """In the same unit; a long list ends early."""
    told = plain(sentence_of("recalibrate", [], [DRAG], {}))
    assert told.endswith("have shifted: yaw drag 125.0 \u00b5N m s\u00b2 for 114 \u00b5N m s\u00b2.")
    assert plain(sentence_of("recalibrate", [], [DRAG] * 6, {})).endswith("and 2 more.")


def test_a_correction_stands_in_words() -> None:
    """A mix-up has words instead of numbers."""
    mixed = FoundEffect("frame_mixup", "axes that are mixed up", "", (), "confirmed", {}, 9.0, correction="in degrees")
    assert sentence_of("mismatch", [mixed], [], {}) == "Missing from the model: axes that are mixed up (in degrees)."


def test_robots_with_findings_of_their_own_are_named() -> None:
    """Two robots, two effects: each beside its robot."""
    bias = replace(LAG, id="torque_bias", name="a torque", robots=("lily_02",), parameters={}, ambiguous_with=())
    assert plain(sentence_of("mismatch", [LAG, bias], [], {})) == (
        "Missing from the model: a lag of the thrust of lily_01 (time constant 314 ms; or else sensor latency), "
        "and a torque of lily_02."
    )
