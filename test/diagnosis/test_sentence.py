"""The headline of a diagnosis, short whatever was found, and the numbers below it."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.eddies import ALONG_X
from cocorosim_ros.diagnosis.catalogue.law_forms import single
from cocorosim_ros.diagnosis.catalogue.law_words import READING_WORDS, identifier_words, law_words, opposite_law_words
from cocorosim_ros.diagnosis.catalogue.laws import LAWS_OF, SWINGING
from cocorosim_ros.diagnosis.catalogue.sensor_laws import SENSOR_LAWS_OF
from cocorosim_ros.diagnosis.findings import (
    Comparison,
    Estimate,
    FoundEffect,
    HeldOut,
    PassedOver,
    Recalibrated,
    Rival,
)
from cocorosim_ros.diagnosis.report.headline import (
    difference_sentence,
    other_vehicle_headline,
    sentence_of,
    unable_sentence,
)
from cocorosim_ros.diagnosis.report.sentence import detail_lines
from cocorosim_ros.diagnosis.report.significance import may_be_nothing, not_shown_numbers
from cocorosim_ros.diagnosis.showing.doubt import NOT_FORETOLD, SIZE_MAY_BE_NOTHING
from cocorosim_ros.diagnosis.showing.other_forms import SHORTLY_OF_NO_NAME
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

SWING = single("sin_t")
DRAG = Recalibrated("yaw_drag", 1.14e-4, Estimate(1.25e-4, 1.2e-4, 1.3e-4, "N m s^2"), ("lily_01",))
LAWS = [
    *(Law(equation, product) for equation, products in LAWS_OF.items() for product in products),
    *(Law(equation, SWING) for equation in SWINGING),
    *(Law(reading, product) for reading, products in SENSOR_LAWS_OF.items() for product in products),
    ALONG_X,
]
LAWS_AS_TEXT = {(law.of, law.text) for law in LAWS}
LAG = FoundEffect(
    "thruster_lag", "a lag of the thrust", "", ("lily_01",), "confirmed",
    {"time_constant": Estimate(0.3143, 0.3012, 0.3274, "s")}, 90.0, (Rival("sensor_latency", 1.2),),
)  # fmt: skip
NAMED = [
    *(replace(LAG, id=each.id, name=name) for each in ENTRIES for name in (each.name, each.opposite) if name),
    *(replace(LAG, id=law.text, name=law_words(law), law=law) for law in LAWS),
]
"""An effect of each entry of the catalogue, by both of its names, and of each law that is looked for outside it."""
ROBOTS = tuple(f"lily_{number:02}" for number in range(1, 12))


def plain(text: str) -> str:
    """With usual spaces."""
    return text.replace("\u00a0", " ")


def found(*effects: FoundEffect, **parts: Any) -> Any:
    """A diagnosis as the lines look at it."""
    rest: dict[str, Any] = {
        "verdict": "mismatch",
        "recalibrated": (),
        "fit": {},
        "against": None,
        "passed_over": (),
        "reasons": (),
        "unlike": (),
        "sentence": "",
    }
    return SimpleNamespace(effects=effects, **{**rest, **parts})


def test_the_headline_names_the_effect_and_the_lines_its_size_rival_and_gain() -> None:
    """Every number in the unit that makes it handy."""
    table = {"position": HeldOut(0.05, 0.11, 0.00535, 0.0055, "m")}
    assert sentence_of("mismatch", [LAG], []) == "Missing from the model of lily_01: a lag of the thrust."
    assert [plain(line) for line in detail_lines(found(LAG, fit=table))] == [
        "a lag of the thrust of lily_01, confirmed: time constant 314 ms; or else sensor latency",
        "error of position on unseen data: 5.35 mm with it instead of 110 mm (with a force without a name 5.50 mm)",
    ]


def is_headline(told: str) -> bool:
    """One sentence of at most 25 words."""
    return len(told.split()) <= 25 and told.endswith(".") and ". " not in told


@pytest.mark.parametrize("count", [1, 2, 3, 5, 12])
@pytest.mark.parametrize("tier", ["confirmed", "suspected", "mixed"])
@pytest.mark.parametrize("robots", [(), ROBOTS[:1], ROBOTS[:3], ROBOTS], ids=len)
def test_no_headline_has_more_than_25_words(count: int, tier: str, robots: tuple[str, ...]) -> None:
    """Whatever effects and laws are found together, of however many robots, and however one of them is in doubt."""
    shifted = [replace(DRAG, parameter=f"number_{index}") for index in range(count)]
    for first in range(len(NAMED)):
        effects = [
            replace(
                NAMED[(first + 7 * index) % len(NAMED)],
                robots=robots,
                tier=("confirmed", "suspected")[index % 2] if tier == "mixed" else tier,
            )
            for index in range(count)
        ]
        ids = [each.id for each in effects]
        for told in (
            sentence_of("mismatch", effects, []),
            sentence_of("recalibrate", [], shifted),
            difference_sentence("mismatch", effects, shifted, "unknown:surge~1"),
            sentence_of("mismatch", effects, [], collapsed=True),
            difference_sentence("mismatch", effects, []),
            difference_sentence("mismatch", [], [], "", ids),
            difference_sentence("mismatch", [], [], "", [], [ids[:2], ids[1:3], ids]),
            difference_sentence("mismatch", effects[:1], [], "unknown:surge~1", ids, [ids[:2]]),
        ):
            assert is_headline(told), told
        for shortly in (SIZE_MAY_BE_NOTHING, NOT_FORETOLD, SHORTLY_OF_NO_NAME):
            told = sentence_of("mismatch", [], [], [PassedOver(each, True, (), shortly) for each in effects])
            assert is_headline(told), told


def test_a_headline_is_shortened_step_by_step() -> None:
    """First fewer names, then the shortest words for them, and at last the number of what was found."""
    long = replace(LAG, id="unknown:surge~u", name="word " * 30)
    assert sentence_of("mismatch", [LAG, long], []) == (
        "Missing from the model of lily_01: a lag of the thrust; and 1 more."
    )
    assert sentence_of("mismatch", [long], []) == (
        "Missing from the model of lily_01: an unexplained force ahead or astern."
    )
    wordy = replace(long, id="word_" * 30)
    assert sentence_of("mismatch", [wordy, wordy], []) == ("Missing from the model of lily_01: 2 effects, named below.")


def test_reasons_stand_below_the_headline_where_nothing_could_be_tested() -> None:
    """A single short one is the headline itself, and is not said twice."""
    long = "tank: lily_01 " + "never " * 30 + "moves."
    assert is_headline(unable_sentence([long])) and is_headline(unable_sentence(["A.", "B."]))
    assert unable_sentence(["It never moves."]) == "It never moves."
    assert long in detail_lines(found(verdict="insufficient", reasons=(long,), sentence=unable_sentence([long])))
    assert detail_lines(found(verdict="insufficient", reasons=("A.",), sentence="A.")) == ()


def test_another_vehicle_is_told_with_as_many_numbers_as_fit() -> None:
    """The headline has the factors of a robot's numbers, fewer of many, and none of one with a name of many words."""
    factors = {"thrust gain": 0.278, "yaw drag": 0.5, "inertia": 2.5, "yaw torque gain": 1.8}
    assert other_vehicle_headline("boat", dict(list(factors.items())[:2])) == (
        "boat does not look like the same vehicle: thrust gain 0.28, yaw drag 0.5 times as before; nothing is named."
    )
    for count in range(1, 5):
        assert is_headline(other_vehicle_headline("boat", dict(list(factors.items())[:count])))
    assert is_headline(other_vehicle_headline("a " * 20, factors))


