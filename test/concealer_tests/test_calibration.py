"""Reliability and Brier's score against hand computation and closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest


def secret(name: str, **more: Any) -> dict[str, Any]:
    """A hidden effect as an envelope has it."""
    return {"id": name, "topic": None, "size": 0.5} | more


def case(hidden: list[dict[str, Any]], **told: float) -> Any:
    """A case of a diagnosis that tells probabilities; `_and_` stands for " + ", `_` alone for a space in two names."""
    from concealer.cases import Case

    names = {
        name.replace("_and_", " + ").replace("something_else", "something else"): each for name, each in told.items()
    }
    diagnosis = {"verdict": "mismatch", "effects": [], "probabilities": names}
    return Case({"recording": "r", "kind": "single", "effects": hidden, "noise": 0.01}, diagnosis)


def test_briers_score_by_hand() -> None:
    """Brier (1950), for three answers: certain and right 0, certain and wrong 2, all alike 2/3."""
    from concealer.calibration import brier

    assert brier({"a": 1.0, "b": 0.0, "c": 0.0}, "a") == 0.0
    assert brier({"a": 1.0, "b": 0.0, "c": 0.0}, "b") == 2.0
    assert brier(dict.fromkeys("abc", 1.0 / 3.0), "c") == pytest.approx(2.0 / 3.0)
    assert brier({"a": 0.7, "b": 0.2, "c": 0.1}, "a") == pytest.approx(0.09 + 0.04 + 0.01)


def test_the_parts_of_the_score_add_up() -> None:
    """Murphy's identity is exact where all forecasts of a class are equal: 0.2 and 0.8, ten and five times."""
    from concealer.calibration import parts_of_brier

    forecast, happened = [0.2] * 10 + [0.8] * 5, [True] * 3 + [False] * 7 + [True] * 4 + [False]
    parts = parts_of_brier(forecast, happened)
    assert parts["reliability"] == pytest.approx((10 * 0.1**2 + 5 * 0.0**2) / 15)
    assert parts["resolution"] == pytest.approx((10 * (0.3 - 7 / 15) ** 2 + 5 * (0.8 - 7 / 15) ** 2) / 15)
    assert parts["uncertainty"] == pytest.approx(7 / 15 * 8 / 15)
    assert parts["score"] == pytest.approx(parts["reliability"] - parts["resolution"] + parts["uncertainty"])


def test_told_as_it_happens_is_reliable() -> None:
    """Events drawn with the probability that was told: rates that hold it, and the expected score, p (1 - p)."""
    from concealer.calibration import parts_of_brier, reliability

    rng = np.random.default_rng(3)
    forecast = rng.uniform(size=20000)
    happened = rng.uniform(size=20000) < forecast
    rows = reliability(list(zip(forecast.tolist(), happened.tolist(), strict=True)))
    assert sum(row["of"] for row in rows) == 20000 and len(rows) == 8
    assert all(abs(row["rate"] - row["mean"]) < 4.0 * np.sqrt(0.25 / row["of"]) for row in rows)
    parts = parts_of_brier(forecast.tolist(), happened.tolist())
    assert parts["score"] == pytest.approx(1.0 / 6.0, abs=0.005)  # integral of p (1 - p) from 0 to 1
    assert parts["reliability"] < 0.001
    sure = reliability([(min(1.0, 1.5 * p), bool(o)) for p, o in zip(forecast, happened, strict=True)])
    assert sure[-1]["rate"] < sure[-1]["mean"] - 0.1  # the check can fail: too sure of itself


def test_an_edge_belongs_to_the_class_above() -> None:
    """0, 0.02, 0.9 and 1: the last class holds 1 too."""
    from concealer.calibration import EDGES, classes

    assert classes(np.array([0.0, 0.02, 0.9, 0.97, 1.0])).tolist() == [0, 1, 6, 7, len(EDGES) - 2]


@pytest.mark.parametrize(
    ("hidden", "right"),
    [
        ([], "nothing"),
        ([secret("tether")], "tether"),
        ([secret("battery_sag")], "something else"),
        ([secret("tether"), secret("pump_lag")], "pump_lag + tether"),
        ([secret("tether"), secret("battery_sag")], "tether + something else"),
        ([secret("tether"), secret("pump_lag"), secret("battery_sag")], "tether + something else"),
        ([secret("pump_lag"), secret("battery_sag")], "something else"),
        ([secret("unknown:yaw~x")], "something else"),
        ([secret("unknown:surge~u^3", twins=["tether"])], "tether"),
        ([secret("tether"), secret("unknown:yaw~x")], "tether + something else"),
        ([secret("tether"), secret("tether")], "tether + something else"),
    ],
)
def test_what_came_true(hidden: list[dict[str, Any]], right: str) -> None:
    """A set is right if it is what is hidden, whole; something else completes a set, or stands for one not told."""
    from concealer.calibration import came_true

    told = {"tether": 0.4, "tether_and_something_else": 0.2, "pump_lag_and_tether": 0.2, "something_else": 0.15}
    assert came_true(case(hidden, **told, nothing=0.05)) == right


def test_each_named_effect_by_hand() -> None:
    """A right name of two robots counts once, a wrong one and a law where there is none are wrong."""
    from concealer.calibration import calibration

    one = case([secret("tether")], tether=0.7, something_else=0.2, nothing=0.1)
    named = [("tether", 0.95), ("tether", 0.6), ("pump_lag", 0.92), ("unknown:yaw~x", 0.4)]
    one.diagnosis["effects"] = [{"id": name, "probability": share} for name, share in named]
    rows = {row["from"]: (row["mean"], row["hits"], row["of"]) for row in calibration([one])["by_effect"]}
    assert rows == {0.3: (0.4, 0, 1), 0.9: (pytest.approx(0.935), 1, 2)}


def test_the_figures_of_four_recordings_by_hand() -> None:
    """Two right and one wrong at 0.8, one that tells no probability; the table is written."""
    from concealer.calibration import calibration
    from concealer.score_text import probabilities_text

    told = {"tether": 0.8, "something_else": 0.1, "nothing": 0.1}
    cases = [case([secret("tether")], **told), case([secret("tether")], **told), case([], **told), case([])]
    found = calibration(cases)
    assert found["recordings"] == 3
    right, wrong = 0.04 + 0.01 + 0.01, 0.64 + 0.01 + 0.81
    assert found["brier"]["mean"] == pytest.approx((2 * right + wrong) / 3)
    assert found["brier_of_certainty"]["mean"] == pytest.approx(2 / 3)
    (row,) = found["by_most_probable"]
    assert (row["hits"], row["of"], row["mean"]) == (2, 3, pytest.approx(0.8))
    assert [(row["hits"], row["of"]) for row in found["by_any"]] == [(1, 6), (2, 3)]
    assert {name: (row["hits"], row["of"]) for name, row in found["by_answer"].items()} == {
        "effects by name": (2, 3), "nothing": (1, 3), "something else": (0, 3)
    }  # fmt: skip
    text = "\n".join(probabilities_text(found))
    assert "| 70.0 % to 90.0 % | 80.0 % | 66.7 % | 2/3 |" in text
    assert calibration([case([])]) == {} and probabilities_text({}) == []
