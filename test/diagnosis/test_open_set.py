"""Laws outside the catalogue: those of readings along a known course, and that no law is reported where none is."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.catalogue.sensor_laws import SENSOR_LAWS_OF
from cocorosim_ros.diagnosis.filter.layout import COMPASS, KIND_NAMES, PRESSURE
from cocorosim_ros.diagnosis.filter.records import Readings
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.reading_laws import law_shift
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.laws.readings import READING_CODE, READINGS
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

SECONDS = 150.0


def test_codes_of_readings_are_the_filters() -> None:
    """One order of readings, and laws for all of them."""
    assert tuple(READING_CODE) == KIND_NAMES
    assert set(SENSOR_LAWS_OF) == set(READING_CODE)


def course() -> Course:
    """Eleven grid points, 0.1 s apart: z falls by 0.5 m/s, yaw is 0.7, two thrusters and a pump work."""
    time, state = 0.1 * np.arange(11), np.zeros((11, 12))
    state[:, 2], state[:, 3], state[:, 7] = -0.5 * time, 0.7, -0.2
    force = np.tile([-0.002, 0.003, 0.01], (11, 1))
    thrust = np.tile([0.001, 0.0, 0.0, 1e-4], (11, 1))
    water = np.full(3, -9.0), np.array([9.0, 9.0, 0.0])
    return Course(
        time, state, thrust, force, 0.0 * force, np.array([False, False, True]), water, np.zeros((1, 0, 5)), -1
    )


def law_row(reading: str, coefficient: float, *factors: tuple[str, float, bool]) -> Any:
    """The numbers of a model with one law of readings."""
    row = NEUTRAL.copy()
    row[COLUMN["sensor_law_1.coefficient"]] = coefficient
    row[COLUMN["sensor_law_1.reading"]] = READING_CODE[reading]
    for place, (name, power, signed) in enumerate(factors, 1):
        row[COLUMN[f"sensor_law_1.regressor_{place}"]] = REGRESSOR_CODE[name]
        row[COLUMN[f"sensor_law_1.power_{place}"]] = power
        row[COLUMN[f"sensor_law_1.signed_{place}"]] = float(signed)
    return row


@pytest.mark.parametrize(
    ("factors", "expected"),
    [
        ((("1", 1.0, True),), 1.0),
        ((("t", 1.0, True),), 0.43),
        ((("z", 2.0, False),), (0.5 * 0.43) ** 2),
        ((("z", 1.0, True), ("r", 1.0, True)), 0.5 * 0.43 * 0.2),
        ((("r", 2.0, True),), -0.04),
        ((("thrust", 1.0, True),), 0.001),
        ((("thrust", 1.0, False), ("sin_yaw", 1.0, True)), 0.005 * math.sin(0.7)),
        ((("pump", 1.0, True),), 0.01),
        ((("yaw_command", 1.0, True),), 1e-4),
        ((("wall_distance", 1.0, True),), 0.5 * 0.43),
    ],
)
def test_what_a_law_adds(factors: Any, expected: float) -> None:
    """To readings of its own kind alone, by its regressors where the robot was when they were taken."""
    shown = Readings(
        0.1, 0.0, np.array([0] * 5 + [2] * 7), np.array([COMPASS, PRESSURE]), np.array([0.03, 0.03]),
        np.full(2, 0.03), np.ones(2), np.full(2, 0.43), np.zeros(2), np.ones(2), np.arange(2), np.full(2, -1),
        np.zeros(2),
    )  # fmt: skip
    shift = law_shift(law_row("compass", 3.0, *factors), shown, course)
    assert shift is not None
    np.testing.assert_allclose(shift, [3.0 * expected, 0.0], rtol=1e-9, atol=1e-15)


def test_no_law_adds_nothing() -> None:
    """Nobody even asks for the course."""
    shown = Readings(0.1, 0.0, np.zeros(2, dtype=np.int64), *(np.zeros(0) for _ in range(10)))
    assert law_shift(NEUTRAL, shown, lambda: pytest.fail("asked")) is None


def test_every_law_is_nothing_at_first_and_something_then(swim: Any) -> None:
    """Bit for bit the innovations of the model without it; with a coefficient others. No two have one name."""
    from cocorosim_ros.diagnosis.catalogue.open_set import open_set
    from cocorosim_ros.diagnosis.fitting.base_model import base_rows, base_unknowns, noise_unknowns
    from cocorosim_ros.diagnosis.fitting.candidate import expand
    from cocorosim_ros.diagnosis.fitting.fit import make_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.naming.residual import scene_of
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
    from cocorosim_ros.scenario.parts.platform import load_platform

    tracks = make_tracks(swim(load_platform("lily"), 20.0))
    rows = base_rows(tracks)
    fit = make_fit(tracks, rows, base_unknowns(tracks), noise_unknowns(tracks, rows))
    scene = scene_of(fit.tracks, smoothed_tracks(fit))
    found = expand(open_set(scene, [], fit.rows, water=True), fit.tracks, fit.rows)
    assert len(found) > 150
    seen = set()
    for candidate in found:
        # The phase of a swing is nought at first.
        values = list(candidate.settings(scene))[-1]
        reading = values.get("sensor_law_1.reading")
        if reading is not None and not fit.tracks[0].timeline.sees(READINGS[int(reading)].name):
            continue
        row, change = candidate.write(fit.filled, values)[0], np.zeros(len(fit.passes[0].innovation))
        fit.tracks[0].filter.slope(row, fit.passes[0], 1.0, change)
        np.testing.assert_array_equal(change, 0.0, candidate.entry.name)
        (amplitude,) = candidate.entry.amplitudes
        row[COLUMN[amplitude.column]] = -0.01 * amplitude.large  # a drag; a large push would run away
        fit.tracks[0].filter.slope(row, fit.passes[0], 1.0, change)
        assert np.abs(change).max() > 1e-12, candidate.entry.name
        seen.add(candidate.entry.name)
    assert len(seen) > 150


def test_laws_that_the_base_has_keep_their_places(swim: Any) -> None:
    """Their coefficients may turn out to be others; everything else is looked for in the next place, or not at all."""
    from cocorosim_ros.diagnosis.catalogue.open_set import open_set
    from cocorosim_ros.diagnosis.fitting.candidate import expand
    from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.naming.residual import scene_of
    from cocorosim_ros.diagnosis.tracks.columns import COLUMN
    from cocorosim_ros.scenario.parts.platform import load_platform

    fit = first_fit(swim(load_platform("lily"), 20.0))
    scene = scene_of(fit.tracks, smoothed_tracks(fit))
    rows = fit.rows.copy()

    def hold(place: str, law: str, coefficient: float) -> dict[str, Any]:
        """What is looked for once the base has the law in a place: candidates by name."""
        for name, value in {"coefficient": coefficient, **Law.parse(law).codes}.items():
            rows[:, COLUMN[f"{place}.{name}"]] = value
        found = expand(open_set(scene, [], rows, water=False), fit.tracks, rows)
        assert len({candidate.entry.name for candidate in found}) == len(found)
        return {candidate.entry.id: candidate for candidate in found if candidate.entry.topic is None}

    found = hold("law_1", "unknown:heave~u*u", -0.1)
    known = found.pop("unknown:heave~u*u")
    assert (known.entry.law, known.known, list(known.settings(scene))) == ("law_1", ((-0.1,),), [{}])
    assert known.amplitudes()[0].value(0.0) == -0.1
    assert {candidate.entry.law for candidate in found.values()} == {"law_2"}
    assert not any(candidate.known for candidate in found.values())
    hold("law_2", "unknown:yaw~x", 1e-6)
    assert set(hold("law_3", "unknown:yaw~y", 1e-6)) == {"unknown:heave~u*u", "unknown:yaw~x", "unknown:yaw~y"}


def test_a_law_of_the_pump_is_held_to_what_a_pump_is_held_to(swim: Any) -> None:
    """Behind its command by less than a pump's lag it is not believed; nor any law that pushes next to nothing.

    Nor one that says a hundredth of the mass where axes turn: the filter's steps follow these no better.
    """
    from cocorosim_ros.diagnosis.catalogue.laws import law_entries
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.naming.residual import scene_of
    from cocorosim_ros.scenario.parts.platform import load_platform

    fit = base_fit(swim(load_platform("lily"), 60.0))
    entries = {entry.id: entry for entry in law_entries(scene_of(fit.tracks, smoothed_tracks(fit)), "law_1")}
    of_pump = {name for name, entry in entries.items() if entry.of_pump}
    assert {"unknown:heave~pump_rate", "unknown:heave~|w|^-1*w", "unknown:heave~w*z"} <= of_pump
    assert not {"unknown:yaw~pump", "unknown:heave~u*u", "unknown:surge~pump_rate"} & of_pump
    behind, ahead = entries["unknown:heave~pump_rate"].amplitudes[0].negligible
    assert behind == -0.04 and 0.0 < ahead < 0.01
    for entry in entries.values():
        (amplitude,) = entry.amplitudes
        # `large` is a tenth of the full force.
        turning = 0.0044 if entry.id in ("unknown:sway~u*r", "unknown:surge~v*r") else 0.0
        assert amplitude.negligible[1] == pytest.approx(max(0.02 * amplitude.large, turning))


def diagnosed(evidence: Any) -> Any:
    """The diagnosis of a swim."""
    from cocorosim_ros.diagnosis.diagnose import diagnose

    return diagnose(evidence, lambda words, share: None)


def test_motors_that_turn_the_compass_are_no_distorted_compass(swim: Any) -> None:
    """A compass in error by 8 rad/N of what both thrusters deliver together: 0.08 rad at full thrust of 0.01 N."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    lily = load_platform("lily")
    evidence = swim(lily, SECONDS, seed=3)
    log = evidence.recordings[0].robots[0]
    compass = log.streams["compass"]
    tick = np.clip(np.searchsorted(log.command_time, compass.time, side="right") - 1, 0, len(log.command) - 1)
    amount = 0.005 * np.abs(log.command[tick, :2]).sum(axis=1)
    streams = {**log.streams, "compass": replace(compass, value=compass.value + 8.0 * amount[:, None])}
    recording = replace(evidence.recordings[0], robots=(replace(log, streams=streams),))
    diagnosis = diagnosed(replace(evidence, recordings=(recording,)))
    assert [part.id for part in diagnosis.effects] == ["motor_field"]
    (found,) = diagnosis.effects
    assert found.topic == "compass"
    field = found.parameters["field"]
    assert abs(field.value - 0.08) <= field.high - field.low < 0.08
    assert diagnosis.fit["compass"].augmented < diagnosis.fit["compass"].recalibrated


