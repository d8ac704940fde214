"""The overlay of a diagnosis: ghosts, forces and evidence as an independent reader finds them, at the right moments."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from cocorosim_ros.diagnosis.findings import Clock, Diagnosis, GatheredEvidence
from cocorosim_ros.diagnosis.report.output_folder import write_folder
from cocorosim_ros.diagnosis.report.overlay import has_overlay, write_overlay
from cocorosim_ros.diagnosis.showing.gathered_evidence import gathered_evidence
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.library.recording import read_recording

from .conftest import EXAMPLES

START = 1_700_000_000 * 10**9  # ns
HULL = 0.15  # m
Read = dict[str, list[tuple[int, Any]]]


@pytest.fixture
def found() -> Diagnosis:
    """A diagnosis whose recording began in 2023."""
    clock, plain = Clock("runs/one", START), EXAMPLES["mismatch"]()
    time = np.arange(0.0, 60.0, 0.25)
    return replace(
        plain,
        free_runs=tuple(replace(run, clock=clock) for run in plain.free_runs),
        residual_before=tuple(replace(each, clock=clock) for each in plain.residual_before),
        residual_after=tuple(replace(each, clock=clock) for each in plain.residual_after),
        gathered=(GatheredEvidence("lily_01", time, 2.0 * time, clock),),
    )


def read(bag: Path) -> Read:
    """Every message by topic, with its time of recording [ns], as `rosbags` reads it."""
    messages: Read = {}
    with AnyReader([bag]) as reader:
        for connection, at, data in reader.messages():
            messages.setdefault(connection.topic, []).append((at, reader.deserialize(data, connection.msgtype)))
    return messages


def stamp(message: Any) -> int:
    """The stamp of a header [ns]."""
    return int(message.header.stamp.sec) * 10**9 + int(message.header.stamp.nanosec)


def test_ghosts(found: Diagnosis, tmp_path: Path) -> None:
    """Both models' free runs as poses in the world, stamped by the recording's clock."""
    write_overlay(found, HULL, tmp_path / "overlay")
    messages = read(tmp_path / "overlay")
    for topic, model in (("/lily_01/by_platform/pose", "nominal"), ("/lily_01/by_model/pose", "augmented")):
        expected = np.concatenate([getattr(run, model) for run in found.free_runs])
        moments = np.concatenate([run.time for run in found.free_runs])
        got = [message for _, message in messages[topic]]
        assert [stamp(each) for each in got] == [at for at, _ in messages[topic]]
        assert [stamp(each) for each in got] == [START + round(1e9 * float(time)) for time in moments]
        assert {each.header.frame_id for each in got} == {"world"}
        places = [[getattr(each.pose.position, axis) for axis in "xyz"] for each in got]
        assert np.allclose(places, expected[:, :3], atol=0.0)
        turns = [2.0 * math.atan2(each.pose.orientation.z, each.pose.orientation.w) for each in got]
        assert np.allclose(np.exp(1j * np.array(turns)), np.exp(1j * expected[:, 3]))


def test_forces_and_evidence(found: Diagnosis, tmp_path: Path) -> None:
    """Residual forces in the axes of the body, the same as arrows in the world, and the evidence."""
    write_overlay(found, HULL, tmp_path / "overlay")
    messages = read(tmp_path / "overlay")
    (residual,) = found.residual_before
    wrenches = messages["/lily_01/residual_force"]
    assert {message.header.frame_id for _, message in wrenches} == {"lily_01/base_link"}
    at, first = wrenches[0]
    force = residual.force[0]
    assert at == START + round(1e9 * float(residual.time[0]))
    parts = (first.wrench.force.x, first.wrench.force.y, first.wrench.force.z, first.wrench.torque.z)
    assert parts == pytest.approx(force)
    assert "/lily_01/residual_force_left" in messages
    arrows = [message.markers[0] for _, message in messages["/markers/residuals"]]
    assert {(arrow.ns, arrow.id) for arrow in arrows} == {("lily_01", 0), ("lily_01", 1)}
    arrow = next(each for each in arrows if each.id == 0)
    begin, end = (np.array([getattr(point, axis) for axis in "xyz"]) for point in arrow.points)
    assert begin == pytest.approx(residual.place[0, :3])
    yaw = residual.place[0, 3]
    push = [
        math.cos(yaw) * force[0] - math.sin(yaw) * force[1],
        math.sin(yaw) * force[0] + math.cos(yaw) * force[1],
        force[2],
    ]
    assert np.cross(end - begin, push) == pytest.approx(np.zeros(3), abs=1e-9)
    assert np.dot(end - begin, push) >= 0.0
    scale = float(read_recording(tmp_path / "overlay").metadata["arrow_metres_per_newton"])
    assert end - begin == pytest.approx(scale * np.array(push), rel=1e-4, abs=1e-9)
    evidence = messages["/lily_01/evidence"]
    assert [message.data for _, message in evidence] == found.gathered[0].nats.tolist()
    assert [at for at, _ in evidence] == [START + round(1e9 * time) for time in found.gathered[0].time.tolist()]


def test_several_recordings_have_a_bag_each(found: Diagnosis, tmp_path: Path) -> None:
    """The same robot in two recordings is two ghosts in two bags."""
    other = replace(found.free_runs[0], clock=Clock("runs/two", START + 10**12))
    write_overlay(replace(found, free_runs=(*found.free_runs, other)), HULL, tmp_path / "overlay")
    assert sorted(path.name for path in (tmp_path / "overlay").iterdir()) == ["01_one", "02_two"]
    ghost = read(tmp_path / "overlay" / "02_two")["/lily_01/by_platform/pose"]
    assert ghost[0][0] == START + 10**12 + round(1e9 * float(other.time[0]))


def test_nothing_to_lay_over() -> None:
    """A recording that could not be fitted has no overlay."""
    assert not has_overlay(EXAMPLES["insufficient"]())


def test_the_viewers_take_it(
    found: Diagnosis, cocorosim: Callable[..., SimpleNamespace], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The ghosts are robots for `view`, alone and beside the recording."""
    monkeypatch.chdir(tmp_path)
    write_overlay(found, HULL, tmp_path / "overlay")
    page = cocorosim("view", "overlay", "--out", "page.html", "--no-open")
    assert page.status == 0, page.err
    assert "lily_01/by_model" in Path("page.html").read_text("utf-8")
    pytest.importorskip("rerun", reason="needs rerun-sdk")
    scene = cocorosim("view", "overlay", "--3d", "--against", "overlay", "--out", "scene.rrd", "--no-open")
    assert scene.status == 0, scene.err


