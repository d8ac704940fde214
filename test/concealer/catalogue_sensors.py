"""The effects of the interface's table that live in sensors, clocks and cameras; see catalogue.py."""

from __future__ import annotations

import math

import numpy as np

from concealer import speed_logs
from concealer.catalogue import BODY, Hide
from concealer.layout import DURATION, FloatArray
from concealer.scene import Faults, Scene, Secret, direction, signed


def compass_reading(yaw: FloatArray, faults: Faults) -> FloatArray:
    """What a compass shows whose field is distorted by hard and soft iron [rad], not wrapped to the yaw's turn."""
    if faults.iron_axis == 0.0:
        along = (np.cos(yaw) + faults.hard_iron[0]) * (1.0 + faults.soft_iron)
        across = np.sin(yaw) - faults.hard_iron[1]
    else:
        induced = faults.soft_iron * np.cos(yaw + faults.iron_axis)
        along = np.cos(yaw) + induced * math.cos(faults.iron_axis)
        across = np.sin(yaw) - induced * math.sin(faults.iron_axis)
    return np.asarray(np.arctan2(across, along) + faults.compass_offset)


def compass_distortion(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Hard iron of this strength, some soft iron, an offset; parameters: first harmonics over a full turn."""
    fault = scene.fault
    fault.hard_iron = direction(rng, amount)
    fault.soft_iron = signed(rng, 0.15 * amount)
    fault.compass_offset = signed(rng, amount * rng.uniform(0.0, 0.5))
    yaw = np.linspace(-math.pi, math.pi, 720, endpoint=False)
    error = np.angle(np.exp(1j * (compass_reading(yaw, fault) - yaw)))
    found = {
        "offset": float(error.mean()),
        "sin": float(2.0 * np.mean(error * np.sin(yaw))),
        "cos": float(2.0 * np.mean(error * np.cos(yaw))),
    }
    form = "field vector with hard and soft iron"
    return Secret("compass_distortion", {**found}, form, "compass", tolerated=("soft_iron",))


def soft_iron(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Iron in any direction that the earth's field magnetises; parameters: second harmonics over a full turn."""
    fault = scene.fault
    fault.soft_iron, fault.iron_axis = 2.0 * amount, rng.uniform(-math.pi / 2.0, math.pi / 2.0)
    yaw = np.linspace(-math.pi, math.pi, 720, endpoint=False)
    error = np.angle(np.exp(1j * (compass_reading(yaw, fault) - yaw)))
    found = {
        "sin_2": float(2.0 * np.mean(error * np.sin(2.0 * yaw))),
        "cos_2": float(2.0 * np.mean(error * np.cos(2.0 * yaw))),
    }
    return Secret("soft_iron", {**found}, "field vector, stretched along one direction", "compass")


def pressure_offset(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A constant number of pascals."""
    scene.fault.pressure_offset = signed(rng, amount)
    return Secret("pressure_offset", {"offset": scene.fault.pressure_offset}, "constant", "pressure")


def pressure_drift(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """An exponential approach; the rate is that from start to end."""
    duration = float(scene.own[DURATION])
    scene.fault.pressure_drift = signed(rng, amount * duration)
    scene.fault.drift_time = duration * rng.uniform(1.0, 3.0)
    rate = scene.fault.pressure_drift / duration
    return Secret("pressure_drift", {"rate": rate}, "exponential; from start to end", "pressure")


def overpressure(time: FloatArray, pressure: FloatArray, faults: Faults) -> FloatArray:
    """(n,) what a gauge makes of the pressure above that of the surface [Pa]: its span swings with the warmth."""
    period, phase = faults.gauge_warmth
    return np.asarray(pressure * (1.0 + faults.gauge_gain * (1.0 + 0.3 * np.sin(2.0 * np.pi * time / period + phase))))


def pressure_gain(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A span that swings as the gauge warms and cools; the number is its mean."""
    fault = scene.fault
    fault.gauge_gain = signed(rng, amount)
    fault.gauge_warmth = float(scene.own[DURATION] / rng.integers(2, 5)), rng.uniform(-math.pi, math.pi)
    form = "1 + s (1 + 0.3 sin(2 pi t / T)), whole periods; gain: the mean"
    return Secret("pressure_gain", {"gain": 1.0 + fault.gauge_gain}, form, "pressure")


def gyro_scale(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A gyroscope that is not equally wrong to both sides; the number is the mean of both."""
    scene.fault.gyro_gain, scene.fault.gyro_uneven = signed(rng, amount), rng.uniform(-0.3, 0.3)
    form = "1 + s (1 + e sign(r)); scale: the mean of both sides"
    return Secret("gyro_scale", {"scale": 1.0 + scene.fault.gyro_gain}, form, "imu")


def sensor_latency(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """One stream shows the past."""
    topic = str(rng.choice(["pose", "compass", "imu"]))
    scene.fault.latency[topic] = amount
    return Secret("sensor_latency", {"latency": amount}, "constant", topic)


def command_delay(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Commands that wait in buffers, not equally long; the number is the mean."""
    scene.fault.command_late, scene.fault.command_scatter = amount, rng.uniform(0.0, 0.4)
    return Secret("command_delay", {"delay": amount}, "uniform about the mean, for every command anew")


def clock_skew(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """The clock of one stream runs fast or slow."""
    topic = str(rng.choice(["pose", "compass", "imu"]))
    scene.fault.skew[topic] = signed(rng, amount)
    return Secret("clock_skew", {"skew": scene.fault.skew[topic]}, "stamps since the stream's first", topic)


def camera_scale(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """All three coordinates of the camera, about the world's origin."""
    scene.fault.scale = 1.0 + signed(rng, amount)
    return Secret("camera_scale", {"scale": scene.fault.scale}, "x, y and z about the world's origin", "pose")


MIXUPS: dict[str, tuple[str, str]] = {
    "compass_clockwise": ("compass", "the reading runs clockwise from north: yaw = pi/2 - reading"),
    "compass_negative": ("compass", "the reading runs clockwise from +x: yaw = -reading"),
    "compass_degrees": ("compass", "the reading is in degrees"),
    "pose_ned": ("pose", "the pose is in north-east-down axes: swap x and y, negate z, yaw = pi/2 - yaw"),
    "pose_millimetres": ("pose", "the position is in millimetres"),
    "pressure_hectopascal": ("pressure", "the pressure is in hectopascals"),
    "imu_frd": ("imu", "the IMU's axes are forward-right-down: negate y and z"),
}


def frame_mixup(rng: np.random.Generator, _amount: float, scene: Scene) -> Secret:
    """Axes, signs or units of one stream."""
    kind = str(rng.choice(sorted(MIXUPS)))
    scene.fault.mixup = kind
    topic, correction = MIXUPS[kind]
    return Secret("frame_mixup", {"correction": correction}, kind, topic)


def imu_bias(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Amount is in m/s^2 of acceleration; the gyroscope gets 0.4 rad/s per m/s^2."""
    gyro = signed(rng, 0.4 * amount * rng.uniform(0.5, 1.0))
    x, y, z = (float(value) for value in amount * rng.uniform(-1.0, 1.0, 3))
    scene.fault.gyro_bias, scene.fault.accel_bias = gyro, (x, y, z)
    return Secret("imu_bias", {"gyro_z": gyro, "accel_x": x, "accel_y": y, "accel_z": z}, "constant", "imu")


def logged(time: FloatArray, speed: FloatArray, faults: Faults) -> FloatArray:
    """(n, 3) what a log makes of speeds u, v, w: beams that are turned each by itself, a scale that swings."""
    forward, aside = faults.log_turn
    period, phase = faults.log_warmth
    scale = 1.0 + faults.log_scale * (1.0 + 0.3 * np.sin(2.0 * np.pi * time / period + phase))
    ahead = speed[:, 0] * np.cos(forward) + speed[:, 1] * np.sin(forward)
    left = speed[:, 1] * np.cos(aside) - speed[:, 0] * np.sin(aside)
    return np.asarray(np.stack([ahead, left, speed[:, 2]], axis=1) * scale[:, None])


def hung(speed: FloatArray, rate: FloatArray, faults: Faults) -> FloatArray:
    """(n, 3) speeds u, v, w where a log hangs beside the centre, from a pole that leans in turns of (n,) rad/s."""
    place = np.array(faults.log_place) * (1.0 + faults.log_swing * np.sign(rate)[:, None])
    return np.asarray(speed + np.stack([-rate * place[:, 1], rate * place[:, 0], 0.0 * rate], axis=1))


def marked(state: FloatArray, faults: Faults) -> FloatArray:
    """(n, 4) place and yaw of a marker that is put on beside the centre and askew; nearer the camera it looks wider."""
    ahead, left = faults.marker
    if ahead == 0.0 and left == 0.0 and faults.marker_turn == 0.0:
        return state
    out, yaw = state.copy(), state[:, 3].copy()
    wide = 1.0 + 0.05 * (state[:, 2] - state[:, 2].mean())
    out[:, 0] += wide * (ahead * np.cos(yaw) - left * np.sin(yaw))
    out[:, 1] += wide * (ahead * np.sin(yaw) + left * np.cos(yaw))
    out[:, 3] += faults.marker_turn * (1.0 + faults.marker_wobble * np.sin(2.0 * yaw))
    return out


def speed_log_scale(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A log of the speed through the water with another gain."""
    return speed_logs.scale(rng, amount, scene.fault, "speed_log", scene.own[DURATION])


def speed_log_misalignment(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A log of the speed through the water that is put on askew."""
    return speed_logs.misalignment(rng, amount, scene.fault, "speed_log")


def speed_log_lever(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A log of the speed through the water beside the centre."""
    return speed_logs.lever(rng, amount, scene.fault, "speed_log")


def pose_heading(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A marker that is put on askew, seen by a camera that is not quite above."""
    scene.fault.marker_turn, scene.fault.marker_wobble = signed(rng, amount), rng.uniform(-0.15, 0.15)
    form = "d (1 + e sin(2 yaw)); offset: the mean over a full turn"
    return Secret("pose_heading", {"offset": scene.fault.marker_turn}, form, "pose")


def pose_lever(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A marker beside the centre, which looks the wider apart the nearer the camera it is."""
    scene.fault.marker = direction(rng, amount)
    ahead, left = scene.fault.marker
    form = "R(yaw) (ahead, left) times 1 + 0.05 per metre above the mean height"
    return Secret("pose_lever", {"ahead": ahead, "left": left}, form, "pose")


def motor_field(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Motors whose cables lie nearer to the compass on one side than on the other; the number is that of both."""
    scene.fault.compass_motor, scene.fault.motor_uneven = signed(rng, amount), rng.uniform(-0.3, 0.3)
    form = "(c_l |left| + c_r |right|) / 2 of the commands; field: (c_l + c_r) / 2"
    return Secret("motor_field", {"field": scene.fault.compass_motor}, form, "compass")


CATALOGUE: dict[str, Hide] = BODY | {
    hide.__name__: hide
    for hide in (
        compass_distortion, pressure_offset, pressure_drift, sensor_latency, clock_skew, camera_scale, frame_mixup,
        imu_bias, speed_log_scale, speed_log_misalignment, pose_heading, pose_lever, motor_field, pressure_gain,
        gyro_scale, soft_iron, command_delay, speed_log_lever,
    )
}  # fmt: skip
