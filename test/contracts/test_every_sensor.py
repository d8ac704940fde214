"""What every sensor of SENSORS and every error of ERRORS has to keep, unasked."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.units.unit_algebra import powers_of
from cocorosim_ros.scenario.parts.corruption import SENSOR_CHANNELS
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.stamped_numbers import numbers_of
from cocorosim_ros.wire.cdr.type_store import build
from cocorosim_ros.world.controllers.controller import EXTRA_TOPICS
from cocorosim_ros.world.laws.law import Product
from cocorosim_ros.world.sensors import KINDS, SENSORS, errors
from cocorosim_ros.world.sensors.errors import ERROR_COLUMNS, ERRORS, changes_of
from cocorosim_ros.world.sensors.law import NO_REGRESSORS_OF_READINGS
from cocorosim_ros.world.sensors.readings import FIELDS
from cocorosim_ros.world.sensors.sensor import PER_CONE, Elements
from cocorosim_ros.world.sensors.sensor_error import TAKEN
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.motors import Motors
from cocorosim_ros.world.terms.search import Strength

CONES = tuple(BlueLightSensor(name, azimuth, 0.0, 2.0, 0.5, 0.3) for name, azimuth in (("left", 1.0), ("right", -1.0)))
MOTORS = Motors(np.array([False, False, True]), np.zeros((3, 0)), np.full((3, 2), 0.005))
OTHERS = {
    "row": np.full(11, 0.003),
    "heading": 0.7,
    "water": np.array([0.3, -0.2, 0.1, 0.5]),
    "ground": np.array([0.4, -0.1, 0.1]),
    "motors": MOTORS,
}
"""What errors may depend on beside their own reading, of a robot with two thrusters and a pump."""
every_sensor = pytest.mark.parametrize("topic", SENSORS)
every_kind = pytest.mark.parametrize("name", KINDS)
CHANGES = [(error, change) for error, described in ERRORS.items() for change in described.changes]
every_change = pytest.mark.parametrize(
    ("error", "change"), CHANGES, ids=[f"{name}-{each.kind}" for name, each in CHANGES]
)


@every_sensor
def test_its_numbers_fill_its_message(topic: str) -> None:
    """As many places as its fields have numbers; each place takes a number and gives it back."""
    sensor = SENSORS[topic]
    layout = sensor.layout(CONES)
    widths = [len(CONES) if field.width == PER_CONE else field.width or 1 for field in sensor.fields]
    assert sensor.measure is None or sum(widths) == len(layout.places)
    message = PackedMessage([build(sensor.message, {"header": {"frame_id": "a"}, **layout.content})], layout.places)
    values = np.random.default_rng(1).normal(size=(1, len(layout.places)))
    assert np.array_equal(message.decode(message.encode(10**9, values)[0]), values[0])


@every_sensor
def test_it_tells_what_it_is(topic: str) -> None:
    """In words; a diagnosis that knows its numbers knows how to read its topic; only its own channels are corrupted."""
    sensor = SENSORS[topic]
    assert sensor.meaning and not sensor.meaning.endswith(".")
    assert bool(sensor.kinds) == (sensor.recorded is not None)
    assert {name for field in sensor.fields for name in field.channels} <= set(SENSOR_CHANNELS)
    if sensor.recorded is not None:
        picked = sensor.recorded.columns(np.ones((4, sensor.recorded.numbers)))
        assert picked.shape == (4, len(sensor.kinds))
        assert not sensor.recorded.drawn or sensor.recorded.drawn in KINDS


def test_what_controllers_may_ask_for_is_there() -> None:
    """Sensors that are asked for, and what is heard or only the simulation knows; nothing else, and none left out."""
    asked = {topic for topic, sensor in SENSORS.items() if sensor.asked}
    assert set(EXTRA_TOPICS) == asked | {"blue_light_rx", "neighbours", "acoustic_rx"}


def test_what_controllers_see_is_measured() -> None:
    """Every field of an observation beside time and talk is a field of a sensor, each of which is seen whole."""
    talk = {"time", "heard_count", "heard", "light_count", "light", "sound_count", "sound"}
    shown = {name for name in Observation._fields if name not in talk and not name.startswith("neighbour_")}
    assert shown | {"neighbour_range"} <= set(FIELDS)
    for sensor in SENSORS.values():
        assert len({field.name in Observation._fields for field in sensor.fields}) <= 1


def test_every_channel_has_a_field() -> None:
    """What a scenario may corrupt is measured by some sensor."""
    assert {name for field in FIELDS.values() for name in field.channels} == set(SENSOR_CHANNELS)


def expected(name: str, state: Any, after: float, numbers: Any) -> float:
    """What the filter expects, `after` [s] behind a state that does not accelerate."""
    from cocorosim_ros.diagnosis.filter.reading import expected as expect
    from cocorosim_ros.diagnosis.filter.records import Rates, When

    still = Rates(np.zeros(STATE_SIZE), np.zeros(STATE_SIZE))
    code = list(KINDS).index(name)
    when, row = When(3.0, after, abs(after), 0.0), np.concatenate([state, [0.004, -0.002, 0.0]])
    return float(expect(code, when, row, still, numbers, state[4:8].copy(), MOTORS))


@every_kind
def test_its_sensitivity_is_the_slope_of_what_it_shows(name: str) -> None:
    """Central differences by each number of the state, with errors, where the rate of the state does not change."""
    from cocorosim_ros.diagnosis.filter.layout import NEUTRAL_SENSORS
    from cocorosim_ros.diagnosis.filter.reading import sensitivity, sensitivity_upright

    kind, code, after = KINDS[name], list(KINDS).index(name), 0.04
    rng = np.random.default_rng(5)
    numbers = np.array(NEUTRAL_SENSORS) + rng.uniform(0.02, 0.1, len(NEUTRAL_SENSORS))
    state = rng.uniform(0.1, 0.9, STATE_SIZE)
    columns = (2, 6) if kind.upright else (0, 1, 3, 4, 5, 7)
    size, slope_of = (VERTICAL, sensitivity_upright) if kind.upright else (HORIZONTAL, sensitivity)
    seen, still = np.full(size, np.nan), np.zeros(HORIZONTAL * HORIZONTAL)
    slope_of(code, after, state, numbers, still, seen)
    for place, column in enumerate(columns):
        up, down = state.copy(), state.copy()
        up[column], down[column] = up[column] + 1e-4, down[column] - 1e-4
        slope = (expected(name, up, after, numbers) - expected(name, down, after, numbers)) / 2e-4
        # A heading is turned where the robot is, not where it will be: a hundredth of a radian with these numbers.
        assert seen[place] == pytest.approx(slope, rel=0.01, abs=1e-3 * max(1.0, abs(slope))), (name, column)


@every_change
def test_neutral_numbers_change_no_bit(error: str, change: Any) -> None:
    """In simulation and filter alike."""
    neutral = {part.name: part.neutral for part in ERRORS[error].parameters}
    given = [neutral[name] for name in change.numbers]
    for value in (0.3, -2.9, 101325.0 + 1234.5):
        for shown in (change.shown, change.foreseen or change.shown):
            assert shown(value, value, 7.0, *(OTHERS[name] for name in change.takes), *given) == value


@every_change
def test_simulation_and_filter_agree(error: str, change: Any) -> None:
    """Where they do not share one function the two differ by rounding alone."""
    rng = np.random.default_rng(9)
    for value, stamp, *given in rng.uniform(-3.0, 3.0, (50, 2 + len(change.numbers))):
        taken = [OTHERS[name] for name in change.takes]
        foreseen = (change.foreseen or change.shown)(value, value, stamp, *taken, *given)
        assert change.shown(value, value, stamp, *taken, *given) == pytest.approx(foreseen, rel=1e-14, abs=1e-14)


@pytest.mark.parametrize("name", ERRORS)
def test_the_file_of_an_error_says_all_of_it(name: str) -> None:
    """The file is called like the error; what changes is a number of its own sensor; every number is looked for."""
    error = ERRORS[name]
    assert getattr(importlib.import_module(f"cocorosim_ros.world.sensors.errors.{name}"), name.upper()) is error
    assert error.summary and error.check.endswith(".")
    assert all(KINDS[change.kind] in SENSORS[error.sensor].kinds for change in error.changes)
    assert {number for change in error.changes for number in change.numbers} in (set(), {n.name for n in error.numbers})
    assert all(isinstance(number.search, Strength) and number.example is not None for number in error.numbers)
    assert set(error.beside) <= set(ERRORS)


@every_change
def test_what_an_error_depends_on_is_known(error: str, change: Any) -> None:
    """Beside its reading it takes what simulation and filter can give."""
    assert set(change.takes) <= set(TAKEN) == set(OTHERS)


def test_no_file_of_an_error_is_left_out() -> None:
    """Every file beside the table is in it, and every number of what changes readings has a column of its own."""
    files = {path.stem for path in Path(str(errors.__file__)).parent.glob("*.py")}
    assert files - {"__init__"} == set(ERRORS)
    columns = [column for kind in KINDS for _, found in changes_of(kind) for column in found]
    assert set(columns) == set(range(len(ERROR_COLUMNS)))


@pytest.mark.parametrize("name", KINDS)
def test_a_reading_has_a_least_noise(name: str) -> None:
    """Above zero, its logarithm is taken; readings that share their noise share this, too."""
    kind = KINDS[name]
    assert kind.least_noise > 0.0
    assert {each.least_noise for each in KINDS.values() if kind.noise and each.noise == kind.noise} <= {
        kind.least_noise
    }


@pytest.mark.parametrize("name", KINDS)
def test_errors_of_a_reading_are_described(name: str) -> None:
    """Each product is read as it is written, no two are the same, and its regressors exist for a single robot."""
    kind = KINDS[name]
    products = [Product.parse(text) for text in kind.error_follows]
    assert [product.text for product in products] == list(kind.error_follows)
    assert len(set(products)) == len(products) > 0
    regressors = {factor.name for product in products for factor in product.factors}
    assert not regressors & set(NO_REGRESSORS_OF_READINGS)
    assert kind.large_error > kind.least_noise


@every_sensor
def test_a_sensor_that_a_diagnosis_reads_shows_motion(topic: str) -> None:
    """In one of its numbers at least, from a size on that is above the noise of the filter's steps."""
    kinds = SENSORS[topic].kinds
    shown = [kind for kind in kinds if kind.least_motion is not None]
    assert bool(shown) == bool(kinds)
    assert all(kind.least_motion > kind.least_noise for kind in shown)


