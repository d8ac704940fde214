"""The page on real recordings: what is asked for, what is documented, words of findings, what went wrong."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

DOCS = Path(__file__).parents[2] / "docs"
Tree = dict[str, Any]


def effect(identifier: str, tier: str = "suspected", because: tuple[str, ...] = (), **numbers: tuple[Any, ...]) -> Tree:
    """An effect of one robot; numbers: value, ends of the interval, unit."""
    parameters = {name: {"value": v, "ci95": [*ends], "unit": unit} for name, (v, *ends, unit) in numbers.items()}
    tree = {"id": identifier, "tier": tier, "robots": ["r"], "parameters": parameters, "nats": 20.0}
    return tree | {"because": list(because), "ambiguous_with": []}


def diagnosis(verdict: str = "consistent", effects: tuple[Tree, ...] = (), **more: Any) -> Tree:
    """What is kept of a diagnosis, and how it ended."""
    kept = {"verdict": verdict, "effects": list(effects), "passed_over": [], "recalibrated": [], "warnings": []}
    return {"diagnosis": kept | {"held_out": {}} | more, "ended": {"status": 0, "seconds": 1.0, "said": ""}}


def group(one: Tree | None = None, other: Tree | None = None, again: Tree | None = None, **unseen: Any) -> Tree:
    """Figures of a group; unseen: error of the platform's file and of the found model by channel."""
    runs = {
        channel: {"nominal": nominal, "found": found, "seconds": 5.0, "windows": 4, "worse": 0.5}
        for channel, (nominal, found) in unseen.items()
    }
    said = {"one_half": one, "other_half": other, "same_again": again, "half_against_half": None}
    return {
        "platform": "lily",
        "recordings": {"one_half": ["a"], "other_half": ["b", "c"]},
        "diagnoses": {name: each or diagnosis() for name, each in said.items()},
        "unseen": runs,
    }


def figures(**groups: Tree) -> Tree:
    """Figures of groups, made by one command."""
    source = {"command": "prove.py real", "commit": "0" * 40, "of": list(groups)}
    return {"sources": [source], "groups": groups, "ships": {}, "thruster": {}}


BIAS = effect("torque_bias", "confirmed", torque=(1.0, 0.8, 1.2, "N m"))


@pytest.mark.parametrize(
    ("nominal", "found", "held", "told"),
    [
        (2.0, 1.9, True, "0.95: heading 0.95 (boat)"),
        (2.0, 2.0, True, "1.00: heading 1.00 (boat)"),
        (2.0, 5.0, False, "2.50: heading 2.50 (boat)"),
    ],
)
def test_the_worst_channel_of_the_worst_set(nominal: float, found: float, held: bool, told: str) -> None:
    """Headings count as positions do; a depth that is held at zero is no channel; a warning tells why."""
    from trial.real_musts import unseen_row

    boat = group(
        diagnosis(warnings=["Many readings are repeated.", "Foretells worse; its fit has collapsed."]),
        heading=(nominal, found),
        depth=(0.0, 0.0),
    )
    row = unseen_row(figures(boat=boat))
    assert (row.held, row.measured) == (held, told)
    why = "boat, heading: 2.50 (4 windows). Foretells worse; its fit has collapsed."
    assert row.why == (() if held else (why,))
    assert unseen_row(figures(boat=group())).held is None


def test_confirmed_effects_count_in_both_directions() -> None:
    """One that the held-out half alone confirms counts against the must, and is listed with its half."""
    from trial.real_musts import kept_row

    row = kept_row(figures(boat=group(diagnosis("mismatch"), diagnosis("mismatch", (BIAS,)))))
    assert row.held is False
    assert row.measured.startswith("0 of 1 = 0.0 %") and row.measured.endswith("the sign alone 0")
    assert row.why == ("boat, the other half: `torque_bias` is not named there",)
    both = diagnosis("mismatch", (BIAS,))
    assert kept_row(figures(boat=group(both, both))).measured.startswith("2 of 2 = 100.0 %")
    assert kept_row(figures(boat=group())).held is None


