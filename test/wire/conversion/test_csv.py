"""CSV files of known content arrive in the recording as they are, each number where it belongs."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Convert = Callable[..., SimpleNamespace]
POSE = "{x: {column: x, unit: m}, y: {column: y, unit: m}, z: {fixed: -1 m}, yaw: {fixed: 0 rad}}"
TIME = "time: {column: t, unit: s}"
LONG = 1554973784843524933  # ns, more digits than a float has
S = 1_000_000_000  # ns
SHA256 = "f57c0a1187fc672127aa7f0c9a2dbb35ebc6aedbe8b3b7061201218a97372813"  # printf 't,x,y\\n0,1,1\\n' | sha256sum


def table(rest: str, streams: str = f"pose: {POSE}", robot: str = "boat", files: str = '"*.csv"') -> str:
    """One table of a map."""
    return f"  - {{files: {files}, robot: {robot}, {rest}, streams: {{{streams}}}}}\n"


def test_pose_round_trip(convert_csv: Convert) -> None:
    """Positions, depth in cm, yaw in degrees and stamps come back exactly."""
    streams = (
        "pose: {x: {column: x, unit: m}, y: {column: 3, unit: mm, scale: -1, offset: 1 m}, "
        "depth: {column: d, unit: cm}, yaw: {column: yaw, unit: deg}}"
    )
    text = "t;x;y;d;yaw\n# a comment\n0,5;1,25;250;57;90\n0,75;-2;0;0;-180\n"
    layout = 'layout: {separator: ";", decimal: ",", comment: "#"}'
    found = convert_csv(table(f"{TIME}, {layout}", streams), {"log.csv": text}).topics["/boat/pose"]
    first, second = (message.content.pose for message in found)
    assert [message.at for message in found] == [500_000_000, 750_000_000]
    assert (first.position.x, first.position.y, first.position.z) == (1.25, 0.75, -0.57)
    assert (second.position.x, second.position.y, second.position.z) == (-2.0, 1.0, 0.0)
    assert (first.orientation.z, first.orientation.w) == (math.sin(math.pi / 4), math.cos(math.pi / 4))
    assert found[0].content.header.frame_id == "world"
    assert second.orientation.z == -1.0


def test_instruments(convert_csv: Convert) -> None:
    """Compass wrapped, depth as absolute pressure, rates in rad/s; axes that were not measured are no numbers."""
    streams = (
        "compass: {heading: {column: h, unit: deg}}, pressure: {depth: {column: d, unit: m}}, "
        "imu: {rate_z: {column: w, unit: deg/s}}, velocity: {x: {column: u, unit: cm/s}}"
    )
    topics = convert_csv(table(TIME, streams), {"a.csv": "t,h,d,w,u\n1,270,2,180,5\n"}).topics
    imu = topics["/boat/imu"][0].content
    velocity = topics["/boat/velocity"][0].content
    assert topics["/boat/compass"][0].content.heading == pytest.approx(-math.pi / 2)
    assert topics["/boat/pressure"][0].content.fluid_pressure == 101325 + 1000 * 9.81 * 2
    assert imu.angular_velocity.z == pytest.approx(math.pi)
    assert math.isnan(imu.angular_velocity.x)
    assert imu.linear_acceleration_covariance[0] == imu.orientation_covariance[0] == -1
    assert imu.angular_velocity_covariance[0] == 0
    assert (velocity.twist.linear.x, velocity.header.frame_id) == (0.05, "boat/base_link")
    assert math.isnan(velocity.twist.linear.y)


@pytest.mark.parametrize(
    ("time", "cells", "stamps"),
    [
        ("{column: 1, unit: ns}", [str(LONG), str(LONG + 1)], [LONG, LONG + 1]),
        ("{column: 1, unit: ms}", ["0.5", "1e3"], [500_000, 1_000_000_000]),
        ("{column: 1, unit: us, start: 2 s}", ["7", "8"], [2_000_007_000, 2_000_008_000]),
        ("{row_rate: 3 Hz}", ["0", "0", "0", "0"], [0, 333_333_333, 666_666_667, 1_000_000_000]),
        ("{counter: 1, rate: 25 Hz}", ["1.0", "4"], [40_000_000, 160_000_000]),
        ("{columns: [{column: 1, unit: s}, {column: 2, unit: ns}]}", ["12,5", "12,9"], [12 * S + 5, 12 * S + 9]),
        ("{clock: 1, form: '%d.%m.%Y %H.%M.%S'}", ["01.01.1970 00.01.05.5"], [131 * S // 2]),
        ("{clock: 1, form: '%Y-%m-%d %H:%M:%S'}", ["1970-01-01 00:00:02.5", "1970-01-01 00:00:3"], [5 * S // 2, 3 * S]),
        ("{clock: 1, form: '%Y/%m/%dT%H:%M:%S', fraction: ns, ahead: 2 h, start: 1 s}",
         ["1970/01/01T02:00:07.25", "1970/01/01T02:00:07.134398244"], [8 * S + 25, 8 * S + 134_398_244]),
    ],
)  # fmt: skip
def test_every_way_to_tell_time(convert_csv: Convert, time: str, cells: list[str], stamps: list[int]) -> None:
    """Time from a column in any unit, two columns, the row number, a counter, a clock: exact to the nanosecond."""
    streams = "compass: {heading: {fixed: 0 rad}}"
    rows = "\n".join(cells)
    topics = convert_csv(table(f"time: {time}, layout: {{header: false}}", streams), {"a.csv": rows}).topics
    assert [message.at for message in topics["/boat/compass"]] == stamps


def test_gaps_stay_and_missing_rows_are_counted(convert_csv: Convert) -> None:
    """A row without a number is left out and said; nothing is put into the gap."""
    result = convert_csv(table(TIME), {"a.csv": "t,x,y\n0,1,1\n1,nan,1\n2,,1\n,1,1\n3,inf,1\n9,2\n90,2,2\n"})
    assert [message.at for message in result.topics["/boat/pose"]] == [0, 90_000_000_000]
    told = " ".join(result.findings)
    assert "4 rows with missing or infinite numbers were left out" in told
    assert "1 row without a time was left out" in told
    assert "1 row ends early; its last cells count as missing" in told


@pytest.mark.parametrize(
    ("text", "line", "cells", "way_out"),
    [
        ("t,x,y\n0,1,2\n0,5,1,5,2,5\n", 3, 6, "write the file again with points or with another separator"),
        ("t,x,y\n0,1,2,3\n", 2, 4, "else correct the line"),
        ("t;x;y\n0;1;2\n1;2;3;4\n", 3, 4, "correct the line, or 'separator' in the map's layout"),
    ],
)
def test_rows_longer_than_the_header(convert_csv: Convert, text: str, line: int, cells: int, way_out: str) -> None:
    """Decimals with commas between commas would be numbers of other columns, taken in silence."""
    rest = TIME if ";" not in text else f"{TIME}, layout: {{separator: ';'}}"
    with pytest.raises(CocorosimError, match=rf"a.csv line {line} has {cells} cells and its header 3, .*{way_out}"):
        convert_csv(table(rest), {"a.csv": text})


@pytest.mark.parametrize("text", ["t,x,y\n0,1,2,\n1,2,3, \n", "t,x,y,\n0,1,2,\n1,2,3,\n", "t,x,y,\n0,1,2,,\n1,2,3\n"])
def test_empty_cells_behind_the_last(convert_csv: Convert, text: str) -> None:
    """A separator at the end of lines, with or without the header, is no further cell."""
    rows = convert_csv(table(TIME), {"a.csv": text}).topics["/boat/pose"]
    assert [(row.content.pose.position.x, row.content.pose.position.y) for row in rows] == [(1, 2), (2, 3)]


def test_time_backwards_is_refused_or_sorted(convert_csv: Convert) -> None:
    """The sentence says where and by how much; `sort` sorts and says so; the bag has growing stamps."""
    files = {"a.csv": "t,x,y\n0,0,0\n2,2,2\n1.5,1,1\n3,3,3\n"}
    with pytest.raises(CocorosimError, match=r"boat/pose: time runs backwards at 1 place, first by 0\.5 s, 2 s after"):
        convert_csv(table(TIME), files)
    result = convert_csv(table(f"{TIME}, backwards: sort"), files)
    assert [message.content.pose.position.x for message in result.topics["/boat/pose"]] == [0, 1, 2, 3]
    assert "the rows were sorted" in result.findings[0]


@pytest.mark.parametrize("backwards", ["refuse", "sort"])
@pytest.mark.parametrize(
    ("files", "told"),
    [
        (('"a.csv"', '"b.csv"'), r"a.csv \(tables\[0\]\) and by b.csv \(tables\[1\]\)"),
        (('"*.csv"',), r"a.csv \(tables\[0\]\) and by b.csv \(tables\[0\]\)"),
        (('"a.csv"', '"a.csv"'), r"a.csv \(tables\[0\]\) and by a.csv \(tables\[1\]\)"),
    ],
)
def test_two_sources_of_one_topic(convert_csv: Convert, files: tuple[str, ...], told: str, backwards: str) -> None:
    """Two tables or files tell of the same time: sorted, the boat would leap from one place to another and back."""
    tables = "".join(table(f"{TIME}, backwards: {backwards}", files=each) for each in files)
    logs = {"a.csv": "t,x,y\n0,0,0\n2,2,2\n3,3,3\n", "b.csv": "t,x,y\n1,9,9\n2.5,8,8\n5,0,0\n"}
    with pytest.raises(CocorosimError, match=f"boat/pose is given by {told} for the same [23] s; give it by one"):
        convert_csv(tables, logs)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_utf_16(convert_csv: Convert, tmp_path: Path, encoding: str) -> None:
    """With and without a mark at its begin, and whatever the map says of it: Latin letters are none of it."""
    (tmp_path / "logs").mkdir()
    (tmp_path / "logs" / "a.csv").write_bytes("t,x,y\n0,1,2\n".encode(encoding))
    for layout in ("", ", layout: {encoding: latin-1}"):
        with pytest.raises(CocorosimError, match=r"a\.csv is UTF-16 text; save it as UTF-8"):
            convert_csv(table(TIME + layout), {})


def test_pieces_that_meet(convert_csv: Convert) -> None:
    """The last moment of one file may be the first of the next."""
    logs = {"a.csv": "t,x,y\n0,0,0\n2,2,2\n", "b.csv": "t,x,y\n2,2,2\n5,0,0\n"}
    rows = convert_csv(table(TIME), logs).topics["/boat/pose"]
    assert [row.at for row in rows] == [0, 2 * S, 2 * S, 5 * S]


def test_robots_from_a_column(convert_csv: Convert) -> None:
    """1 and 1.0 are the same robot; each robot has its own rows in their order."""
    robot = "{prefix: fish_, column: id, digits: 2}"
    topics = convert_csv(table(TIME, robot=robot), {"a.csv": "t,id,x,y\n0,1.0,5,0\n0,2,7,0\n1,1,6,0\n"}).topics
    found = {topic: [message.content.pose.position.x for message in rows] for topic, rows in topics.items()}
    assert found == {"/fish_01/pose": [5, 6], "/fish_02/pose": [7]}


def test_one_file_for_each_robot_and_parts_of_a_log(convert_csv: Convert) -> None:
    """{robot} tells robots apart, * puts parts behind each other."""
    files = {"r3/a.csv": "t,x,y\n0,1,0\n", "r3/b.csv": "t,x,y\n1,2,0\n", "r4/a.csv": "t,x,y\n0,9,0\n"}
    topics = convert_csv(table(TIME, robot="{prefix: lily_, digits: 2}", files='"r{robot}/*.csv"'), files).topics
    found = {topic: [message.content.pose.position.x for message in rows] for topic, rows in topics.items()}
    assert found == {"/lily_03/pose": [1, 2], "/lily_04/pose": [9]}


def test_several_runs_become_several_recordings(
    convert_csv: Convert, messages: Callable[..., dict[str, list[SimpleNamespace]]]
) -> None:
    """Each run of a folder has its own recording; a file alone is its own run."""
    files = {"run_a.csv": "t,x,y\n0,1,0\n", "run_b.csv": "t,x,y\n0,2,0\n"}
    mapped = table(TIME, files='"run_{run}.csv"')
    done = convert_csv(mapped, files).done
    assert [entry.folder.name for entry in done] == ["a", "b"]
    assert messages(done[1].folder)["/boat/pose"][0].content.pose.position.x == 2
    one = convert_csv(mapped, files, "run_b.csv", "one")
    assert [message.content.pose.position.x for message in one.topics["/boat/pose"]] == [2]


def test_one_file_of_two_tables(convert_csv: Convert) -> None:
    """What is named is read alone, by every table that it fits."""
    tables = table(TIME) + table(TIME, "compass: {heading: {fixed: 0 rad}}")
    result = convert_csv(tables, {"a.csv": "t,x,y\n0,1,1\n", "b.csv": "t,x,y\n1,2,1\n"}, "b.csv")
    assert {topic: [message.at for message in found] for topic, found in result.topics.items()} == {
        "/boat/pose": [S], "/boat/compass": [S]
    }  # fmt: skip


def test_commands_from_pulse_widths(convert_csv: Convert) -> None:
    """1500 us is stop, 1900 full ahead, 1100 full astern; a dead zone stays in; beyond the limits is cut and said."""
    streams = "thruster_command: {left: {column: p, unit: us, stop: 1500 us, forward: 1900 us, reverse: 1100 us}}"
    result = convert_csv(table(TIME, streams), {"a.csv": "t,p\n0,1500\n1,1520\n2,1900\n3,1300\n4,2300\n"})
    commands = [message.content.command[0] for message in result.topics["/boat/thruster_command"]]
    np.testing.assert_allclose(commands, [0, 0.05, 1, -0.5, 1], atol=1e-12)
    assert "1 command beyond -1..1 was cut" in result.findings[0]


def test_uneven_limits(convert_csv: Convert) -> None:
    """With full ahead at 400 above and full astern at 200 below stop, each side has its own scale."""
    streams = "thruster_command: {left: {column: p, unit: us, stop: 1500 us, forward: 1900 us, reverse: 1300 us}}"
    topics = convert_csv(table(TIME, streams), {"a.csv": "t,p\n0,1700\n1,1400\n"}).topics
    commands = [message.content.command[0] for message in topics["/boat/thruster_command"]]
    np.testing.assert_allclose(commands, [0.5, -0.5], atol=1e-12)


def test_actuators_in_files_of_their_own(convert_csv: Convert) -> None:
    """Two rates in two files: at every change both, the other as it last was; before both are known, nothing."""
    mapped = table(TIME, 'thruster_command: {left: {column: c, unit: "1"}}', files="left.csv")
    mapped += table(TIME, 'thruster_command: {right: {column: c, unit: "%"}}', files="right.csv")
    result = convert_csv(mapped, {"left.csv": "t,c\n0,0.1\n1,0.2\n3,0.3\n", "right.csv": "t,c\n0.5,50\n3,-100\n"})
    found = [(message.at / 1e9, *message.content.command) for message in result.topics["/boat/thruster_command"]]
    assert found == [(0.5, 0.1, 0.5), (1.0, 0.2, 0.5), (3.0, 0.3, -1.0)]
    assert result.topics["/boat/thruster_command"][0].content.name == ["left", "right"]
    assert "1 moment before all actuators are known" in result.findings[0]


def test_white_space_and_skipped_lines(convert_csv: Convert) -> None:
    """Columns apart by any white space, after lines that are no table."""
    layout = "layout: {separator: space, skip: 2, missing: [lost]}"
    result = convert_csv(table(f"{TIME}, {layout}"), {"a.csv": "Logger 3\n\nt   x y\n0  1\t2\n1 lost 3\n"})
    assert [message.content.pose.position.y for message in result.topics["/boat/pose"]] == [2]


def test_what_it_was_made_from(convert_csv: Convert) -> None:
    """The recording knows its sources by sha256, the map's text and the findings, and is the same each time."""
    from cocorosim_ros.wire.bags.bag_reader import read_bag

    files = {"a.csv": "t,x,y\n0,1,1\n"}
    first = convert_csv(table(TIME), files).done[0]
    metadata = read_bag(first.folder).summary.metadata["cocorosim"]
    assert json.loads(metadata["converted_from"]) == {"a.csv": SHA256}
    assert "format: csv" in metadata["conversion_map"]
    assert metadata["digest"] == first.digest
    content = (first.folder / "bag_0.mcap").read_bytes()
    again = convert_csv(table(TIME), files, force=True).done[0]
    assert again.digest == first.digest
    assert (again.folder / "bag_0.mcap").read_bytes() == content


