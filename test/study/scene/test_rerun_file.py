"""Scenes for Rerun, read back by Rerun's own reader: every entity is there, and where the recording has it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.results import recording_metadata, scenario_facts
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.library.recording import Recording, read_recording
from cocorosim_ros.study.scene.cones import cone_lines
from cocorosim_ros.study.scene.gathering import gather_scene
from cocorosim_ros.study.scene.scene import Scene
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario

pytest.importorskip("rerun", reason="rerun-sdk is not installed, and it is optional")
if np.__version__.startswith("1."):
    pytest.skip("rerun-sdk asks for NumPy 2", allow_module_level=True)
from rerun.chunk import RrdReader  # after the question whether it is there

from cocorosim_ros.study.scene.rerun_file import write_rerun

SHIPPED = Path(__file__).parents[3] / "bags" / "five_lilys"
LILYS = [f"lily_0{number}" for number in range(1, 6)]
METRICS = ("angular_momentum", "lost", "polarisation", "separation", "shoal_speed", "shoals")
Rows = Mapping[str, Any]


def scene_of(recording: Recording) -> Scene:
    """All that is to be seen of a recording."""
    return gather_scene(recording.bag, recording.tracks, scenario_facts(recording.bag), recording.scenario)


def entities(file: Path) -> dict[str, dict[str, list[Any]]]:
    """By path and column what a file holds, in the order of time; times in seconds."""
    found: dict[str, dict[str, list[Any]]] = {}
    for chunk in RrdReader(file).stream().to_chunks():
        batch = chunk.to_record_batch()
        into = found.setdefault(chunk.entity_path, {})
        for name in batch.schema.names:
            values = batch.column(name)
            rows = [each.value / 1e9 for each in values] if name == "time" else values.to_pylist()
            into.setdefault(name, []).extend(rows)
    return found


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> SimpleNamespace:
    """The recording that comes with the repository, and its scene as Rerun reads it."""
    file = tmp_path_factory.mktemp("scene") / "scene.rrd"
    recording = read_recording(SHIPPED)
    write_rerun([scene_of(recording)], file)
    return SimpleNamespace(recording=recording, file=file, rows=entities(file))


def test_every_robot_is_where_the_recording_has_it(shipped: SimpleNamespace) -> None:
    """One row a pose: time since the first pose, place, heading as a turn about z."""
    for name in LILYS:
        track, rows = shipped.recording.tracks[name], shipped.rows[f"/run/robots/{name}"]
        assert len(rows["time"]) == len(track.stamp_ns) == 240
        np.testing.assert_allclose(rows["time"], track.time, atol=1e-9)
        place = np.reshape(rows["Transform3D:translation"], (-1, 3))
        np.testing.assert_allclose(place, track.position, atol=1e-6)
        x, y, z, w = np.reshape(rows["Transform3D:quaternion"], (-1, 4)).T
        np.testing.assert_allclose(np.hypot(x, y), 0.0, atol=1e-7)
        np.testing.assert_allclose(np.exp(2j * np.arctan2(z, w)), np.exp(1j * track.yaw), atol=1e-6)


def test_everything_is_there(shipped: SimpleNamespace) -> None:
    """Bodies, bows, thrusters, cones, what they see, trails, who hears whom, walls, surface, metrics, words."""
    parts = ("", "/body", "/bow", "/thrusters", "/cones", "/sight")
    expected = {f"/run/robots/{name}{part}" for name in LILYS for part in parts}
    expected |= {f"/run/trails/{name}" for name in LILYS} | {f"/run/metrics/{name}" for name in METRICS}
    expected |= {"/run", "/run/hearing", "/run/tank/walls", "/run/tank/surface", "/run/about"}
    assert set(shipped.rows) - {"/__properties"} == expected


def test_it_opens_with_a_layout(shipped: SimpleNamespace) -> None:
    """The file brings a blueprint with three-dimensional views, a plot for each metric and the words."""
    (blueprint,) = RrdReader(shipped.file).blueprints()
    chunks = RrdReader(shipped.file).stream(store=blueprint).to_chunks()
    columns = [chunk.to_record_batch().to_pydict() for chunk in chunks]
    kinds = [value for rows in columns for key, value in rows.items() if key.endswith("class_identifier")]
    views = [name for value in kinds for row in value for name in (row if isinstance(row, list) else [row])]
    assert (views.count("3D"), views.count("TimeSeries"), views.count("TextDocument")) == (2, 6, 1)


def test_the_curves_are_those_of_the_metrics(shipped: SimpleNamespace) -> None:
    """The same numbers at the same times as `cocorosim metrics` has; undefined moments are left out."""
    statistics = shipped.recording.measure()
    for name in METRICS:
        known = np.isfinite(statistics[name])
        rows = shipped.rows[f"/run/metrics/{name}"]
        np.testing.assert_allclose(rows["time"], statistics.time[known], atol=1e-9)
        np.testing.assert_array_equal(np.ravel([x for x in rows["Scalars:scalars"] if x]), statistics[name][known])


def test_links_go_from_senders_to_listeners_within_radio_range(shipped: SimpleNamespace) -> None:
    """What was said a tick before was heard within 0.5 m; in one tick of 0.5 s a Lily moves 0.04 m at most."""
    links = [link for row in shipped.rows["/run/hearing"]["LineStrips3D:strips"] if row for link in row]
    ends = np.array(links)
    assert ends.shape[0] > 100
    assert ends.shape[1:] == (2, 3)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    assert 0.0 < length.min()
    assert length.max() <= 0.5 + 2 * 0.04


def test_thrusters_push_as_they_are_asked(shipped: SimpleNamespace) -> None:
    """One hull (0.13 m) long at full command: ahead for the thrusters of a Lily, up for its pump."""
    commands = shipped.recording.readings["lily_03"]["thruster_command"]
    rows = shipped.rows["/run/robots/lily_03/thrusters"]
    vectors = np.array([row for row in rows["Arrows3D:vectors"] if row])
    assert vectors.shape == (len(commands.stamp_ns), 3, 3)
    for place, (name, axis) in enumerate((("left", 0), ("right", 0), ("buoyancy", 2))):
        expected = np.zeros((len(vectors), 3))
        expected[:, axis] = 0.13 * commands.column(name)
        np.testing.assert_allclose(vectors[:, place], expected, atol=1e-7)


def test_lit_cones_end_where_the_neighbour_is(shipped: SimpleNamespace) -> None:
    """As many cones as sensors that see a robot, five lines each, of which the longest ends at the range."""
    scan = shipped.recording.readings["lily_02"]["blss"]
    names = [name for name in scan.columns if name.endswith("neighbour_range")]
    ranges = np.stack([scan.column(name) for name in names], axis=-1)
    rows = [row for row in shipped.rows["/run/robots/lily_02/sight"]["LineStrips3D:strips"] if row is not None]
    assert [len(row) // 5 for row in rows] == np.isfinite(ranges).sum(axis=1).tolist()
    for row, seen in zip(rows, ranges, strict=True):
        ends = [np.linalg.norm(line, axis=1).max() for line in row]
        assert ends == pytest.approx(np.repeat(seen[np.isfinite(seen)], 5).tolist(), abs=1e-6)


def test_a_cone_has_its_axis_and_opening() -> None:
    """A cone of 120 degrees to the left: every point of its rim is 60 degrees off +y, at the reach."""
    rim, *spokes = cone_lines(np.pi / 2, 0.0, np.radians(120.0), 0.5)
    np.testing.assert_allclose(np.linalg.norm(rim, axis=1), 0.5)
    np.testing.assert_allclose(rim[:, 1], 0.25)
    assert [line[0].tolist() for line in spokes] == [[0, 0, 0]] * 4


def test_shoals_have_colours(shipped: SimpleNamespace) -> None:
    """At every moment there are as many colours of bodies as shoals."""
    shoals = shipped.recording.measure()["shoals"]
    times = np.arange(240) * 0.5
    colours = []
    for name in LILYS:
        rows = shipped.rows[f"/run/robots/{name}/body"]
        changes = [row[0] for row in rows["Ellipsoids3D:colors"] if row]
        colours.append([changes[at] for at in np.searchsorted(rows["time"], times, "right") - 1])
    assert [len(set(together)) for together in zip(*colours, strict=True)] == shoals.tolist()


def test_two_runs_side_by_side(shipped: SimpleNamespace, tmp_path: Path) -> None:
    """Each below its own root, on one time line."""
    scene = scene_of(shipped.recording)
    write_rerun([scene, scene], tmp_path / "two.rrd")
    rows = entities(tmp_path / "two.rrd")
    ours = {path.removeprefix("/run") for path in rows if path.startswith("/run")}
    theirs = {path.removeprefix("/against") for path in rows if path.startswith("/against")}
    assert ours == theirs
    assert len(ours) == len(shipped.rows) - 1
    assert rows["/run/robots/lily_01"]["time"] == rows["/against/robots/lily_01"]["time"]


@pytest.fixture
def record(tmp_path: Path) -> Callable[[str], Recording]:
    """A function that runs `one_lily` for two seconds with these lines put into the scenario."""

    def run(lines: str) -> Recording:
        text = load_scenario("one_lily", duration="2 s").to_yaml()
        scenario = parse_scenario(text.replace("water: null\n", "") + lines, "here")
        bodies = [describe_body(robot) for robot in scenario.robots]
        made = RunRecord(tmp_path / "bag", bodies, recording_metadata(scenario))
        run_in_process(scenario, made)
        made.close()
        return read_recording(tmp_path / "bag")

    return run


def test_water_is_drawn_where_the_recording_knows_it(record: Callable[[str], Recording], tmp_path: Path) -> None:
    """A uniform current of 3 cm/s north goes 0.3 m in 10 s, everywhere in the tank; the plume's source is a point."""
    recording = record(
        "water:\n  currents:\n    - {kind: uniform, x: 0 m/s, y: 0.03 m/s}\n"
        "  plume: {source: [1 m, 1 m, -1 m], rate: 1e-6 kg/s, diffusivity: 1e-4 m^2/s}\n"
    )
    write_rerun([scene_of(recording)], tmp_path / "water.rrd")
    rows = entities(tmp_path / "water.rrd")
    current = rows["/run/water/current"]
    vectors = np.array([row for row in current["Arrows3D:vectors"] if row])
    np.testing.assert_allclose(vectors, np.broadcast_to([0, 0.3, 0], vectors.shape), atol=1e-7)
    (origins,) = [row for row in current["Arrows3D:origins"] if row]
    assert np.all(np.array(origins)[:, 2] < 0)
    assert vectors.shape[1] == len(origins) == 8 * 8 * 3
    assert rows["/run/water/plume_source"]["Points3D:positions"] == [[[1.0, 1.0, -1.0]]]