@pytest.mark.parametrize(("outcomes", "held"), [("r" * 18 + "bs", [True, True]), ("r" * 17 + "sww", [False, False])])
def test_altered_logs_and_their_controls(outcomes: str, held: list[bool]) -> None:
    """19 of 20 right or out of sight hold 90 %, 17 of 20 do not; 2 of 20 named as something else are more than 5 %."""
    from trial.real_musts import altered_rows

    words = {"r": "right", "b": "cannot be seen", "s": "silent", "w": "something else"}
    rows = [{"group": "boat", "way": f"gain_{k}", "outcome": words[o], "named": []} for k, o in enumerate(outcomes)]
    control = {"group": "boat", "way": "control", "outcome": "right", "named": []}
    right, other, controls = altered_rows([control, *rows])
    assert [right.held, other.held] == held
    assert controls.held is True and controls.measured.startswith("0 of 1")
    assert "of 20 drawn for 200" in right.measured
    assert len(right.why) == (0 if held[0] else 3)
    assert [row.held for row in altered_rows([])] == [None] * 3


def test_the_found_model_and_its_own_recordings() -> None:
    """Two of three are consistent: the third is told with what it names."""
    from trial.real_musts import again_row

    good, bad = group(), group(again=diagnosis("mismatch", (BIAS,)))
    row = again_row(figures(a=good, b=good, c=bad))
    assert row.measured.startswith("2 of 3 = 66.7 %")
    assert row.held is False
    assert row.why == ("c: mismatch, `torque_bias`. The diagnosis warned of nothing.",)
    assert again_row(figures(a=good)).held is True
    blind = again_row(figures(a=good, b=group(diagnosis("insufficient"), again=diagnosis("insufficient"))))
    assert blind.held is False  # not `consistent`, but nothing is found either
    assert blind.why == ("b: insufficient both times; the model that was found is the platform's file or hardly more.",)


def test_rows_of_single_sets() -> None:
    """Bars of wind, tanker and blimp by hand; a glider that is given a name fails."""
    from trial.real_musts import blimp_row, glider_row, tanker_row, wind_row

    wind = diagnosis("mismatch", (effect("wind", x=(1.0, 0.5, 1.5, "m/s")),))
    told = figures(
        esso_osaka_july=group(wind),
        rgblimp=group(position=(1.0, 0.08)),
        slocum_glider=group(diagnosis("mismatch", (BIAS,))),
    )
    told["ships"] = {
        "esso_osaka_july": {"anemometer": 2.0, "named": 1.0, "beside": 31.0},
        "kvlcc2_hsva": {"explained": {"u": 0.98, "v": 0.98, "r": 0.98}},
    }
    assert wind_row(told).measured == "31 deg (suspected; by the other half not named)"
    rows = [wind_row(told), tanker_row(told), blimp_row(told), glider_row(told)]
    assert [row.held for row in rows] == [False, True, True, False]
    empty = figures()
    assert [row(empty).held for row in (wind_row, tanker_row, blimp_row, glider_row)] == [None] * 4


def test_documented_causes_beside_what_was_said() -> None:
    """Named with intervals that hold the documented number or not, passed over, not named; what else is named."""
    from trial.documented import beside, is_named, said_of

    cause = {"names": ["linear_drag"], "numbers": {"surge": 0.03, "yaw": 1.0}}
    drag = effect("linear_drag", surge=(0.02, 0.01, 0.04, "N s/m"), yaw=(0.0, -0.5, 0.5, "N m s"))
    said = diagnosis("mismatch", (drag, BIAS))["diagnosis"]
    assert said_of(cause, said) == "suspected: `linear_drag`, holds 0.03 (surge), does not hold 1 (yaw)"
    assert is_named(cause, said) and beside([cause], said) == ["`torque_bias`"]
    passed = diagnosis(passed_over=[drag])["diagnosis"]
    assert said_of(cause, passed) == "passed over: `linear_drag`" and not is_named(cause, passed)
    assert said_of(cause, diagnosis()["diagnosis"]) == "not named"
    assert said_of(cause, None) == "no diagnosis"


