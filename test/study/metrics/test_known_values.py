"""Values of hand-made swarms, and independent calculations with numpy and scipy."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components
from scipy.spatial.distance import pdist, squareform

from cocorosim_ros.study.metrics import COLUMN

from .swarm_poses import Poses, aligned, column, everybody, measured, milling, two_clusters, wandering


def last(poses: Poses, name: str) -> float:
    """The value of a metric at the last tick."""
    return float(column(measured(poses), name)[-1])


@pytest.mark.parametrize("direction", ["", "_travel"])
def test_aligned_swarm_is_polarised(direction: str) -> None:
    """Robots that all head and swim the same way have p = 1."""
    assert last(aligned(), f"polarisation{direction}") == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("variant", ["", "_median_centre", "_largest", "_median_centre_largest"])
def test_a_line_that_swims_along_itself_has_no_angular_momentum(variant: str) -> None:
    """r is parallel to v for robots in line ahead, so m = 0."""
    line = aligned()
    along = everybody(line.position, np.zeros_like(line.yaw))
    assert last(along, f"angular_momentum{variant}") == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("variant", ["", "_travel", "_median_centre", "_travel_median_centre", "_largest"])
def test_milling_ring_has_momentum_one(variant: str) -> None:
    """A ring that circles has m = 1 (travel over a chord of 0.01 rad: cos 0.005)."""
    chord = np.cos(0.005) if "travel" in variant else 1.0
    assert last(milling(), f"angular_momentum{variant}") == pytest.approx(chord, abs=1e-12)


def test_milling_ring_is_not_polarised() -> None:
    """A ring that circles has p = 0 and its centre stays."""
    assert last(milling(), "polarisation") == pytest.approx(0.0, abs=1e-12)
    assert last(milling(), "shoal_speed") == pytest.approx(0.0, abs=1e-12)


def test_raw_momentum_is_measured_in_patches() -> None:
    """A ring of 0.3 m radius has a raw momentum of 3 patches of 0.1 m."""
    assert last(milling(radius=0.3), "angular_momentum_raw") == pytest.approx(3.0, abs=1e-12)


def test_momentum_is_the_norm_of_a_vector_in_three_dimensions() -> None:
    """Two robots above each other that head apart: r x v is horizontal and adds up to m = 1."""
    pose = everybody(np.tile([[0.0, 0.0, -0.9], [0.0, 0.0, -1.1]], (2, 1, 1)), np.tile([0.0, np.pi], (2, 1)))
    assert last(pose, "angular_momentum") == pytest.approx(1.0, abs=1e-12)


def test_a_robot_at_rest_counts_without_a_direction_of_travel() -> None:
    """One robot swims and one rests: the sum of directions has length 1 and N is 2."""
    pose = everybody([[[0.0, 0, -1], [0.2, 0, -1]], [[0.1, 0, -1], [0.2, 0, -1]]], np.zeros((2, 2)))
    assert last(pose, "polarisation_travel") == pytest.approx(0.5, abs=1e-15)


def test_shoal_speed_is_way_per_time() -> None:
    """The aligned swarm moves 0.05 m in half a second: 0.1 m/s, and 0.25 m/s if that took 0.2 s."""
    for step_ns, speed in ((500_000_000, 0.1), (200_000_000, 0.25)):
        assert column(measured(aligned(), step_ns), "shoal_speed")[-1] == pytest.approx(speed, abs=1e-12)


def test_shoal_speed_before_the_second_tick_is_undefined() -> None:
    """There is no movement before there are two moments."""
    assert np.isnan(column(measured(aligned()), "shoal_speed")[0])


def test_centre_does_not_jump_when_a_robot_appears() -> None:
    """A robot far away that was absent at the previous tick leaves the speed of the others as it is."""
    poses = aligned(4)
    poses.position[:, 3] = [100.0, 0.0, -1.0]
    poses.present[0, 3] = False
    assert last(poses, "shoal_speed") == pytest.approx(0.1, abs=1e-12)


def test_median_centre_ignores_a_runaway() -> None:
    """Three robots rest and one leaves by 1 m in 0.5 s: the mean moves 0.5 m/s, the median stays."""
    start = np.array([[0.0, 0, -1], [0.1, 0, -1], [0.2, 0, -1], [0.3, 0, -1]])
    end = start + np.array([[0.0, 0, 0], [0, 0, 0], [0, 0, 0], [1.0, 0, 0]])
    poses = everybody(np.stack([start, end]), np.zeros((2, 4)))
    assert last(poses, "shoal_speed") == pytest.approx(0.5, abs=1e-12)
    assert last(poses, "shoal_speed_median_centre") == pytest.approx(0.0, abs=1e-15)


def test_two_clusters() -> None:
    """Clusters of three and two robots 1 m apart: two shoals; all distances are known."""
    poses = two_clusters()
    assert last(poses, "shoals") == 2
    assert last(poses, "shoals_of_two") == 2
    # all pairs: 0.1 0.1 0.1 0.2 1.0 1.1 1.1 1.2 1.2 1.3; within shoals: 0.1 0.1 0.1 0.2; largest: 0.1 0.1 0.2
    assert last(poses, "separation") == pytest.approx((1.0 + 1.1) / 2)
    assert last(poses, "separation_same_shoal") == pytest.approx(0.1)
    assert last(poses, "separation_largest") == pytest.approx(0.1)
    assert last(poses, "separation_nearest") == pytest.approx(0.1)


def test_a_robot_alone_is_a_shoal_of_one() -> None:
    """Three robots far apart: three shoals, none of two; no shoal is the largest."""
    poses = everybody(np.tile([[0.0, 0, -1], [2, 0, -1], [-2, 0, -1]], (2, 1, 1)), np.zeros((2, 3)))
    assert last(poses, "shoals") == 3
    assert last(poses, "shoals_of_two") == 0
    assert np.isnan(last(poses, "polarisation_largest"))
    assert np.isnan(last(poses, "separation_same_shoal"))


def test_contact_range_includes_half_a_metre() -> None:
    """Robots exactly 0.5 m apart are one shoal, robots a hair farther apart are two."""
    for apart, shoals in ((0.5, 1), (0.5000001, 2)):
        assert last(everybody([[[0.0, 0, 0], [apart, 0, 0]]], np.zeros((1, 2))), "shoals") == shoals


def test_of_equal_shoals_the_most_compact_is_the_largest() -> None:
    """Pairs 0.4 m and 0.2 m apart, far from each other: the closer pair counts, in either order."""
    poses = everybody([[[0.0, 0, 0], [0.4, 0, 0], [3.0, 0, 0], [3.2, 0, 0]]], [[0.0, np.pi, 1.0, 1.0]])
    assert last(poses, "separation_largest") == pytest.approx(0.2)
    assert last(poses, "polarisation_largest") == pytest.approx(1.0)
    other = everybody(poses.position[:, ::-1], poses.yaw[:, ::-1])
    assert last(other, "separation_largest") == pytest.approx(0.2)


def from_distances(distances: list[float], yaw: float = 0.0) -> Poses:
    """Two robots, the second at this distance ahead of the first at each tick, both with this yaw."""
    position = np.zeros((len(distances), 2, 3))
    position[:, 1, 0] = distances
    return everybody(position, np.full((len(distances), 2), yaw))


def test_lost_counts_changes_and_not_ticks() -> None:
    """Two robots part, stay apart, meet and part again: each is lost twice, at the moments of parting."""
    values = column(measured(from_distances([0.3, 0.6, 0.7, 0.4, 0.8])), "lost")
    np.testing.assert_array_equal(values, [0, 2, 2, 2, 4])


def test_a_robot_that_starts_alone_is_not_lost() -> None:
    """There is nothing to lose before the first contact."""
    np.testing.assert_array_equal(column(measured(from_distances([0.8, 0.9, 1.0])), "lost"), [0, 0, 0])


def test_an_absent_robot_keeps_its_state() -> None:
    """A robot with company that is absent for a while and comes back alone is lost when it is seen again."""
    poses = from_distances([0.3, 0.3, 0.9])
    poses.present[1, :] = False
    np.testing.assert_array_equal(column(measured(poses), "lost"), [0, 0, 2])


@pytest.mark.parametrize(
    ("bearing", "elevation", "by_any", "but_back"),
    [
        (0.0, 0.0, True, True),
        (60.0, 0.0, True, True),
        (-119.0, 0.0, True, True),
        (121.0, 0.0, True, False),
        (180.0, 0.0, True, False),
        (0.0, 20.0, False, False),
        (0.0, 31.0, True, True),
        (180.0, 31.0, True, True),
        (77.0, -90.0, True, True),
    ],
)
def test_cones_of_the_blue_light_sensors(bearing: float, elevation: float, by_any: bool, but_back: bool) -> None:
    """Axes 60 deg left and right, back, up, down, each 120 deg wide: known directions are seen or missed.

    The second robot moves, always within 0.5 m, from above the first to the given direction from it. Each
    of the two that no longer sees the other has lost it once; whether the second sees the first says the
    arc cosine.
    """
    here = np.array([0.2, 0.1, -1.0])
    b, e = np.radians(bearing), np.radians(elevation)
    offset = 0.3 * np.array([np.cos(b) * np.cos(e), np.sin(b) * np.cos(e), np.sin(e)])
    turn = np.array([[np.cos(0.4), -np.sin(0.4), 0], [np.sin(0.4), np.cos(0.4), 0], [0, 0, 1]])
    above = here + np.array([0.0, 0.0, 0.3])
    position = np.stack([[here, above], [here, here + turn @ offset]])
    values = measured(everybody(position, np.full((2, 2), 0.4)))
    lost_any, lost_but_back = (column(values, name)[-1] for name in ("lost_blss", "lost_blss_no_back"))
    seen_by_other = _sees(-(turn @ offset), 0.4)
    assert lost_any == (not by_any) + (not seen_by_other[0])
    assert lost_but_back == (not but_back) + (not seen_by_other[1])
    assert column(values, "lost")[-1] == 0


def _sees(offset: NDArray[np.float64], yaw: float) -> tuple[bool, bool]:
    """Angles to the five cone axes by the arc cosine of dot products."""
    axes = [(60.0, 0.0), (-60.0, 0.0), (0.0, 90.0), (0.0, -90.0), (180.0, 0.0)]
    seen = []
    for azimuth, elevation in axes:
        a, e = np.radians(azimuth) + yaw, np.radians(elevation)
        axis = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
        cosine = axis @ offset / np.linalg.norm(offset)
        seen.append(np.degrees(np.arccos(np.clip(cosine, -1, 1))) <= 60.0 + 1e-6)
    return any(seen), any(seen[:4])


@pytest.mark.parametrize("robots", [2, 3, 11, 40])
def test_components_and_medians_agree_with_scipy_and_numpy(robots: int) -> None:
    """Shoals by scipy's connected components; separation, centres, polarisation by plain numpy."""
    poses = wandering(robots, ticks=8, robots=robots)
    values = measured(poses)
    for tick in range(8):
        for name, expected in _reference(poses.position[tick], poses.yaw[tick]).items():
            np.testing.assert_allclose(values[tick, COLUMN[name]], expected, rtol=1e-12, atol=1e-13, err_msg=name)


