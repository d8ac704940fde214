"""The Scorer on diagnoses made by hand."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest


def secret(name: str, size: float = 0.5, **more: Any) -> dict[str, Any]:
    """A hidden effect as an envelope has it."""
    return {
        "id": name,
        "size": size,
        "parameters": {},
        "topic": None,
        "acceptable": [],
        "tolerated": [],
        "robots": [],
    } | more


def reported(name: str, *rivals: tuple[str, float], **parameters: Any) -> dict[str, Any]:
    """An effect as a diagnosis reports it; parameters are (value, low, high)."""
    shown = {key: {"value": v, "ci95": [low, high], "unit": ""} for key, (v, low, high) in parameters.items()}
    behind = [{"id": rival, "nats_behind": nats} for rival, nats in rivals]
    return {"id": name, "tier": "confirmed", "parameters": shown, "nats": 9.0, "ambiguous_with": behind}


def case(kind: str, hidden: list[Any], effects: list[Any] | None, verdict: str = "mismatch", **more: Any) -> Any:
    """A case; effects None: no diagnosis."""
    from concealer.cases import Case

    truth = {"recording": "r", "kind": kind, "effects": hidden, "noise": 0.01, "oracle": {}}
    diagnosis = None if effects is None else {"verdict": verdict, "effects": effects} | more
    return Case(truth, diagnosis)


@pytest.mark.parametrize(("hits", "of", "low", "high"), [(0, 54, 0.0, 0.0664), (5, 10, 0.2366, 0.7634), (0, 0, 0, 1)])
def test_intervals_are_wilsons(hits: int, of: int, low: float, high: float) -> None:
    """Known values: 0/54 still allows 6.6 %."""
    from concealer.figures import wilson

    assert wilson(hits, of) == pytest.approx((low, high), abs=1e-4)


def test_a_single_effect_is_exact_only_without_companions() -> None:
    """Right and alone; with a second effect, none, another, or no diagnosis it is not."""
    hidden = [secret("tether")]
    answers = [
        [reported("tether")],
        [reported("tether"), reported("torque_bias")],
        [],
        [reported("steady_current")],
        None,
    ]
    assert [case("single", hidden, answer).exact() for answer in answers] == [True, False, False, False, False]


def test_names_are_right_by_tier_and_stream() -> None:
    """One of several robots counts once; another stream's error is wrong; a suspected one is counted apart."""
    doubtful = reported("clock_skew") | {"tier": "suspected", "topic": "imu"}
    late = reported("sensor_latency") | {"topic": "pose"}
    answer = case("single", [secret("sensor_latency", topic="compass")], [late, doubtful, doubtful])
    assert (answer.of_tier("confirmed"), answer.of_tier("suspected")) == ([False], [False])
    assert case("single", [secret("clock_skew", topic="imu")], [doubtful, doubtful]).of_tier("suspected") == [True]