def test_dry_friction_is_no_linear_drag(swim: Any) -> None:
    """A yaw moment against the sense of turning is named as such, alone, with evidence of a credible size."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    hidden = {"coefficient": -1e-5, "equation": 3.0, "power_1": 0.0, "round_1": 0.02}
    hidden["regressor_1"] = float(REGRESSOR_CODE["r"])
    lily = load_platform("lily")
    diagnosis = diagnosed(swim(hiding(lily, {"law_1": hidden}), SECONDS, seed=4, base=lily))
    assert [part.id for part in diagnosis.effects] == ["unknown:yaw~|r|^-1*r"]
    assert diagnosis.effects[0].nats < 5000.0


def test_an_eddy_is_no_sheared_current(swim: Any) -> None:
    """Water that turns about a place is named as such, alone, with the circulation in its interval."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    hidden = {"x": 0.5, "y": 0.2, "circulation": 0.05, "core": 0.5}
    lily = load_platform("lily")
    diagnosis = diagnosed(swim(hiding(lily, {"eddy": hidden}), 2.0 * SECONDS, seed=5, base=lily))
    assert [part.id for part in diagnosis.effects] == ["unknown:world_x~y"]
    (found,) = diagnosis.effects
    assert found.simulated_as == "eddy"
    coefficient = found.parameters["coefficient"]
    assert abs(coefficient.value - 0.05) <= coefficient.high - coefficient.low


def test_where_only_water_moves_a_robot_no_law_of_its_place_is_asked(swim: Any) -> None:
    """A place that is read too short would make the water look calmer: laws of poses need a robot that is driven."""
    from cocorosim_ros.diagnosis.catalogue.sensor_laws import sensor_law_entries
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.naming.residual import scene_of
    from cocorosim_ros.scenario.parts.platform import load_platform

    fit = base_fit(swim(load_platform("lily"), SECONDS, seed=8))
    driven = scene_of(fit.tracks, smoothed_tracks(fit))
    assert driven.driven
    of_pose = [entry for entry in sensor_law_entries(driven, "sensor_law_1") if entry.topic == "pose"]
    assert of_pose
    adrift = sensor_law_entries(driven._replace(driven=False), "sensor_law_1")
    assert adrift and not [entry for entry in adrift if entry.topic == "pose"]
    for track in fit.tracks:
        track.log.command[:] = 0.0
    idle = replace(
        fit, tracks=tuple(track.piece(0, track.timeline.grid.points) for track in fit.tracks)
    )  # forces are reckoned anew
    assert not scene_of(idle.tracks, smoothed_tracks(idle)).driven