def _reference(position: NDArray[np.float64], yaw: NDArray[np.float64]) -> dict[str, float]:
    pairs = pdist(position)
    square = squareform(pairs)
    count, label = connected_components(square <= 0.5, directed=False)
    same = squareform(label[:, None] == label[None, :], checks=False)
    heading = np.column_stack([np.cos(yaw), np.sin(yaw), np.zeros_like(yaw)])
    r = position - position.mean(axis=0)
    raw = np.linalg.norm(np.cross(r / 0.1, heading).mean(axis=0))
    unit = np.linalg.norm(np.cross(r / np.linalg.norm(r, axis=1)[:, None], heading).mean(axis=0))
    np.fill_diagonal(square, np.inf)
    return {
        "shoals": float(count),
        "shoals_of_two": float((np.bincount(label) > 1).sum()),
        "separation": float(np.median(pairs)),
        "separation_same_shoal": float(np.median(pairs[same])) if same.any() else np.nan,
        "separation_nearest": float(np.median(square.min(axis=1))),
        "polarisation": float(np.linalg.norm(heading.mean(axis=0))),
        "angular_momentum": float(unit),
        "angular_momentum_raw": float(raw),
    }


def test_one_robot_alone() -> None:
    """A single robot is aligned with itself, circles around nothing, and is at no distance from anybody."""
    poses = everybody(np.full((2, 1, 3), -1.0), np.zeros((2, 1)))
    assert last(poses, "polarisation") == 1.0
    assert last(poses, "angular_momentum") == 0.0
    assert last(poses, "shoals") == 1
    assert np.isnan(last(poses, "separation"))