def test_every_group_has_its_documents_and_every_name_is_an_effect() -> None:
    """Groups are those of the driver; causes have a source and names that a diagnosis can give."""
    from trial.documented import causes_by_group

    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES

    causes = causes_by_group()
    assert set(json.loads((DOCS / "real.json").read_text())["groups"]) == set(causes)
    names = {entry.id: {a.name for a in entry.amplitudes} for entry in ENTRIES}
    for cause in (each for some in causes.values() for each in some):
        assert cause["what"] and cause["source"] and cause["names"]
        assert all(name in names or name.startswith("unknown:") for name in cause["names"])
        assert all(set(cause.get("numbers", {})) <= names[name] for name in cause["names"] if cause.get("numbers"))


def test_words_of_findings() -> None:
    """Intervals stand beside numbers; nothing is told as perhaps nothing but what is; other reasons stand as given."""
    from trial.real_words import digits, effect_line, passed_over_line, recalibrated_line

    assert [digits(value) for value in (None, "flipped", 0.01234, 12345.0, 1.2e7)] == [
        "-", "flipped", "0.0123", "12300", "1.2e+07",
    ]  # fmt: skip
    assert effect_line(BIAS) == "`torque_bias` (20 nats, confirmed): torque 1 N m (0.8 to 1.2)"
    vague = effect("torque_bias", because=("Its size may as well be nothing: the interval holds zero.",))
    assert effect_line(vague).endswith("; its size may as well be nothing")
    flipped = effect("frame_mixup", correction=("its sign is flipped", None, None, None))
    assert effect_line(flipped).endswith(": correction its sign is flipped")
    refused = effect("tether", because=("Free runs do not gain by it: something like it is missing.",))
    assert passed_over_line(refused) == "passed over, `tether` (20 nats): Free runs do not gain by it"
    assert passed_over_line(vague | {"parameters": BIAS["parameters"]}) == (
        "passed over, `torque_bias` (20 nats), torque 1 N m (0.8 to 1.2): Its size may as well be nothing"
    )
    moved = {"parameter": "drag", "nominal": 10.0, "value": 12.0, "ci95": [11.0, 13.0], "unit": "kg/m"}
    assert recalibrated_line([moved]) == "the platform's own numbers: drag 12 kg/m (11 to 13) for 10"


def test_words_of_warnings_are_those_of_the_tool() -> None:
    """The page looks for two of its sentences: they are still there."""
    from trial.real_musts import AT_A_BOUND, COLLAPSED
    from trial.real_words import MAY_BE_NOTHING

    from cocorosim_ros.diagnosis.showing import doubt, hard_stops

    text = Path(hard_stops.__file__).read_text("utf-8")
    assert COLLAPSED in text and AT_A_BOUND in text and MAY_BE_NOTHING in text
    assert MAY_BE_NOTHING in doubt.MAY_BE_NOTHING and MAY_BE_NOTHING not in doubt.GAINS_TOO_LITTLE


def test_all_failures_are_listed() -> None:
    """One of each kind, and none where all is well."""
    from trial.real_failures import failures

    worse = {"heading": {"nominal": 1.0, "augmented": 2.0, "unit": "rad"}}
    one = diagnosis("mismatch", (BIAS,), held_out=worse, warnings=["It is worse; its fit has collapsed."])
    bad = group(one, again=diagnosis("insufficient"), heading=(1.0, 2.0))
    bad["diagnoses"]["half_against_half"] = {"diagnosis": None, "ended": {"status": None, "said": "no answer"}}
    text = "\n".join(failures(figures(tauv_pool=bad)))
    for line in (
        "- tauv_pool, the halves compared: no answer",
        "- tauv_pool, one half: `torque_bias` is not named there",
        "- tauv_pool: added mass",
        "- tauv_pool, heading: 2.00 (4 windows). It is worse; its fit has collapsed.",
        "- tauv_pool, one half, heading: 2 for 1 rad",
        "- tauv_pool: insufficient",
        "- tauv_pool, one half: It is worse; its fit has collapsed.",
    ):
        assert line in text
    assert "- " not in "\n".join(failures(figures(boat=group())))


