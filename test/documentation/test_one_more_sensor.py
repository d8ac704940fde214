"""What CONTRIBUTING.md promises: a sensor is one new file and one line, and so is an error of a sensor.

Its thermometer and its wrong gain are added to a copy of the package.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
SCALE = 1.1
SECONDS = 60
PLATFORM = f"""name: warm
description: a Lily with a thermometer and a pressure gauge with a wrong gain
based_on: lily
sensors: {{compass: true, pressure: true, imu: true, thermometer: true}}
effects: {{pressure_scale: {{scale: {{value: {SCALE}, unit: "1", source: a test}}}}}}
"""
SCENARIO = f"""name: dives
description: one Lily that dives and rises
seed: 1
tick: 0.5 s
duration: {SECONDS} s
tank: {{size: [8 m, 8 m, 4 m]}}
integrator: {{name: rk4, step: 0.05 s, contact: inelastic}}
swarm:
  - platform: PLATFORM
    prefix: lily
    controller: programme
    overrides:
      {{row_1_time: 6 s, row_1_ahead: 0.8, row_1_rise: 0.3, row_2_time: 4 s, row_2_rise: -0.2, row_3_time: 3 s,
        row_3_turn: 0.4, row_3_rise: -0.3, row_4_time: 4 s, row_5_time: 4 s, row_5_ahead: 0.4, row_5_rise: 0.3,
        row_6_time: 4 s, row_6_rise: -0.3, row_7_time: 3 s, row_7_turn: -0.4}}
    start: {{poses: [[0 m, 0 m, -1.5 m, 0 deg]]}}
corruption:
  - {{channel: compass, kind: noise, sd: 1 deg}}
  - {{channel: pressure, kind: noise, sd: 20 Pa}}
lockstep: {{silent_controller: thrusters_off, patience: 10 s}}
recording: {{topics: all}}
"""
READ_BACK = """
import json, sys
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.cdr.type_store import deserialize
found = {topic: [] for topic in ("/lily_01/pose", "/lily_01/thermometer")}
for message in read_bag(sys.argv[1]).messages(list(found)):
    found[message.topic].append(deserialize(message.type_name, message.data))
heights = [message.pose.position.z for message in found["/lily_01/pose"]]
warmths = [message.temperature for message in found["/lily_01/thermometer"]]
print(json.dumps([heights, warmths]))
"""


def recipe(heading: str) -> str:
    """The file that a recipe shows."""
    section = (ROOT / "CONTRIBUTING.md").read_text("utf-8").partition(f"## {heading}\n")[2].partition("\n## ")[0]
    (code,) = re.findall(r"^ *```python\n(.*?)^ *```", section, re.DOTALL | re.MULTILINE)
    return textwrap.dedent(code)


def put_into_table(table: Path, module: str, name: str, line: str, before: str) -> None:
    """One line in a table, before another, with its import."""
    text = table.read_text()
    assert text.count(before) == 1
    text = text.replace(before, f"    {line},\n{before}")
    first = "from cocorosim_ros.world.sensors.sensor"
    place = text.index(first)
    table.write_text(f"{text[:place]}from {module} import {name}\n{text[place:]}")


def add_both(package: Path) -> None:
    """The steps of both recipes: a file each, and a line each."""
    sensors = package / "world" / "sensors"
    (sensors / "thermometer.py").write_text(recipe("Add a sensor"))
    module = "cocorosim_ros.world.sensors.thermometer"
    put_into_table(sensors / "__init__.py", module, "THERMOMETER", "THERMOMETER", ")\n\nSENSORS")
    (sensors / "errors" / "pressure_scale.py").write_text(recipe("Add an error of a sensor"))
    module, line = "cocorosim_ros.world.sensors.errors.pressure_scale", '"pressure_scale": PRESSURE_SCALE'
    put_into_table(sensors / "errors" / "__init__.py", module, "PRESSURE_SCALE", line, '}\n"""Every error')