def test_the_table_counts_by_hand() -> None:
    """Every row of the table for cases whose answers are plain."""
    from concealer.score import score
    from concealer.score_text import as_text

    lag = [secret("thruster_lag")]
    odd = [secret("unknown:yaw~x", acceptable=["unknown:yaw~x"], tolerated=["sheared_current"])]
    poor = [secret("thruster_deadband")]
    cases = [
        case("nothing", [], [], "consistent"),
        case("nothing", [], [reported("torque_bias")]),
        case("recalibration", [], [], "recalibrate"),
        case("recalibration", [], [], "mismatch"),
        case("single", lag, [reported("thruster_lag", ("sensor_latency", 2.0), ("added_mass", 4.0))]),
        case("single", lag, [reported("sensor_latency", ("thruster_lag", 0.5))]),
        case("single", lag, [reported("added_mass")]),
        case("single", lag, [], "consistent"),
        case("several", [*lag, secret("tether")], [reported("tether"), reported("thruster_lag")]),
        case("outside", odd, [reported("unknown:yaw~x")]),
        case("outside", odd, [reported("unknown:yaw~y")]),
        case("outside", odd, [reported("tether")]),
        case("outside", odd, [reported("sheared_current")]),
        case("cannot_tell", poor, [], "consistent", not_shown_by_this_recording=["thruster_deadband"]),
        case("cannot_tell", poor, [], "consistent"),
        case("cannot_tell", poor, None),
    ]
    figures = score(cases)
    rates = {name: (r["hits"], r["of"]) for name, r in figures["table"]["rates"].items()}
    assert rates == {
        "exact, one medium effect, 1% noise": (1, 4),
        "exact, one effect, all sizes": (1, 4),
        "truth in ambiguity set, where something is named": (2, 3),
        "first named effect wrong, one or more effects": (2, 5),
        "first named effect wrong, one medium effect": (2, 4),
        "first named effect right but others added, one effect": (0, 4),
        "right robots, where several swim and something is named": (0, 0),
        "names told as confirmed that are right, in all recordings": (6, 10),
        "names told as suspected that are right, in all recordings": (0, 0),
        "false alarm, nothing concealed": (1, 2),
        "false alarm, recalibration only": (1, 2),
        "verdict consistent or recalibrate, nothing concealed": (1, 2),
        "verdict recalibrate, recalibration only": (1, 2),
        "exact, two effects": (1, 1),
        "exact, three effects": (0, 0),
        "nothing else named, two or three effects": (1, 1),
        "outside the catalogue: flagged": (2, 4),
        "outside the catalogue: right law": (1, 4),
        "outside the catalogue: named as an entry of it": (1, 4),
        "cannot tell: abstains": (2, 3),
        "cannot tell: abstains and says so": (1, 3),
        "diagnosis written": (15, 16),
    }
    assert figures["table"]["ambiguity_set_size"] == pytest.approx(5 / 3)
    assert figures["confusion"]["thruster_lag"] == {"thruster_lag": 1, "sensor_latency": 1, "added_mass": 1, "none": 1}
    # Flagged under a wrong law is no failure of the flag, but named wrongly or silent is.
    assert len(figures["failures"]) == 8
    assert figures["flagged_by_law"]["unknown:yaw~x"]["hits"] == 2
    text = as_text(figures)
    assert "| exact, two effects | 100.0 % | 1/1 | 20.7 % to 100.0 % |" in text  # Wilson: 1 / (1 + 1.96^2)
    assert "outside, noise 1%, 1 robot: unknown:yaw~x (size 0.50); said mismatch: tether (9 nats)" in text


def test_intervals_are_held_against_the_truth_of_the_same_stream() -> None:
    """Inside, outside, of another stream (not counted), and a tide whose sign and phase are turned."""
    from concealer.score import intervals

    latency = secret("sensor_latency", parameters={"latency": 0.1}, topic="compass")
    tide = secret("tidal_current", parameters={"x": 1.0, "y": 0.0, "period": 100.0, "phase": 0.5})
    turned = {"x": (-1.0, -1.1, -0.9), "y": (0.0, -0.1, 0.1), "period": (99.0, 98.0, 99.5), "phase": (3.6, 3.5, 3.7)}
    cases = [
        case("single", [latency], [reported("sensor_latency", latency=(0.11, 0.09, 0.13)) | {"topic": "compass"}]),
        case("single", [latency], [reported("sensor_latency", latency=(0.2, 0.15, 0.25)) | {"topic": "compass"}]),
        case("single", [latency], [reported("sensor_latency", latency=(0.2, 0.15, 0.25)) | {"topic": "pose"}]),
        case("single", [tide], [reported("tidal_current", **turned)]),
    ]
    found = intervals(cases)
    by_name = {name: (r["hits"], r["of"]) for name, r in found["coverage_by_parameter"].items()}
    assert by_name == {
        "sensor_latency.latency": (1, 2), "tidal_current.x": (1, 1), "tidal_current.y": (1, 1),
        "tidal_current.period": (0, 1), "tidal_current.phase": (1, 1),
    }  # fmt: skip
    assert found["relative_error_by_parameter"]["sensor_latency.latency"]["median"] == pytest.approx(0.55)


def test_an_effect_of_another_stream_or_with_a_second_one_is_not_exact() -> None:
    """A latency of the camera is not one of the compass; a twin that the recording cannot tell apart is as right."""
    late = [secret("sensor_latency", topic="pose")]
    shear = [secret("sheared_current", twins=["steady_current"])]
    assert case("single", late, [reported("sensor_latency") | {"topic": "pose"}]).exact()
    assert case("single", late, [reported("sensor_latency")]).exact()
    wrong = case("single", late, [reported("sensor_latency") | {"topic": "compass"}])
    assert not wrong.exact() and wrong.first_wrong()
    both = case("single", late, [reported("sensor_latency") | {"topic": topic} for topic in ("pose", "compass")])
    assert not both.exact() and not both.first_wrong() and len(both.spurious()) == 1
    twin = case("single", shear, [reported("steady_current", ("tether", 1.0))])
    assert twin.exact() and twin.truth_in_set() and not twin.first_wrong()
    assert not case("single", shear, [reported("tidal_current")]).exact()


