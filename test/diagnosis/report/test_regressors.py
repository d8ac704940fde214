"""Regressors by the contract's names, and residuals in body and world axes."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.findings import Located, ResidualForce
from cocorosim_ros.diagnosis.report.binned_means import CellEdges, binned_means, mean_map
from cocorosim_ros.diagnosis.report.regressors import SaidLaw, followed_by, regressor_of, residual_of, said_law
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE


def moment(yaw: float = 0.0) -> ResidualForce:
    """One moment with numbers that are easy to follow."""
    state = np.array([[0.5, -0.25, -1.0, yaw, 3.0, -4.0, 12.0, 0.5]])
    thrust, force = np.array([[0.01, 0.0, 0.0, 2e-4]]), np.array([[0.02, 0.03]])
    course = Course(
        np.array([7.0]), state, thrust, force, 10.0 * force, np.array([False, True]),
        (np.full(3, -3.0), np.array([3.0, 3.0, 0.0])), np.array([[[0.5, -0.25, -1.0], [0.5, 0.75, -1.0]]]), 0,
    )  # fmt: skip
    return ResidualForce("lily_01", np.array([[1.0, 2.0, 3.0, 4.0]]), np.full((1, 4), 0.1), course)


def located(equation: str, regressor: str, law: Law | None) -> Located:
    """A finding that swings at 0.3 rad/s from 0.4 rad, if it does."""
    return Located(("lily_01",), equation, regressor, "", (0.0, 9.0), 1.0, "N", 9.0, law, (0.3, 0.4))


CASES = [
    ("1", 7.0, "s"),  # a constant is drawn over time
    ("x", 0.5, "m"),
    ("y", -0.25, "m"),
    ("z", -1.0, "m"),
    ("t", 7.0, "s"),
    ("u", 3.0, "m/s"),
    ("v", -4.0, "m/s"),
    ("w", 12.0, "m/s"),
    ("r", 0.5, "rad/s"),
    ("speed", 13.0, "m/s"),
    ("u*v", -12.0, "m^2/s^2"),
    ("|v|*v", -16.0, "m^2/s^2"),
    ("|v|^0.5*v", -8.0, "m^1.5/s^1.5"),
    ("|v|^-1*v", -1.0, "1"),
    ("v*r", -2.0, "m/s^2"),
    ("sin_yaw", 0.0, "1"),
    ("cos_yaw", 1.0, "1"),
    ("sin_t", np.sin(2.5), "1"),
    ("cos_t", np.cos(2.5), "1"),
    ("thrust", 0.01, "N"),
    ("yaw_command", 2e-4, "N m"),
    ("pump", 0.03, "N"),
    ("pump_rate", 0.3, "N/s"),
    ("neighbour_distance", 1.0, "m"),
    ("wall_distance", 1.0, "m"),
]


@pytest.mark.parametrize(("name", "value", "unit"), CASES)
def test_what_a_residual_is_drawn_over(name: str, value: float, unit: str) -> None:
    """Values by hand, units multiplied out."""
    found = followed_by(located("surge", name, Law.parse(f"unknown:surge~{name}")), moment())
    assert found is not None
    assert found.values[0] == pytest.approx(value)
    assert found.unit == unit


def test_every_regressor_is_drawn() -> None:
    """The list above holds the whole table."""
    assert set(REGRESSOR_CODE) <= {name for name, _, _ in CASES}


def test_what_is_no_law_of_motion_is_not_drawn_over_anything() -> None:
    """Streams have no residual force, parameters of effects no values."""
    assert followed_by(located("compass", "sin", None), moment()) is None
    assert followed_by(located("compass", "u", Law.parse("unknown:compass~u")), moment()) is None
    assert residual_of("compass", moment()) is None


def test_the_heading_is_drawn_over() -> None:
    """Though no law is in proportion to it."""
    assert (regressor_of("yaw", moment(0.3)).values[0], regressor_of("yaw", moment()).unit) == (0.3, "rad")


def test_world_axes() -> None:
    """At a quarter turn ahead is north and left is west."""
    turned = moment(np.pi / 2)
    assert [residual_of(name, turned).values[0] for name in ("world_x", "world_y", "world_z", "yaw")] == pytest.approx(
        [-2.0, 1.0, 3.0, 4.0]
    )
    assert said_law(located("surge", "x (world_x)", Law.parse("unknown:world_x~x"))) == SaidLaw("world_x", "x")
    assert said_law(located("yaw", "u*v", Law.parse("unknown:yaw~u*v"))) == SaidLaw("yaw", "u*v")
    assert said_law(located("pose", "u", Law.parse("unknown:velocity~u", "velocity_u"))) == SaidLaw("pose", "u")
    assert said_law(located("compass", "sin", None)) == SaidLaw("compass", "sin")


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
    edges = CellEdges(x=np.array([0.0, 1.0, 2.0]), y=np.array([0.0, 1.0]))
    places = np.array([[0.5, 0.5], [0.6, 0.2], [5.0, 0.5]])
    cells = mean_map(places, np.array([1.0, 3.0, 9.0]), edges)
    assert cells[0, 0] == 2.0
    assert np.isnan(cells[0, 1])
    assert np.isnan(mean_map(places, np.array([1.0, 3.0, 9.0]), edges, least=3)).all()
