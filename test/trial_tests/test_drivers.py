"""The drivers of the trial: seeds, seals before answers, the table that is asked for, judgements of altered logs."""

from __future__ import annotations

import hashlib
import json
import math
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Tool = Callable[[str], Path]


def test_the_seed_follows_from_a_public_word() -> None:
    """SHA-256 of "abc" begins ba7816bf8f01cfea (FIPS 180-2); a bit is dropped, so that it is a positive integer."""
    from trial.provenance import seed_of

    assert seed_of("abc") == 0xBA7816BF8F01CFEA >> 1
    assert 0 <= seed_of("abd") < 2**63


def test_parts_make_two_hundred_nulls_out_of_four_hundred() -> None:
    """The prior draws a quarter nulls and a tenth that only moved; the other parts add to 200 each."""
    from trial.parts import parts

    counts = {part.name: part.count for part in parts(400, [])}
    assert counts == {"main": 400, "nothing": 100, "recalibration": 160, "medium_1": 60, "medium_3": 60}
    assert 0.25 * 400 + counts["nothing"] == 200 and 0.10 * 400 + counts["recalibration"] == 200
    assert [part.name for part in parts(8, ["main", "medium_1"])] == ["main", "medium_1"]


def test_a_trial_is_sealed_diagnosed_and_scored(tool: Tool, tmp_path: Path) -> None:
    """A tool that always says "consistent" is silent on the nulls and names nothing; resumed, it is not asked again."""
    from trial import sealed
    from trial.examiner import Terms
    from trial.parts import Part
    from trial.sealed_text import page

    answer = json.dumps({"verdict": "consistent", "effects": []})
    runs = tool(
        f'test -f {tmp_path}/trial/main/ledger.json && mkdir -p "$out" && echo \'{answer}\' > "$out/diagnosis.json"'
    )
    words = ("--duration", "40", "--robots", "1")
    some = [Part("main", 1, (*words, "--effects", "tether")), Part("nothing", 1, (*words, "--kind", "nothing"))]
    for _ in range(2):
        folders = [sealed.conceal(tmp_path, part, 5, 1) for part in some]
        todo = [task for folder in folders for task in sealed.tasks(tmp_path, folder)]
        outcomes = sealed.diagnose(todo, Terms(limit=20.0))
    assert [o.status for o in outcomes] == [0, 0]
    assert runs.read_text().split() == ["ran"] * 2
    ledger = (tmp_path / "trial" / "main" / "ledger.json").read_bytes()
    assert sealed.digests(folders)["main"] == hashlib.sha256(ledger).hexdigest()
    score = sealed.score(tmp_path, outcomes, 20.0)
    rates = score["figures"]["table"]["rates"]
    assert rates["exact, one effect, all sizes"]["hits"] == 0
    assert (rates["false alarm, nothing concealed"]["hits"], rates["diagnosis written"]["hits"]) == (0, 2)
    some_tried = sealed.score(tmp_path, outcomes[:1], 20.0)["figures"]
    assert some_tried["recordings"] == 1
    text = page(score, {"commit": "0" * 40}, outcomes)
    assert "| false alarm where nothing is concealed | 0/1 = 0.0% (0.0 to 79.3 %) | at most 1% | 0.0% | yes |" in text
    assert "main/r0000  single" in text