@pytest.fixture(scope="module")
def python(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., str]:
    """Function of words: what Python prints, with the copy first on its path, and with a cache of its own."""
    copy = tmp_path_factory.mktemp("copy")
    for name in ("cocorosim_ros", "config", "msg_defs", "test"):
        shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("package.xml", "pyproject.toml"):
        shutil.copy(ROOT / name, copy / name)
    add_both(copy / "cocorosim_ros")
    environment = os.environ | {"PYTHONPATH": str(copy), "NUMBA_CACHE_DIR": str(copy / "compiled")}

    def run(*words: Any) -> str:
        done = subprocess.run(
            [sys.executable, *map(str, words)], cwd=copy, env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="module")
def command(python: Callable[..., str]) -> Callable[..., str]:
    """Function of words: what `cocorosim` prints in the copy."""
    return lambda *words: python("-c", "from cocorosim_ros.commands.main import main; main()", *words)


@pytest.fixture(scope="module")
def recorded(command: Callable[..., str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run of the Lily that has both, recorded."""
    folder = tmp_path_factory.mktemp("warm")
    (folder / "warm.yaml").write_text(PLATFORM)
    (folder / "dives.yaml").write_text(SCENARIO.replace("PLATFORM", str(folder / "warm.yaml")))
    command("run", folder / "dives.yaml", "--in-process", "--out", folder / "run")
    return folder / "run"


@pytest.fixture(scope="module")
def diagnosed(command: Callable[..., str], recorded: Path) -> SimpleNamespace:
    """What a diagnosis says of the recording that has a plain Lily."""
    out = recorded.parent / "out"
    command("diagnose", recorded, "--platform", "lily", "--out", out)
    return SimpleNamespace(
        said=json.loads((out / "diagnosis.json").read_text()), page=(out / "report.html").read_text("utf-8")
    )


def test_the_sensor_is_simulated_and_recorded(python: Callable[..., str], recorded: Path) -> None:
    """At every tick it shows 20 degC and 2 K per metre of height, as the recipe says."""
    heights, warmths = json.loads(python("-c", READ_BACK, recorded))
    assert len(warmths) == len(heights) >= 2 * SECONDS
    assert warmths == pytest.approx([20.0 + 2.0 * height for height in heights], abs=1e-12)
    assert max(warmths) - min(warmths) > 0.2


def test_recordings_with_it_are_measured_and_have_a_digest(command: Callable[..., str], recorded: Path) -> None:
    """Commands that know nothing of the sensor take the recording as any other."""
    assert "polarisation" in command("metrics", recorded, "--all")
    assert re.search(r"[0-9a-f]{64}", command("digest", recorded))


def test_the_error_is_simulated_and_found(diagnosed: SimpleNamespace) -> None:
    """It is what is named, alone, with its number in the interval."""
    (gain,) = diagnosed.said["effects"]
    assert (gain["id"], gain["name"]) == ("pressure_scale", "pressure gauge with a wrong gain")
    scale = gain["parameters"]["scale"]
    assert scale["ci95"][0] <= SCALE <= scale["ci95"][1]
    assert scale["ci95"][1] - scale["ci95"][0] < 0.5 * (SCALE - 1.0)


def test_the_error_is_drawn(diagnosed: SimpleNamespace) -> None:
    """The page names it, says what to check on the robot, and draws the stream against what the error's file says."""
    assert "pressure gauge with a wrong gain" in diagnosed.page
    assert "hold the sensor at two known depths." in diagnosed.page
    assert "/lily_01/pressure: what it shows less what the model expects" in diagnosed.page


def test_what_every_sensor_has_to_keep_is_tested_on_both_unasked(python: Callable[..., str]) -> None:
    """The tests over the tables pick them up: messages, units, a platform file."""
    folders = ("test/contracts/test_every_sensor.py", "test/world/motion/test_units.py", "test/world/vehicle_model")
    python("-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", "thermometer or pressure_scale", *folders)
