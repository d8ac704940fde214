"""diagnosis.json has the fields of the contract, of the types of the contract, and no others."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.findings import ActuatorReport, Diagnosis, Estimate, FoundEffect, Rival
from cocorosim_ros.diagnosis.report.json_file import diagnosis_json

Example = Callable[[str], Diagnosis]
VERDICTS = ("consistent", "recalibrate", "mismatch", "insufficient")
NUMBER = (int, float, type(None))
TEXT = (str,)
# The contract, section "What diagnose writes": a tuple is the types of a value, a list of one form any number of
# that form, a mapping with "*" any names.
FORM: Any = {
    "verdict": TEXT,
    "recalibrated": [
        {"parameter": TEXT, "nominal": NUMBER, "value": NUMBER, "ci95": [NUMBER], "unit": TEXT, "robots": [TEXT]}
    ],
    "mismatch": [
        {
            "robots": [TEXT], "equation": TEXT, "regressor": TEXT, "where": TEXT, "when": [NUMBER],
            "size": NUMBER, "unit": TEXT, "z": NUMBER,
        }
    ],
    "effects": [
        {
            "id": TEXT, "name": TEXT, "equation": TEXT, "robots": [TEXT], "tier": TEXT,
            "parameters": {"*": {"value": (*NUMBER, str), "ci95": [NUMBER], "unit": (str, type(None))}},
            "nats": NUMBER, "probability": (float,), "ambiguous_with": [{"id": TEXT, "nats_behind": NUMBER}],
            "because": [TEXT],
        }
    ],
    "probabilities": {"*": (float,)},
    "not_shown_by_this_recording": [TEXT],
    "not_looked_for": [{"id": TEXT, "lacks": [TEXT], "because": TEXT}],
    "next_manoeuvre": (str, type(None)),
    "warnings": [TEXT],
    "cannot_be_told": [TEXT],
    "fit": {
        "held_out": {
            "*": {"nominal": NUMBER, "recalibrated": NUMBER, "augmented": NUMBER, "noise_floor": NUMBER, "unit": TEXT}
        }
    },
    "passed_over": [
        {
            "id": TEXT, "name": TEXT, "equation": TEXT, "robots": [TEXT],
            "parameters": {"*": {"value": NUMBER, "ci95": [NUMBER], "unit": TEXT}},
            "nats": NUMBER, "ambiguous_with": [{"id": TEXT, "nats_behind": NUMBER}],
            "because": [TEXT], "missing": (int,),
        }
    ],
    "missing_in": [TEXT],
    "screened": {"*": {"nats": NUMBER, "seen_from": NUMBER}},
}  # fmt: skip
OPTIONAL = {"topic": TEXT, "against": TEXT, "may_be_nothing": (bool,)}


def check(value: Any, form: Any, place: str = "top") -> None:
    """Nothing, if a value has the form."""
    if isinstance(form, tuple):
        assert isinstance(value, form), f"{place}: {value!r}"
        assert not isinstance(value, bool) or place.endswith((".missing", ".may_be_nothing")), place
    elif isinstance(form, list):
        assert isinstance(value, list), place
        for index, part in enumerate(value):
            check(part, form[0], f"{place}[{index}]")
    else:
        assert isinstance(value, dict), place
        if "*" not in form:
            assert set(value) - set(OPTIONAL) == set(form), place
        for name, part in value.items():
            check(part, OPTIONAL.get(name, form.get(name, form.get("*"))), f"{place}.{name}")


def refuse(word: str) -> float:
    """What json.loads calls for NaN and infinities."""
    raise AssertionError(word)


def read(diagnosis: Diagnosis) -> Any:
    """The file's content; NaN and Infinity are not JSON and fail."""
    return json.loads(diagnosis_json(diagnosis), parse_constant=refuse)


@pytest.mark.parametrize("verdict", VERDICTS)
def test_every_verdict_has_the_form_of_the_contract(example: Example, verdict: str) -> None:
    """All fields, no others, right types."""
    tree = read(example(verdict))
    check(tree, FORM)
    assert tree["verdict"] == verdict


def test_what_has_no_name_stands_by_itself(example: Example) -> None:
    """Not among the effects, with its numbers, its nats, why it has no name, and whether something is missing."""
    tree = read(example("nameless"))
    check(tree, FORM)
    assert tree["effects"] == [] and tree["verdict"] == "mismatch"
    (passed,) = tree["passed_over"]
    assert (passed["id"], passed["topic"], passed["nats"], passed["missing"]) == ("gyro_scale", "imu", 52.3, True)
    assert passed["parameters"]["scale"]["ci95"] == [0.97, 1.07]
    assert passed["because"] == ["Its size may as well be nothing."]
    assert "gyro_scale" not in tree["probabilities"]


def test_the_form_notices_a_wrong_field(example: Example) -> None:
    """The check of this file can fail: a field too many, one too few, a wrong type."""
    tree = read(example("mismatch"))
    for wrong in ({**tree, "more": 1}, {k: v for k, v in tree.items() if k != "fit"}, {**tree, "effects": "none"}):
        with pytest.raises(AssertionError):
            check(wrong, FORM)


