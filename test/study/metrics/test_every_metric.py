"""What must hold of every metric of the table, also of one that is added tomorrow."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from cocorosim_ros.study.metrics import FAMILIES, METRICS, PAPER_METRICS
from cocorosim_ros.study.metrics.kernel import measure_tick
from cocorosim_ros.study.metrics.memory import new_memory

from .swarm_poses import STEP_NS, Poses, column, measured, wandering

SEEDS = (1, 2, 3, 4)


@pytest.fixture(scope="module")
def runs() -> list[tuple[Poses, NDArray[np.float64]]]:
    """Wandering swarms and their values."""
    return [(poses, measured(poses)) for poses in map(wandering, SEEDS)]


def test_no_two_metrics_have_one_name() -> None:
    """A name that two families use would hide one of them."""
    assert len(METRICS) == sum(len(family.metrics) for family in FAMILIES)


def test_the_six_metrics_of_the_paper_are_marked() -> None:
    """The paper has six metrics."""
    assert set(PAPER_METRICS) == {
        "polarisation", "angular_momentum", "shoal_speed", "separation", "lost", "shoals",
    }  # fmt: skip


@pytest.mark.parametrize("name", METRICS)
def test_record_is_complete(name: str) -> None:
    """Every metric has a unit, a formula and a source, and its key is its name."""
    metric = METRICS[name]
    assert metric.name == name
    assert metric.unit and metric.formula and metric.source


@pytest.mark.parametrize("name", METRICS)
def test_is_finite(name: str, runs: list[tuple[Poses, NDArray[np.float64]]]) -> None:
    """From the second tick on every metric of an ordinary swarm is a number."""
    for _, values in runs:
        assert np.isfinite(column(values, name)[1:]).all()


@pytest.mark.parametrize("name", METRICS)
def test_varies(name: str, runs: list[tuple[Poses, NDArray[np.float64]]]) -> None:
    """No metric is stuck at one value while swarms split and drift."""
    assert np.ptp(np.concatenate([column(values, name)[1:] for _, values in runs])) > 0.0


@pytest.mark.parametrize("name", METRICS)
def test_order_of_robots_is_irrelevant(name: str, runs: list[tuple[Poses, NDArray[np.float64]]]) -> None:
    """Numbering the robots differently changes nothing beyond rounding."""
    for poses, values in runs:
        order = np.random.default_rng(5).permutation(poses.yaw.shape[1])
        shuffled = measured(Poses(poses.position[:, order], poses.yaw[:, order], poses.present[:, order]))
        np.testing.assert_allclose(column(shuffled, name), column(values, name), rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize("name", METRICS)
def test_rigid_motion_changes_nothing(name: str, runs: list[tuple[Poses, NDArray[np.float64]]]) -> None:
    """Shifting the whole swarm, and turning it about the vertical, leaves every metric as it is.

    A coordinate-wise median depends on the axes; quarter turns only swap these.
    """
    angle = 0.7 if METRICS[name].frame_free else np.pi / 2
    turn = np.array([[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
    for poses, values in runs:
        moved = Poses(poses.position @ turn.T + np.array([3.0, -2.0, -1.0]), poses.yaw + angle, poses.present)
        np.testing.assert_allclose(column(measured(moved), name), column(values, name), rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("name", METRICS)
def test_absent_robot_is_as_if_it_did_not_exist(name: str, runs: list[tuple[Poses, NDArray[np.float64]]]) -> None:
    """A robot that is absent throughout, whatever its pose says, changes no value."""
    for poses, values in runs:
        ticks = poses.yaw.shape[0]
        for junk in (np.nan, 0.0, np.inf):
            more = Poses(
                np.concatenate([poses.position, np.full((ticks, 1, 3), junk)], axis=1),
                np.concatenate([poses.yaw, np.full((ticks, 1), junk)], axis=1),
                np.concatenate([poses.present, np.zeros((ticks, 1), np.bool_)], axis=1),
            )
            np.testing.assert_array_equal(column(measured(more), name), column(values, name))


@pytest.mark.parametrize("name", METRICS)
def test_a_pose_that_is_not_a_number_poisons_nothing(name: str) -> None:
    """A robot with NaN for a position, or for a yaw, counts as absent; the others' values stay numbers."""
    poses = wandering(6)
    poses.position[4, 2, 1] = np.nan
    poses.yaw[7, 3] = np.nan
    said_absent = Poses(np.nan_to_num(poses.position), np.nan_to_num(poses.yaw), poses.present.copy())
    said_absent.present[4, 2] = said_absent.present[7, 3] = False
    values = column(measured(poses), name)
    assert np.isfinite(values[1:]).all()
    np.testing.assert_array_equal(values, column(measured(said_absent), name))


