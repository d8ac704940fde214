"""A run drawn for Rerun while it goes on, read back by Rerun's own reader."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.commands.run_modes import RunChoices, check_startable
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.results import facts_of
from cocorosim_ros.library.record import new_record
from cocorosim_ros.library.recording import read_recording
from cocorosim_ros.study.scene.drifting_plume import drifting_plume
from cocorosim_ros.world.checks.loading import load_scenario

TICKS = 10


def test_without_rerun_it_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    """Before anything begins: what is missing, how to get it, how to do without."""
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    choices = dict.fromkeys(RunChoices.__dataclass_fields__)
    given = {"scenario": "one_lily", "rate": 0.0, "smooth": 0.0, "wait": 60.0, "view": True, "in_process": True}
    with pytest.raises(CocorosimError, match=r"needs the Python package rerun.*leave out --view"):
        check_startable(load_scenario("one_lily"), RunChoices(**{**choices, **given}))  # type: ignore[arg-type]


def entities(file: Path) -> dict[str, list[dict[str, Any]]]:
    """By path the rows of a file that have a time."""
    from rerun.chunk import RrdReader

    found: dict[str, list[dict[str, Any]]] = {}
    for chunk in RrdReader(file).stream().to_chunks():
        batch = chunk.to_record_batch()
        if "time" in batch.schema.names:
            times = [each.value / 1e9 for each in batch.column("time")]
            columns = {name: batch.column(name).to_pylist() for name in batch.schema.names if name != "time"}
            rows = [{name: cells[row] for name, cells in columns.items()} for row in range(len(times))]
            rows = [{**row, "time": time} for row, time in zip(rows, times, strict=True)]
            found.setdefault(chunk.entity_path, []).extend(rows)
    return {path: sorted(rows, key=lambda row: row["time"]) for path, rows in found.items()}


def component(rows: list[dict[str, Any]], ending: str) -> list[Any]:
    """The first instance of a component in each row that has it."""
    name = next(name for row in rows for name in row if name.endswith(ending))
    return [row[name][0] for row in rows if row.get(name)]


def test_it_shows_what_is_recorded(tmp_path: Path) -> None:
    """Every pose of every robot at its time, its trail, its commands, and the metrics as they were measured."""
    pytest.importorskip("rerun", reason="rerun-sdk is not installed, and it is optional")
    if np.__version__.startswith("1."):
        pytest.skip("rerun-sdk asks for NumPy 2")
    import rerun as rr

    from cocorosim_ros.study.scene.rerun_live import LiveScene

    scenario = load_scenario("plume_tracking", duration=f"{TICKS * 0.5} s")
    stream = rr.RecordingStream("cocorosim")
    stream.save(tmp_path / "live.rrd")
    record = new_record(scenario, tmp_path / "bag")
    record.show_to(LiveScene(stream, scenario, facts_of(scenario)))
    run_in_process(scenario, record)
    record.close()
    stream.flush()
    stream.disconnect()
    recording, drawn = read_recording(tmp_path / "bag"), entities(tmp_path / "live.rrd")
    for robot, track in recording.tracks.items():
        rows = drawn[f"/run/robots/{robot}"]
        assert [row["time"] for row in rows] == (track.stamp_ns / 1e9).tolist()
        assert component(rows, "translation") == pytest.approx(track.position, abs=1e-6)
        assert len(drawn[f"/run/trails/{robot}"]) == len(track.stamp_ns) - 1
        assert len(drawn[f"/run/robots/{robot}/thrusters"]) == len(recording.readings[robot]["thruster_command"].time)
    measured = recording.measure()
    rows = drawn["/run/metrics/polarisation"]
    assert component(rows, "scalars") == pytest.approx(measured["polarisation"])
    plume = drifting_plume(scenario, np.array([recording.tracks[scenario.robots[0].name].stamp_ns[-1]]))
    assert plume is not None
    assert plume.stamp_ns.size == TICKS - 1  # at the end of each tick; the run ends with a tick's beginning
    rows = [row for row in drawn["/run/water/plume"] if any(row.values())]
    assert [row["time"] for row in rows] == (plume.stamp_ns / 1e9).tolist()
    places = np.concatenate([row["Points3D:positions"] for row in rows])
    assert places == pytest.approx(plume.centre, abs=1e-6)
