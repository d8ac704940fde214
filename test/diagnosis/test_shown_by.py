"""An error of a reading is told by other readings, or not at all, and it is no larger than an instrument can err."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.sensor_laws import SENSOR_LAWS_OF
from cocorosim_ros.diagnosis.catalogue.shown_by import LENGTHS, SHOWN_BY, can_be_told, is_shown, own_state
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.regressors import REGRESSOR

POSE = frozenset({"pose_x", "pose_y", "pose_z", "pose_yaw"})
ON_BOARD = frozenset({"compass", "pressure", "gyro_z", "accel_x", "accel_y", "accel_z"})
GROUND = frozenset({"ground_velocity_u", "ground_velocity_v"})
KNOWN = {"1", "t", "thrust", "yaw_command", "pump", "pump_rate"}


def law(reading: str, product: str) -> Any:
    """The entry of a law of readings."""
    from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
    from cocorosim_ros.world.laws.law import Law, Product

    form = Law(reading, Product.parse(product))
    amplitude = Amplitude("sensor_law_1.coefficient", "coefficient", form.unit, 1.0)
    return Entry(form.text, "", "", form.topic or "", (amplitude,), topic=form.topic, law="sensor_law_1", form=form)


@pytest.mark.parametrize(
    ("reading", "product", "present", "told"),
    [
        ("pressure", "z", ON_BOARD, False),
        ("pressure", "z", ON_BOARD | {"pose_z"}, True),
        ("pressure", "z", ON_BOARD | {"velocity_w"}, True),
        ("pressure", "t", ON_BOARD, True),
        ("pressure", "pump", frozenset({"pressure"}), True),
        ("pressure", "speed", ON_BOARD, False),
        ("compass", "r", frozenset({"compass"}), False),
        ("compass", "r", frozenset({"compass", "gyro_z"}), True),
        ("compass", "sin_yaw*cos_yaw", frozenset({"compass", "pose_yaw"}), True),
        ("gyro_z", "z", frozenset({"gyro_z", "pressure"}), True),
        ("gyro_z", "z", frozenset({"gyro_z"}), False),
        ("gyro_z", "r", frozenset({"gyro_z", "compass"}), True),
        ("pose_x", "y", POSE, True),
        ("pose_x", "x*y", POSE, False),
        ("pose_x", "x*y", POSE | {"velocity_u", "velocity_v"}, True),
        ("pose_x", "x*y", POSE | GROUND, True),
        ("pose_z", "z", POSE, False),
        ("pose_z", "x", POSE, True),
        ("velocity_u", "u", POSE | {"velocity_u"}, True),
        ("velocity_u", "u", frozenset({"velocity_u", "compass"}), False),
        ("velocity_u", "|u|*u", frozenset({"velocity_u", "ground_velocity_u"}), True),
        ("ground_velocity_u", "|u|*u", POSE | GROUND, True),
        ("ground_velocity_u", "|u|*u", GROUND, False),
    ],
)
def test_a_law_needs_another_reading(reading: str, product: str, present: frozenset[str], told: bool) -> None:
    """What this reading alone shows cannot be what its error depends on; time and commands always can."""
    assert can_be_told(law(reading, product), [present]) is told
    assert can_be_told(law(reading, product), [frozenset(), present]) is told


@pytest.mark.parametrize(
    ("identifier", "present", "told"),
    [
        ("compass_distortion", frozenset({"compass", "pressure"}), False),
        ("compass_distortion", frozenset({"compass", "gyro_z"}), True),
        ("camera_scale", POSE, False),
        ("camera_scale", POSE | {"compass", "gyro_z"}, False),
        ("camera_scale", POSE | {"pressure"}, True),
        ("camera_scale", POSE | {"velocity_u", "velocity_v"}, True),
        ("pressure_offset", frozenset({"pressure"}), True),
        ("pressure_drift", frozenset({"pressure"}), True),
        ("imu_bias", frozenset({"gyro_z"}), True),
        ("linear_drag", frozenset({"pressure"}), True),
        ("speed_log_scale", frozenset({"velocity_u", "velocity_v", "compass"}), False),
        ("speed_log_scale", POSE | {"velocity_u", "velocity_v"}, True),
        ("speed_log_misalignment", frozenset({"velocity_u", "velocity_v", "pressure", "compass"}), False),
        ("speed_log_misalignment", POSE | {"velocity_u", "velocity_v"}, True),
        ("speed_log_misalignment", {"pose_x", "pose_y", "compass", "velocity_u", "velocity_v"}, True),
        ("speed_log_lever", {"velocity_u", "velocity_v", "gyro_z"}, True),
        ("speed_log_lever", {"velocity_u", "velocity_v", "pressure"}, False),
        ("ground_log_lever", GROUND | {"gyro_z"}, True),
        ("ground_log_lever", GROUND, False),
        ("ground_log_scale", GROUND | {"compass"}, False),
        ("ground_log_scale", POSE | GROUND, True),
        ("ground_log_scale", GROUND | {"velocity_u", "velocity_v"}, True),
        ("ground_log_misalignment", GROUND | {"compass"}, False),
        ("ground_log_misalignment", GROUND | {"velocity_u", "velocity_v"}, True),
        ("camera_scale", POSE | GROUND, True),
        ("pose_heading", POSE | GROUND, True),
        ("pose_heading", POSE, False),
        ("pose_heading", POSE | {"gyro_z"}, False),
        ("pose_heading", POSE | {"compass"}, True),
        ("pose_heading", POSE | {"velocity_u", "velocity_v"}, True),
        ("pose_lever", POSE, False),  # cameras alone
        ("pose_lever", POSE | {"compass"}, True),
        ("pose_lever", POSE | {"gyro_z"}, True),
        ("pose_lever", frozenset({"pose_x", "pose_y"}), False),
        ("motor_field", frozenset({"compass"}), True),
    ],
)
def test_an_error_of_the_catalogue_needs_another_reading(identifier: str, present: frozenset[str], told: bool) -> None:
    """Gains and distortions do; offsets, drifts and physics do not."""
    (entry, *_) = [each for each in ENTRIES if each.id == identifier]
    assert can_be_told(entry, [present]) is told


def test_a_vehicle_of_known_numbers_shows_lengths() -> None:
    """Poses alone then tell a camera's scale, but no law of poses by place, and no heading."""
    known = {each.id: can_be_told(each, [POSE], LENGTHS) for each in ENTRIES}
    assert known["camera_scale"] and not known["pose_heading"]
    assert not can_be_told(law("pose_x", "x"), [POSE], LENGTHS)


