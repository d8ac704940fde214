"""What every entry of EFFECTS has to keep, unasked."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world import effects
from cocorosim_ros.world.effects import BASIC_EFFECTS, CATALOGUE_EFFECTS, EFFECTS, LAWS, OF_ACTUATORS
from cocorosim_ros.world.state.state import STATE_SIZE, SURGE, YAW_RATE, row_size
from cocorosim_ros.world.terms.search import Strength
from cocorosim_ros.world.vehicle_model.vehicles import (
    EFFECT_BIT,
    GAINS,
    INERTIA_PARAMETERS,
    PARAMETER_COLUMNS,
    parameter_names,
)

Make = Callable[..., Any]
every_effect = pytest.mark.parametrize("name", EFFECTS)
catalogue = pytest.mark.parametrize("name", CATALOGUE_EFFECTS)
TICKS = 4
IN_LINE = [[0.0, -1.0, 1.0, -1.0, -0.1, 0.0, 0.0, 0.05]]  # 0.1 m behind another one, see terms.jet
BOUNDS = ((-3.1, -3.1, -2.1), (3.1, 3.1, 0.0))


def random_rows(count: int) -> Any:
    """States (count, row_size(3)) of robots anywhere in a tank, at up to twice their terminal speeds."""
    half = np.array([3.0, 3.0, 1.0, 10.0, 0.15, 0.15, 0.5, 3.0])
    rows = np.zeros((count, row_size(3)))
    rows[:, :STATE_SIZE] = np.random.default_rng(11).uniform(-half, half, (count, STATE_SIZE))
    rows[:, 2] -= 1.0
    rows[0, SURGE : YAW_RATE + 1] = 0.0
    return rows


def swum(vehicles: Any, tank: Any, rows: Any, integrator: int = 0, steps: int = 3) -> Any:
    """The rows (runs, robots, columns) after TICKS ticks of 0.5 s under commands that change at every tick."""
    from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move

    state = rows.copy()
    for tick in range(TICKS):
        shape = (*state.shape[:2], 3)
        command = np.sin(1.0 + 2.3 * tick + np.arange(3) + np.arange(shape[1])[:, None]) * np.ones(shape)
        apply_commands(state, command, vehicles)
        move(state, vehicles, tank, Stepping(integrator, steps, 0.5 / steps, 1), np.zeros(0), 0.5 * tick)
    return state


def without_effect(vehicles: Any, name: str) -> Any:
    """The vehicles with one effect less, if they had it."""
    return vehicles._replace(active=vehicles.active & ~EFFECT_BIT[name])


def with_effect(vehicles: Any, name: str, values: Any) -> Any:
    """The vehicles with one effect more; values by the order of its parameters."""
    parameters = vehicles.parameters.copy()
    parameters[..., [PARAMETER_COLUMNS[column] for column in parameter_names(name)]] = values
    return vehicles._replace(parameters=parameters, active=vehicles.active | EFFECT_BIT[name])


def neutral(name: str) -> list[float]:
    """Its parameters where nobody gives any."""
    return [parameter.neutral for parameter in EFFECTS[name].parameters]


def some_numbers(name: str, shape: tuple[int, ...]) -> Any:
    """Parameters that a Lily can have, drawn anew for every robot: (*shape, parameters)."""
    draw = np.random.default_rng(3)
    values = draw.uniform(0.01, 0.1, (*shape, len(EFFECTS[name].parameters))) + np.array(neutral(name))
    for column, parameter in enumerate(EFFECTS[name].parameters):
        if parameter.unit in ("N", "N m", "kg", "kg m", "kg m^2", "N m s", "N m s^2", "N s/m", "N/m", "*"):
            values[..., column] *= 0.001
        if parameter.name.startswith(("equation", "regressor")):
            values[..., column] = draw.integers(0, 7, shape)
    if name == "offset_centre":
        values *= 0.2  # within the hull
    return values


@every_effect
@pytest.mark.parametrize("integrator", [0, 1])
def test_without_its_parameters_it_is_nothing(make_vehicles: Make, make_tank: Make, name: str, integrator: int) -> None:
    """With neutral parameters robots swim bit for bit as without it."""
    vehicles, rows = make_vehicles(2, 15), random_rows(30).reshape(2, 15, -1)
    with_nothing = with_effect(vehicles, name, neutral(name))
    tank = make_tank(BOUNDS)
    without = swum(without_effect(vehicles, name), tank, rows, integrator)[..., : STATE_SIZE + 3]
    assert np.array_equal(swum(with_nothing, tank, rows, integrator)[..., : STATE_SIZE + 3], without)


@every_effect
def test_it_does_something_finite(make_vehicles: Make, make_tank: Make, name: str) -> None:
    """With parameters of a common size robots swim elsewhere, and all their numbers stay finite."""
    vehicles, rows = make_vehicles(2, 15), random_rows(30).reshape(2, 15, -1)
    rows[:, 1, :3] = rows[:, 0, :3] + 0.05
    if "side_thrusters" in EFFECTS[name].needs:
        vehicles.actuator_wrench[..., 0, 1] = 0.5
    if "thruster_in_a_jet" in EFFECTS[name].needs:
        vehicles = vehicles._replace(jets=np.tile(IN_LINE, (2, 15, 1, 1)))
    changed = with_effect(vehicles, name, some_numbers(name, (2, 15)))
    tank = make_tank(BOUNDS)
    after, before = swum(changed, tank, rows), swum(without_effect(vehicles, name), tank, rows)
    assert np.isfinite(after).all()
    assert not np.array_equal(after[..., :STATE_SIZE], before[..., :STATE_SIZE])


@every_effect
def test_a_batch_is_its_single_runs(make_vehicles: Make, make_tank: Make, name: str) -> None:
    """30 robots in two runs move bit for bit as each run by itself; and without neighbours each robot by itself."""
    vehicles, rows = make_vehicles(2, 15), random_rows(30).reshape(2, 15, -1)
    changed, tank = with_effect(vehicles, name, some_numbers(name, (2, 15))), make_tank(BOUNDS)
    together = swum(changed, tank, rows)
    for run in range(2):
        one = type(vehicles)(*(part[run : run + 1].copy() for part in changed))
        assert np.array_equal(swum(one, tank, rows[run : run + 1])[0], together[run])


@every_effect
def test_it_tells_what_it_is(name: str) -> None:
    """Each parameter is told in full, the effect has a summary, and acts somewhere."""
    effect = EFFECTS[name]
    assert effect.summary
    places = ("wrench", "inertia", "centre", "water", "command", "thrust", "response")
    assert any(getattr(effect, place) for place in places)
    assert effect.parameters
    for parameter in effect.parameters:
        assert parameter.name.isidentifier() and parameter.unit and parameter.meaning


@pytest.mark.parametrize("name", [name for name in EFFECTS if name not in (*LAWS, *OF_ACTUATORS)])
def test_its_own_file_says_all_of_it(name: str) -> None:
    """The file is called like the effect; equation, units of the terms and examples stand there, and what to check."""
    effect = EFFECTS[name]
    module = importlib.import_module(f"cocorosim_ros.world.effects.{name}")
    assert getattr(module, name.upper()) is effect
    assert effect.whole_equation and effect.numbers == effect.parameters
    assert name in BASIC_EFFECTS or all(number.example is not None for number in effect.numbers)
    if effect.search is not None:
        assert effect.check.endswith(".")
        assert any(isinstance(number.search, Strength) for number in effect.numbers)
        assert all(number.search is not None for number in effect.numbers), "a diagnosis would not know what it is"


def test_no_file_of_an_effect_is_left_out() -> None:
    """Every file beside the table is in it."""
    folder = Path(str(effects.__file__)).parent
    assert {path.stem for path in folder.glob("*.py")} - {"__init__", "law", "rudder", "fin"} == set(EFFECTS) - {
        *LAWS,
        *OF_ACTUATORS,
    }


@pytest.mark.parametrize("name", [name for name, effect in EFFECTS.items() if effect.neighbours])
def test_what_needs_neighbours_is_nothing_without(make_vehicles: Make, make_tank: Make, name: str) -> None:
    """A robot that is alone moves as without the effect: only where others swim does a diagnosis look for it."""
    vehicles, rows, tank = make_vehicles(1, 1), random_rows(1).reshape(1, 1, -1), make_tank(BOUNDS)
    alone = swum(with_effect(vehicles, name, some_numbers(name, (1, 1))), tank, rows)
    assert np.array_equal(alone[..., :STATE_SIZE], swum(vehicles, tank, rows)[..., :STATE_SIZE])


def test_every_parameter_has_a_column() -> None:
    """No two parameters share a column, and none is left over."""
    names = [column for name in EFFECTS for column in parameter_names(name)]
    assert len(PARAMETER_COLUMNS) == len(INERTIA_PARAMETERS) + len(GAINS) + len(names)
    assert sorted(PARAMETER_COLUMNS.values()) == list(range(len(PARAMETER_COLUMNS)))


@catalogue
def test_columns_of_the_catalogue_carry_its_names(name: str) -> None:
    """A column is called like the effect and its parameter."""
    for parameter in EFFECTS[name].parameters:
        assert f"{name}.{parameter.name}" in PARAMETER_COLUMNS
