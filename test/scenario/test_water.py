"""The section `water` of a scenario: what it gives, and one sentence for each mistake."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario
from cocorosim_ros.world.tick.assembly import build_world

HEAD = """
name: wet
description: one Lily in water
seed: 1
tick: 0.5 s
duration: 10 s
tank: {size: [5 m, 4 m, 2 m]}
integrator: {name: rk4, step: 0.25 s}
swarm:
  - {platform: lily, controller: idle, start: {poses: [[0 m, 0 m, -1 m, 0 deg]]}}
"""


def with_water(folder: Path, water: str) -> Scenario:
    """The scenario with this section."""
    path = folder / "wet.yaml"
    path.write_text(HEAD + water, encoding="utf-8")
    return load_scenario(path)


def dataset(**names: Any) -> Any:
    """A small velocity field; names and attributes as given."""
    axes = {"t": [0.0, 60.0], "z": [0.0, 1.0, 2.0], "y": [-2.0, 2.0], "x": [-2.0, 0.0, 2.0]}
    draw = np.random.default_rng(1)
    data = xarray.Dataset(
        {name: (tuple(axes), draw.normal(0, 0.1, (2, 3, 2, 3))) for name in names.get("variables", ("u", "v"))},
        coords=axes,
    )
    data["z"].attrs["positive"] = "down"
    return data


def test_absent_is_still(tmp_path: Path) -> None:
    """Without the section there is no water to speak of, and none is written."""
    scenario = with_water(tmp_path, "")
    assert scenario.water is None
    assert "water:" not in scenario.to_yaml()
    assert build_world(scenario).water.flow.size == 0


def test_it_is_read_back(tmp_path: Path) -> None:
    """Every kind of current and the force currents survive being written; unstated choices are the paper's."""
    dataset().to_netcdf(tmp_path / "bay.nc", engine="scipy")
    scenario = with_water(
        tmp_path,
        """
water:
  currents:
    - {kind: uniform, x: 5 cm/s, y: 0 m/s}
    - {kind: sheared, x: 0 m/s, y: 0 m/s, dx_dz: 0.02 1/s}
    - {kind: tidal, x: 0.1 m/s, y: 0 m/s, period: 10 min, phase: 90 deg}
    - {kind: vortex, x: 1 m, y: 0 m, circulation: 0.1 m^2/s, core: 0.4 m}
    - {kind: gridded, file: bay.nc}
  force_currents: {cold_spots: {force: 0.5 mN}, wakes: {}}
""",
    )
    again = parse_scenario(scenario.to_yaml(), str(tmp_path / "again.yaml"))
    assert again == scenario
    assert again.to_yaml() == scenario.to_yaml()
    assert scenario.water is not None and scenario.water.force_currents is not None
    forces = scenario.water.force_currents
    assert (forces.patch, forces.diffusion_rate, forces.decay_rate, forces.lifetime_steps) == (0.1, 0.6, 0.65, 25)
    assert forces.cold_spots is not None and forces.cold_spots.probability == 0.0015
    assert build_world(scenario).water.flow[0] == 5.0


def test_depth_counted_downwards(tmp_path: Path) -> None:
    """`positive: down` on z is turned round: the first layer of the file is the surface."""
    from cocorosim_ros.world.water.currents import CURRENTS

    data = dataset()
    data.to_netcdf(tmp_path / "bay.nc", engine="scipy")
    scenario = with_water(tmp_path, "water: {currents: [{kind: gridded, file: bay.nc}]}")
    assert scenario.water is not None
    numbers = scenario.water.currents[0].file.numbers  # type: ignore[union-attr]
    for depth in (0.0, 1.0, 2.0):
        total = np.zeros(3)
        CURRENTS["gridded"].velocity(np.array([0.0, 2.0, -depth]), 60.0, numbers, total)
        expected = data.sel(t=60.0, z=depth, y=2.0, x=0.0)
        np.testing.assert_allclose(total, [float(expected["u"]), float(expected["v"]), 0.0], rtol=0, atol=1e-15)


PLUME = "water: {plume: {%s}}"
FORCES = "water: {force_currents: {%s}}"


