"""The headline of a diagnosis, short whatever was found, and the numbers below it."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import (
    Comparison,
    Estimate,
    FoundEffect,
    HeldOut,
    PassedOver,
    Recalibrated,
    Rival,
)
from cocorosim_ros.diagnosis.report.sentence import detail_lines, difference_sentence, sentence_of
from cocorosim_ros.diagnosis.report.significance import not_shown_numbers
from cocorosim_ros.diagnosis.showing.doubt import SIZE_MAY_BE_NOTHING
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS

DRAG = Recalibrated("yaw_drag", 1.14e-4, Estimate(1.25e-4, 1.2e-4, 1.3e-4, "N m s^2"), ("lily_01",))
LAG = FoundEffect(
    "thruster_lag", "a lag of the thrust", "", ("lily_01",), "confirmed",
    {"time_constant": Estimate(0.3143, 0.3012, 0.3274, "s")}, 90.0, (Rival("sensor_latency", 1.2),),
)  # fmt: skip
SUMMARIES = [each.summary for each in (*EFFECTS.values(), *ERRORS.values())]
ROBOTS = tuple(f"lily_{number:02}" for number in range(1, 12))


def plain(text: str) -> str:
    """With usual spaces."""
    return text.replace("\u00a0", " ")


def found(*effects: FoundEffect, **parts: Any) -> Any:
    """A diagnosis as the lines look at it."""
    rest: dict[str, Any] = {"verdict": "mismatch", "recalibrated": (), "fit": {}, "against": None, "passed_over": ()}
    return SimpleNamespace(effects=effects, **{**rest, **parts})


def test_the_headline_names_the_effect_and_the_lines_its_size_rival_and_gain() -> None:
    """Every number in the unit that makes it handy."""
    table = {"position": HeldOut(0.05, 0.11, 0.00535, 0.0055, "m")}
    assert sentence_of("mismatch", [LAG], []) == "Missing from the model of lily_01: a lag of the thrust."
    assert [plain(line) for line in detail_lines(found(LAG, fit=table))] == [
        "a lag of the thrust of lily_01, confirmed: time constant 314 ms; or else sensor latency",
        "error of position on unseen data: 5.35 mm with it instead of 110 mm (floor 5.50 mm)",
    ]


@pytest.mark.parametrize("count", [1, 2, 3, 5, 12])
@pytest.mark.parametrize("tier", ["confirmed", "suspected", "mixed"])
@pytest.mark.parametrize("robots", [(), ROBOTS[:1], ROBOTS[:3], ROBOTS], ids=len)
def test_no_headline_has_more_than_25_words(count: int, tier: str, robots: tuple[str, ...]) -> None:
    """Whatever effects of the catalogue are found together, of however many robots; one name at least is told."""
    for first in range(len(SUMMARIES)):
        effects = [
            replace(
                LAG,
                name=SUMMARIES[(first + index) % len(SUMMARIES)],
                robots=robots,
                tier=("confirmed", "suspected")[index % 2] if tier == "mixed" else tier,
            )
            for index in range(count)
        ]
        shifted = [replace(DRAG, parameter=f"number_{index}") for index in range(count)]
        for told in (
            sentence_of("mismatch", effects, []),
            sentence_of("recalibrate", [], shifted),
            difference_sentence("mismatch", effects, shifted, "unknown:surge~1"),
            difference_sentence("mismatch", effects, []),
        ):
            assert len(told.split()) <= 25, told
            assert told.endswith(".") and told.count(".") == 1, told
        assert effects[0].name in sentence_of("mismatch", effects, [])


@pytest.mark.parametrize("verdict", ["consistent", "insufficient"])
def test_silence_is_short_too(verdict: Any) -> None:
    """No effect, no number: one sentence of at most 25 words."""
    for told in (sentence_of(verdict, [], []), difference_sentence(verdict, [], [])):
        assert len(told.split()) <= 25
        assert told.count(".") == 1


def test_what_has_no_name_is_likened_to_something() -> None:
    """The strongest of those by which something is missing, in the headline; all in the lines; none beside a name."""
    names = {each.name for each in ENTRIES}
    for name in names:
        one = PassedOver(
            replace(LAG, name=name, robots=ROBOTS, nats=9.0), stands=True, because=(), shortly=SIZE_MAY_BE_NOTHING
        )
        told = sentence_of("mismatch", [], [], [one])
        assert name in told and len(told.split()) <= 25 and told.count(".") == 1, told
    weak, strong, none = (
        PassedOver(replace(LAG, name=name, nats=nats), stands=stands, because=(), shortly=SIZE_MAY_BE_NOTHING)
        for name, nats, stands in (("a drag", 9.0, True), ("a torque", 12.0, True), ("a tether", 90.0, False))
    )
    assert sentence_of("mismatch", [], [], [weak, strong, none]) == (
        "Something is missing, most like a torque, but its size may as well be nothing."
    )
    assert "torque" not in sentence_of("mismatch", [LAG], [], [strong])
    assert "missing" in sentence_of("consistent", [], [], [none])
    lines = [plain(line) for line in detail_lines(found(passed_over=(strong, none)))]
    assert lines == [
        "not named: a torque of lily_01 (12.0 nats), since its size may as well be nothing: "
        "time constant 314 ms (301 to 327 ms)",
        "not named: a tether of lily_01 (90.0 nats), since its size may as well be nothing: "
        "time constant 314 ms (301 to 327 ms)",
    ]


def test_what_is_only_suspected_is_not_said_to_be_missing() -> None:
    """The headline alone tells what is suspected from what is confirmed."""
    doubtful = replace(LAG, tier="suspected", name="linear drag")
    assert sentence_of("mismatch", [doubtful], []).startswith("Perhaps missing from the model of lily_01: ")
    assert sentence_of("mismatch", [doubtful, LAG], []) == (
        "Missing from the model of lily_01: a lag of the thrust; and perhaps linear drag."
    )


def test_what_may_as_well_be_nothing_is_not_told_as_a_number() -> None:
    """Parts whose intervals hold zero are left out, unless that is all of them; a ratio does nothing at one."""
    size = {"surge": Estimate(0.02, 0.018, 0.022, "N s/m"), "sway": Estimate(0.001, -0.004, 0.006, "N s/m")}
    drag = replace(LAG, id="linear_drag", name="linear drag", parameters=size, ambiguous_with=())
    assert not_shown_numbers(drag) == ("sway",)
    (told,) = detail_lines(found(drag))
    assert plain(told) == "linear drag of lily_01, confirmed: surge 20.0 mN s/m"
    doubtful = replace(drag, parameters={"sway": size["sway"]})
    assert not_shown_numbers(doubtful) == ()
    ratios = {"sway_ratio": Estimate(2.0, 1.8, 2.2, "1"), "heave_ratio": Estimate(1.1, 0.8, 1.4, "1")}
    assert not_shown_numbers(replace(drag, id="anisotropic_drag", parameters=ratios)) == ("heave_ratio",)


def test_a_gain_is_told_of_the_channel_that_has_one() -> None:
    """No gain in position: that in heading is told; none at all: nothing."""
    none = HeldOut(0.1, 0.1, 0.1, math.nan, "m")
    heading = HeldOut(0.2, math.pi / 18, math.pi / 180, math.nan, "rad")
    *_, told = detail_lines(found(LAG, fit={"position": none, "heading": heading}))
    assert "error of heading on unseen data: 1.00\u00b0 with it instead of 10.0\u00b0" in told
    assert len(detail_lines(found(LAG, fit={"position": none}))) == 1


def test_shifted_numbers_stand_beside_the_nominal_ones() -> None:
    """In the same unit; the headline names them, and ends a long list early."""
    assert sentence_of("recalibrate", [], [DRAG]).endswith("its numbers have shifted: yaw drag.")
    (told,) = detail_lines(found(verdict="recalibrate", recalibrated=(DRAG,)))
    assert plain(told) == "yaw drag of lily_01: 125.0 \u00b5N m s\u00b2 for 114 \u00b5N m s\u00b2"
    many = [replace(DRAG, parameter=f"long name of number {index}") for index in range(6)]
    assert sentence_of("recalibrate", [], many).endswith("and 4 more.")


def test_a_correction_stands_in_words() -> None:
    """A mix-up has words instead of numbers."""
    mixed = FoundEffect("frame_mixup", "axes that are mixed up", "", (), "confirmed", {}, 9.0, correction="in degrees")
    assert sentence_of("mismatch", [mixed], []) == "Missing from the model: axes that are mixed up."
    assert detail_lines(found(mixed)) == ("axes that are mixed up, confirmed: in degrees",)


def test_robots_with_findings_of_their_own_are_named() -> None:
    """Two robots, two effects: each beside its robot."""
    bias = replace(LAG, id="torque_bias", name="a torque", robots=("lily_02",), parameters={}, ambiguous_with=())
    assert sentence_of("mismatch", [LAG, bias], []) == "Missing from the model: a lag of the thrust; and a torque."
    assert detail_lines(found(LAG, bias))[1] == "a torque of lily_02, confirmed"


def test_a_doubtful_comparison_is_said() -> None:
    """Recordings compared with that differ among themselves."""
    doubt = Comparison(("good.mcap",), (), ("linear_drag",))
    assert detail_lines(found(against=doubt)) == (
        "the recordings compared with differ among themselves too: linear drag",
    )


def test_a_difference_of_no_known_size_is_said_as_that() -> None:
    """It is neither named as an effect nor called something outside the catalogue."""
    told = difference_sentence("mismatch", [], [], "", ["thruster_gain:right"])
    assert told == (
        "Compared with when it was well, these differ: most likely thruster gain, right, by how much cannot be told."
    )
