"""Files beside others: to each row the nearest of another file, which must be there, once, and clearly named."""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Convert = Callable[..., SimpleNamespace]
TIME = "time: {column: t, unit: s}"
TURN = 'beside: {turn: {files: "{run}/yaw.csv", within: 0.4 s}}'
SHARED = "beside: {turn: {files: yaw.csv, within: 0.4 s}}"
PLACE, YAW = "t,x\n1,10\n", "t,yaw\n1,0.5\n"


def table(rest: str, streams: str, files: str = '"{run}/place.csv"') -> str:
    """One table of a map."""
    return f"  - {{files: {files}, robot: boat, {rest}, streams: {{{streams}}}}}\n"


TURNED = "pose: {x: {column: x, unit: m}, y: {fixed: 0 m}, z: {fixed: 0 m}, yaw: {column: turn.yaw, unit: rad}}"


def test_a_file_beside(convert_csv: Convert) -> None:
    """Each row takes the nearest of the other file of its own run; else it is left out and counted."""
    beside = 'beside: {turn: {files: "{run}/yaw.csv", within: 0.4 s}}'
    files = {
        "a/place.csv": "t,x\n1,10\n2,20\n3,30\n", "a/yaw.csv": "t,yaw\n0.9,0.25\n2.1,0.5\n3.5,0.75\n",
        "b/place.csv": "t,x\n1,40\n", "b/yaw.csv": "t,yaw\n1,1\n",
    }  # fmt: skip
    result = convert_csv(table(f"{TIME}, {beside}", TURNED, files='"{run}/place.csv"'), files)
    first, second = (entry.conversion.streams[0].rows.values for entry in result.done)
    assert first[:, 0].tolist() == [10, 20]
    np.testing.assert_allclose(2 * np.arcsin(first[:, 5]), [0.25, 0.5], atol=1e-15)
    np.testing.assert_allclose(second[:, [0, 5]], [[40, np.sin(0.5)]], atol=1e-15)
    assert "1 row with missing" in result.findings[0]
    assert set(json.loads(result.done[0].conversion.metadata["converted_from"])) == {"a/place.csv", "a/yaw.csv"}


def test_no_file_beside(convert_csv: Convert) -> None:
    """The pattern and what it should stand beside are said."""
    beside = "beside: {turn: {files: yaw.csv, within: 1 s}}"
    with pytest.raises(CocorosimError, match=r"beside.turn' finds no file like 'yaw.csv' beside place.csv; it must be"):
        convert_csv(table(f"{TIME}, {beside}", TURNED, files="place.csv"), {"place.csv": "t,x\n1,1\n"})


def turned(result: SimpleNamespace) -> dict[str, float]:
    """The yaw of each run's first pose."""
    return {each.conversion.run: 2 * np.arcsin(each.conversion.streams[0].rows.values[0, 5]) for each in result.done}


def test_another_run_may_lack_its_file(convert_csv: Convert) -> None:
    """Only what is converted is asked for its neighbours, whether a run or one file of several is named."""
    files = {"a/place.csv": PLACE, "a/yaw.csv": YAW, "b/place.csv": PLACE}
    assert turned(convert_csv(table(f"{TIME}, {TURN}", TURNED), files, "a/place.csv")) == {"a": pytest.approx(0.5)}
    with pytest.raises(CocorosimError, match=r"finds no file like '{run}/yaw.csv' beside b/place.csv"):
        convert_csv(table(f"{TIME}, {TURN}", TURNED), files, "", "all")


def test_another_robot_may_lack_its_file(convert_csv: Convert) -> None:
    """One robot's file is converted alone."""
    rest = f'{TIME}, beside: {{turn: {{files: "{{robot}}_yaw.csv", within: 1 s}}}}'
    tables = table(rest, TURNED, files='"{robot}_place.csv"').replace("robot: boat", "robot: {prefix: b_}")
    files = {"1_place.csv": PLACE, "1_yaw.csv": YAW, "2_place.csv": PLACE}
    assert list(convert_csv(tables, files, "1_place.csv").topics) == ["/b_1/pose"]
    with pytest.raises(CocorosimError, match=r"beside 2_place.csv; it must be exactly one"):
        convert_csv(tables, files, "", "all")


