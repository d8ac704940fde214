"""Every mistake in a map or a log is one sentence that says where it is and what to do."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from cocorosim_ros.foundation.errors import CocorosimError

Convert = Callable[..., SimpleNamespace]
GOOD = """\
  - files: a.csv
    time: {column: t, unit: s}
    robot: boat
    streams:
      pose: {x: {column: x, unit: m}, y: {column: y, unit: m}, z: {fixed: 0 m}, yaw: {fixed: 0 deg}}
"""
LOG = "t,x,y\n0,1,2\n1,2,3\n"


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("column: x, unit", "column: xx, unit",
         r"map.yaml line 8: .*streams.pose.x.column' has 'xx', no column of a.csv; did you mean 'x'. Allowed: t, x"),
        ("column: x, unit", "column: 4, unit", "a.csv has only 3 columns"),
        ("{column: x, unit: m}", "{column: x}", "streams.pose.x' lacks 'unit'; add one of 'm', 'cm' or 'mm'"),
        ("{column: x, unit: m}", "{column: x, unit: deg}", "has 'deg', which is no unit of this number; allowed: 'm'"),
        ("streams:\n      pose: {", "streams: {}\n    #", "is empty, so there is nothing to convert"),
        ("pose: {", "attitude: {", "is no topic that can be converted; allowed: pose, compass"),
        ("z: {fixed: 0 m}, ", "", "needs either 'z' or 'depth'"),
        ("yaw: {fixed: 0 deg}", "roll: {fixed: 0 deg}", "lacks 'yaw' or a quaternion"),
        ("robot: boat", "robot: 7up", "has '7up', no name for ROS"),
        ("robot: boat", "robot: {prefix: b_}", "has a prefix but no 'column'"),
        ("time: {column: t, unit: s}", "time: {unit: s}", "must say when in exactly one way"),
        ("time: {column: t, unit: s}", "time: {clock: t, form: '%d.%m.%Y'}",
         r"a.csv line 2, column 't' has '0', which is no time like '%d.%m.%Y'; correct it"),
        ("time: {column: t, unit: s}", "time: {clock: t}", "lacks 'form'"),
        ("unit: s}", "unit: m}", "has 'm', which is no unit of this number"),
        ("files: a.csv", "files: b.csv", "holds no file like 'b.csv'"),
        ("files: a.csv", 'files: "a.csv"\n    axis: 1', "'tables\\[0\\].axis' is not a known key"),
    ],
)  # fmt: skip
def test_a_wrong_map(convert_csv: Convert, old: str, new: str, sentence: str) -> None:
    """One piece of a good map replaced: the sentence names the place and the way out."""
    assert old in GOOD
    with pytest.raises(CocorosimError, match=sentence) as caught:
        convert_csv(GOOD.replace(old, new, 1), {"a.csv": LOG})
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("log", "sentence"),
    [
        ("t,x,y\n0,1,2\n1,two,3\n", r"a.csv line 3, column 'x' has 'two', which is no number"),
        ("t,x,y\n", "a.csv holds no row of numbers"),
        ("", "a.csv holds no row of numbers"),
        ("t,x,y\n-5,1,2\n", r"a.csv line 2 has the time -5 s.*add 'start'"),
        ("t,x,y\n0,1,2\n1e300,1,2\n", r"a.csv line 3 has the time 1e\+300 s, and a recording lies between"),
        ("t,x,y\n1e999999999,1,2\n", r"a.csv line 2, column 't' has '1e999999999', which is no number"),
        ("t,x,y\nnoon,1,2\n", r"a.csv line 2, column 't' has 'noon'"),
        ("t,x,x,y\n0,1,2,3\n", "the name of several columns of a.csv; give a number"),
        ("t,x,y\n0,nan,2\n", "finds nothing to convert in the source: .*1 row with missing"),
    ],
)
def test_a_wrong_log(convert_csv: Convert, log: str, sentence: str) -> None:
    """File, line and column are named, lines counted as an editor does."""
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(GOOD, {"a.csv": log})


@pytest.mark.parametrize(
    ("word", "sentence"),
    [
        (
            "excel",
            "has 'excel', which is not read: such a file is an Excel file; save it as CSV; allowed: csv, parquet",
        ),
        ("xlsx", "has 'xlsx', which is not read: such a file is an Excel file; save it as CSV"),
        (
            "hdf5",
            "an HDF5 file; open it with h5py .`pip install h5py`. and write its columns as CSV or Parquet; allowed",
        ),
        ("zip", "is a zip archive; unpack it and give what is in it; allowed"),
        ("pickle", "save it as Parquet, npz or CSV: a pickle can run code; allowed"),
        ("cvs", "has 'cvs'; did you mean 'csv'"),
        ("mcap", "has 'mcap'.*by `cocorosim convert`|has 'mcap'.*format: bag"),
    ],
)
def test_a_format_that_is_not_read(tmp_path: Path, word: str, sentence: str) -> None:
    """What to do with such a file is said, beside the formats that are read."""
    from cocorosim_ros.wire.conversion.map_file import load_map

    (tmp_path / "map.yaml").write_text(f"name: test\nformat: {word}\ntables:\n{GOOD}")
    with pytest.raises(CocorosimError, match=sentence):
        load_map(tmp_path / "map.yaml")


def test_pulses_below_stop(convert_csv: Convert) -> None:
    """A thruster without reverse that is asked to turn backwards is an error, not a silent zero."""
    tables = GOOD[: GOOD.index("pose:")] + "thruster_command: {a: {column: x, unit: us, stop: 1.1 ms, forward: 2 ms}}\n"
    with pytest.raises(CocorosimError, match="gives no 'reverse'"):
        convert_csv(tables, {"a.csv": "t,x,y\n0,1050,0\n"})


def test_the_same_number_twice(convert_csv: Convert) -> None:
    """Two tables that give the same actuator at different rates contradict each other."""
    one = GOOD[: GOOD.index("pose:")] + 'thruster_command: {a: {column: x, unit: "1"}}\n'
    two = one.replace("{a:", '{b: {column: y, unit: "1"}, a:')
    with pytest.raises(CocorosimError, match="is given by several tables"):
        convert_csv(one + two, {"a.csv": "t,x,y\n0,0,0\n"})


def test_the_command(tmp_path: Path) -> None:
    """`convert` writes the recording and says what it holds; a wrong source is a sentence."""
    from cocorosim_ros.commands.convert import command

    (tmp_path / "a.csv").write_text(LOG)
    (tmp_path / "map.yaml").write_text(f"name: m\nformat: csv\ntables:\n{GOOD}")
    call = [str(tmp_path / "map.yaml"), str(tmp_path / "a.csv"), "--out", str(tmp_path / "bag")]
    result = CliRunner().invoke(command, call)
    assert result.exit_code == 0, result.output
    assert "/boat/pose: 2 messages in 1.000 s, 1 Hz, longest gap 1 s" in result.output
    assert (tmp_path / "bag" / "metadata.yaml").exists()
    call[1] = str(tmp_path / "absent.csv")
    assert isinstance(CliRunner().invoke(command, [*call, "--force"]).exception, CocorosimError)
    assert (tmp_path / "bag" / "metadata.yaml").exists()


@pytest.mark.parametrize("first", [0, 1])
def test_a_pressure_of_depths_and_one_of_a_sensor(convert_csv: Convert, first: int) -> None:
    """The two are read by different weights of water, so that one topic cannot hold both, in whichever order."""
    head = GOOD[: GOOD.index("pose:")]
    numbers = ("{depth: {column: x, unit: m}}", "{pressure: {column: x, unit: bar}}")
    tables = [f"{head}pressure: {number}\n" for number in numbers]
    both = tables[first] + tables[1 - first].replace("a.csv", "b.csv")
    later = LOG.replace("\n0,", "\n2,").replace("\n1,", "\n3,")
    with pytest.raises(CocorosimError, match="boat/pressure is given as 'depth' by one table and as 'pressure'"):
        convert_csv(both, {"a.csv": LOG, "b.csv": later})
