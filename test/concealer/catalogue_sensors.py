"""The effects of the interface's table that live in sensors, clocks and cameras; see catalogue.py."""

from __future__ import annotations

import math

import numpy as np

from concealer.catalogue import BODY, Hide
from concealer.layout import DURATION, FloatArray
from concealer.scene import Faults, Scene, Secret, direction, signed


def compass_reading(yaw: FloatArray, faults: Faults) -> FloatArray:
    """What a compass shows whose field is distorted by hard and soft iron [rad], not wrapped to the yaw's turn."""
    along = (np.cos(yaw) + faults.hard_iron[0]) * (1.0 + faults.soft_iron)
    across = np.sin(yaw) - faults.hard_iron[1]
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
    return Secret("compass_distortion", {**found}, "field vector with hard and soft iron", "compass")


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


def sensor_latency(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """One stream shows the past."""
    topic = str(rng.choice(["pose", "compass", "imu"]))
    scene.fault.latency[topic] = amount
    return Secret("sensor_latency", {"latency": amount}, "constant", topic)


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


CATALOGUE: dict[str, Hide] = BODY | {
    hide.__name__: hide
    for hide in (
        compass_distortion, pressure_offset, pressure_drift, sensor_latency, clock_skew, camera_scale, frame_mixup,
        imu_bias,
    )
}  # fmt: skip
