"""What CONTRIBUTING.md promises: a sensor is one new file and one line, and so is an error of a sensor.

Its thermometer, its speed log, which a diagnosis compares, and its wrong gain are added to one copy of the package.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.world.sensors.errors.sensor_latency import CLOCK_TICK

pytestmark = pytest.mark.timeout(1800)  # s; everything is compiled anew
SCALE = 1.1
LATE = 0.5  # s
SECONDS = 60
PLATFORM = f"""name: warm
description: a Lily with a thermometer, a speed log that is late, and a pressure gauge with a wrong gain
based_on: lily
sensors: {{compass: true, pressure: true, imu: true, thermometer: true, speed_log: true}}
effects:
  pressure_scale: {{scale: {{value: {SCALE}, unit: "1", source: a test}}}}
  sensor_latency: {{speed_log: {{value: {LATE}, unit: s, source: a test}}}}
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
from cocorosim_ros import read_recording
recording = read_recording(sys.argv[1])
def shown(topic, column):
    frame = recording.to_frame(topic)
    return frame["time"].tolist(), frame[column].tolist()
heights, warmths, speeds = shown("pose", "z"), shown("thermometer", "temperature"), shown("speed_log", "speed")
east, north, yaw = (shown("pose", name)[1] for name in ("x", "y", "yaw"))
print(json.dumps({"z": heights, "warmth": warmths, "speed": speeds, "east": east, "north": north, "yaw": yaw}))
"""


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


@pytest.fixture(scope="module")
def read(python: Callable[..., str], recorded: Path) -> SimpleNamespace:
    """What a notebook reads of the recording: times [s] and values of topics, and the columns of the poses."""
    return SimpleNamespace(**json.loads(python("-c", READ_BACK, recorded)))


def test_the_sensor_is_simulated_and_recorded(read: SimpleNamespace) -> None:
    """At every tick it shows 20 degC and 2 K per metre of height, as the recipe says."""
    (times, heights), (stamps, warmths) = read.z, read.warmth
    assert stamps == times and len(times) >= 2 * SECONDS
    assert warmths == pytest.approx([20.0 + 2.0 * height for height in heights], abs=1e-12)
    assert max(warmths) - min(warmths) > 0.2


def test_the_sensor_that_a_diagnosis_compares_is_simulated_and_recorded(read: SimpleNamespace) -> None:
    """In still water it shows what places show, half a second later: the way forwards from tick to tick over its time.

    The mean of the speeds at both ends differs from the mean speed between by an eighth of the change of acceleration,
    and the way is a chord of a bend: less than 2 mm/s in all.
    """
    time, speed = np.array(read.speed)
    ahead = np.stack([np.cos(read.yaw), np.sin(read.yaw)])
    middle = ahead[:, 1:] + ahead[:, :-1]
    way = np.diff([read.east, read.north]) * middle / np.linalg.norm(middle, axis=0)
    true = way.sum(axis=0) / np.diff(time)
    shown = 0.5 * (speed[1:] + speed[:-1])
    ticks = round(LATE / (time[1] - time[0]))
    assert np.abs(shown[ticks:] - true[:-ticks]).max() < 0.002
    assert np.ptp(speed) > 0.02


def test_recordings_with_it_are_measured_and_have_a_digest(command: Callable[..., str], recorded: Path) -> None:
    """Commands that know nothing of the sensor take the recording as any other."""
    assert "polarisation" in command("metrics", recorded, "--all")
    assert re.search(r"[0-9a-f]{64}", command("digest", recorded))


def test_the_errors_are_simulated_and_found(diagnosed: SimpleNamespace) -> None:
    """They are what is named, nothing else, with their numbers in the intervals.

    That of the delay is widened by what the filter's steps cannot resolve, since this speed log has no noise.
    """
    found = {effect["id"]: effect for effect in diagnosed.said["effects"]}
    assert found.keys() == {"pressure_scale", "sensor_latency"}
    gain, late = found["pressure_scale"], found["sensor_latency"]
    assert gain["name"] == "pressure gauge with a wrong gain"
    assert (late["name"], late["topic"]) == ("speed log that comes late", "speed_log")
    for number, truth, size, beside in (
        (gain["parameters"]["scale"], SCALE, SCALE - 1.0, 0.0),
        (late["parameters"]["latency"], LATE, LATE, CLOCK_TICK),
    ):
        assert number["ci95"][0] - beside <= truth <= number["ci95"][1] + beside
        assert number["ci95"][1] - number["ci95"][0] < 0.5 * size


def test_models_are_compared_on_the_new_sensor(diagnosed: SimpleNamespace) -> None:
    """On the part of the recording that no fit saw, in its unit; a model that is late itself errs less."""
    row = diagnosed.said["fit"]["held_out"]["speed_log"]
    assert row["unit"] == "m/s"
    assert row["augmented"] < 0.5 * row["recalibrated"]


def test_the_errors_are_drawn(diagnosed: SimpleNamespace) -> None:
    """The page names them, says what to check on the robot, and draws their streams against what the files say."""
    assert "pressure gauge with a wrong gain" in diagnosed.page
    assert "hold the sensor at two known depths." in diagnosed.page
    for topic in ("pressure", "speed_log"):
        assert f"/lily_01/{topic}: what it shows less what the model expects" in diagnosed.page


def test_what_every_sensor_has_to_keep_is_tested_on_all_unasked(python: Callable[..., str]) -> None:
    """The tests over the tables pick them up: messages, units, a platform file."""
    folders = ("test/contracts/test_every_sensor.py", "test/world/motion/test_units.py", "test/world/vehicle_model")
    python("-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", "thermometer or speed_log or pressure_scale", *folders)
