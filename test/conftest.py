"""Fixtures by name: Lily's numbers as the contract states them, a world made of them, a swarm in it.

Every world here is put together from explicit numbers, without scenario or platform files: what the core's
tests expect does not depend on how files are read.
"""

from __future__ import annotations

import math
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import hypothesis
import numpy as np
import pytest

# No test fails by a clock: beside other work an example of half a millisecond took a quarter of a second.
hypothesis.settings.register_profile("untimed", deadline=None)
hypothesis.settings.load_profile("untimed")

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
TICK = 0.5  # s
OPEN_WATER = ((-1000.0, -1000.0, -1000.0), (1000.0, 1000.0, 0.0))
TANK = {"bounds": OPEN_WATER, "spheres": (), "boxes": ()}
PAPER_TANK = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))


@pytest.fixture(autouse=True)
def own_environment() -> Iterator[None]:
    """What a command sets in this process's environment, such as its ROS domain, ends with the test that ran it."""
    before = dict(os.environ)
    yield
    for name in os.environ.keys() - before.keys() - {"PYTEST_CURRENT_TEST"}:
        del os.environ[name]
    for name, value in before.items() - os.environ.items():
        if name != "PYTEST_CURRENT_TEST":
            os.environ[name] = value


@pytest.fixture
def browse(tmp_path: Path) -> Callable[..., str]:
    """A function of a page and a place in it: what a browser shows of it when all scripts have run, as HTML.

    With `picture`, a file, the browser also takes a picture of it. Skips the test where there is no browser.
    """
    if BROWSER is None:
        pytest.skip("no Chromium is installed, so the page cannot be opened")
    options = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'profile'}"]
    options += ["--virtual-time-budget=5000", "--window-size=1280,2000", "--hide-scrollbars"]

    def open_page(page: Path, place: str = "", picture: Path | None = None) -> str:
        address = f"{page.as_uri()}{place}"
        jobs = [["--dump-dom"]] + ([[f"--screenshot={picture}"]] if picture else [])
        done = [
            subprocess.run([BROWSER, *options, *job, address], capture_output=True, text=True, timeout=300, check=True)
            for job in jobs
        ]
        return done[0].stdout

    return open_page


@pytest.fixture
def rerun_rows() -> Callable[[Path], dict[str, list[dict[str, Any]]]]:
    """A function of an MCAP file: by topic the rows that have a time, as Rerun's own loader reads them."""
    if np.__version__.startswith("1."):
        pytest.skip("rerun-sdk asks for NumPy 2")
    chunk = pytest.importorskip("rerun.chunk", reason="rerun-sdk is not installed, and it is optional")

    def read(file: Path) -> dict[str, list[dict[str, Any]]]:
        found: dict[str, list[dict[str, Any]]] = {}
        for part in chunk.McapReader(file).stream().to_chunks():
            batch = part.to_record_batch()
            if "message_log_time" in batch.schema.names:
                found.setdefault(part.entity_path, []).extend(batch.to_pylist())
        return found

    return read