def test_a_part_of_what_was_hidden_that_has_an_entry_of_its_own_is_nothing_else() -> None:
    """Hard iron with some soft iron, of both of which there are entries; without the hard iron it is not exact."""
    iron = [secret("compass_distortion") | {"tolerated": ["soft_iron"]}]
    assert case("single", iron, [reported("compass_distortion"), reported("soft_iron")]).exact()
    assert not case("single", iron, [reported("soft_iron")]).exact()
    assert not case("single", iron, [reported("compass_distortion"), reported("motor_field")]).exact()


def test_effects_are_found_on_the_robots_that_have_them() -> None:
    """The robot that has it and no other; what is not named is found on no robot."""
    lag = [secret("thruster_lag", robots=["a"])]
    found_on = [["a"], ["a", "b"], ["b"]]
    answers = [case("single", lag, [reported("thruster_lag") | {"robots": robots}]) for robots in found_on]
    assert [answer.right_robots() for answer in answers] == [True, False, False]
    assert case("single", lag, []).right_robots()


@pytest.mark.parametrize(
    ("said", "pattern", "right"),
    [
        ("unknown:surge~u*|u|^0.5", "unknown:surge~|u|^0.5*u", True),
        ("unknown:surge~u*u*u", "unknown:surge~u^3", True),
        ("unknown:surge~|u|*u", "unknown:surge~u^2", False),
        ("unknown:world_z~cos_t", "unknown:heave~sin_t", True),
        ("unknown:world_x~y", "unknown:world_y~y", False),
        ("unknown:compass~thrust", "unknown:compass~*thrust*", True),
        ("unknown:yaw~x", "unknown:yaw~*y*", False),
        ("steady_current", "unknown:world_x~1", False),
    ],
)
def test_one_law_has_several_names(said: str, pattern: str, right: bool) -> None:
    """Factors commute and powers add up; a sign that is lost, another axis or variable is another law."""
    from concealer.laws import matches

    assert matches(said, pattern) is right


def test_numbers_are_compared_for_the_mass_that_the_diagnosis_assumes() -> None:
    """A robot of 0.484 kg (10 % more) shows forces 10 % smaller to who believes in 0.44 kg, and torques unchanged."""
    from concealer.score import intervals

    trim = secret("buoyancy_trim", parameters={"force": 1.1e-3}, robots=["a"])
    true = {"mass": 0.484, "inertia": 4.05e-4, "drag": 2.2, "thrust_gain": 1.1, "yaw_torque_gain": 0.9}
    found = [
        {"parameter": "drag", "value": 2.01, "ci95": [1.95, 2.05], "robots": ["a"]},  # 2.2 / 1.1 = 2.0: inside
        {"parameter": "thrust_gain", "value": 1.1, "ci95": [1.05, 1.15], "robots": ["a"]},  # 1.0: outside
        {"parameter": "yaw_torque_gain", "value": 0.9, "ci95": [0.85, 0.95], "robots": ["a"]},  # inside
        {"parameter": "yaw_drag", "value": 1.0, "ci95": [0.9, 1.1], "robots": ["b"]},  # of nobody
    ]
    said = reported("buoyancy_trim", force=(1.01e-3, 0.95e-3, 1.05e-3))  # 1.1e-3 / 1.1 = 1.0e-3: inside
    one = case("single", [trim], [said], recalibrated=found)
    one.truth["vehicles"] = {"a": true}
    figures = intervals([one])
    counts = {key: (figures[key]["hits"], figures[key]["of"]) for key in figures if "coverage_of" in key}
    assert counts == {"coverage_of_effects": (1, 1), "coverage_of_platform": (2, 3)}
    assert figures["relative_error"]["median"] == pytest.approx(0.01)
    refitted = case("single", [trim], [said], recalibrated=[*found, {"parameter": "mass", "value": 0.484}])
    refitted.truth["vehicles"] = {"a": true}
    assert intervals([refitted])["coverage_of_effects"]["hits"] == 0  # now the force is 1.1e-3
    wrong = case("single", [trim], [reported("payload_shift")], recalibrated=found)
    wrong.truth["vehicles"] = {"a": true}
    assert intervals([wrong])["coverage_of_platform"]["of"] == 0  # numbers of a wrong model are not asked for


