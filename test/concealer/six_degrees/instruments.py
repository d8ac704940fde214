"""What the instruments make of a trajectory: sounded place, compass, pressure, IMU with attitude, Doppler log."""

from __future__ import annotations

from typing import Any

import numpy as np

from concealer.layout import FloatArray
from concealer.sensors import DIGIT, Stream, hung, logged
from concealer.six_degrees import layout as at
from concealer.six_degrees.effects import Scene
from concealer.speed_logs import TOPICS

Numbers = dict[str, Any]


class Instruments:
    """Reads a trajectory (rows, ROW) of a vehicle with faults."""

    def __init__(self, rows: FloatArray, scene: Scene, numbers: Numbers, rng: np.random.Generator) -> None:
        self.rows, self.scene, self.numbers, self.rng = rows, scene, numbers, rng
        self.clock = np.arange(len(rows)) * at.ROW_TIME

    def between(self, pair: list[float]) -> float:
        """A uniform draw."""
        return float(self.rng.uniform(pair[0], pair[1]))

    def beats(self, topic: str) -> tuple[FloatArray, FloatArray]:
        """Stamps of a stream, some of which are lost, and the times that it shows."""
        n = self.numbers[topic]
        time = np.arange(self.rng.uniform(0.0, 1.0 / n["rate"]), self.clock[-1], 1.0 / n["rate"])
        time = time[self.rng.random(time.size) >= n.get("drop", 0.0)]
        late = self.scene.latency[1] if topic == self.scene.latency[0] else 0.0
        return time, np.clip(time - late, 0.0, None)

    def seen(self, time: FloatArray, first: int, count: int) -> FloatArray:
        """(n, count) columns of the trajectory from the first on."""
        return np.stack([np.interp(time, self.clock, self.rows[:, first + k]) for k in range(count)], axis=1)

    def attitude(self, time: FloatArray, angle: float) -> FloatArray:
        """(n, 4) quaternions as messages have them (x, y, z, w), turned by small random angles."""
        w, x, y, z = self.seen(time, at.QUATERNION, 4).T.copy()
        a, b, c = 0.5 * angle * self.rng.standard_normal((3, time.size))
        out = np.stack([
            x + w * a + y * c - z * b, y + w * b + z * a - x * c, z + w * c + x * b - y * a, w - x * a - y * b - z * c
        ], axis=1)  # fmt: skip
        return np.asarray(out / np.linalg.norm(out, axis=1, keepdims=True))

    def stream(self, topic: str, time: FloatArray, values: FloatArray) -> Stream:
        """The stream as it is logged."""
        logged = time + 0.001 + self.rng.exponential(self.numbers["transport"], time.size)
        return Stream(topic, time, logged, DIGIT * np.rint(values / DIGIT))

    def pose(self) -> Stream:
        """Place by sound, attitude by a filter on board."""
        n, (time, shown) = self.numbers["pose"], self.beats("pose")
        place = self.seen(shown, at.X, 3) + self.between(n["noise"]) * self.rng.standard_normal((time.size, 3))
        return self.stream("pose", time, np.hstack([place, self.attitude(shown, self.between(n["angle"]))]))

    def compass(self) -> Stream:
        """Heading."""
        n, (time, shown) = self.numbers["compass"], self.beats("compass")
        w, x, y, z = self.seen(shown, at.QUATERNION, 4).T.copy()
        yaw = np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
        yaw = yaw + self.between(n["noise"]) * self.rng.standard_normal(time.size)
        return self.stream(
            "compass", time, np.stack([np.arctan2(np.sin(yaw), np.cos(yaw)), np.zeros_like(yaw)], axis=1)
        )

    def pressure(self) -> Stream:
        """Absolute pressure."""
        n, (time, shown) = self.numbers["pressure"], self.beats("pressure")
        reading = at.SURFACE_PRESSURE - at.RHO * at.GRAVITY * self.seen(shown, at.Z, 1)[:, 0]
        reading = reading + self.scene.pressure_offset
        reading = reading + self.between(n["noise"]) * self.rng.standard_normal(time.size)
        return self.stream("pressure", time, np.stack([reading, np.zeros_like(reading)], axis=1))

    def imu(self) -> Stream:
        """Attitude, turn rate and specific force."""
        n, (time, shown) = self.numbers["imu"], self.beats("imu")
        values = np.zeros((time.size, 37))
        values[:, :4] = self.attitude(shown, self.between(n["angle"]))
        gyro, accel = self.between(n["gyro"]), self.between(n["accel"])
        values[:, 13:16] = self.seen(shown, at.RATE, 3) + gyro * self.rng.standard_normal((time.size, 3))
        values[:, 25:28] = self.seen(shown, at.STATE, 3) + accel * self.rng.standard_normal((time.size, 3))
        return self.stream("imu", time, values)

    def velocity(self, topic: str) -> Stream:
        """Doppler log in body axes, and the rate of turn; topic: through the water or over ground."""
        n, (time, shown) = self.numbers[topic], self.beats(topic)
        sigma, values = self.between(n["noise"]), np.zeros((time.size, 6))
        rates, log = self.seen(shown, at.RATE, 3), self.scene.log
        speed = logged(shown, hung(self.seen(shown, at.VELOCITY, 3), rates[:, 2], log), log)
        values[:, :3] = speed + sigma * self.rng.standard_normal((time.size, 3))
        values[:, 3:] = rates + sigma * self.rng.standard_normal((time.size, 3))
        return self.stream(topic, time, values)


def observed(
    rows: FloatArray, commands: FloatArray, scene: Scene, numbers: Numbers, rng: np.random.Generator
) -> list[Stream]:
    """All streams: trajectory (rows, ROW), commands (ticks, COUNT)."""
    eye = Instruments(rows, scene, numbers, rng)
    streams = [eye.pose(), eye.compass(), eye.pressure(), eye.imu()]
    streams += [eye.velocity(topic) for topic in TOPICS.values() if topic in numbers]
    time = np.arange(len(commands)) * at.TICK
    return [*streams, Stream("thruster_command", time, time + 0.002, commands)]