def test_rerun_opens_it(
    found: Diagnosis, rerun_rows: Callable[[Path], dict[str, list[dict[str, Any]]]], tmp_path: Path
) -> None:
    """Its own loader of MCAP has every topic with as many rows as there are messages, at the recording's moments."""
    write_overlay(found, HULL, tmp_path / "overlay")
    messages, rows = read(tmp_path / "overlay"), rerun_rows(tmp_path / "overlay" / "overlay_0.mcap")
    assert {topic: len(each) for topic, each in rows.items()} == {topic: len(each) for topic, each in messages.items()}
    for topic, each in messages.items():
        assert sorted(row["message_log_time"].value for row in rows[topic]) == sorted(at for at, _ in each)
    ghost = rows["/lily_01/by_model/pose"]
    assert {frame for row in ghost for frame in row["CoordinateFrame:frame"]} == {"world"}
    expected = np.concatenate([run.augmented for run in found.free_runs])[:, :3]
    assert [row["InstancePoses3D:translations"][0] for row in ghost] == pytest.approx(expected, abs=1e-6)


def test_it_is_exchanged_with_the_files(found: Diagnosis, tmp_path: Path) -> None:
    """A later diagnosis takes an older overlay away, one that fails leaves everything as it was."""
    texts = {"diagnosis.json": json.dumps({})}
    write_folder(tmp_path, texts, lambda place: write_overlay(found, HULL, place))
    assert (tmp_path / "overlay" / "metadata.yaml").is_file()
    kept = sorted(path.relative_to(tmp_path) for path in tmp_path.rglob("*"))

    def fail(place: Path) -> None:
        write_overlay(found, HULL, place)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_folder(tmp_path, texts, fail)
    assert sorted(path.relative_to(tmp_path) for path in tmp_path.rglob("*")) == kept
    write_folder(tmp_path, texts)
    assert [path.name for path in tmp_path.iterdir()] == ["diagnosis.json"]


def test_evidence_is_the_difference_of_the_likelihoods() -> None:
    """After the last reading it is the difference of both log-likelihoods, before the first it is nothing."""
    stamps = np.array([2.0, 1.0, 3.0])

    def passed(innovation: list[float], variance: float) -> Pass:
        values = np.array(innovation)
        likelihood = float(-0.5 * np.sum(values**2 / variance + np.log(2.0 * math.pi * variance)))
        return Pass(values, np.full(3, variance), np.zeros((3, 1)), np.ones(3, bool), likelihood)

    before, after = passed([1.0, 2.0, 3.0], 4.0), passed([0.5, 0.1, 0.2], 1.0)
    grid = SimpleNamespace(moments=np.array([0.0, 1.0, 2.0, 3.0]))
    clock = Clock("bag", 5)
    track = SimpleNamespace(
        name="lily", timeline=SimpleNamespace(stamp=stamps, grid=grid), log=SimpleNamespace(clock=clock)
    )
    base, final = (SimpleNamespace(tracks=(track,), passes=(each,)) for each in (before, after))
    (found,) = gathered_evidence(base, final)  # type: ignore[arg-type]
    gain = after.log_likelihood - before.log_likelihood
    # At 1 s comes the second reading, -0.5 (0.1^2 - 2^2 / 4 - log 4), at 2 s the first, -0.5 (0.5^2 - 1 / 4 - log 4).
    assert found.nats == pytest.approx([0.0, 0.495 + math.log(2.0), 0.495 + 2.0 * math.log(2.0), gain])
    assert (found.robot, found.clock) == ("lily", clock)