def test_laws_are_said_in_words_that_tell_them_apart() -> None:
    """No letters of the equations, no underscores; different laws have different words, as entries are told by them."""
    words = [law_words(law) for law in LAWS]
    assert len(set(words)) == len(set(LAWS_AS_TEXT))
    letters = {*REGRESSOR_CODE, "X", "Y", "Z", "N"} - {"1", "x", "y", "speed", "thrust", "pump"}
    for told in (*words, *(identifier_words(law.text) for law in LAWS)):
        assert not letters & set(told.replace(",", " ").split()) and not set("_*^|~") & set(told), told
    assert law_words(Law.parse("unknown:sway~u*r")) == (
        "an unexplained force to the left in proportion to the speed forwards times the turn rate"
    )
    assert opposite_law_words(Law.parse("unknown:sway~u*r")) == (
        "an unexplained force to the right in proportion to the speed forwards times the turn rate"
    )
    assert identifier_words("unknown:sway~u*r") == (  # of which the sign is not known
        "an unexplained force to one side in proportion to the speed forwards times the turn rate"
    )
    assert law_words(Law.parse("unknown:velocity~r", "velocity_v")) == (
        "an unexplained error of the speed log to the left in proportion to the turn rate"
    )
    assert set(READING_WORDS) == set(KINDS) and len(set(READING_WORDS.values())) == len(KINDS)


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


