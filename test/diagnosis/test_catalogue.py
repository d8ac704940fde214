"""Every entry of the catalogue, unasked."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES, IDS
from cocorosim_ros.diagnosis.fitting.vehicle_needs import has_all
from cocorosim_ros.diagnosis.naming.detectability import is_blind, not_shown
from cocorosim_ros.diagnosis.report.advice import MANOEUVRES
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.diagnosis.tracks.vehicle_size import LILY_SIZES
from cocorosim_ros.scenario.parts.platform import load_platform

# The contract's table, but for frame_mixup, which is told before any physics is.
CONTRACT = """linear_drag anisotropic_drag added_mass steady_current sheared_current tidal_current tether wall_effect
neighbour_wake thruster_lag thruster_deadband thruster_asymmetry torque_bias reverse_loss advance_loss battery_sag
thruster_misalignment buoyancy_trim pump_lag hull_compressibility stratification compass_distortion pressure_offset
pressure_drift sensor_latency clock_skew camera_scale imu_bias payload_shift""".split()


def test_the_catalogue_is_the_contract() -> None:
    """Every identifier of the contract has an entry; an effect that is added beside them needs no line here."""
    assert set(CONTRACT) <= set(IDS)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: f"{entry.id}-{entry.topic}")
def test_an_entry_is_whole(entry: Any) -> None:
    """Its numbers are columns of the model, neutral where the model says so, and its manoeuvre exists."""
    for part in entry.amplitudes:
        assert NEUTRAL[COLUMN[part.column]] == part.neutral
        assert part.large > 0.0
        assert part.unit in LILY_SIZES, "say in vehicle_size.py how it grows with a vehicle, or that it does not"
    assert all(shape.column in COLUMN for shape in entry.shapes)
    assert all(column in COLUMN for column in entry.fixed)
    assert entry.manoeuvre in MANOEUVRES


@pytest.mark.parametrize(
    ("identifier", "below", "above"),
    [
        ("advance_loss.slope", "thrust that rises with speed", "thrust that falls with speed"),
        ("reverse_loss.loss", "thrust that is stronger backwards", "thrust that is weaker backwards"),
        ("linear_drag.surge", "linear drag", "linear drag"),
    ],
)
def test_a_name_suits_the_sign_of_what_was_found(identifier: str, below: str, above: str) -> None:
    """A slope below zero is thrust gained, and so it is told."""
    entry = next(each for each in ENTRIES if each.id == identifier.partition(".")[0])
    assert entry.amplitudes[0].column == identifier
    assert [entry.name_with({identifier: value}) for value in (-0.3, 0.3)] == [below, above]


@pytest.fixture(scope="module")
def short(swim: Any) -> Any:
    """The fit of half a minute, at its start values."""
    from cocorosim_ros.diagnosis.fitting.base_model import base_rows, base_unknowns, noise_unknowns
    from cocorosim_ros.diagnosis.fitting.fit import make_fit
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
    from cocorosim_ros.scenario.parts.platform import load_platform

    tracks = make_tracks(swim(load_platform("lily"), 30.0))
    rows = base_rows(tracks)
    return make_fit(tracks, rows, base_unknowns(tracks), noise_unknowns(tracks, rows))


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: f"{entry.id}-{entry.topic}")
def test_neutral_changes_nothing_and_large_does(entry: Any, short: Any) -> None:
    """With its amplitudes neutral the innovations are bit for bit the model's; with large ones they are not."""
    from cocorosim_ros.diagnosis.fitting.candidate import expand
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.diagnosis.naming.residual import scene_of

    found = expand([entry], short.tracks, short.rows)
    if not found:
        assert entry.needs_neighbours or entry.needs or entry.topic in ("velocity", "ground_velocity")
        return
    scene = scene_of(short.tracks, smoothed_tracks(short))
    values = next(iter(found[0].settings(scene)), None)
    if values is None:
        assert entry.id == "surface_loss"  # the robot kept away from the surface
        return
    row, change = found[0].write(short.filled, values)[0], np.zeros(len(short.passes[0].innovation))
    short.tracks[0].filter.slope(row, short.passes[0], 1.0, change)
    np.testing.assert_array_equal(change, 0.0)
    for part in entry.amplitudes:
        row[COLUMN[part.column]] = part.neutral + part.large
    short.tracks[0].filter.slope(row, short.passes[0], 1.0, change)
    assert np.abs(change).max() > 1e-9