@pytest.mark.parametrize("name", METRICS)
def test_nobody_gives_no_number(name: str) -> None:
    """Without any robot a metric is NaN, and a count is zero."""
    poses = wandering(1, ticks=2)
    values = column(measured(Poses(poses.position, poses.yaw, np.zeros_like(poses.present))), name)
    expected = 0.0 if METRICS[name].summary == "last" else np.nan
    np.testing.assert_array_equal(values, np.full(2, expected))


def test_a_batch_of_runs_gives_the_bits_of_single_runs() -> None:
    """Three hundred runs measured at once equal the same runs measured alone, bit for bit."""
    swarms = [wandering(seed, ticks=4) for seed in range(300)]
    memory = new_memory(len(swarms), 11)
    together = np.empty((4, len(swarms), len(METRICS)))
    for tick in range(4):
        position, yaw, present = (
            np.stack([getattr(swarm, field)[tick] for swarm in swarms]) for field in ("position", "yaw", "present")
        )
        elapsed = np.full(len(swarms), 0 if tick == 0 else STEP_NS)
        measure_tick(position, yaw, present, elapsed, memory, together[tick])
    alone = np.stack([measured(swarm) for swarm in swarms], axis=1)
    assert together.tobytes() == alone.tobytes()


@pytest.mark.parametrize("robots", [1, 2, 3, 11, 12, 30])
@pytest.mark.parametrize("runs", [*range(1, 10)])
def test_runs_beside_others_have_the_bits_of_runs_alone(robots: int, runs: int) -> None:
    """In one, two or three fours of runs, with robots absent and several shoals: neighbours change no bit."""
    generator = np.random.default_rng([robots, runs])
    homes = generator.choice([0.0, 0.4, 3.0], (runs, robots, 1))
    memory, alone = new_memory(runs, robots), [new_memory(1, robots) for _ in range(runs)]
    together, each = np.empty((runs, len(METRICS))), np.empty((runs, len(METRICS)))
    for tick in range(4):
        position = homes + generator.uniform(-0.3, 0.3, (runs, robots, 3))
        position[generator.random(position.shape) < 0.02] = np.nan
        yaw = generator.uniform(-np.pi, np.pi, (runs, robots))
        present = generator.random((runs, robots)) < 0.9
        elapsed = np.full(runs, STEP_NS if tick else 0)
        measure_tick(position, yaw, present, elapsed, memory, together)
        for run in range(runs):
            row = slice(run, run + 1)
            measure_tick(position[row], yaw[row], present[row], elapsed[row], alone[run], each[row])
        assert together.tobytes() == each.tobytes()


def test_arrays_that_do_not_fit_are_refused() -> None:
    """Values of the wrong width, or memory of another swarm, would write outside their arrays."""
    poses = wandering(1, ticks=1)
    elapsed = np.zeros(1, np.int64)
    with pytest.raises(ValueError, match="do not fit"):
        measure_tick(poses.position, poses.yaw, poses.present, elapsed, new_memory(1, 11), np.empty((1, 3)))
    with pytest.raises(ValueError, match="do not fit"):
        measure_tick(poses.position, poses.yaw, poses.present, elapsed, new_memory(1, 4), np.empty((1, len(METRICS))))
