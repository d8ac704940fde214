"""Regressors by the contract's names, and residuals in body and world axes."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.findings import ResidualForce
from cocorosim_ros.diagnosis.report.binned_means import binned_means, mean_map
from cocorosim_ros.diagnosis.report.regressors import law_of, regressor_of, residual_of


def moment(yaw: float = 0.0) -> ResidualForce:
    """One moment with numbers that are easy to follow."""
    return ResidualForce(
        "lily_01", np.array([7.0]), np.array([[1.0, 2.0, 3.0, 4.0]]), np.full((1, 4), 0.1),
        np.array([[0.5, -0.25, -1.0, yaw]]), np.array([[3.0, -4.0, 12.0, 0.5]]), {"thrust": np.array([0.01])},
    )  # fmt: skip


@pytest.mark.parametrize(
    ("name", "value", "unit"),
    [
        ("1", 1.0, "1"),
        ("x", 0.5, "m"),
        ("t", 7.0, "s"),
        ("speed", 13.0, "m/s"),
        ("u*v", -12.0, "m^2/s^2"),
        ("|v|*v", -16.0, "m^2/s^2"),
        ("|v|^0.5*v", -8.0, "m^1.5/s^1.5"),
        ("|v|^-1*v", -1.0, "1"),
        ("v*r", -2.0, "m/s^2"),
        ("cos_yaw", 1.0, "1"),
        ("thrust", 0.01, "N"),
    ],
)
def test_regressors(name: str, value: float, unit: str) -> None:
    """Values by hand, units multiplied out."""
    found = regressor_of(name, moment())
    assert found is not None
    assert found[0][0] == pytest.approx(value)
    assert found[1] == unit


def test_what_was_not_kept_has_no_value() -> None:
    """A regressor that the residual does not hold, and words that are none."""
    assert regressor_of("pump_rate", moment()) is None
    assert regressor_of("sin", moment()) is None
    assert residual_of("compass", moment()) is None


def test_world_axes() -> None:
    """At a quarter turn ahead is north and left is west."""
    turned = moment(np.pi / 2)
    assert [residual_of(name, turned)[0][0] for name in ("world_x", "world_y", "world_z", "yaw")] == pytest.approx(
        [-2.0, 1.0, 3.0, 4.0]
    )
    assert law_of("surge", "x (world_x)") == ("world_x", "x")
    assert law_of("yaw", "u*v") == ("yaw", "u*v")


def test_means_in_classes_count_visits() -> None:
    """Two classes visited four times each: means by hand; the interval is that of the mean over visits."""
    x = np.repeat([0.0, 1.0] * 4, 5)
    y = np.repeat([1.0, 10.0, 2.0, 10.0, 3.0, 10.0, 4.0, 10.0], 5)
    means = binned_means(x, y, classes=2)
    assert means.mean == pytest.approx([2.5, 10.0])
    # Four visits 1, 2, 3, 4: variance of the mean 1/4^2 * (2 * 1.5^2 + 2 * 0.5^2) * 4/3.
    assert means.half_width == pytest.approx([1.96 * np.sqrt(5.0 / 16.0 * 4.0 / 3.0), 0.0])


def test_a_class_that_was_visited_once_has_no_interval() -> None:
    """One visit says nothing of the next."""
    assert np.isnan(binned_means(np.array([0.0, 0.0, 1.0]), np.zeros(3), classes=2).half_width).all()
    assert len(binned_means(np.array([np.nan]), np.zeros(1)).mean) == 0


def test_maps_have_means_where_the_robot_was() -> None:
    """A grid of two by one cells, one of which has two samples."""
    edges = (np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0]))
    places = np.array([[0.5, 0.5], [0.6, 0.2], [5.0, 0.5]])
    cells = mean_map(places, np.array([1.0, 3.0, 9.0]), edges)
    assert cells[0, 0] == 2.0
    assert np.isnan(cells[0, 1])
    assert np.isnan(mean_map(places, np.array([1.0, 3.0, 9.0]), edges, least=3)).all()