def test_a_vehicle_whose_envelope_tells_its_platform_is_scaled_by_that() -> None:
    """34 N of drag on 20 kg, told for the 17 kg of the file, are 28.9; a ratio and a number of no effect stay."""
    from concealer.score import intervals

    true = {
        "mass": 20.0, "inertia": 0.28, "drag": 20.0, "linear_drag.surge": 34.0, "anisotropic_drag.sway_ratio": 1.2,
        "assumed": {"mass": 17.0, "inertia": 0.28},
    }  # fmt: skip
    found = [
        {"parameter": "drag", "value": 17.0, "ci95": [16.9, 17.1], "robots": ["a"]},
        {"parameter": "linear_drag.surge", "value": 28.9, "ci95": [28.8, 29.0], "robots": ["a"]},
        {"parameter": "anisotropic_drag.sway_ratio", "value": 1.2, "ci95": [1.1, 1.3], "robots": ["a"]},
        {"parameter": "added_mass.yaw", "value": 1.0, "ci95": [0.9, 1.1], "robots": ["a"]},  # the envelope has none
    ]
    one = case("recalibration", [], [], "recalibrate", recalibrated=found)
    one.truth["vehicles"] = {"a": true}
    assert {key: (r["hits"], r["of"]) for key, r in intervals([one])["coverage_by_parameter"].items()} == {
        "platform.drag": (1, 1), "platform.linear_drag.surge": (1, 1), "platform.anisotropic_drag.sway_ratio": (1, 1),
    }  # fmt: skip


def test_weak_random_forces_have_rows_of_their_own() -> None:
    """Half a percent is not taken for none, nor 1.5 % for two."""
    from concealer.score import score

    cases = [case("single", [secret("tether")], []) for _ in range(3)]
    for one, noise in zip(cases, (0.0, 0.005, 0.015), strict=True):
        one.truth["noise"] = noise
    rates = score(cases)["table"]["rates"]
    assert [name for name in rates if name.startswith("exact, one medium effect, ")] == [
        f"exact, one medium effect, {noise} noise" for noise in ("0%", "0.5%", "1.5%")
    ]


def test_added_mass_ties_inertia_to_mass() -> None:
    """True: m 0.44 + 0.06 kg in surge, I 4e-4, A_r 1e-4. Known is (I + A_r) / 0.5 kg, so 4.4e-4 in all for 0.44 kg."""
    from concealer.estimates import of_effects

    hidden = secret("added_mass", parameters={"sway_minus_surge": 0.05, "yaw": 1e-4}, robots=["a"])
    said = reported("added_mass", sway_minus_surge=(0.044, 0.04, 0.05), yaw=(3.5e-5, 3e-5, 4e-5))
    one = case("single", [hidden], [said])
    one.truth["vehicles"] = {"a": {"mass": 0.44, "moving_mass": 0.5, "inertia": 4.0e-4}}
    truth = {name: value for name, value, _ in of_effects(one)}
    assert truth["added_mass.sway_minus_surge"] == pytest.approx(0.044)
    assert truth["added_mass.yaw"] == pytest.approx(4.4e-4 - 4.05e-4)


def test_a_trial_in_parts_is_scored_as_one(tmp_path: Path) -> None:
    """Parts have their own ledgers; the row of all sizes counts what the prior drew, not what was asked for."""
    from concealer.score import score_trial
    from concealer.seal import canonical, publish, seal

    for part in ("main", "medium"):
        truth = case("single", [secret("tether", unit="", robots=["a"])], None).truth | {"salt": "0" * 32}
        (tmp_path / part / "envelopes").mkdir(parents=True)
        (tmp_path / part / "envelopes" / "r.json").write_bytes(canonical(truth))
        publish(tmp_path / part, {"r": {"envelope": seal(truth)}})
        answer = tmp_path / "answers" / part / "r" / "diagnosis.json"
        answer.parent.mkdir(parents=True)
        answer.write_text(json.dumps({"verdict": "mismatch", "effects": [reported("tether")] * (part == "main")}))
    text = score_trial(tmp_path, tmp_path / "answers", tmp_path / "scores")
    rates = json.loads((tmp_path / "scores" / "scores.json").read_text())["table"]["rates"]
    assert (rates["exact, one effect, all sizes"]["hits"], rates["exact, one effect, all sizes"]["of"]) == (1, 1)
    assert (rates["exact, one medium effect, 1% noise"]["hits"], rates["diagnosis written"]["of"]) == (1, 2)
    assert "- medium/r  single" in text


