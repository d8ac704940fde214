"""The sample recording that ships, whole and damaged: nominal Lilys without noise, of which nothing is missing."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from mcap.reader import make_reader

import cocorosim_ros as cocorosim
from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RobotLog
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.platform import load_platform

BAG = Path(__file__).parents[2] / "bags" / "five_lilys" / "bag"
CUT = (50.0, 63.0)  # s after the begin
IN_A_TURN = (60.5, 73.0)  # s: there a buoyancy gain was called moved to 1.0025
CHUNK_HEAD = 200  # bytes; so far from its begin a chunk of MCAP holds messages
STOPPED = ("pose", "imu")


def outside(time: Floats, cut: tuple[float, float]) -> Flags:
    """Flags (m,) of the times that are not cut out."""
    return (time <= cut[0]) | (time >= cut[1])


def without_a_chunk(robot: RobotLog, cut: tuple[float, float] = CUT) -> RobotLog:
    """A robot without any reading or command of some seconds, as where a chunk of the file is damaged."""
    kept = outside(robot.command_time, cut)
    stopped = with_restart(robot, tuple(robot.streams), cut)
    return replace(stopped, command_time=robot.command_time[kept], command=robot.command[kept])


def without_another_chunk(robot: RobotLog) -> RobotLog:
    """The same, of a chunk that begins in a turn."""
    return without_a_chunk(robot, IN_A_TURN)


def with_restart(robot: RobotLog, streams: tuple[str, ...] = STOPPED, cut: tuple[float, float] = CUT) -> RobotLog:
    """A robot some of whose streams stop and begin again, while its commands go on."""
    stopped = {}
    for name in streams:
        stream = robot.streams[name]
        kept = outside(stream.time, cut)
        stopped[name] = replace(stream, time=stream.time[kept], value=stream.value[kept])
    return replace(robot, streams={**robot.streams, **stopped})


def of_robots(damaged: Callable[[RobotLog], RobotLog], count: int) -> Evidence:
    """Evidence of some of the five robots, damaged in a way."""
    evidence = gather_evidence([BAG], load_platform("lily"))
    (recording,) = evidence.recordings
    robots = tuple(damaged(robot) for robot in recording.robots[:count])
    return replace(evidence, recordings=(replace(recording, robots=robots),))


@pytest.mark.parametrize(
    ("damaged", "count"),
    [(lambda robot: robot, 5), (without_a_chunk, 2), (without_another_chunk, 5), (with_restart, 2)],
    ids=["whole", "without_a_chunk", "without_another_chunk", "with_restart"],
)  # fmt: skip
def test_nothing_is_missing(damaged: Callable[[RobotLog], RobotLog], count: int) -> None:
    """No effect, and no number of the platform has moved."""
    diagnosis = diagnose(of_robots(damaged, count), lambda words, share: None)
    assert (diagnosis.effects, diagnosis.recalibrated) == ((), ())
    assert diagnosis.verdict == "consistent"


def test_nothing_is_missing_of_the_eleven_of_the_demo(tmp_path: Path) -> None:
    """The swarm of `make demo` through the file of its recording, for a minute."""
    demo = cocorosim.load_scenario("eleven_lilys", duration="60 s")
    recording = cocorosim.record(demo, tmp_path / "demo")
    assert len(recording.tracks) == 11
    found = cocorosim.diagnose(tmp_path / "demo", "lily").diagnosis
    assert (found.verdict, found.effects, found.recalibrated, found.beyond_floor) == ("consistent", (), (), ())


def test_a_damaged_file_lacks_what_the_cut_takes_out(tmp_path: Path) -> None:
    """Of a copy one chunk of which is damaged, the same is left as of the recording that is cut in memory."""
    file = tmp_path / "bag" / "bag_0.mcap"
    shutil.copytree(BAG, file.parent)
    with file.open("rb") as opened:
        summary = make_reader(opened).get_summary()
    (begin,) = (
        chunk.chunk_start_offset
        for chunk in summary.chunk_indexes
        if (chunk.message_start_time / 1e9, chunk.message_end_time / 1e9) == IN_A_TURN
    )
    whole = bytearray(file.read_bytes())
    whole[begin + CHUNK_HEAD] ^= 0xFF
    file.write_bytes(whole)
    (damaged,) = gather_evidence([file.parent], load_platform("lily")).recordings
    (cut,) = of_robots(without_another_chunk, 5).recordings
    assert [robot.name for robot in damaged.robots] == [robot.name for robot in cut.robots]
    for one, other in zip(damaged.robots, cut.robots, strict=True):
        assert outside(one.command_time, IN_A_TURN).all()
        assert abs(len(one.command_time) - len(other.command_time)) <= 1
        for name, stream in one.streams.items():
            assert outside(stream.time, IN_A_TURN).all()
            assert abs(len(stream.time) - len(other.streams[name].time)) <= 1, name


def test_the_damage_is_there() -> None:
    """Thirteen seconds of twice a second are out, of the commands as well only where a chunk is."""
    for damaged, commands in ((without_a_chunk, 240 - 25), (with_restart, 240)):
        (recording,) = of_robots(damaged, 1).recordings
        (robot,) = recording.robots
        assert len(robot.streams["pose"].time) == 240 - 25
        assert len(robot.command_time) == commands
