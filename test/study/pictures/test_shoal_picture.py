"""The picture of a run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.image import imread

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.pictures.colours import robot_colours
from cocorosim_ros.study.pictures.extent import extent
from cocorosim_ros.study.pictures.facts import MetricSeries, ScenarioFacts
from cocorosim_ros.study.pictures.metric_panels import draw_metric, time_axis
from cocorosim_ros.study.pictures.shoal_picture import draw_shoal
from cocorosim_ros.study.pictures.track_views import draw_from_above, draw_from_the_side
from cocorosim_ros.world.state.pose_track import PoseTrack

STEP_NS = 500_000_000
TANK = ScenarioFacts("eleven", 42, (-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))


def tracks(robots: int = 11, poses: int = 60) -> dict[str, PoseTrack]:
    """Robots that wander from the middle of the tank."""
    rng = np.random.default_rng(1)
    stamps = STEP_NS * np.arange(poses)
    made = {}
    for number in range(robots):
        start = np.array([0.1 * number, 0.0, -1.0])
        position = start + np.cumsum(rng.normal(0.0, 0.01, (poses, 3)), axis=0)
        made[f"lily_{number + 1:02d}"] = PoseTrack(stamps, position, rng.uniform(-3.0, 3.0, poses))
    return made


def series(ticks: int = 60) -> MetricSeries:
    """Some values of every metric; none at the first tick."""
    values = np.random.default_rng(2).random((ticks, len(METRICS)))
    values[0] = np.nan
    return MetricSeries(STEP_NS * np.arange(ticks), values)


def test_a_picture_is_written(tmp_path: Path) -> None:
    """The file is a PNG of 2000 x 1250 pixels with something on it."""
    draw_shoal(tmp_path / "shoal.png", tracks(), series(), TANK)
    pixels = imread(tmp_path / "shoal.png")
    assert pixels.shape[:2] == (1250, 2000)
    assert pixels[..., :3].std() > 0.05


@pytest.mark.parametrize(
    ("made", "ticks", "facts"),
    [
        (tracks(1, 1), 1, TANK),
        (tracks(1, 1), 1, ScenarioFacts("a real pool")),
        (tracks(50, 20), 20, TANK),
        (tracks(3, 25_000), 25_000, TANK),
        (tracks(2, 3), 30_000, ScenarioFacts("longer than its tracks", None)),
    ],
    ids=["one pose", "no tank", "fifty robots", "long", "hours"],
)
def test_unusual_runs_are_drawn(tmp_path: Path, made: dict[str, PoseTrack], ticks: int, facts: ScenarioFacts) -> None:
    """One pose, an unknown tank, many robots and long runs all give a picture, without any warning."""
    draw_shoal(tmp_path / "shoal.png", made, series(ticks), facts)
    assert (tmp_path / "shoal.png").stat().st_size > 10_000


def test_a_robot_without_poses_is_left_out(tmp_path: Path) -> None:
    """Its empty track does not stop the picture."""
    made = tracks(2) | {"silent": PoseTrack(np.empty(0, np.int64), np.empty((0, 3)), np.empty(0))}
    draw_shoal(tmp_path / "shoal.png", made, series(), TANK)
    assert (tmp_path / "shoal.png").exists()


def test_the_same_run_gives_the_same_file(tmp_path: Path) -> None:
    """Nothing of the moment of drawing goes into the file."""
    for name in ("a.png", "b.png"):
        draw_shoal(tmp_path / name, tracks(3), series(), TANK)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_an_existing_file_is_kept_unless_forced(tmp_path: Path) -> None:
    """Nothing is overwritten without being told so."""
    path = tmp_path / "shoal.png"
    path.write_text("mine")
    with pytest.raises(CocorosimError, match="exists already"):
        draw_shoal(path, tracks(2), series(), TANK)
    assert path.read_text() == "mine"
    draw_shoal(path, tracks(2), series(), TANK, force=True)
    assert path.read_bytes()[1:4] == b"PNG"


def test_nothing_to_draw_is_said(tmp_path: Path) -> None:
    """Neither without tracks nor without statistics is a file made."""
    for made, values in (({}, series()), (tracks(2), _no_series())):
        with pytest.raises(CocorosimError, match="no poses"):
            draw_shoal(tmp_path / "shoal.png", made, values, TANK)
    assert not (tmp_path / "shoal.png").exists()


def _no_series() -> MetricSeries:
    return MetricSeries(np.empty(0, np.int64), np.empty((0, len(METRICS))))


def test_a_missing_folder_is_said(tmp_path: Path) -> None:
    """The sentence names the file."""
    with pytest.raises(CocorosimError, match=r"nowhere.*in a folder that does not exist"):
        draw_shoal(tmp_path / "nowhere" / "shoal.png", tracks(2), series(), TANK)


@pytest.mark.parametrize("robots", [1, 10, 11, 50])
def test_every_robot_has_its_own_colour(robots: int) -> None:
    """No two robots share one."""
    colours = robot_colours([f"lily_{number}" for number in range(robots)])
    assert len(set(colours.values())) == robots


@pytest.mark.parametrize(("draw", "plane"), [(draw_from_above, (0, 1)), (draw_from_the_side, (0, 2))])
def test_views_show_starts_ends_and_walls_to_scale(draw: object, plane: tuple[int, int]) -> None:
    """A ring at each start, a disc at each end, the tank's walls, and one metre as long across as up."""
    made = tracks(3)
    axes = Figure().add_subplot()
    draw(axes, made, TANK, extent(made, TANK), 0)  # type: ignore[operator]
    points = [tuple(line.get_xydata()[0]) for line in axes.lines if line.get_marker() == "o"]
    for track in made.values():
        assert tuple(track.position[0, plane]) in points
        assert tuple(track.position[-1, plane]) in points
    wall = axes.patches[-1].get_bbox()
    assert (wall.x0, wall.x1) == (-3.0, 3.0)
    assert (wall.y0, wall.y1) == (TANK.low_corner[plane[1]], TANK.high_corner[plane[1]])  # type: ignore[index]
    assert axes.get_aspect() == 1.0


def test_a_view_contains_robots_outside_the_tank() -> None:
    """A camera that sees a robot behind the wall is worth seeing."""
    made = {"a": PoseTrack(np.array([0]), np.array([[9.0, 0.0, -1.0]]), np.zeros(1))}
    low, high = extent(made, TANK)
    assert high[0] > 9.0
    assert low[0] < -3.0


@pytest.mark.parametrize(("seconds", "unit", "end"), [(300, "s", 300.0), (3600, "min", 60.0), (18000, "h", 5.0)])
def test_time_is_in_a_suitable_unit(seconds: int, unit: str, end: float) -> None:
    """Seconds, minutes or hours, from the first stamp on."""
    axis = time_axis(np.array([7, 7 + seconds * 1_000_000_000]))
    assert axis.unit == unit
    assert axis.time.tolist() == [0.0, end]


def test_a_panel_says_what_it_shows() -> None:
    """Name, unit and summary stand over the panel."""
    values = series()
    axes = Figure().add_subplot()
    draw_metric(axes, "separation", values, time_axis(values.stamp_ns))
    assert axes.get_title(loc="left") == "Separation [m]"
    assert axes.get_title(loc="right").startswith("median 0.")


def test_no_global_state_is_used() -> None:
    """pyplot is never imported: drawing in a thread or beside a user's own figures is safe."""
    code = "import sys, cocorosim_ros.study.pictures.shoal_picture; sys.exit('matplotlib.pyplot' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