def test_the_power_curve_finds_where_answers_turn_right() -> None:
    """Answers right above a tenth: half are right near a tenth; nothing is said of too few or one-sided answers."""
    from concealer.figures import power_curve

    sizes = [0.05 * 1.05**k for k in range(60)]
    curve = power_curve(sizes, [size > 0.1 for size in sizes])
    assert curve["half"] == pytest.approx(0.1, rel=0.15)
    assert curve["half"] < curve["nine_tenths"] < 0.3
    assert power_curve(sizes, [True] * 60) == {
        "of": 60, "half": None, "nine_tenths": None, "smallest_right": 0.05, "largest_wrong": None,
    }  # fmt: skip


def test_the_power_curve_is_the_logistic_one() -> None:
    """Chances of a logistic curve around 0.3, of slope 3 in the logarithm, reach nine tenths at 0.3 * 9^(1/3)."""
    import numpy as np
    from concealer.figures import power_curve

    rng = np.random.default_rng(0)
    sizes = np.exp(rng.uniform(math.log(0.05), 0.0, 4000))
    right = rng.random(4000) < 1.0 / (1.0 + (sizes / 0.3) ** -3.0)
    curve = power_curve(list(sizes), list(right))
    assert curve["half"] == pytest.approx(0.3, rel=0.05)
    assert curve["nine_tenths"] == pytest.approx(0.3 * 9 ** (1 / 3), rel=0.08)


def test_free_runs_are_compared_with_the_oracle_of_the_same_length() -> None:
    """The ratio is to the root mean square over robots of the oracle's error."""
    from concealer.score import held_out

    one = case(
        "single", [secret("tether")], [], fit={"held_out": {"position": {"recalibrated": 0.04, "augmented": 0.02}}}
    )
    one.truth["oracle"] = {r: {"20": {"position": p}} for r, p in (("a", 0.01), ("b", 0.03))}
    found = held_out([one], 20.0)
    assert found["position: augmented / oracle"]["median"] == pytest.approx(0.02 / math.sqrt(5e-4))
    assert found["position: augmented / recalibrated"]["median"] == pytest.approx(0.5)
    assert list(held_out([one], 10.0)) == ["position: augmented / recalibrated"]
    one.truth["oracle"] = {"a": {"20": {"position": 0.05, "position_alone": 0.04}}}
    assert held_out([one], 20.0)["position: augmented / oracle"]["median"] == pytest.approx(0.5)
    row = one.diagnosis["fit"]["held_out"]["position"]
    one.truth["oracle"]["a"]["2"] = {"position": 0.02, "position_alone": 0.01}
    row |= {"seconds": 2.0}  # what a diagnosis says of the length of its runs goes before
    assert held_out([one], 20.0)["position: augmented / oracle"]["median"] == pytest.approx(2.0)
    row |= {"against": "readings"}  # whose noise is in both errors
    assert held_out([one], 20.0)["position: augmented / oracle"]["median"] == pytest.approx(1.0)
    one.truth["noise"] = 0.0  # the oracle makes no error of its own
    assert "position: augmented / oracle" not in held_out([one], 20.0)


def test_a_whole_trial_is_scored_after_its_seals_are_checked(trial: Path, tmp_path: Path) -> None:
    """Files in, tables out; silent answers give no false alarm; a forged envelope is refused."""
    import shutil

    from concealer.score import score_trial

    answers = tmp_path / "answers"
    for name in ("r0000", "r0001", "r0002", "r0003"):
        (answers / name).mkdir(parents=True)
        (answers / name / "diagnosis.json").write_text(json.dumps({"verdict": "consistent", "effects": []}))
    text = score_trial(trial, answers, tmp_path / "scores")
    assert "4 concealed recordings" in text and "## Failures" in text
    rates = json.loads((tmp_path / "scores" / "scores.json").read_text())["table"]["rates"]
    assert rates["diagnosis written"]["rate"] == 1.0
    assert rates["false alarm, nothing concealed"]["hits"] == 0
    forged = shutil.copytree(trial, tmp_path / "forged")
    (forged / "envelopes" / "r0000.json").write_text("{}")
    with pytest.raises(ValueError, match="r0000"):
        score_trial(forged, answers, tmp_path / "other")