def test_a_file_beside_every_run(convert_csv: Convert) -> None:
    """A file without {run} in its name is of every run, as a table and beside one."""
    files = {"a/place.csv": PLACE, "b/place.csv": PLACE, "yaw.csv": YAW}
    assert turned(convert_csv(table(f"{TIME}, {SHARED}", TURNED), files)) == {
        "a": pytest.approx(0.5), "b": pytest.approx(0.5)
    }  # fmt: skip


@pytest.mark.parametrize("word", ["{run}", "{robot}"])
def test_a_word_that_the_table_lacks(convert_csv: Convert, word: str) -> None:
    """What {run} or {robot} stands for is known from the table's own file alone, so the map is refused."""
    rest = f'{TIME}, beside: {{turn: {{files: "{word}/yaw.csv", within: 1 s}}}}'
    with pytest.raises(CocorosimError, match=rf"beside.turn.files' has {word}, and the table's own 'files' "):
        convert_csv(table(rest, TURNED, files="place.csv"), {"place.csv": PLACE, "1/yaw.csv": YAW})


@pytest.mark.parametrize(
    ("header", "column", "yaw"), [(False, "turn.2", "1,0.5\n"), (True, "turn.2", YAW), (True, "turn.2", "2,t\n0.5,1\n")]
)
def test_a_numbered_column_beside(convert_csv: Convert, header: bool, column: str, yaw: str) -> None:
    """The number counts the columns of the file beside, unless one is called so."""
    rest = f"time: {{column: {'t' if header else 1}, unit: s}}, {SHARED}, layout: {{header: {str(header).lower()}}}"
    streams = TURNED.replace("turn.yaw", column).replace("column: x", "column: 2")
    if yaw.startswith("2"):
        streams = streams.replace("column: 2,", "column: x,")
    files = {"place.csv": PLACE if header else "1,10\n", "yaw.csv": yaw}
    assert turned(convert_csv(table(rest, streams, files="place.csv"), files)) == {"": pytest.approx(0.5)}


@pytest.mark.parametrize(
    ("column", "sentence"),
    [
        ("turn.yw", r"has 'turn.yw', no column of yaw.csv; did you mean 'turn.yaw'\? Allowed: t, x, turn.t, turn.yaw"),
        (
            "trn.yaw",
            r"has 'trn.yaw', no column of place.csv; did you mean 'turn.yaw'\? Allowed: t, x, turn.t",
        ),
        ("turn.3", "has 'turn.3', and yaw.csv has only 2 columns"),
        ("turn.0", "has 'turn.0', no column of yaw.csv"),
    ],
)
def test_a_wrong_column_beside(convert_csv: Convert, column: str, sentence: str) -> None:
    """Sentences show the column as the map has it, and what there is in all files."""
    with pytest.raises(CocorosimError, match=rf"pose.yaw.column' {sentence}"):
        convert_csv(
            table(f"{TIME}, {SHARED}", TURNED.replace("turn.yaw", column), files="place.csv"),
            {"place.csv": PLACE, "yaw.csv": YAW},
        )


def test_a_column_called_like_one_beside(convert_csv: Convert) -> None:
    """Which of the two is meant cannot be known."""
    with pytest.raises(CocorosimError, match=r"'turn.yaw', a column of place.csv, and 'yaw' of yaw.csv beside it"):
        convert_csv(
            table(f"{TIME}, {SHARED}", TURNED, files="place.csv"),
            {"place.csv": "t,x,turn.yaw\n1,10,0.25\n", "yaw.csv": YAW},
        )


def test_damage_is_told_once(convert_csv: Convert) -> None:
    """Of a file that is read as a table and stands beside one."""
    rest = f'{TIME}, beside: {{turn: {{files: "{{run}}/place.csv", within: 0.1 s}}}}'
    result = convert_csv(table(rest, TURNED), {"a/place.csv": "t,x,yaw\n1,2,3\n2,5\n"})
    assert [told for told in result.findings if "ends early" in told] == [
        "a/place.csv: 1 row ends early; its last cells count as missing."
    ]