def test_puffs_of_a_plume_go_with_the_water(record: Callable[[str], Recording], tmp_path: Path) -> None:
    """One every second: after 1.5 s the first has gone 1.5 s with 3 cm/s north and faded, the second 0.5 s."""
    water = (
        "water:\n  currents:\n    - {kind: uniform, x: 0 m/s, y: 0.03 m/s}\n"
        "  plume: {source: [1 m, 1 m, -1 m], rate: 1e-6 kg/s, diffusivity: 1e-4 m^2/s, interval: 1 s}\n"
    )
    write_rerun([scene_of(record(water))], tmp_path / "plume.rrd")
    puffs = entities(tmp_path / "plume.rrd")["/run/water/plume"]
    places, shades = (
        dict(zip(puffs["time"], [row for row in puffs[f"Points3D:{name}"] if row], strict=True))
        for name in ("positions", "colors")
    )
    assert np.array(places[1.5]) == pytest.approx(np.array([[1.0, 1.045, -1.0], [1.0, 1.015, -1.0]]), abs=1e-6)
    older, newer = (shade >> 24 for shade in shades[1.5])
    assert older < newer, "red, the first of four bytes"


def test_nothing_half_written_is_left(shipped: SimpleNamespace, tmp_path: Path) -> None:
    """A folder where the file should be: a sentence, and no other file."""
    (tmp_path / "scene.rrd").mkdir()
    with pytest.raises(CocorosimError, match=r"scene\.rrd cannot be written"):
        write_rerun([scene_of(shipped.recording)], tmp_path / "scene.rrd")
    assert [each.name for each in tmp_path.iterdir()] == ["scene.rrd"]