def test_every_regressor_of_a_reading_is_known_or_shown() -> None:
    """A new regressor or kind of reading has to say by what it is shown."""
    used = {factor.name for products in SENSOR_LAWS_OF.values() for each in products for factor in each.factors}
    assert used <= KNOWN | set(SHOWN_BY)
    assert not KNOWN & set(SHOWN_BY)
    assert set(SHOWN_BY) - {"yaw", "zero_of_yaw"} <= set(REGRESSOR)
    assert {kind for sets in SHOWN_BY.values() for each in sets for kind in each} <= set(KINDS)
    for kind in KINDS:
        assert len(own_state(kind)) == (not kind.startswith("accel"))
        for state in own_state(kind):
            assert not is_shown(state, [kind], [kind]) and is_shown(state, [kind], [*KINDS])


def only(evidence: Any, topics: tuple[str, ...], change: Callable[[str, Any], Any]) -> Any:
    """Evidence of the same swim with these topics alone, each changed."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {name: change(name, log.streams[name]) for name in topics}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def test_a_gauge_alone_does_not_explain_the_depth_away(swim: Any) -> None:
    """A gauge that shows half the depth, without poses: neither a law nor a gain, an offset or a drift is its name.

    That something is wrong is said, of the depth and without a name.
    """
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    def half(name: str, stream: Any) -> Any:
        return replace(stream, value=0.5 * (101325.0 + stream.value)) if name == "pressure" else stream

    lily = load_platform("lily")
    alone = diagnose(only(swim(lily, 100.0, seed=11), ("compass", "pressure", "imu"), half), lambda words, share: None)
    assert not [each.id for each in alone.effects if each.topic == "pressure" or each.id.startswith("pressure")]
    assert alone.beyond_floor == ("depth",) and alone.verdict == "mismatch"
    assert any("cannot be told" in said and "pressure" in said for said in alone.untold)


def test_an_error_beyond_the_instrument_is_no_hypothesis(swim: Any) -> None:
    """By hand: 0.4 rad of offset is a compass, 0.6 rad is none; a drift of 30 Pa/s is 3000 Pa after 100 s."""
    from cocorosim_ros.diagnosis.fitting.candidate import expand
    from cocorosim_ros.diagnosis.fitting.fit import evaluated
    from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
    from cocorosim_ros.diagnosis.naming.instruments import is_beyond_instrument, most_error
    from cocorosim_ros.scenario.parts.platform import load_platform

    fit = first_fit(swim(load_platform("lily"), 100.0, seed=12))
    candidates = {each.entry.id: each for each in expand(ENTRIES, fit.tracks, fit.rows)}

    def beyond(identifier: str, values: dict[str, float]) -> bool:
        candidate = candidates[identifier]
        new = candidate.amplitudes()
        q = [values.get(each.owner.parameter, each.base) - each.base for each in new]
        scaled = [number / each.scale for number, each in zip(q, new, strict=True)]
        with_it = replace(fit, unknowns=(*fit.unknowns, *new), q=np.concatenate([fit.q, scaled]))
        return is_beyond_instrument(candidate, evaluated(with_it))

    assert not beyond("compass_distortion", {"offset": 0.4})
    assert beyond("compass_distortion", {"offset": -0.6})
    assert not beyond("pressure_drift", {"rate": 10.0})
    assert beyond("pressure_drift", {"rate": 30.0})
    assert not beyond("torque_bias", {"torque": 1.0})
    assert most_error("pressure", np.array([0.0, 80000.0])) == pytest.approx(4000.0)  # a tenth of a spread of 40 kPa
    assert most_error("compass", np.array([0.0, 100.0])) == 0.5
    assert most_error("pose_x", np.array([0.0, 8.0])) == pytest.approx(0.4)  # a tenth of a spread of 4 m
    assert most_error("pose_x", np.array([0.0, 8.0]), ERRORS["camera_scale"].most_error) == pytest.approx(1.4)
    assert most_error("pose_x", np.array([0.0, 8.0]), ERRORS["pose_lever"].most_error, 1.2) == 1.2  # a hull of 1.2 m