def test_numbers_arrive_as_they_are(example: Example) -> None:
    """Values, intervals and rivals of the example, by hand."""
    tree = read(example("mismatch"))
    assert tree["recalibrated"] == [
        {
            "parameter": "drag",
            "nominal": 1.7778,
            "value": 1.853,
            "ci95": [1.831, 1.875],
            "unit": "kg/m",
            "robots": ["lily_01"],
        }
    ]
    effect = tree["effects"][0]
    assert effect["parameters"]["sway_minus_surge"] == {"value": 0.0443, "ci95": [0.0431, 0.0455], "unit": "kg"}
    assert effect["ambiguous_with"] == [{"id": "anisotropic_drag", "nats_behind": 2.1}]
    assert "topic" not in effect
    assert tree["mismatch"][0]["when"] == [12.0, 588.0]
    assert tree["fit"]["held_out"]["heading"]["noise_floor"] is None


def test_whatever_is_not_finite_is_null(example: Example) -> None:
    """NaN and infinities anywhere become null."""
    found = example("mismatch")
    effect = replace(found.effects[0], nats=math.inf, parameters={"yaw": Estimate(1.0, -math.inf, math.nan, "kg m^2")})
    tree = read(replace(found, effects=(effect,)))
    assert tree["effects"][0]["nats"] is None
    assert tree["effects"][0]["parameters"]["yaw"] == {"value": 1.0, "ci95": [None, None], "unit": "kg m^2"}


def test_a_stream_is_named_and_a_correction_stands_in_words(example: Example) -> None:
    """An effect of one stream carries its topic; the correction of a mix-up has the keys of any parameter."""
    effect = FoundEffect(
        "frame_mixup", "axes mixed up", "", ("lily_01",), "confirmed", {}, 90.0,
        topic="compass", correction="the reading is in degrees",
    )  # fmt: skip
    tree = read(replace(example("mismatch"), effects=(effect,)))
    check(tree, FORM)
    assert tree["effects"][0]["topic"] == "compass"
    assert tree["effects"][0]["parameters"] == {
        "correction": {"value": "the reading is in degrees", "ci95": [None, None], "unit": None}
    }


def test_each_number_that_may_be_nothing_is_marked(example: Example) -> None:
    """By itself, where its interval holds the value at which it does nothing, one for a ratio; no other has the key."""
    numbers = {"sway_ratio": Estimate(2.0, 1.8, 2.2, "1"), "heave_ratio": Estimate(1.1, 0.8, 1.4, "1")}
    drag = FoundEffect("anisotropic_drag", "drag of its own", "", ("lily_01",), "confirmed", numbers, 90.0)
    both = replace(drag, parameters=numbers | {"sway_ratio": Estimate(1.2, 0.9, 1.5, "1")})
    for effect, marked in ((drag, {"heave_ratio"}), (both, {"sway_ratio", "heave_ratio"})):
        (told,) = read(replace(example("mismatch"), effects=(effect,)))["effects"]
        assert {name for name, each in told["parameters"].items() if each.get("may_be_nothing") is True} == marked
        assert all("may_be_nothing" not in each for name, each in told["parameters"].items() if name not in marked)


def test_what_is_suspected_says_why(example: Example) -> None:
    """Its reasons; without any its rivals, by their names; without these the data that its fit did not see."""
    (munk, *_) = example("mismatch").effects
    plain = replace(munk, tier="suspected", because=(), ambiguous_with=())
    rivals = (Rival("thruster_lag", 1.0), Rival("pump_lag", 2.0))

    def reasons(effect: FoundEffect) -> list[str]:
        (told,) = read(replace(example("mismatch"), effects=(effect,)))["effects"]
        return list(told["because"])

    assert reasons(replace(plain, because=("It is chance.",))) == ["It is chance."]
    (rivalled,) = reasons(replace(plain, ambiguous_with=rivals))
    assert rivalled.startswith("Thruster lag, pump lag would explain the recordings as well")
    (unseen,) = reasons(plain)
    assert unseen.startswith("The evidence is there, but data that its fit did not see")
    assert reasons(replace(plain, tier="confirmed")) == []


REPORTED = ActuatorReport(
    "boat",
    "rudder",
    "angle",
    {
        "gain": Estimate(0.9, 0.88, 0.92, "1"),
        "delay": Estimate(0.4, 0.3, 0.5, "s"),
        "time_constant": Estimate(0.2, 0.1, 0.3, "s"),
        "lateness": Estimate(0.6, 0.55, 0.65, "s"),
    },
    before={"lateness": Estimate(0.3, 0.25, 0.35, "s")},
)
STILL = ActuatorReport("boat", "propeller", "rotation", because="its command hardly changes")


def test_what_actuators_report_is_a_key_of_its_own(example: Example) -> None:
    """By actuator its numbers with intervals, or why there are none; no key where nothing was reported."""
    tree = read(replace(example("consistent"), actuators=(REPORTED, STILL)))
    told, untold = tree.pop("actuator_feedback")
    check(tree, FORM)
    assert told == {
        "robots": ["boat"], "actuator": "rudder", "quantity": "angle", "of_amount": False,
        "gain": {"value": 0.9, "ci95": [0.88, 0.92], "unit": "1"},
        "delay": {"value": 0.4, "ci95": [0.3, 0.5], "unit": "s"},
        "time_constant": {"value": 0.2, "ci95": [0.1, 0.3], "unit": "s"},
        "lateness": {"value": 0.6, "ci95": [0.55, 0.65], "unit": "s"},
        "before": {"lateness": {"value": 0.3, "ci95": [0.25, 0.35], "unit": "s"}},
    }  # fmt: skip
    assert untold == {
        "robots": ["boat"], "actuator": "propeller", "quantity": "rotation", "of_amount": False,
        "because": "its command hardly changes",
    }  # fmt: skip
