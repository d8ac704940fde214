"""Rows of numbers by name."""

from __future__ import annotations

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.vehicle_model.columns import numbered, stretch_of
from cocorosim_ros.world.vehicle_model.vehicles import MASS, PARAMETER_COLUMNS, YAW_INERTIA


def test_columns_are_in_the_order_of_the_names() -> None:
    """From zero on."""
    assert numbered(["mass", "drag", "gain"]) == {"mass": 0, "drag": 1, "gain": 2}


def test_a_name_stands_once() -> None:
    """Two columns of one name would leave one without a way to it."""
    with pytest.raises(CocorosimError, match="two columns 'drag'"):
        numbered(["drag", "mass", "drag"])


def test_a_stretch_is_of_columns_behind_each_other() -> None:
    """Two in the middle are; the outer ones, or these turned round, are not."""
    columns = numbered(["mass", "drag", "gain", "lag"])
    assert stretch_of(columns, ["drag", "gain"]) == slice(1, 3)
    for names in (["mass", "lag"], ["gain", "drag"]):
        with pytest.raises(CocorosimError, match="behind each other"):
            stretch_of(columns, names)


def test_the_physics_stand_at_the_same_places_in_a_row_of_the_diagnosis() -> None:
    """So that a slice of that row is a body's row."""
    from cocorosim_ros.diagnosis.tracks.columns import COLUMN, PHYSICS

    assert {name: COLUMN[name] - PHYSICS.start for name in PARAMETER_COLUMNS} == PARAMETER_COLUMNS
    assert (COLUMN["mass"], COLUMN["yaw_inertia"]) == (MASS, YAW_INERTIA)