def test_families_are_sealed_before_the_tool_runs(tool: Tool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The hash of the families is written down before the tool is asked; page and figures have it, and its table."""
    from trial import parts, prove

    out, pages = tmp_path / "out", tmp_path / "pages"
    answer = json.dumps({"verdict": "consistent", "effects": []})
    runs = tool(
        f'grep -q families {out}/provenance.json && mkdir -p "$out" && echo \'{answer}\' > "$out/diagnosis.json"'
    )
    short = ("--families", "a word", "--duration", "40", "--robots", "1")
    monkeypatch.setattr(parts, "families_parts", lambda _count, _word: [parts.Part("families", 2, short)])
    words = [
        "families",
        "--count",
        "2",
        "--seed-word",
        "a word",
        "--jobs",
        "1",
        "--out",
        str(out),
        "--pages",
        str(pages),
    ]
    options = prove.parser().parse_args(words)
    assert options.run(options) == 0
    assert runs.read_text().split() == ["ran"] * 2
    told = json.loads((pages / "trial_families.json").read_text())
    digest = hashlib.sha256(json.dumps(told["families_table"], sort_keys=True).encode()).hexdigest()
    assert digest == told["source"]["families"]
    assert digest in (pages / "trial_families.md").read_text()
    envelopes = [json.loads(path.read_text()) for path in (out / "trial" / "families" / "envelopes").glob("*.json")]
    assert [envelope["families"]["table"] for envelope in envelopes] == [digest] * 2
    assert told["families"]["right answers of all kinds, sealed or open"]


def test_parts_of_families_share_a_word() -> None:
    """Half as many with drawn forms, a quarter outside the catalogue; each part is given the word."""
    from trial.parts import families_parts

    parts = families_parts(16, "a word")
    assert [(part.name, part.count) for part in parts] == [
        ("families", 16), ("families_forms", 8), ("families_outside", 4),
    ]  # fmt: skip
    assert all(part.words[:2] == ("--families", "a word") for part in parts)


def test_parts_are_equally_far_at_any_time(tmp_path: Path) -> None:
    """Of four and two tasks, the first three hold two and one."""
    from trial.examiner import Task
    from trial.sealed import shuffled_evenly

    parts = [[Task(f"{name}{k}", (), tmp_path) for k in range(count)] for name, count in (("a", 4), ("b", 2))]
    assert [task.name for task in shuffled_evenly(parts)] == ["a0", "b0", "a1", "a2", "b1", "a3"]


def test_the_asked_table_says_where_the_least_does_not_hold() -> None:
    """19 of 20 hold 95 %, 18 of 20 do not; 1 of 50 false alarms is too many; sizes and ratios are compared too."""
    from trial.sealed_text import asked_table

    def rate(hits: int, of: int) -> dict[str, Any]:
        return {"hits": hits, "of": of, "rate": hits / of, "low": 0.0, "high": 1.0}

    rates = {
        "exact, one medium effect, 1% noise": rate(18, 20), "exact, one medium effect, 3% noise": rate(19, 20),
        "false alarm, nothing concealed": rate(1, 50), "false alarm, recalibration only": rate(0, 50),
    }  # fmt: skip
    figures = {
        "table": {"rates": rates, "ambiguity_set_size": 1.25},
        "intervals": {"coverage": rate(97, 100), "coverage_of_effects": rate(91, 100)},
        "held_out": {"position: augmented / oracle": {"median": 1.08, "lower": 1.0, "upper": 1.2, "of": 9}},
    }  # fmt: skip
    lines = asked_table(figures)
    held = {line.split(" | ")[0].strip("| "): line.split(" | ")[-1].strip("| ") for line in lines[2 : lines.index("")]}
    assert "what_may_be_believed.md" in lines[-2]  # why rows fall short
    assert held == {
        "exact naming, one medium effect, random force 1 % of thrust": "no", "the same at 3 %": "yes",
        "truth in the ambiguity set": "-", "mean size of the ambiguity set": "yes", "first named effect wrong": "-",
        "false alarm where nothing is concealed": "no", "false alarm where only parameters moved": "yes",
        "two effects, both and nothing else": "-", "outside the catalogue: flagged": "-",
        "outside the catalogue: named as an entry of it": "-", "recordings that cannot tell: abstains": "-",
        "95 % intervals that hold the truth": "yes",
        "the same, of effects alone": "no",
        "held-out free run, position, against a model that knows the truth": "no",
    }  # fmt: skip


def said(name: str, key: str = "", value: float = 0.0, half: float = 0.0, topic: str | None = None) -> dict[str, Any]:
    """A diagnosis with one effect."""
    numbers = {key: {"value": value, "ci95": [value - half, value + half], "unit": ""}} if key else {}
    return {"effects": [{"id": name, "topic": topic, "parameters": numbers, "ambiguous_with": []}]}


@pytest.mark.parametrize(
    ("control", "tampered", "right"),
    [
        ({"effects": []}, said("thruster_asymmetry", "difference", -0.17), True),  # -0.162 was put in
        ({"effects": []}, said("thruster_asymmetry", "difference", 0.17), False),  # the other way round
        (said("thruster_asymmetry", "difference", 0.1), said("thruster_asymmetry", "difference", -0.06), True),
        (said("thruster_asymmetry", "difference", 0.1), said("thruster_asymmetry", "difference", 0.1), False),
        ({"effects": []}, said("torque_bias"), False),
        ({"effects": []}, None, False),
    ],
)
def test_what_was_altered_is_judged_against_the_control(control: Any, tampered: Any, right: bool) -> None:
    """The left log times 0.85 is a left thruster stronger by 2 (1/0.85 - 1) / (1/0.85 + 1) = 0.162, beside what was."""
    from trial.ways import WAYS, judged

    way = WAYS["hovercraft_epfl"][0]
    assert (way.how, way.amount) == ("gain:0", -0.15) and math.isclose(way.change, -0.3 / 1.85)
    assert judged(control, tampered, way)["right"] is right


def test_what_is_not_right_is_said_to_be_so() -> None:
    """Effects neither put in nor in the control, what was said to be out of sight, and what was passed over."""
    from trial.ways import WAYS, judged

    way, none = WAYS["hovercraft_epfl"][0], {"effects": []}
    unseen = none | {"not_shown_by_this_recording": ["thruster_asymmetry"]}
    assert judged(none, said("steady_current") | unseen | said("steady_current"), way)["outcome"] == "named wrongly"
    assert judged(said("steady_current"), said("steady_current"), way)["outcome"] == "missed"
    assert judged(none, unseen, way)["outcome"] == "cannot be seen"
    assert judged(none, None, way)["outcome"] == "no diagnosis"


def test_a_late_pose_may_be_a_lag_where_there_is_nothing_else() -> None:
    """What was of the thrusters before and what is of the pose now count together."""
    from trial.ways import WAYS, judged

    way = next(way for way in WAYS["hovercraft_epfl"] if way.how == "delay:pose")
    before = said("thruster_lag", "time_constant", 0.07)
    assert judged(before, said("thruster_lag", "time_constant", 0.12), way)["right"]
    assert judged(before, said("sensor_latency", "latency", 0.115, topic="pose"), way)["right"]
    assert judged(before, before, way)["outcome"] == "missed"


def test_a_stream_is_judged_by_its_topic() -> None:
    """A mirrored compass is a frame mix-up of the compass that the control does not have."""
    from trial.ways import WAYS, judged

    mirror = next(way for way in WAYS["haizhe_auv"] if way.how == "mirror")
    none: dict[str, Any] = {"effects": []}
    assert judged(none, said("frame_mixup", topic="compass"), mirror)["right"]
    assert not judged(none, said("frame_mixup", topic="imu"), mirror)["right"]
    assert not judged(said("frame_mixup", topic="compass"), said("frame_mixup", topic="compass"), mirror)["right"]


def test_every_way_is_one_of_the_concealers() -> None:
    """The Concealer's own truth of a way is the effect and the number that the driver looks for."""
    from concealer.tamper import plan
    from trial.ways import WAYS

    for way in [way for ways in WAYS.values() for way in ways]:
        topic, _, truth = plan(way.how, way.amount)
        assert truth["id"] == way.effect and way.topic in (None, topic)
        if way.parameter and way.effect != "camera_scale":
            assert truth["parameters"][way.parameter] == pytest.approx(way.change)


def test_every_draw_is_one_of_the_concealers() -> None:
    """The Concealer alters the stream whose effect the driver looks for, whatever the amount."""
    from concealer.tamper import plan
    from trial.draws import SETS, WHOLE

    for draw in [draw for data_set in SETS for draw in data_set.ways]:
        way = draw.drawn(random.Random(1))
        topic, _, truth = plan(way.how, way.amount)
        assert way.topic in (None, topic)
        if way.effect not in ("thruster_gain", WHOLE, "command_delay"):  # told otherwise by the Concealer
            assert truth["id"] == way.effect


def test_a_hidden_stream_is_nothing_to_be_found() -> None:
    """Silence is right, and any name is wrong; a gain of one thruster is told by its factor."""
    from trial.against import judged
    from trial.draws import way_of

    none = {"effects": [], "recalibrated": [], "not_shown_by_this_recording": []}
    hidden = way_of("hidden:velocity", 1.0)
    assert judged(none, hidden)["outcome"] == "right"
    assert judged(none | said("steady_current"), hidden)["outcome"] == "something else"
    gain = way_of("gain:2", -0.2, "down")
    assert judged(none | said("thruster_gain", "down", 1.25), gain)["outcome"] == "right"
    assert judged(none | said("thruster_gain", "down", 1.4), gain)["outcome"] == "something else"
    assert judged(none | said("thruster_gain", "ahead", 1.25), gain)["outcome"] == "something else"


def test_data_sets_are_asked_for_by_name(tmp_path: Path) -> None:
    """One that there is not is said, with those that there are; one whose folder is not there makes no group."""
    from trial.against import halves
    from trial.real import groups

    with pytest.raises(ValueError, match="boat is not a data set of real recordings; there are hovercraft_epfl"):
        groups(tmp_path, tmp_path, ["boat"])
    assert groups(tmp_path, tmp_path, ["rgblimp"]) == []
    with pytest.raises(ValueError, match="boat is not a data set of altered logs; there are hovercraft_epfl"):
        halves(tmp_path, tmp_path, ["boat"])
    assert halves(tmp_path, tmp_path, ["rgblimp"]) == []