def test_what_free_runs_lack_is_said_where_nothing_has_a_name() -> None:
    """With the channel, before the numbers that have shifted; nothing says then that nothing is missing."""
    shifted = [Recalibrated("drag", 1.0, Estimate(1.2, 1.1, 1.3, "1"), ("lily_01",))]
    assert sentence_of("mismatch", [], shifted, beyond_floor=["depth"]) == (
        "Something without a name is missing in depth; the model's numbers have shifted: drag."
    )
    told = sentence_of("mismatch", [], [], beyond_floor=["position", "heading"])
    assert told == "Something without a name is missing in position and heading."


def test_what_has_no_name_is_told_with_its_reason() -> None:
    """In the lines below the headline."""
    strong, none = (
        PassedOver(replace(LAG, name=name, nats=nats), stands=stands, because=(), shortly=SIZE_MAY_BE_NOTHING)
        for name, nats, stands in (("a torque", 12.0, True), ("a tether", 90.0, False))
    )
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


def test_errors_of_instruments_are_not_missing_physics() -> None:
    """A pose that comes late is said of the readings; beside a force the model lacks something."""
    late = replace(LAG, id="sensor_latency", name="pose that comes late", topic="pose")
    wrong = replace(late, id="unknown:velocity~r", name="an error", law=Law.parse("unknown:velocity~r", "velocity_v"))
    assert sentence_of("mismatch", [late, wrong], []).startswith("The readings of lily_01 err: pose that comes late; ")
    doubtful = [replace(each, tier="suspected") for each in (late, wrong)]
    assert sentence_of("mismatch", doubtful, []).startswith("Perhaps the readings of lily_01 err: ")
    assert sentence_of("mismatch", [late, LAG], []).startswith("Missing from the model of lily_01: ")


def test_a_collapsed_fit_knows_nothing() -> None:
    """Whatever it has found, and however little the recordings excite the vehicle."""
    doubtful = replace(LAG, tier="suspected")
    assert sentence_of("mismatch", [doubtful], [], collapsed=True) == (
        "The fit has collapsed, so that nothing is sure; perhaps a lag of the thrust."
    )
    for verdict in ("consistent", "recalibrate", "mismatch", "insufficient"):
        assert "is not known" in sentence_of(verdict, [], [DRAG], collapsed=True)
    mixed = replace(LAG, id="frame_mixup", name="axes that are mixed up", correction="in degrees")  # before any fit
    assert (
        sentence_of("mismatch", [mixed], [], collapsed=True) == "The readings of lily_01 err: axes that are mixed up."
    )


def test_recordings_that_excite_too_little_may_show_numbers() -> None:
    """What they show of the platform's numbers is said in the same sentence."""
    blind = "These recordings do not excite the vehicle enough to tell what its model lacks"
    assert sentence_of("insufficient", [], []) == f"{blind}."
    assert sentence_of("insufficient", [], [DRAG]) == f"{blind}; its numbers have shifted: yaw drag."
    assert len(sentence_of("insufficient", [], 9 * [DRAG]).split()) <= 25


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