@pytest.mark.parametrize(("lowest", "highest", "looked_for"), [(-1.5, -0.2, True), (-1.08, -0.95, False)])
def test_a_density_layer_is_looked_for_where_it_was_crossed(lowest: float, highest: float, looked_for: bool) -> None:
    """Among depths that were clearly above and below the robot; one that held its depth crossed none."""
    layer = next(entry for entry in ENTRIES if entry.id == "stratification")
    scene: Any = SimpleNamespace(lower=(0.0, 0.0, lowest), upper=(1.0, 1.0, highest))
    depths = layer.shapes[0].grid(scene)
    assert bool(depths) is looked_for
    assert all(lowest + 0.1 < -depth < highest - 0.1 for depth in depths)


def test_what_a_pump_tells_of_is_weighed_by_how_far_it_was_moved() -> None:
    """A robot that holds a depth answers the water sooner than it is recorded: a sound pressure sensor looks late."""
    found = {(entry.id, entry.topic) for entry in ENTRIES if entry.of_pump}
    assert found == {("pump_lag", None), ("sensor_latency", "pressure"), ("clock_skew", "pressure")}


def test_a_skew_counts_by_what_it_makes_of_the_recording() -> None:
    """Of 15 s less than a tick, what is a quarter of a second in ten minutes."""
    from cocorosim_ros.diagnosis.fitting.candidate import Candidate
    from cocorosim_ros.diagnosis.naming.needed_evidence import is_negligible

    skew = next(entry for entry in ENTRIES if entry.id == "clock_skew" and entry.topic == "imu")
    (amplitude,) = skew.amplitudes
    short, long = (Candidate(skew, ("a",), ((0,),), duration=seconds) for seconds in (15.0, 600.0))
    for value in (-4e-4, 4e-4):
        assert is_negligible(short, amplitude, value) and not is_negligible(long, amplitude, value)
    assert not is_negligible(short, amplitude, 2e-3)
    assert is_negligible(long, amplitude, 3e-5)


INSTRUMENTS = ("pose", "compass", "pressure", "imu", "velocity")


def recorded_lily(*streams: str) -> Any:
    """A track of a Lily of which these streams were recorded."""
    log = SimpleNamespace(streams=dict.fromkeys(streams))
    return SimpleNamespace(vehicle=vehicle_model(load_platform("lily")), log=log)


def test_what_was_not_recorded_is_no_blindness() -> None:
    """A camera alone: that nothing shows errors of five other instruments tells nothing of what it does show."""
    had = {each.id for each in ENTRIES if each.id in IDS and has_all(recorded_lily().vehicle, each.needs)}
    physics = sorted(each.id for each in ENTRIES if each.id in had and each.topic is None)
    others = {each.id for each in ENTRIES if each.topic} - {each.id for each in ENTRIES if each.topic == "pose"}
    unseen = [*physics[: int(0.4 * len(physics))], *sorted(others & had)]
    assert is_blind(unseen, [recorded_lily(*INSTRUMENTS)])
    assert not is_blind(unseen, [recorded_lily("pose")])


def test_an_instrument_that_few_robots_have_is_asked_for_where_it_was_recorded() -> None:
    """A log over ground: without one, nothing of it is unseen, and silence tells as much as before there was any."""
    entry = next(each for each in ENTRIES if each.id == "ground_log_scale")
    tried: Any = SimpleNamespace(
        candidate=SimpleNamespace(entry=entry, spread=1.0), information=np.array([[1e-9]]), felt=float("nan")
    )
    assert entry.id not in IDS and entry.id not in not_shown([])
    assert set(not_shown([])) == set(IDS)
    assert set(not_shown([tried])) == {*IDS, entry.id}
    seen: Any = SimpleNamespace(candidate=tried.candidate, information=np.array([[1e9]]), felt=float("nan"))
    assert set(not_shown([seen])) == set(IDS)
    lily = recorded_lily(*INSTRUMENTS)
    had = [each.id for each in ENTRIES if each.id in IDS and has_all(lily.vehicle, each.needs)]
    share = list(dict.fromkeys(had))[: int(0.45 * len(set(had)))]
    assert not is_blind([*share, entry.id, "ground_log_misalignment"], [lily])


def test_what_a_vehicle_cannot_have_is_no_blindness() -> None:
    """A cable, a thruster in another's jet: no Lily has them, so that unseen they say nothing of her recordings."""
    lily = recorded_lily(*INSTRUMENTS)
    had = {each.id for each in ENTRIES if each.id in IDS and has_all(lily.vehicle, each.needs)}
    lacking = set(IDS) - had
    assert {"tether_drag", "wash_loss", "wind"} <= lacking and "thruster_lag" in had
    assert not is_blind(sorted(lacking), [lily])
    assert is_blind(sorted(had), [lily])
