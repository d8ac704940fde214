"""Recordings with something concealed: deterministic, sealed, readable by other code, and true to what they hide."""

from __future__ import annotations

import json
import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest


def observed(rows: Any, **faults: Any) -> dict[str, Any]:
    """Streams by topic of a trajectory (rows, ROW) seen through faults, with little noise."""
    from concealer import prior
    from concealer.scene import Faults
    from concealer.sensors import observe

    numbers = prior.load()["sensors"]
    numbers["camera"] |= {"jitter": 0.0, "noise": [1e-6, 1e-6], "heading": [1e-6, 1e-6], "gaps": 0, "drop": [0.0, 0.0]}
    numbers["compass"]["noise"] = [1e-6, 1e-6]
    numbers["pressure"]["noise"] = [1e-6, 1e-6]
    numbers["imu"] |= {"gyro": [1e-6, 1e-6], "accel": [1e-6, 1e-6], "missing": 0.0}
    numbers["velocity"] |= {"present": 1.0, "noise": [1e-6, 1e-6]}
    commands = np.tile([0.5, -0.3, 0.0], ((len(rows) - 1) // 5, 1))
    return {s.topic: s for s in observe(rows, commands, Faults(**faults), numbers, np.random.default_rng(5))}


@pytest.fixture(scope="module")
def turning(run: Any) -> Any:
    """A trajectory of a minute in a wide circle, with a dive."""
    return run((0.9, 0.7, 0.01), 60.0, {2: -1.0})


def test_the_same_seed_gives_the_same_bytes(trial: Path, tmp_path: Path, numbers: dict[str, Any]) -> None:
    """Another run, in a process of its own and from another number on, writes the same files."""
    from concealer.conceal import conceal
    from concealer.prior import Wish

    assert sorted(conceal(tmp_path / "t", numbers, 7, range(3, 4), Wish(), jobs=2)) == ["r0003"]
    for file in ("recordings/r0003/r0003.mcap", "envelopes/r0003.json"):
        assert (tmp_path / "t" / file).read_bytes() == (trial / file).read_bytes()


def test_logs_and_markers_by_hand() -> None:
    """A scale at the crest of its swing, beams at right angles, a marker seen at its mean height."""
    from concealer.catalogue_sensors import hung, logged, marked
    from concealer.scene import Faults

    speed = np.array([[0.3, -0.1, 0.02]])
    warm = Faults(log_scale=0.1, log_warmth=(8.0, 0.0))
    np.testing.assert_allclose(logged(np.array([2.0]), speed, warm), 1.13 * speed, rtol=1e-12)
    turned = Faults(log_turn=(0.5 * math.pi, 0.5 * math.pi))
    np.testing.assert_allclose(logged(np.array([2.0]), speed, turned), [[-0.1, -0.3, 0.02]], atol=1e-15)
    aside = hung(np.repeat(speed, 2, axis=0), np.array([0.5, -0.5]), Faults(log_place=(0.2, 0.1), log_swing=0.1))
    np.testing.assert_allclose(aside, [[0.245, 0.01, 0.02], [0.345, -0.19, 0.02]], atol=1e-15)
    state = np.array([[1.0, 2.0, -1.0, 0.5 * math.pi]])
    beside = marked(state, Faults(marker=(0.3, -0.1), marker_turn=0.2, marker_wobble=0.5))
    np.testing.assert_allclose(beside, [[1.1, 2.3, -1.0, 0.5 * math.pi + 0.2]], atol=1e-12)


def test_other_seeds_give_other_recordings(trial: Path) -> None:
    """No two recordings of a trial have the same data or envelope."""
    ledger = json.loads((trial / "ledger.json").read_text())["recordings"]
    assert len({entry[key] for entry in ledger.values() for key in entry}) == 8


def test_the_seal_breaks_when_a_byte_changes(trial: Path, tmp_path: Path) -> None:
    """Seals hold as written; an envelope with another digit, a missing or an added one, is noticed."""
    import shutil

    from concealer.seal import broken_seals

    assert broken_seals(trial / "ledger.json", trial / "envelopes", trial / "recordings") == []
    copy = shutil.copytree(trial / "envelopes", tmp_path / "envelopes")
    text = (copy / "r0001.json").read_text()
    (copy / "r0001.json").write_text(text.replace('"noise": 0', '"noise": 1', 1))
    (copy / "r0002.json").rename(copy / "r0009.json")
    assert [line.partition(":")[0] for line in broken_seals(trial / "ledger.json", copy)] == ["r0001", "r0002", "r0009"]


def test_a_truth_without_salt_is_not_sealed() -> None:
    """A hash that could be guessed from a list of sizes is refused."""
    from concealer.seal import seal

    with pytest.raises(ValueError, match="salt"):
        seal({"effects": []})


def test_an_independent_reader_finds_the_contract_in_the_recording(trial: Path) -> None:
    """Types, frames, actuators, units and stamps are the interface's, as rosbags decodes them."""
    from concealer.bag import typestore
    from rosbags.rosbag2 import Reader

    seen: dict[str, Any] = {}
    with Reader(trial / "recordings" / "r0000") as reader:
        for link, logged, data in reader.messages():
            message = typestore().deserialize_cdr(data, link.msgtype)
            stamp = message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
            assert abs(logged - stamp) < 10**9
            seen.setdefault(link.topic.rpartition("/")[2], message)
    assert {"pose", "compass", "thruster_command", "pressure"} <= set(seen)
    assert seen["pose"].header.frame_id == "world"
    turn = seen["pose"].pose.orientation
    assert turn.z**2 + turn.w**2 == pytest.approx(1.0)
    assert seen["thruster_command"].name == ["left", "right", "buoyancy"]
    assert seen["compass"].header.frame_id.endswith("/base_link")
    depth = -seen["pose"].pose.position.z
    assert seen["pressure"].fluid_pressure == pytest.approx(101325.0 + 9810.0 * depth, abs=1500.0)


def test_the_tool_reads_the_recording(trial: Path) -> None:
    """The project's own reader finds all robots and their poses in it, undamaged."""
    from cocorosim_ros.wire.bags.bag_reader import read_bag
    from cocorosim_ros.wire.bags.tracks import read_poses

    truth = json.loads((trial / "envelopes" / "r0000.json").read_text())
    bag = read_bag(trial / "recordings" / "r0000")
    tracks = read_poses(bag)
    assert sorted(tracks) == truth["robots"]
    track = tracks["lily_01"]
    assert track.frames == ("world",)
    assert (track.not_finite, track.unreadable, track.conflicts) == (0, 0, 0)
    assert 450 < len(track.time) <= 600
    assert not bag.summary.damage


def test_latency_shows_the_past_and_skew_stretches_stamps(turning: Any) -> None:
    """With latency the camera shows where the robot was; with skew the stamps run away from the start."""
    plain, late, fast = (
        observed(turning), observed(turning, latency={"pose": 0.2}), observed(turning, skew={"pose": 0.01}),
    )  # fmt: skip
    clock = np.arange(len(turning)) * 0.02
    for streams, delay in ((plain, 0.0), (late, 0.2)):
        stamp, x = streams["pose"].stamp[50:], streams["pose"].values[50:, 0]
        assert np.allclose(x, np.interp(stamp - delay, clock, turning[:, 0]), atol=1e-5)
    start = plain["pose"].stamp[0]
    assert np.allclose(fast["pose"].stamp - start, 1.01 * (plain["pose"].stamp - start))
    for topic in ("compass", "imu", "pressure"):
        assert np.array_equal(fast[topic].stamp, plain[topic].stamp)


def test_sensors_show_the_contracts_units_and_signs(turning: Any) -> None:
    """Pressure rises with depth, gravity points up in a resting accelerometer, the gyroscope is counter-clockwise."""
    streams = observed(turning, gyro_bias=0.01, accel_bias=(0.0, 0.02, 0.0), pressure_offset=70.0, scale=1.05)
    imu, pressure, pose = (streams[topic] for topic in ("imu", "pressure", "pose"))
    clock = np.arange(len(turning)) * 0.02
    z = np.interp(pressure.stamp, clock, turning[:, 2])
    assert np.allclose(pressure.values[:, 0], 101325.0 - 9810.0 * z + 70.0, atol=1.0)
    assert np.allclose(imu.values[:, 15], np.interp(imu.stamp, clock, turning[:, 7]) + 0.01, atol=1e-4)
    side = np.interp(imu.stamp, clock, turning[:, 4] * turning[:, 7])  # centripetal, to the left when turning left
    assert np.median(imu.values[200:, 26] - 0.02 - side[200:]) == pytest.approx(0.0, abs=2e-3)
    assert imu.values[-1, 27] == pytest.approx(9.81, abs=0.01)
    assert np.allclose(pose.values[:, 0], 1.05 * np.interp(pose.stamp, clock, turning[:, 0]), atol=1e-4)
    assert imu.values[0, 4] == -1.0


def test_gauges_and_gyroscopes_that_are_wrong_by_a_factor(turning: Any) -> None:
    """A span at the crest of its swing, 0.05 (1 + 0.3); a turn to the left, 0.04 (1 + 0.5)."""
    plain = observed(turning)
    warm = observed(turning, gauge_gain=0.05, gauge_warmth=(1e12, math.pi / 2.0), gyro_gain=0.04, gyro_uneven=0.5)
    over = (streams["pressure"].values[:, 0] - 101325.0 for streams in (warm, plain))
    np.testing.assert_allclose(next(over), 1.065 * next(over), rtol=1e-6)
    factor = 1.0 + 0.04 * (1.0 + 0.5 * math.copysign(1.0, np.median(turning[:, 7])))
    rate, shown = (streams["imu"].values[200:, 15] for streams in (plain, warm))
    np.testing.assert_allclose(shown, factor * rate, atol=1e-5)


def test_the_compass_parameters_are_those_of_the_contracts_equation() -> None:
    """reading = yaw + offset + sin sin(yaw) + cos cos(yaw), within the second harmonic that soft iron adds."""
    from concealer import layout as at
    from concealer.catalogue_sensors import compass_distortion, compass_reading
    from concealer.scene import Faults, Scene

    scene = Scene(at.nominal_robot()[None], [Faults()], 0)
    secret = compass_distortion(np.random.default_rng(2), 0.06, scene)
    yaw = np.linspace(-3.0, 3.0, 50)
    p = {key: float(value) for key, value in secret.parameters.items()}
    error = np.angle(np.exp(1j * (compass_reading(yaw, scene.fault) - yaw)))
    assert np.allclose(error, p["offset"] + p["sin"] * np.sin(yaw) + p["cos"] * np.cos(yaw), atol=0.01)
    assert math.hypot(p["sin"], p["cos"]) == pytest.approx(0.06, rel=0.1)


def test_soft_iron_errs_by_its_second_harmonic() -> None:
    """By 0.08 rad, and by less than the square of 0.16 beside it, whichever way the iron lies."""
    from concealer import layout as at
    from concealer.catalogue_sensors import compass_reading, soft_iron
    from concealer.scene import Faults, Scene

    scene = Scene(at.nominal_robot()[None], [Faults()], 0)
    secret = soft_iron(np.random.default_rng(5), 0.08, scene)
    yaw = np.linspace(-3.0, 3.0, 50)
    p = {key: float(value) for key, value in secret.parameters.items()}
    error = np.angle(np.exp(1j * (compass_reading(yaw, scene.fault) - yaw)))
    assert np.allclose(error, p["sin_2"] * np.sin(2.0 * yaw) + p["cos_2"] * np.cos(2.0 * yaw), atol=0.16**2 / 2.0)
    assert math.hypot(p["sin_2"], p["cos_2"]) == pytest.approx(0.08, rel=0.1)


def test_late_commands_are_logged_before_they_act() -> None:
    """By 0.3 s on average, each by another time, and none before the recording begins."""
    from concealer.scene import Faults
    from concealer.sensors import Observer, sent

    faults, rng = Faults(command_late=0.3, command_scatter=0.2), np.random.default_rng(1)
    commands = np.arange(900.0).reshape(300, 3)
    stream = sent(commands, faults, Observer(np.zeros((2, 1)), faults, {"transport": 0.004}, rng))
    ticks = stream.values[:, 0] / 3.0
    early = ticks * 0.1 - stream.stamp
    assert np.mean(early) == pytest.approx(0.3, abs=0.01)
    assert early.min() >= 0.24 - 1e-9 and early.max() <= 0.36 + 1e-9 and np.ptp(early) > 0.1
    assert stream.stamp.min() >= 0.0 and (np.diff(ticks) == 1.0).all()


def test_every_effect_of_the_contract_can_be_hidden_and_changes_the_recording(numbers: dict[str, Any]) -> None:
    """For each entry inside and outside the table: other trajectory or streams than with nothing, names as fixed."""
    from concealer.catalogue_sensors import CATALOGUE
    from concealer.outside import OUTSIDE
    from concealer.prior import Plot
    from concealer.recording import move, stage
    from concealer.sensors import observe

    assert set(CATALOGUE) == {*numbers["effects"], *numbers["asked_for"]} and set(OUTSIDE) == set(numbers["outside"])
    assert len(CATALOGUE) >= 30 and len(OUTSIDE) >= 8

    def streams(hidden: dict[str, float]) -> Any:
        plot = Plot("single", hidden, robots=2, duration=60.0, side=3.0)
        scene, secrets = stage(np.random.default_rng(1), numbers, plot)
        scene.robots[:, :7] = numbers["nominal"][:7]  # the vehicle draws the same, but for what is hidden
        rows, commands = move(np.random.default_rng(2), plot, scene)
        k = scene.victim
        seen = observe(rows[:, k], commands[:, k], scene.faults[k], numbers["sensors"], np.random.default_rng(3))
        return secrets, {s.topic: np.column_stack([s.stamp, s.values]) for s in seen}

    from concealer.layout import nominal_robot

    always = numbers["sensors"] | {"velocity": numbers["sensors"]["velocity"] | {"present": 1.0}}
    numbers = numbers | {"nominal": nominal_robot(), "sensors": always}
    nothing = streams({})[1]
    followers = streams({"neighbour_wake": 1e-9})[1]
    for name in [*CATALOGUE, *OUTSIDE]:
        secrets, seen = streams({name: 1.0})
        base = followers if name == "neighbour_wake" else nothing
        assert any(not np.array_equal(seen[topic], base[topic]) for topic in base), name
        assert secrets[0].id == name if name in CATALOGUE else secrets[0].id.startswith("unknown:")
        assert all(pattern.startswith("unknown:") for pattern in secrets[0].acceptable)


@pytest.mark.parametrize("manoeuvre", ["rich", "cruise", "steady_turns", "circle", "straight", "idle"])
def test_robots_stay_in_the_tank(numbers: dict[str, Any], manoeuvre: str) -> None:
    """Ten minutes of any programme at 3 % noise keep 5 cm from walls, floor and surface."""
    from concealer.prior import Wish, draw
    from concealer.recording import move, stage

    plot = draw(np.random.default_rng(4), numbers, Wish("nothing", noise=0.03, manoeuvre=manoeuvre, duration=600.0))
    scene, _ = stage(np.random.default_rng(4), numbers, plot)
    rows, _ = move(np.random.default_rng(4), plot, scene)
    assert np.abs(rows[..., :2]).max() < 0.5 * plot.side - 0.05
    assert -2.0 + 0.05 < rows[..., 2].min() and rows[..., 2].max() < -0.05


def test_poor_programmes_do_not_show_what_they_are_said_not_to(numbers: dict[str, Any]) -> None:
    """A recording that cannot tell is the same, command for command, with and without its hidden effect."""
    from concealer.manoeuvres import CANNOT_SHOW
    from concealer.prior import Plot
    from concealer.recording import move, stage

    for manoeuvre, names in CANNOT_SHOW.items():
        tracks = []
        for hidden in ({}, *({name: 1.0} for name in names)):
            plot = Plot("cannot_tell", hidden, noise=0.01, manoeuvre=manoeuvre, duration=60.0, side=6.0)
            scene, _ = stage(np.random.default_rng(6), numbers, plot)
            tracks.append(move(np.random.default_rng(7), plot, scene)[0][..., :4])
        assert all(np.allclose(track, tracks[0], atol=1e-9) for track in tracks), manoeuvre


def test_the_oracle_runs_freely_on_the_truth(trial: Path) -> None:
    """Without random forces the oracle's error is the camera's noise; it never is below it."""
    from concealer import prior
    from concealer.oracle import free_run
    from concealer.prior import Plot
    from concealer.recording import move, stage

    plot = Plot("single", {"thruster_lag": 0.5, "pump_lag": 0.5}, noise=0.0, duration=60.0, side=4.0)
    scene, _ = stage(np.random.default_rng(1), prior.load(), plot)
    rows, commands = move(np.random.default_rng(2), plot, scene)
    assert np.sqrt(free_run(scene.robots, rows, commands, 10.0)).max() < 1e-9
    scene.own[4] *= 1.05
    assert np.sqrt(free_run(scene.robots, rows, commands, 10.0)).max() > 1e-3
    truth = json.loads((trial / "envelopes" / "r0000.json").read_text())
    assert truth["oracle"]["lily_01"]["20"]["position"] > 0.001


def test_the_oracle_knows_the_cameras_noise() -> None:
    """Second differences of a smooth track with noise of 3 mm and 0.02 rad give these back."""
    from concealer.oracle import _noise
    from concealer.sensors import Stream

    rng, time = np.random.default_rng(8), np.arange(0.0, 600.0, 0.1)
    values = np.zeros((time.size, 7))
    values[:, :3] = 0.05 * time[:, None] + 0.003 * rng.standard_normal((time.size, 3))
    yaw = 0.5 * time + 0.02 * rng.standard_normal(time.size)
    values[:, 5], values[:, 6] = np.sin(yaw / 2), np.cos(yaw / 2)
    assert _noise(Stream("pose", time, time, values)) == pytest.approx([0.003, 0.003, 0.003, 0.02], rel=0.06)


def test_the_cameras_noise_does_not_depend_on_where_results_lie(monkeypatch: pytest.MonkeyPatch) -> None:
    """The arctangent sees whole rows; that of strided columns differs in NumPy 1.26 where memory is adjacent."""
    from concealer.oracle import _noise
    from concealer.sensors import Stream

    rng, arctangent = np.random.default_rng(8), np.arctan2
    memory = np.zeros(100 * 7 + 2 + 100)
    values, adjacent = memory[:700].reshape(100, 7), memory[702:802]
    values[:, 5:] = rng.uniform(0.1, 0.9, (100, 2))
    expected = _noise(Stream("pose", np.arange(100.0), np.arange(100.0), values))

    def into_adjacent_memory(y: Any, x: Any) -> Any:
        return arctangent(y, x, out=adjacent).copy()

    monkeypatch.setattr(np, "arctan2", into_adjacent_memory)
    assert np.array_equal(_noise(Stream("pose", np.arange(100.0), np.arange(100.0), values)), expected)


def test_tampering_changes_one_stream_as_sealed(trial: Path, tmp_path: Path) -> None:
    """The logged command of one thruster is scaled, all else is the same byte for byte, and the truth says so."""
    from concealer.bag import typestore
    from concealer.tamper import tamper
    from rosbags.rosbag2 import Reader

    source = trial / "recordings" / "r0000"
    told = json.loads(tamper(source, tmp_path / "t", "gain:1", -0.05))
    with Reader(source) as before, Reader(tmp_path / "t" / "recordings" / "r0000") as after:
        for (link, time, old), (_, other_time, new) in zip(before.messages(), after.messages(), strict=True):
            assert time == other_time
            if link.topic != "/lily_01/thruster_command":
                assert bytes(old) == bytes(new)
                continue
            a, b = (typestore().deserialize_cdr(data, link.msgtype) for data in (old, new))
            assert np.allclose(b.command, a.command * [1.0, 0.95, 1.0])
    assert told["parameters"]["difference"] == pytest.approx(0.05 / 0.975, rel=1e-3)
    for how in ("delay:pose", "skew:imu" if "imu" in str(told) else "skew:pose", "compass", "scale", "lowpass"):
        target = tmp_path / how.replace(":", "_")
        assert json.loads(tamper(source, target, how, 0.01))["messages"] > 100
    with pytest.raises(ValueError, match="no topic"):
        tamper(source, tmp_path / "none", "delay:sonar", 0.1)
    with pytest.raises(ValueError, match="more than full"):
        tamper(source, tmp_path / "full", "gain:1", 9.0)


def test_velocities_and_rates_are_put_into_other_axes_and_units() -> None:
    """By hand: ahead is north at a heading of a quarter turn; x and y change places; pi rad/s are 180 deg/s."""
    from concealer.tamper import degrees_change, earth_change, swapped_change

    def message(x: float, y: float, rate: float = 0.0) -> Any:
        stamp = SimpleNamespace(sec=10, nanosec=0)
        return SimpleNamespace(
            header=SimpleNamespace(stamp=stamp),
            twist=SimpleNamespace(linear=SimpleNamespace(x=x, y=y, z=0.0)),
            angular_velocity=SimpleNamespace(z=rate),
        )

    north = earth_change([8.0, 12.0], [0.0, math.pi])(message(1.0, 0.5), 0.0)
    assert north is not None
    assert (north.twist.linear.x, north.twist.linear.y) == pytest.approx((-0.5, 1.0))
    other = swapped_change(1.0)(message(1.0, 0.5), 0.0)
    assert other is not None and (other.twist.linear.x, other.twist.linear.y) == (0.5, 1.0)
    turning = degrees_change(1.0)(message(0.0, 0.0, math.pi), 0.0)
    assert turning is not None and turning.angular_velocity.z == pytest.approx(180.0)


def test_a_twin_is_what_the_recording_cannot_tell_apart() -> None:
    """Nats by hand: 1e-4 N left unexplained for 100 s, 1 % noise of 2 s: 0.5 * 1e-8 * 100 / (2 * 2 * 1e-8) = 12.5."""
    from concealer import layout as at
    from concealer.scene import Secret
    from concealer.twins import nats, twins

    assert nats(np.full(1000, 1e-4), 0.01, 2.0) == pytest.approx(12.5)
    p, rows = at.nominal_robot(), np.zeros((6001, at.ROW))
    rows[:, at.Y] = np.linspace(-1.0, 1.0, 6001)
    rows[:, at.U] = 0.05
    commands = np.ones((1200, 3))
    for gradient, names in ((0.005, []), (0.00005, ["steady_current"])):
        p[[at.CURRENT_X, at.SHEAR_XY]] = 0.003, gradient
        assert twins(Secret("sheared_current", {}, ""), p, rows, commands, (0.01, 2.0)) == names
    # At one speed a cubic law is a quadratic one; at all speeds it is not.
    p[at.CUBIC] = 5.0
    assert twins(Secret("unknown:surge~u^3", {}, ""), p, rows, commands, (0.01, 2.0)) == ["linear_drag"]
    rows[:, at.U] = np.linspace(-0.08, 0.08, 6001)
    assert twins(Secret("unknown:surge~u^3", {}, ""), p, rows, commands, (0.003, 0.5)) == []


def test_without_a_ruler_only_camera_and_compass_are_there(numbers: dict[str, Any], tmp_path: Path) -> None:
    """The recording that cannot show its lengths has no pressure, no IMU and no speed."""
    from concealer.prior import Wish
    from concealer.recording import make
    from rosbags.rosbag2 import Reader

    for folder in ("recordings", "envelopes"):
        (tmp_path / folder).mkdir()
    make(0, 3, tmp_path, numbers, Wish("cannot_tell", manoeuvre="no_ruler", robots=1))
    with Reader(tmp_path / "recordings" / "r0000") as reader:
        assert sorted(link.topic.rpartition("/")[2] for link in reader.connections) == [
            "compass", "pose", "thruster_command",
        ]  # fmt: skip
    assert json.loads((tmp_path / "envelopes" / "r0000.json").read_text())["effects"][0]["id"] == "camera_scale"