def test_a_name_whose_size_may_be_nothing_is_doubted_beside_it() -> None:
    """In headline and line; not beside one a number of which is clear. A law outside the catalogue has one number."""
    size = {"surge": Estimate(0.02, -0.01, 0.05, "N s/m"), "sway": Estimate(0.001, -0.004, 0.006, "N s/m")}
    drag = replace(
        LAG,
        id="linear_drag",
        name="linear drag",
        parameters=size,
        ambiguous_with=(),
        tier="suspected",
        because=("No.",),
    )
    clear = replace(drag, parameters=size | {"sway": Estimate(0.02, 0.018, 0.022, "N s/m")})
    numbers = {"coefficient": Estimate(-0.01, -0.03, 0.01, "N"), "moment": Estimate(3.0, 1.0, 5.0, "s")}
    law = replace(drag, id="unknown:yaw~v", name="a moment", law=Law.parse("unknown:yaw~v"), parameters=numbers)
    assert may_be_nothing(drag) and may_be_nothing(law) and not may_be_nothing(clear)
    for doubtful in (drag, law):
        assert sentence_of("mismatch", [clear, doubtful], []).endswith(
            f"linear drag; and {doubtful.name} (may be nothing)."
        )
        collapsed = sentence_of("mismatch", [doubtful], [], collapsed=True)
        assert collapsed.endswith(f"perhaps {doubtful.name} (may be nothing).")
        told = plain(detail_lines(found(doubtful))[0])
        assert told.startswith(f"{doubtful.name} of lily_01, suspected, and its size may as well be nothing: ")
    assert "nothing" not in detail_lines(found(clear))[0]


def test_a_gain_is_told_of_the_channel_that_has_one() -> None:
    """No gain in position: that in heading is told; none at all: nothing."""
    none = HeldOut(0.1, 0.1, 0.1, math.nan, "m")
    heading = HeldOut(0.2, math.pi / 18, math.pi / 180, math.nan, "rad")
    *_, told = detail_lines(found(LAG, fit={"position": none, "heading": heading}))
    assert "error of heading on unseen data: 1.00\u00b0 with it instead of 10.0\u00b0" in told
    assert len(detail_lines(found(LAG, fit={"position": none}))) == 1


def test_shifted_numbers_stand_beside_the_nominal_ones() -> None:
    """In the same unit; the headline names them, and ends a long list early."""
    assert sentence_of("recalibrate", [], [DRAG]).endswith("the model's numbers have shifted: yaw drag.")
    (told,) = detail_lines(found(verdict="recalibrate", recalibrated=(DRAG,)))
    assert plain(told) == "yaw drag of lily_01: 125.0 \u00b5N m s\u00b2 for 114 \u00b5N m s\u00b2"
    many = [replace(DRAG, parameter=f"long name of number {index}") for index in range(6)]
    assert sentence_of("recalibrate", [], many).endswith("and 4 more.")


def test_a_correction_stands_in_words() -> None:
    """A mix-up has words instead of numbers."""
    mixed = FoundEffect("frame_mixup", "axes that are mixed up", "", (), "confirmed", {}, 9.0, correction="in degrees")
    assert sentence_of("mismatch", [mixed], []) == "The readings err: axes that are mixed up."
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


def test_a_suspected_difference_is_not_told_as_sure() -> None:
    """A confirmed one stands as it is, beside it."""
    effects = [replace(NAMED[0], name="weed"), replace(NAMED[1], name="iron", tier="suspected")]
    told = difference_sentence("mismatch", effects, [])
    assert plain(told) == "Compared with when it was well, these differ: weed; and perhaps iron."


def test_a_difference_of_no_known_size_is_said_as_that() -> None:
    """It is neither named as an effect nor called something outside the catalogue."""
    told = difference_sentence("mismatch", [], [], "", ["thruster_gain:right"])
    assert told == (
        "Compared with when it was well, these differ: most likely thruster gain, right, by how much cannot be told."
    )