@pytest.fixture
def cocorosim(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Callable[..., SimpleNamespace]:
    """A function of arguments: the command's exit status, output and errors; run in this process."""
    from cocorosim_ros.commands.main import main

    def run(*arguments: Any) -> SimpleNamespace:
        monkeypatch.setattr(sys, "argv", ["cocorosim", *(str(argument) for argument in arguments)])
        capfd.readouterr()
        with pytest.raises(SystemExit) as ended:
            main()
        out, err = capfd.readouterr()
        return SimpleNamespace(status=ended.value.code or 0, out=out, err=err)

    return run


@pytest.fixture
def free_domain() -> Iterator[str]:
    """The number of a ROS domain that nobody else on this machine uses during the test."""
    from cocorosim_ros.graph.nodes.domain import OwnDomain

    domain = OwnDomain()
    yield str(domain.number)
    domain.release()


@pytest.fixture(scope="session")
def lily() -> SimpleNamespace:
    """Lily by the contract, with what follows from its numbers by hand."""
    return SimpleNamespace(
        mass=0.44,  # kg
        inertia=4.05e-4,  # kg m^2
        drag=1.7778,  # kg/m
        yaw_drag=1.14e-4,  # N m s^2
        thrust=0.005,  # N, each of two
        lever=0.055 * math.cos(math.radians(63.0)),  # m
        pump=1000.0 * 10e-6 * 9.81,  # N, 10 cm^3 of water
        gravity=9.81,
        boids=(1.0, 1.0, 10.0, 0.15, 0.475, 1.0, 0.1, 0.1, 0.1, 0.08, 0.1, 3.0),
    )


@pytest.fixture(scope="session")
def blue_light() -> SimpleNamespace:
    """Lily's five sensors: axes (5, 3), rays (5, 3, 3) and how many of them each has."""

    def unit(azimuth: float, elevation: float = 0.0) -> list[float]:
        a, e = math.radians(azimuth), math.radians(elevation)
        return [math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e)]

    azimuths = (60.0, -60.0, 180.0)
    axes = np.array([unit(a) for a in azimuths] + [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    rays = np.zeros((5, 3, 3))
    rays[:3] = [[unit(a), unit(a + 60.0), unit(a - 60.0)] for a in azimuths]
    rays[3:, 0] = axes[3:]
    return SimpleNamespace(axes=axes, rays=rays, ray_count=np.array([3, 3, 3, 1, 1]))


@pytest.fixture(scope="session")
def make_vehicles(lily: SimpleNamespace) -> Callable[..., Any]:
    """Function of (runs, robots, inertia): Lilys with two thrusters and a pump."""
    from cocorosim_ros.world.effects import EFFECTS
    from cocorosim_ros.world.terms.jet import JET_COLUMNS
    from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS, Vehicles, neutral_row

    def make(runs: int, robots: int, inertia: float | None = None) -> Vehicles:
        known = {
            "mass": lily.mass,
            "yaw_inertia": inertia or lily.inertia,
            "drag": lily.drag,
            "yaw_drag": lily.yaw_drag,
        }
        parameters = np.tile(neutral_row(), (runs, robots, 1))
        for name, value in known.items():
            parameters[..., PARAMETER_COLUMNS[name]] = value
        bits = sum(EFFECT_BIT[name] for name in EFFECTS if name in ("quadratic_drag", "net_buoyancy"))
        wrench = np.zeros((runs, robots, 3, 4))
        wrench[...] = [[1, 0, 0, -lily.lever], [1, 0, 0, lily.lever], [0, 0, 1, 0]]
        limit = np.zeros((runs, robots, 3, 2))
        limit[...] = np.array([lily.thrust, lily.thrust, lily.pump])[:, None]
        pump = np.tile([False, False, True], (runs, robots, 1))
        nothing = np.zeros((runs, robots, 3, 0)), np.zeros((runs, robots, 0, JET_COLUMNS))
        return Vehicles(parameters, np.full((runs, robots), bits), wrench, limit, pump, *nothing)

    return make


@pytest.fixture(scope="session")
def make_tank() -> Callable[..., Any]:
    """Function of (bounds, spheres, boxes): a tank."""
    from cocorosim_ros.world.surroundings.tank import Tank

    def make(bounds: Any = OPEN_WATER, spheres: Any = (), boxes: Any = ()) -> Tank:
        solid = np.reshape(np.asarray(spheres, dtype=float), (-1, 4))
        return Tank(*np.array(bounds, dtype=float), solid, np.reshape(np.asarray(boxes, dtype=float), (-1, 6)))

    return make


@pytest.fixture(scope="session")
def make_instruments(lily: SimpleNamespace, blue_light: SimpleNamespace) -> Callable[..., Any]:
    """Function of (robots, needs): Lily's instruments; cones of 120 degrees, 0.5 m to robots, 0.3 m to obstacles."""
    from cocorosim_ros.scenario.parts.vehicle_parts import Sensors
    from cocorosim_ros.world.sensors import SENSORS
    from cocorosim_ros.world.sensors.instruments import Instruments

    every = Sensors(compass=True, pressure=True, imu=True, velocity=True)

    def make(robots: int, needs: tuple[str, ...] = ()) -> Instruments:
        return Instruments(
            axis=np.tile(blue_light.axes, (robots, 1, 1)),
            cosine_half_angle=np.full((robots, 5), 0.5),
            neighbour_range=np.full((robots, 5), 0.5),
            obstacle_range=np.full((robots, 5), 0.3),
            ray=np.tile(blue_light.rays, (robots, 1, 1, 1)),
            ray_count=np.tile(blue_light.ray_count, (robots, 1)),
            water_density=np.full(robots, 1000.0),
            gravity=np.full(robots, lily.gravity),
            measured=np.tile(
                [sensor.for_all or sensor.is_on(every, needs) for sensor in SENSORS.values()], (robots, 1)
            ),
        )

    return make


@pytest.fixture(scope="session")
def make_crew(blue_light: SimpleNamespace) -> Callable[..., Any]:
    """Function of (robots, controller, settings): controllers on Lily's operating system."""
    from cocorosim_ros.world.controllers import CONTROLLER_CODE
    from cocorosim_ros.world.controllers.crew import Crew

    system = [0.25, 0.2, 0.5, 0.1, 0.5, 15.0, 5.0, 60.0, 1300.0, 130.0, 1.0, 0.05, 127.0, 127.5, 1000.0, 9.81, 0.0]

    def make(robots: int, controller: str = "idle", settings: Any = ()) -> Crew:
        return Crew(
            code=np.full(robots, CONTROLLER_CODE[controller]),
            settings=np.tile(np.asarray(settings, dtype=float), (robots, 1)),
            settings_count=np.full(robots, len(settings)),
            system=np.tile(system, (robots, 1)),
            actuator=np.tile([0, 1, 2], (robots, 1)),
            sensor_axis=np.tile(blue_light.axes, (robots, 1, 1)),
            sensor_count=np.full(robots, 5),
        )

    return make


@pytest.fixture(scope="session")
def make_simulation(
    make_vehicles: Callable[..., Any],
    make_tank: Callable[..., Any],
    make_instruments: Callable[..., Any],
    make_crew: Callable[..., Any],
) -> Callable[..., Any]:
    """Function of (start, controller, settings; by name integrator, steps, inertia, contact, bounds, spheres, boxes).

    `start` (runs, robots, 4) are x, y, z, yaw; the tick lasts 0.5 s.
    """
    from cocorosim_ros.world.controllers import CONTROLLERS
    from cocorosim_ros.world.motion.contact import CONTACT_CODE
    from cocorosim_ros.world.motion.integrators import INTEGRATOR_CODE
    from cocorosim_ros.world.motion.motion import Stepping
    from cocorosim_ros.world.surroundings.lamps import Lamps
    from cocorosim_ros.world.tick.simulation import Simulation
    from cocorosim_ros.world.tick.wants import Wants
    from cocorosim_ros.world.tick.world import World

    def make(start: Any, controller: str = "idle", settings: Any = (), **choice: Any) -> Simulation:
        needs, medium = CONTROLLERS[controller].needs, CONTROLLERS[controller].medium
        wanted = ("neighbours", "blue_light_rx")
        start = np.asarray(start, dtype=float)
        runs, robots = start.shape[:2]
        steps = choice.get("steps", 5)
        integrator = INTEGRATOR_CODE[choice.get("integrator", "rk4")]
        contact = CONTACT_CODE[choice.get("contact", "inelastic")]
        world = World(
            names=tuple(f"lily_{index:02d}" for index in range(1, robots + 1)),
            tick_ns=round(TICK * 1e9),
            tank=make_tank(*(choice.get(part, usual) for part, usual in TANK.items())),
            stepping=Stepping(integrator, steps, TICK / steps, contact),
            vehicles=make_vehicles(runs, robots, choice.get("inertia")),
            instruments=make_instruments(robots, needs),
            crew=make_crew(robots, controller, settings),
            radio_range=np.full(robots, 0.5),
            wants=Wants(
                *(np.full(robots, topic in needs) for topic in wanted),
                np.full(robots, medium == "blue_light"),
                np.full(robots, "acoustic_rx" in needs),
                np.full(robots, medium == "acoustic"),
            ),
            lamps=Lamps(50.0, np.array([[0.0, 0.0, -1.0, 500.0, 0.7]])),
        )
        return Simulation(world, start)

    return make


@pytest.fixture(scope="session")
def crowd() -> Callable[..., Any]:
    """Function of (runs, robots, seed): start (runs, robots, 4) in the central cube of the paper's tank."""

    def make(runs: int, robots: int, seed: int = 1) -> Any:
        draw = np.random.default_rng(seed)
        low, high = [-0.45, -0.45, -1.9, -math.pi], [0.45, 0.45, -1.1, math.pi]
        return draw.uniform(low, high, (runs, robots, 4))

    return make
