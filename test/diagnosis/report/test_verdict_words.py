"""Words of the verdict: what is known of what was found, and no more."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, FoundEffect, HeldOut, PassedOver
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.diagnosis.report.verdict_words import is_of_instruments, verdict_words, weighed_words
from cocorosim_ros.diagnosis.showing.probability import probabilities_of
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.laws.law import Law

Example = Callable[[str], Diagnosis]
LILY = ("lily_01",)
LATE = FoundEffect("sensor_latency", "pose that comes late", "", LILY, "confirmed", {}, 90.0, topic="pose")
SPEED_LOG = Law.parse("unknown:velocity~r", "velocity_v")
WORSE = HeldOut(0.1, 0.5, 0.4, 0.05, "m", {"recalibrated": (0.3, 0.7)})
AGAINST = Comparison(("good",), (), ())


def suspected(*effects: FoundEffect) -> tuple[FoundEffect, ...]:
    """The effects, each with a reason against it."""
    return tuple(replace(each, tier="suspected", because=("It may be chance.",)) for each in effects)


def told(found: Diagnosis) -> str:
    """The page as text."""
    return render_report(found, Origin(load_platform("lily"), ("bags/tank_7",), LILY, 600.0))


def test_physics_is_missing_only_where_that_is_known(example: Example) -> None:
    """All confirmed, some, or none; the found model is to find nothing only where all of it is confirmed."""
    found = example("mismatch")
    (munk,) = found.effects
    lag = replace(munk, id="thruster_lag", name="a lag", nats=40.0)
    sure = verdict_words(found)
    assert sure.heading == "Physics is missing" and "effects below do" in sure.sentence
    assert "should find nothing" in sure.next
    partly = verdict_words(replace(found, effects=(munk, *suspected(lag))))
    assert partly.heading == "Physics is missing" and "suspected ones may be" in partly.sentence
    doubtful = verdict_words(replace(found, effects=suspected(replace(munk, ambiguous_with=()))))
    assert doubtful.heading == "Perhaps physics is missing" and "none has to be there" in doubtful.sentence
    for words in (partly, doubtful):
        assert "effects below do" not in words.sentence and "find nothing" not in words.next


def test_errors_of_instruments_are_no_physics(example: Example) -> None:
    """Of a late pose, a law of a reading or swapped axes nothing is said about the vehicle's physics but that."""
    found = example("mismatch")
    law = replace(LATE, id="unknown:velocity~r", law=SPEED_LOG, topic="velocity")
    axes = FoundEffect("frame_mixup", "axes", "", LILY, "confirmed", {}, 9.0, topic="pose", correction="in degrees")
    for effects in ((LATE,), (law,), (axes,), (LATE, law, axes)):
        words = verdict_words(replace(found, effects=effects))
        assert words.heading == "Readings err" and "nothing says that physics" in words.sentence, effects
    assert verdict_words(replace(found, effects=suspected(LATE))).heading == "Perhaps readings err"
    # A force that has no name speaks for physics all the same, if it stands.
    force = PassedOver(replace(found.effects[0], id="linear_drag"), stands=True, because=(), shortly="")
    assert "eadings" not in verdict_words(replace(found, effects=suspected(LATE), passed_over=(force,))).heading
    chance = replace(force, stands=False)
    assert "eadings" in verdict_words(replace(found, effects=suspected(LATE), passed_over=(chance,))).heading
    # Beside a force that is only suspected, what is confirmed of readings says nothing about physics.
    beside = verdict_words(replace(found, effects=(LATE, *suspected(found.effects[0]))))
    assert beside.heading == "Perhaps physics is missing"


def test_each_entry_is_of_instruments_or_of_motion() -> None:
    """By hand for a few: forces of the water and of thrusters are no errors of readings."""
    kinds = {each.id: is_of_instruments(replace(LATE, id=each.id, topic=each.topic)) for each in ENTRIES}
    for name in ("linear_drag", "added_mass", "steady_current", "thruster_lag", "pump_lag", "buoyancy_trim"):
        assert not kinds[name], name
    for name in ("sensor_latency", "clock_skew", "compass_distortion", "camera_scale", "imu_bias", "pose_lever"):
        assert kinds[name], name
    assert not is_of_instruments(replace(LATE, id="unknown:sway~u*r", law=Law.parse("unknown:sway~u*r")))


def test_a_name_that_is_less_probable_than_another_cause_is_said_as_that(example: Example) -> None:
    """Several suspects, each at even odds: "something else" is then the most probable answer, and the words say so."""
    found = example("mismatch")
    (munk,) = found.effects
    names = ("added_mass", "anisotropic_drag", "steady_current", "battery_sag")
    many = suspected(*(replace(munk, id=name, ambiguous_with=()) for name in names))
    law = suspected(replace(munk, id="unknown:sway~u*r", law=Law.parse("unknown:sway~u*r"), ambiguous_with=()))
    doubtful = replace(found, effects=(*law, *many))
    assert max(probabilities_of(doubtful).told.items(), key=lambda each: each[1])[0] == "something else"
    words = verdict_words(doubtful)
    assert "name is not known" in words.heading and "none of their names is sure" in words.sentence
    assert "effects below do." not in told(doubtful) and "should find nothing" not in told(doubtful)


def test_a_collapsed_fit_of_which_nothing_is_taken_is_none(example: Example) -> None:
    """No number has clearly moved and nothing is named: what is left is the platform as given, which foretells well."""
    found = example("consistent")
    collapsed = replace(found, fit={**found.fit, "position": WORSE})
    assert verdict_words(collapsed) == verdict_words(found)