@pytest.mark.parametrize(
    ("water", "words"),
    [
        ("water: {curents: []}", "line 11: 'water.curents' is not a known key; did you mean 'currents'?"),
        ("water: {currents: [{kind: vortx}]}", "did you mean 'vortex'?"),
        ("water: {currents: [{kind: uniform, x: 1 m, y: 0 m/s}]}", "which is not a speed"),
        ("water: {currents: [{kind: uniform, x: 1 m/s}]}", "lacks 'y'"),
        ("water: {currents: [{kind: tidal, x: 1 m/s, y: 0 m/s, period: 0 s}]}", "must be greater than zero"),
        ("water: {currents: [{kind: gridded, file: none.nc}]}", "which is no file"),
        (FORCES % "patch: 0.3 m", "do not divide the tank's x of 5 m"),
        (FORCES % "patch: 0.5 m, step: 0.7 s", "not a whole number of ticks of '0.5 s'"),
        (FORCES % "patch: 1 mm", "more than 50,000,000"),
        (FORCES % "diffusion_rate: 0.4", "multiplies every current by 1.13 in each step"),
        (FORCES % "diffusion_rate: 1.4", "must lie between 0 and 1"),
        (FORCES % "diffusion: netlogo", "allowed: paper_equation_5, released"),
        (FORCES % "cold_spots: {force: 1 N, lifetime: 12.2 s}", "not a whole number of steps of '0.5 s'"),
        (FORCES % "cold_spots: {force: -1 N}", "must not be negative"),
        (PLUME % "source: [0 m, 0 m, 1 m], rate: 1 g/s, diffusivity: 1 cm^2/s", "which is not in the tank"),
        (PLUME % "source: [0 m, 0 m, -1 m], rate: 1 g, diffusivity: 1 cm^2/s", "which is not a mass rate"),
        (
            PLUME % "source: [0 m, 0 m, -1 m], rate: 1 g/s, diffusivity: 1 cm^2/s, interval: 0.7 s",
            "not a whole number of ticks",
        ),
    ],
)
def test_a_mistake_is_one_sentence(tmp_path: Path, water: str, words: str) -> None:
    """It names the file, the key, what was found and what is allowed."""
    with pytest.raises(CocorosimError) as caught:
        with_water(tmp_path, water)
    assert words in str(caught.value)
    assert "wet.yaml line 1" in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("patch", ["0.3 m", "0.07 m", "9 m", "0.7 m"])
def test_the_patch_that_is_told_is_taken(tmp_path: Path, patch: str) -> None:
    """It divides all sides, not only the one that was found, and has all its digits."""
    with pytest.raises(CocorosimError) as caught:
        with_water(tmp_path, FORCES % f"patch: {patch}")
    told = str(caught.value).rpartition("e.g. ")[2].rstrip(".")
    assert with_water(tmp_path, FORCES % f"patch: {told}").water.force_currents.patch == float(told.removesuffix(" m"))


def _holes(data: Any) -> Any:
    data["u"][0, 0, 0, 0] = np.nan
    return data


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda data: data.rename(u="water_u"), "lacks 'u' (it has 'water_u' and 'v'"),
        (lambda data: data.drop_vars("v").drop_vars("u"), "lacks 'u' and 'v'"),
        (lambda data: data.assign(u=data["u"].assign_attrs(units="knots")), "is in 'knots'"),
        (lambda data: data.rename(x="lon"), "it must run over x and y"),
        (lambda data: data.isel(y=0, drop=True), "it must run over x and y"),
        (lambda data: data.drop_vars("x"), "whose axis 'x' has no values"),
        (lambda data: data.assign_coords(x=[0.0, 2.0, 1.0]), "neither ascends nor descends"),
        (_holes, "has 1 missing values"),
    ],
)
def test_a_file_that_is_no_velocity_field(tmp_path: Path, change: Any, words: str) -> None:
    """One sentence that says what is wrong with the netCDF file."""
    change(dataset()).to_netcdf(tmp_path / "bay.nc", engine="scipy")
    with pytest.raises(CocorosimError) as caught:
        with_water(tmp_path, "water: {currents: [{kind: gridded, file: bay.nc}]}")
    assert words.replace("'", "") in str(caught.value).replace("'", "")


def test_a_file_that_is_no_netcdf(tmp_path: Path) -> None:
    """Text is told from netCDF."""
    (tmp_path / "bay.nc").write_text("u v", encoding="utf-8")
    with pytest.raises(CocorosimError, match="cannot be read as netCDF"):
        with_water(tmp_path, "water: {currents: [{kind: gridded, file: bay.nc}]}")


def test_a_file_that_has_changed(tmp_path: Path) -> None:
    """A scenario that was recorded with a field does not run with another one of the same name."""
    dataset().to_netcdf(tmp_path / "bay.nc", engine="scipy")
    recorded = with_water(tmp_path, "water: {currents: [{kind: gridded, file: bay.nc}]}").to_yaml()
    (2.0 * dataset()).to_netcdf(tmp_path / "bay.nc", engine="scipy")
    with pytest.raises(CocorosimError, match="whose content has changed"):
        parse_scenario(recorded, "recorded")
