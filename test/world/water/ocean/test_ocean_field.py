"""Files of ocean models as water, by fields that are known everywhere; a sentence for each that does not fit."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.scenario.parts.stated_file import StatedFile
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.water.currents.gridded import interpolate
from cocorosim_ros.world.water.ocean.ocean_field import ocean_field
from cocorosim_ros.world.water.ocean.sea_water import density

sys.path.append(str(Path(__file__).parent))
from made_up import LATITUDE, LONGITUDE, MODELS, START, cmems, hycom, roms, truth

SIZE = (200.0, 100.0, 20.0)
SCENARIO = """
name: at_sea
description: one Lily at sea
seed: 1
tick: 0.5 s
duration: {duration}
tank: {{size: [200 m, 100 m, 20 m]}}
integrator: {{name: rk4, step: 0.25 s}}
swarm:
  - {{platform: lily, controller: idle, start: {{poses: [[20 m, 0 m, -10 m, 0 deg]]}}}}
water: {{currents: [{{kind: ocean, file: sea.nc, latitude: 60 deg, longitude: 5 deg, {more}}}]}}
"""


def at_sea(folder: Path, data: Any, more: str = "start: '2024-05-01T12:20:00'", duration: str = "60 s") -> Scenario:
    """A scenario in this water."""
    data.to_netcdf(folder / "sea.nc", engine="scipy")
    (folder / "at_sea.yaml").write_text(SCENARIO.format(more=more, duration=duration))
    return load_scenario(folder / "at_sea.yaml")


def field_of(folder: Path, data: Any, start: str | None = START, duration: float = 3600.0) -> Any:
    """The field around the origin."""
    data.to_netcdf(folder / "sea.nc", engine="scipy")
    file = StatedFile(str(folder / "sea.nc"), "")
    current = OceanCurrent(file, math.radians(LATITUDE), math.radians(LONGITUDE), start)
    return ocean_field(current, SIZE, duration)


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("start", [START, "2024-05-01T12:30:00"])
def test_fields_are_known_everywhere(tmp_path: Path, name: str, start: str) -> None:
    """Linear fields come out as they are, at places and moments between those of the file, in metres east and north."""
    field = field_of(tmp_path, MODELS[name](), start)
    late = 1800.0 if start != START else 0.0
    for x, y, z, t in np.random.default_rng(1).uniform((-100, -50, -20, 0), (100, 50, -1.5, 3600), (50, 4)):
        total, dense = np.zeros(3), np.zeros(1)
        interpolate(np.array([x, y, z]), t, field.velocity, total)
        interpolate(np.array([x, y, z]), t, field.density, dense)
        known = truth(x, y, z, t + late)
        # ROMS's levels are put on even ones, between which a moved surface shows.
        np.testing.assert_allclose(total, [known["u"], known["v"], 0.0], rtol=0, atol=2e-4 if name == "roms" else 1e-9)
        expected = density(known["temperature"], known["salinity"], np.array(-z * 1025.0 * 9.81 / 1e5))
        assert dense[0] == pytest.approx(float(expected), abs=0.01)


@pytest.mark.parametrize(("turned", "transform"), [(0.0, 1), (0.0, 2), (-50.0, 2)])
def test_grids_of_roms(tmp_path: Path, turned: float, transform: int) -> None:
    """However the grid is turned and its levels are spread, velocities are eastward and northward."""
    field = field_of(tmp_path, roms(turned, transform))
    total = np.zeros(3)
    interpolate(np.array([60.0, -30.0, -8.0]), 0.0, field.velocity, total)
    known = truth(60.0, -30.0, -8.0, 0.0)
    np.testing.assert_allclose(total, [known["u"], known["v"], 0.0], rtol=0, atol=2e-4)


def test_above_the_first_level_it_holds(tmp_path: Path) -> None:
    """At the surface the velocity is that of the level half a metre down."""
    field = field_of(tmp_path, cmems())
    total = np.zeros(3)
    interpolate(np.array([0.0, 0.0, 0.0]), 0.0, field.velocity, total)
    assert total[0] == pytest.approx(truth(0.0, 0.0, -0.5, 0.0)["u"], abs=1e-12)


def test_standard_names_and_packed_numbers(tmp_path: Path) -> None:
    """Names that nobody has heard of are told by `standard_name` and `axis`; 16-bit numbers are unpacked."""
    data = cmems().rename(uo="a", vo="b", thetao="c", so="d", depth="e", latitude="f", longitude="g", time="h")
    standard = {
        "a": "eastward_sea_water_velocity",
        "b": "northward_sea_water_velocity",
        "c": "sea_water_potential_temperature",
        "d": "sea_water_salinity",
        "f": "latitude",
        "g": "longitude",
        "h": "time",
    }
    for name, words in standard.items():
        data[name].attrs["standard_name"] = words
    packing = {"dtype": "int16", "scale_factor": 1e-5, "add_offset": 0.1, "_FillValue": -32767}
    data.to_netcdf(tmp_path / "sea.nc", engine="scipy", encoding={"a": packing})
    file = StatedFile(str(tmp_path / "sea.nc"), "")
    current = OceanCurrent(file, math.radians(LATITUDE), math.radians(LONGITUDE), START)
    total = np.zeros(3)
    interpolate(np.array([50.0, 20.0, -5.0]), 0.0, ocean_field(current, SIZE, 60.0).velocity, total)
    known = truth(50.0, 20.0, -5.0, 0.0)
    np.testing.assert_allclose(total, [known["u"], known["v"], 0.0], rtol=0, atol=1.1e-5)


def _holes(data: Any) -> Any:
    data["uo"][0, 2, 1:4, 2:4] = np.nan
    return data


@pytest.mark.parametrize(
    ("data", "more", "duration", "words"),
    [
        (lambda: cmems().assign(uo=cmems()["uo"].assign_attrs(units="cm/s")), "", "60 s", "'uo' is in 'cm/s'; convert"),
        (lambda: cmems().assign(so=cmems()["so"].assign_attrs(units="kg/m3")), "", "60 s", "'so' is in 'kg/m3'"),
        (lambda: cmems().isel(depth=0, drop=True), "", "60 s", "with no depth among them"),
        (lambda: cmems().isel(depth=slice(3)), "", "60 s", "levels reach 10 m down, and the tank 20 m"),
        (lambda: _holes(cmems()), "", "60 s", "there is land, or nothing, where 'eastward' is needed"),
        (cmems, "start: '2024-05-02T00:00:00'", "60 s", "2024-05-01T12:00:00 to 2024-05-01T14:00:00, which does not"),
        (cmems, "start: '2024-05-01T13:59:30'", "60 s", "change 'start' or 'duration'"),
        (cmems, "start: yesterday", "60 s", "which is no moment"),
        (lambda: cmems().isel(latitude=slice(3, None)), "", "60 s", "m south of the origin; take a larger cut-out"),
        (lambda: hycom().isel(lon=slice(None, 3)), "", "60 s", "m east of the origin; take a larger cut-out"),
        (lambda: cmems().drop_vars("thetao"), "", "60 s", "no temperature to make density of"),
        (lambda: cmems().rename(uo="east", vo="north"), "", "60 s", "no eastward and northward velocity is recognised"),
        (lambda: roms().drop_vars("h"), "", "60 s", "s-levels but no 'h'"),
        (lambda: roms().assign_coords(lat_rho=roms()["lat_rho"] + 3.0), "", "60 s", "nowhere near the origin"),
    ],
)
def test_what_does_not_fit_is_a_sentence(tmp_path: Path, data: Any, more: str, duration: str, words: str) -> None:
    """Other units, missing depth, land, moments and places outside: file, line and key, and what to do."""
    with pytest.raises(CocorosimError) as caught:
        at_sea(tmp_path, data(), more, duration)
    assert words in str(caught.value)
    assert "at_sea.yaml line 1" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_no_netcdf(tmp_path: Path) -> None:
    """Text is told from netCDF."""
    (tmp_path / "at_sea.yaml").write_text(SCENARIO.format(more="", duration="60 s"))
    (tmp_path / "sea.nc").write_text("u v")
    with pytest.raises(CocorosimError, match="cannot be read as netCDF"):
        load_scenario(tmp_path / "at_sea.yaml")


def test_the_same_after_yaml_and_back(tmp_path: Path) -> None:
    """The file by its digest, moments with a time zone as UTC; a file that has changed is refused."""
    more = "start: '2024-05-01T14:20:00+02:00', buoyancy: false, reference_density: 1027 kg/m^3"
    scenario = at_sea(tmp_path, cmems(), more)
    assert scenario.water is not None
    assert scenario.water.currents[0].start == "2024-05-01T12:20:00"  # type: ignore[union-attr]
    text = scenario.to_yaml()
    assert parse_scenario(text, str(tmp_path / "again.yaml")) == scenario
    hycom().to_netcdf(tmp_path / "sea.nc", engine="scipy")
    with pytest.raises(CocorosimError, match="whose content has changed"):
        parse_scenario(text, str(tmp_path / "again.yaml"))


def swum(scenario: Scenario, ticks: int) -> Any:
    """The state of the robot after so many ticks."""
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    for _ in range(ticks):
        simulation.advance()
    return simulation.state[0, 0]


def test_a_robot_drifts_with_the_water(tmp_path: Path) -> None:
    """Neutral, at rest: after a minute it goes as the water at its place does, east and north."""
    still = cmems()
    for name in ("thetao", "so"):
        still[name][...] = float(still[name].mean())
    free = at_sea(tmp_path, still, "start: '2024-05-01T12:00:00', buoyancy: false", "600 s")
    state = swum(free, 1200)
    water = truth(state[0], state[1], state[2], 600.0)
    surge, sway = state[4], state[5]
    np.testing.assert_allclose([surge, sway], [water["u"], water["v"]], rtol=0, atol=5e-3)
    assert 30.0 < state[0] < 90.0
    assert state[1] < -10.0


def test_density_decides_where_it_floats(tmp_path: Path) -> None:
    """Ballasted for the water of some depth, a robot ends up there; the water grows denser downwards."""
    depth = 6.0
    known = truth(0.0, 0.0, -depth, 0.0)
    bar = np.array(depth * 1025.0 * 9.81 / 1e5)
    dense = float(density(known["temperature"], known["salinity"], bar))
    more = f"start: '2024-05-01T12:00:00', reference_density: {dense:.9f} kg/m^3"
    calm = cmems()
    for name in ("uo", "vo"):
        calm[name][...] = 0.0
    state = swum(at_sea(tmp_path, calm, more, "3000 s"), 6000)
    assert -state[Z] == pytest.approx(depth, abs=0.7)


def test_fresh_water_robots_float_at_sea(tmp_path: Path) -> None:
    """Lily's 440 cm^3, neutral in 1000 kg/m^3: at the first tick the sea lifts it by (rho - 1000) g V over its mass."""
    scenario = at_sea(tmp_path, cmems(), "start: '2024-05-01T12:00:00'")
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    known = truth(20.0, 0.0, -10.0, 0.0)
    dense = float(density(known["temperature"], known["salinity"], np.array(1.006)))
    force = (dense - 1000.0) * 9.81 * 440e-6
    assert simulation.sense().specific_force[0, 0, 2] - 9.81 == pytest.approx(force / 0.44, rel=1e-3)
