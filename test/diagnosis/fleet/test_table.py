"""The rows of a fleet and its Parquet file."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest

from cocorosim_ros.diagnosis.fleet.outcome import Outcome
from cocorosim_ros.diagnosis.fleet.rows import rows_of
from cocorosim_ros.diagnosis.fleet.table import parquet_bytes, table_of

Make = Callable[..., Any]
ASYMMETRY = {
    "id": "thruster_asymmetry", "name": "", "equation": "", "robots": ["lily_01"], "tier": "confirmed", "because": [],
    "parameters": {"difference": {"value": -0.1, "ci95": [-0.11, -0.09], "unit": "1"}}, "nats": 62.0,
    "ambiguous_with": [{"id": "torque_bias", "nats_behind": 2.0}],
}  # fmt: skip


def read(outcomes: Any) -> Any:
    """The table of outcomes, as it comes back from its file."""
    return pq.read_table(io.BytesIO(parquet_bytes(table_of(rows_of(outcomes)))))


def test_a_row_has_what_was_found(outcome: Make) -> None:
    """Numbers with intervals, effects with theirs, what was not shown, and when it was."""
    made = outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001), "thrust_gain": (0.0, 0.01)}, [ASYMMETRY])
    (row,) = read([made]).to_pylist()
    assert (row["robot"], row["verdict"], row["recording_verdict"], row["nats"]) == (
        "lily_01",
        "mismatch",
        "mismatch",
        62,
    )
    assert row["start"].isoformat() == "2023-11-15T22:13:20+00:00" and row["dated_by"] == "stamps"
    assert row["drag"] == pytest.approx(1.7778 * np.exp(0.1)) and row["drag_low"] < row["drag"] < row["drag_high"]
    assert (row["drag_nominal"], row["drag_moved"], row["thrust_gain_moved"]) == (1.7778, True, False)
    (found,) = row["effects"]
    assert (found["id"], found["tier"], found["ambiguous_with"]) == ("thruster_asymmetry", "confirmed", ["torque_bias"])
    assert found["parameters"] == [{"name": "difference", "value": -0.1, "low": -0.11, "high": -0.09, "unit": "1"}]
    assert (row["not_shown"], row["probabilities"], row["problem"]) == (["tether"], None, None)


def test_probabilities_are_taken_where_they_are(outcome: Make) -> None:
    """A diagnosis with probabilities of suspects fills their column."""
    made = outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001)}, diagnosis={"probabilities": {"tether": 0.9, "x": 0.1}})
    assert read([made]).to_pylist()[0]["probabilities"] == [("tether", 0.9), ("x", 0.1)]


def test_a_robot_that_lacks_something_without_a_name_has_a_mismatch(outcome: Make) -> None:
    """Of the robot alone, and only where something is missing without it."""
    for missing, verdict in ((True, "mismatch"), (False, "recalibrate")):
        passed = [{"id": "tether", "robots": ["lily_01"], "missing": missing}]
        made = outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001)}, diagnosis={"passed_over": passed})
        assert read([made]).to_pylist()[0]["verdict"] == verdict
        other = outcome("a", "lily_02", 1.0, {"drag": (0.1, 0.001)}, diagnosis={"passed_over": passed})
        assert read([other]).to_pylist()[0]["verdict"] == "recalibrate"


def test_every_column_says_what_it_is(outcome: Make) -> None:
    """Its meaning, and its unit where it has one."""
    schema = read([outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001)})]).schema
    assert all(field.metadata[b"meaning"] for field in schema)
    assert schema.field("drag_low").metadata[b"unit"] == b"kg/m" and schema.field("duration").metadata[b"unit"] == b"s"


def test_the_order_of_completion_changes_nothing(drawn_fleet: Make) -> None:
    """The same bytes, whatever was finished first, how long it took and whether a process died."""
    made = drawn_fleet(np.random.default_rng(11), 5, 4)
    other = [replace(each, seconds=9.0, attempts=2, ended="was killed") for each in reversed(made)]
    assert parquet_bytes(table_of(rows_of(made))) == parquet_bytes(table_of(rows_of(other)))


def test_robots_of_one_recording_have_rows_of_their_own(outcome: Make) -> None:
    """The verdict about each is its own; a robot without numbers could not tell."""
    made = outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001)}, [ASYMMETRY], robots=["lily_01", "lily_02", "lily_03"])
    made.found["numbers"].append({**made.found["numbers"][0], "robots": ["lily_02"]})
    rows = read([made]).to_pylist()
    assert [(row["robot"], row["verdict"]) for row in rows] == [
        ("lily_01", "mismatch"),
        ("lily_02", "consistent"),
        ("lily_03", "insufficient"),
    ]
    assert rows[1]["effects"] == [] and rows[2]["drag"] is None


def test_a_recording_without_a_diagnosis_is_a_row_with_a_sentence(outcome: Make) -> None:
    """So is a copy of another one, which would count twice."""
    good = outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001)})
    copy = outcome("b", "lily_01", 1.0, {"drag": (0.1, 0.001)}, sha256="a")
    rows = read([copy, Outcome("c", (), "c is no recording; give another."), good]).to_pylist()
    assert [row["problem"] for row in rows][::2] == [None, "c is no recording; give another."]
    assert "b is a copy of a, byte by byte" in rows[1]["problem"]
    assert rows[1]["robot"] is rows[2]["verdict"] is rows[2]["drag"] is None


def test_nothing_at_all() -> None:
    """A fleet of which nothing is there yet has an empty table."""
    assert read([]).num_rows == 0


def test_what_the_vehicle_cannot_have_is_not_told_as_not_shown(outcome: Make) -> None:
    """A Lily has no cable: no diagnosis looks for its drag, so that no better recording would show it."""
    blind = {
        "not_shown_by_this_recording": ["wind", "pump_lag"],
        "screened": {"pump_lag": {}, "wall_effect": {}},
    }
    made = outcome("a", "lily_01", 1.0, {"drag": (0.1, 0.001)}, diagnosis=blind)
    assert read([made]).to_pylist()[0]["not_shown"] == ["pump_lag"]


@pytest.mark.parametrize(("verdict", "told"), [("mismatch", "mismatch"), ("insufficient", "insufficient")])
def test_what_free_runs_alone_lack_is_a_mismatch_of_the_robot(outcome: Make, verdict: str, told: str) -> None:
    """As it is of the recording, though nothing has a name; of a fit that cannot tell it says nothing."""
    lacking = {"verdict": verdict, "missing_in": ["position"]}
    made = outcome("a", "lily_01", 1.0, {"drag": (0.0, 0.1)}, diagnosis=lacking)
    assert read([made]).to_pylist()[0]["verdict"] == told