def test_figures_of_other_groups_are_kept(tmp_path: Path) -> None:
    """What is made again takes the old one's place, with its source; a number that is none is null in the file."""
    from trial.real_figures import merged, nothing, read, write

    file = tmp_path / "real.json"
    assert read(file) == nothing()
    earlier = figures(ship=group(), boat=group())
    new = figures(boat=group(position=(float("nan"), 1.0)))
    new["sources"][0]["commit"] = "1" * 40
    write(file, merged(earlier, new))
    found = read(file)
    assert [source["of"] for source in found["sources"]] == [["ship"], ["boat"]]
    assert list(found["groups"]) == ["ship", "boat"]
    assert found["groups"]["boat"]["unseen"]["position"]["nominal"] is None
    assert merged(figures(boat=group()), new)["sources"] == new["sources"]


def test_what_was_not_tried_has_no_section() -> None:
    """Neither ships nor thruster have a head without figures; a group of the page has its row in every table."""
    from trial.real_page import page_of
    from trial.thruster import FORMS, LARGEST

    told = figures(tauv_pool=group(heading=(1.0, 0.5), one=diagnosis(held_out={"heading": {"nominal": 1.0}})))
    text = page_of(told, [])
    assert not any("actuator by itself" in line or "model ships" in line for line in text)
    assert sum(line.startswith("| tauv_pool | ") for line in text) == 5
    told["thruster"] = {"T": dict.fromkeys((LARGEST, *FORMS), 1.0)}
    assert any(line.startswith("| T | 1.0 | 1.00 |") for line in page_of(told, []))


def test_the_driver_keeps_what_every_diagnosis_said(tmp_path: Path) -> None:
    """Figures of a group have its four diagnoses by what they are of; one that is not there has how it ended."""
    from trial.real import learn, replay
    from trial.real_figures import ENDINGS, group_figures
    from trial.recordings import Group

    pair = Group("boat", "lily", (tmp_path / "a",)), Group("boat_held_out", "lily", (tmp_path / "b",))
    tasks = [*learn(pair, tmp_path), replay(pair, tmp_path)]
    for task, verdict in zip(tasks[:3], ("one", "two", "three"), strict=True):
        task.out.mkdir(parents=True)
        said = {"verdict": verdict, "effects": [BIAS | {"name": "a bias"}], "mismatch": [1, 2]}
        (task.out / "diagnosis.json").write_text(json.dumps(said))
        task.outcome.write_text(json.dumps({"name": task.name, "status": 0, "seconds": 1.0, "said": ""}))
    found = group_figures(pair, tmp_path)["diagnoses"]
    assert set(found) == set(ENDINGS)
    verdicts = [(found[name]["diagnosis"] or {}).get("verdict") for name in ENDINGS]
    assert verdicts == ["one", "two", None, "three"]
    assert found["one_half"]["diagnosis"]["effects"] == [BIAS]
    assert found["same_again"]["ended"]["said"] == "not tried"


def test_the_page_is_written_of_the_figures() -> None:
    """docs/real.md is what `prove.py real-page --pages docs` writes of docs/real.json and docs/against.json."""
    from trial.real_figures import read
    from trial.real_page import page_of

    altered = json.loads((DOCS / "against.json").read_text("utf-8"))
    text = page_of(read(DOCS / "real.json"), altered)
    assert (DOCS / "real.md").read_text("utf-8").split("\n") == text, "run: prove.py real-page --pages docs"