@every_sensor
def test_its_messages_are_read(topic: str) -> None:
    """Of a header and numbers, every column and every place of the layout is one of them; else as named elements."""
    sensor = SENSORS[topic]
    numbers = numbers_of(sensor.message)
    if isinstance(sensor.shown, Elements):
        assert not numbers and powers_of(sensor.shown.unit) is not None
        return
    assert {column.place for column in sensor.shown} | set(sensor.layout(()).places) <= set(numbers)
    assert len({column.name for column in sensor.shown}) == len(sensor.shown)
    assert bool(sensor.shown) == bool(sensor.fields)  # places are read as tracks
    assert sensor.recorded is None or sensor.recorded.numbers == len(numbers)


SHOWN_BY_ITSELF = {"gyro_z": "r", "compass": "yaw", "pressure": "z", "velocity_u": "u", "velocity_v": "v"}
"""The regressor of laws that a reading is, or is a straight line of."""


@pytest.mark.parametrize("name", SHOWN_BY_ITSELF)
def test_no_law_of_a_reading_is_an_error_with_a_name(name: str) -> None:
    """Where both are looked for, the same error could be named twice, with two halves of its size."""
    from cocorosim_ros.diagnosis.catalogue.sensor_laws import SENSOR_LAWS_OF

    truth = np.random.default_rng(8).uniform(-3.0, 3.0, 300)
    known = {SHOWN_BY_ITSELF[name]: truth, "sin_yaw": np.sin(truth), "cos_yaw": np.cos(truth)}
    slopes = [slope_by_number(error, change, number, truth) for error, change, number in plain_numbers_of(name)]
    shapes = [np.column_stack([slope, np.ones(300)]) for slope in slopes if np.ptp(slope) > 1e-6]
    assert shapes
    for product in SENSOR_LAWS_OF[name]:
        if {each.strip("|") for each in product.text.split("*")} <= set(known):
            factors = [abs(known[e.strip("|")]) if "|" in e else known[e] for e in product.text.split("*")]
            law = np.prod(factors, axis=0)
            for shape in shapes:
                left = law - shape @ np.linalg.lstsq(shape, law, rcond=None)[0]
                assert float(np.std(left)) > 1e-3 * float(np.std(law)), product.text


def plain_numbers_of(name: str) -> list[tuple[str, Any, int]]:
    """Errors, changes and places of their numbers, of a reading, that depend on nothing but it."""
    return [
        (error, change, place)
        for error, each in ERRORS.items()
        for change in each.changes
        if change.kind == name and not change.takes
        for place in range(len(change.numbers))
    ]


def slope_by_number(error: str, change: Any, place: int, truth: Any) -> Any:
    """Derivative (n,) of what is shown by one number of an error, at values of the truth (n,)."""
    neutral = {part.name: part.neutral for part in ERRORS[error].parameters}
    numbers = np.array([neutral[each] for each in change.numbers])
    step = np.zeros(len(numbers))
    step[place] = 1e-3
    return np.array(
        [(change.shown(v, v, 0.0, *(numbers + step)) - change.shown(v, v, 0.0, *numbers)) / 1e-3 for v in truth]
    )