@pytest.mark.parametrize("verdict", ["mismatch", "nameless", "recalibrate"])
def test_a_collapsed_fit_is_said_first(example: Example, verdict: str) -> None:
    """Whatever it has found: nothing is known, and its model is not to be used; a fit that is as good says nothing."""
    found = example(verdict)
    collapsed = replace(found, fit={**found.fit, "position": WORSE})
    words = verdict_words(collapsed)
    assert "collapsed" in words.heading and "Do not simulate" in words.next
    assert "collapsed" not in verdict_words(found).heading
    page = told(collapsed)
    assert "Physics is missing" not in page and "should find nothing" not in page and "Nothing was found" not in page


@pytest.mark.parametrize("verdict", ["mismatch", "nameless", "recalibrate", "insufficient"])
def test_numbers_that_are_kept_as_given_are_said_first(example: Example, verdict: str) -> None:
    """Little is known, whatever was found beside them; the found model may be used, since it foretells no worse."""
    found = example("recalibrate" if verdict == "insufficient" else verdict)
    words = verdict_words(replace(found, verdict=verdict if verdict != "nameless" else "mismatch", held=("yaw_drag",)))
    assert "collapsed" in words.heading and "Do not simulate" not in words.next


def test_recordings_that_cannot_tell_say_what_was_tried(example: Example) -> None:
    """Nothing could be tested where nothing was; a collapsed fit is called that by badge, headline and section."""
    untested = example("insufficient")
    assert "Nothing could be tested" in told(untested)
    tried = replace(example("consistent"), verdict="insufficient")
    collapsed = replace(tried, fit={**tried.fit, "position": WORSE})
    held = replace(tried, held=("yaw_drag",))
    for found, why in (
        (tried, "would not have shown"),
        (collapsed, "the fault of the fit"),
        (held, "fault of the fit"),
    ):
        page = told(found)
        assert "could be tested" not in page and "too little information" not in page
        assert "effects were tried" in page and why in page
    assert verdict_words(tried).heading == "This recording cannot tell"
    words = verdict_words(collapsed)
    assert "collapsed" in words.heading and words.next == ""  # its model.yaml is the platform as given


def test_another_vehicle_is_no_lack_of_information(example: Example) -> None:
    """The page says everywhere why nothing is named; no recording was too poor, and no drive would show more."""
    found = replace(example("insufficient"), manoeuvres=(), against=replace(AGAINST, unlike=("boat",)))
    assert "another vehicle" in verdict_words(found).heading
    page = told(found)
    assert "No effect was screened, because these recordings do not look like the same vehicle" in page
    assert "more than happens to one vehicle" in page and "This was not worked out" in page
    assert "too little information" not in page and "was not driven so" not in page


def test_differences_are_as_sure_as_their_names(example: Example) -> None:
    """Suspected, of readings alone, or beside a number that has changed for certain."""
    found = replace(example("mismatch"), against=AGAINST, recalibrated=())
    assert verdict_words(found).heading == "Something differs"
    assert verdict_words(replace(found, effects=suspected(*found.effects))).heading == "Perhaps something differs"
    assert verdict_words(replace(found, effects=(LATE,))).heading == "Readings differ"
    moved = replace(found, effects=(LATE,), recalibrated=example("mismatch").recalibrated)
    assert verdict_words(moved).heading == "Something differs"


def test_what_silence_is_worth_is_said_beside_its_probability(example: Example) -> None:
    """Where nothing was found, "something else" is what was believed before; in a comparison that is too much."""
    silent = example("consistent")
    assert "believed before the recording was seen" in weighed_words(silent)
    assert "nothing is more probable here than this says" in weighed_words(replace(silent, against=AGAINST))
    assert "believed before the recording was seen" in weighed_words(example("recalibrate"))
    collapsed = replace(silent, fit={**silent.fit, "position": WORSE})
    for found in (example("mismatch"), collapsed):
        assert "of another vehicle it is a guess" in weighed_words(found)
    assert "Nothing is missing" not in verdict_words(silent).heading
    assert weighed_words(silent) in told(silent)


def test_shared_reasons_stand_once(example: Example) -> None:
    """What speaks against the whole fit is said at the top, and each effect points there; its own reasons stay."""
    found = example("mismatch")
    (munk,) = found.effects
    general = ("The fit of drag stands at the end of its range.", "What is foretold errs not at random.")
    effects = tuple(
        replace(munk, id=name, tier="suspected", because=(f"Its {name} is odd.", *general))
        for name in ("added_mass", "linear_drag", "thruster_lag")
    )
    page = told(replace(found, effects=effects, warnings=general))
    for sentence in general:
        assert page.count(sentence) == 1
    assert page.count("at the top of this page</a> (2 sentences)") == 3
    assert all(page.count(f"Its {each.id} is odd.") == 1 for each in effects)
    alone = told(replace(found, effects=effects[:1], warnings=general[:1]))
    assert alone.count("at the top of this page</a>.") == 1 and alone.count(general[1]) == 1


@pytest.mark.parametrize(
    ("verdict", "more"), [("consistent", "nothing is named"), ("recalibrate", "numbers have shifted")]
)
def test_what_free_runs_alone_lack_is_a_mismatch(example: Example, verdict: str, more: str) -> None:
    """With or without numbers that have shifted; what evidence speaks for is another matter."""
    lacking = replace(example(verdict), verdict="mismatch", beyond_floor=("position",))
    words = verdict_words(lacking)
    assert words.heading == f"Something is missing, and {more}" and not words.next
    assert "warnings say where" in words.sentence
    stands = replace(lacking, passed_over=(PassedOver(LATE, stands=True, because=(), shortly="it may be nothing"),))
    assert verdict_words(stands).heading == "Something is missing"