def test_nothing_is_overwritten_or_left_behind(convert_csv: Convert, tmp_path: Path) -> None:
    """A recording that is there stays without --force, and a conversion that fails leaves no folder."""
    with pytest.raises(CocorosimError, match="is no number"):
        convert_csv(table(TIME), {"a.csv": "t,x,y\n0,1,abc\n"})
    assert not (tmp_path / "bag").exists()
    convert_csv(table(TIME), {"a.csv": "t,x,y\n0,1,1\n"})
    with pytest.raises(CocorosimError, match="exists already"):
        convert_csv(table(TIME), {"a.csv": "t,x,y\n0,2,1\n"})
    with pytest.raises(CocorosimError, match="is no number"):
        convert_csv(table(TIME), {"a.csv": "t,x,y\n0,1,abc\n"}, force=True)
    assert (tmp_path / "bag" / "metadata.yaml").exists()


def test_several_recordings_are_not_replaced_by_one(convert_csv: Convert, tmp_path: Path) -> None:
    """One run is the folder itself, several are folders below it: these are named, and stay, even with --force."""
    of_runs = table(TIME, files='"{run}.csv"')
    logs = {f"r{run}.csv": f"t,x,y\n0,{run},1\n" for run in range(4)}
    several = convert_csv(of_runs, logs).done
    assert [made.folder for made in several] == [tmp_path / "bag" / f"r{run}" for run in range(4)]
    told = r"bag holds whole recordings \('r0', 'r1', 'r2', \.\.\.\), as a conversion of several runs leaves them"
    with pytest.raises(CocorosimError, match=rf"{told}.*; .*choose another folder, or remove this one first\."):
        convert_csv(table(TIME), {"a.csv": "t,x,y\n0,1,1\n"}, source="a.csv", force=True)
    assert all((made.folder / "metadata.yaml").exists() for made in several)
    (tmp_path / "bag" / "thesis.tex").write_text("years of work")
    with pytest.raises(CocorosimError, match=r"bag holds 'thesis\.tex', which is no part of a recording"):
        convert_csv(table(TIME), {"a.csv": "t,x,y\n0,1,1\n"}, source="a.csv", force=True)
