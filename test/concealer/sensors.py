"""What camera, compass, pressure sensor, IMU and log make of a trajectory: rates, jitter, noise, gaps, faults."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from concealer import layout as at
from concealer.catalogue_sensors import compass_reading, hung, logged, marked, overpressure
from concealer.layout import FloatArray
from concealer.noises import in_digits, left_by_holes, noise
from concealer.scene import Faults

DIGIT = 2.0**-22  # of all readings; what is finer would be noise that no file can be made smaller of
EPOCH_NS = 1_760_000_000_000_000_000
Numbers = dict[str, Any]


@dataclass(frozen=True)
class Stream:
    """One topic of one robot: stamps and log times since EPOCH_NS, and the numbers of each message."""

    topic: str
    stamp: FloatArray  # (n,) s
    logged: FloatArray  # (n,) s
    values: FloatArray  # (n, numbers)


class Observer:
    """Reads one robot's trajectory (rows, ROW) through faulty sensors."""

    def __init__(self, rows: FloatArray, faults: Faults, numbers: Numbers, rng: np.random.Generator) -> None:
        self.rows, self.faults, self.numbers, self.rng = rows, faults, numbers, rng
        self.member = numbers.get("member", {})  # of the family of noises; white noise if there is none
        self.clock = np.arange(len(rows)) * at.ROW_TIME
        self.end = float(self.clock[-1])

    def seen(self, time: FloatArray, *places: int) -> FloatArray:
        """(n, places) columns of the trajectory at these times."""
        return np.stack([np.interp(time, self.clock, self.rows[:, place]) for place in places], axis=1)

    def held(self, time: FloatArray, *places: int) -> FloatArray:
        """(n, places) the same of columns that jump with the commands, at the last time kept before."""
        row = np.minimum((time / at.ROW_TIME + 1e-9).astype(np.int64), len(self.rows) - 1)
        return self.rows[row][:, list(places)]

    def beats(self, rate: float, jitter: float = 0.0) -> FloatArray:
        """Times of measurement: regular but for a normal jitter [s]."""
        time = np.arange(self.rng.uniform(0.0, 0.5 / rate), self.end, 1.0 / rate)
        return np.asarray(np.sort(np.clip(time + jitter * self.rng.standard_normal(time.size), 0.0, self.end)))

    def stream(self, topic: str, time: FloatArray, values: FloatArray) -> Stream:
        """The stream as it is logged: its clock's stamps, the recorder's log times."""
        stamp = time[0] + (1.0 + self.faults.skew.get(topic, 0.0)) * (time - time[0])
        whole = Stream(topic, stamp, time + self.transport(time.size), DIGIT * np.rint(values / DIGIT))
        keep = left_by_holes(self.rng, time, self.member)
        return Stream(topic, whole.stamp[keep], whole.logged[keep], whole.values[keep])

    def noise(self, time: FloatArray, *columns: int) -> FloatArray:
        """Noise of standard deviation 1 in one column, or in so many, of readings at these times."""
        return noise(self.rng, (time.size, *columns), self.member, time)

    def digits(self, kind: str, values: FloatArray) -> FloatArray:
        """Readings of a kind of instrument in its digits; exact ones where nothing is coarse."""
        return in_digits(values, self.member.get("digits", 0.0) * self.numbers.get("digit", {}).get(kind, 0.0))

    def transport(self, count: int) -> FloatArray:
        """Delays between measurement and log [s]."""
        return 0.001 + self.rng.exponential(self.numbers["transport"], count)

    def shown(self, topic: str, time: FloatArray) -> FloatArray:
        """The times that a stream shows when it is stamped with these."""
        return np.clip(time - self.faults.latency.get(topic, 0.0), 0.0, None)

    def between(self, pair: list[float]) -> float:
        """A uniform draw."""
        return float(self.rng.uniform(pair[0], pair[1]))

    def pose(self) -> Stream:
        """The camera: position and yaw, with drop-outs, gaps and now and then a message twice."""
        n = self.numbers["camera"]
        time = self.beats(n["rate"], n["jitter"])
        keep = self.rng.random(time.size) >= self.between(n["drop"])
        for _ in range(self.rng.integers(0, n["gaps"] + 1)):
            start = self.rng.uniform(0.0, self.end)
            keep &= (time < start) | (time > start + self.between(n["gap"]))
        time = np.sort(np.concatenate([time[keep], time[keep][self.rng.random(keep.sum()) < 0.001]]))
        state = self.seen(self.shown("pose", time), at.X, at.Y, at.Z, at.YAW)
        noise = self.between(n["noise"]) * self.noise(time, 4)
        noise[:, 3] = self.between(n["heading"]) * self.noise(time)
        same = np.flatnonzero(np.diff(time) == 0.0) + 1
        noise[same] = noise[same - 1]
        state = state + noise
        state = marked(state, self.faults)
        place = self.digits("pose", state[:, :3] * self.faults.scale)
        yaw = self.digits("compass", state[:, 3])
        if self.faults.mixup == "pose_millimetres":
            place = place * 1000.0
        if self.faults.mixup == "pose_ned":
            place, yaw = place[:, [1, 0, 2]] * [1.0, 1.0, -1.0], 0.5 * np.pi - yaw
        turn = np.stack([np.zeros_like(yaw), np.zeros_like(yaw), np.sin(yaw / 2), np.cos(yaw / 2)], axis=1)
        return self.stream("pose", time, np.hstack([place, turn]))

    def compass(self, commands: FloatArray) -> Stream:
        """The compass; commands (ticks, 3) are those of the motors that may disturb it."""
        n = self.numbers["compass"]
        time = self.beats(float(self.rng.choice(n["rate"])))
        shown = self.shown("compass", time)
        tick = np.minimum((shown / at.TICK).astype(int), len(commands) - 1)
        sigma = self.between(n["noise"])
        reading = compass_reading(self.seen(shown, at.YAW)[:, 0], self.faults)
        uneven = 1.0 + 0.5 * self.faults.motor_uneven * np.array([1.0, -1.0])
        reading = reading + self.faults.compass_motor * (np.abs(commands[tick, :2]) * uneven).mean(axis=1)
        reading = self.digits("compass", reading + sigma * self.noise(time))
        if self.faults.mixup == "compass_clockwise":
            reading = 0.5 * np.pi - reading
        if self.faults.mixup == "compass_negative":
            reading = -reading
        reading = -((np.pi - reading) % (2.0 * np.pi)) + np.pi
        if self.faults.mixup == "compass_degrees":
            reading = np.degrees(reading)
        variance = sigma**2 if self.rng.random() < 0.5 else 0.0
        return self.stream("compass", time, np.stack([reading, np.full(time.size, variance)], axis=1))

    def pressure(self) -> Stream:
        """Absolute pressure."""
        n = self.numbers["pressure"]
        time = self.beats(float(self.rng.choice(n["rate"])))
        depth = -self.seen(self.shown("pressure", time), at.Z)[:, 0]
        drift = np.expm1(-time / self.faults.drift_time) / np.expm1(-self.end / self.faults.drift_time)
        reading = at.SURFACE_PRESSURE + overpressure(time, at.RHO * at.GRAVITY * depth, self.faults)
        reading = reading + self.between(n["noise"]) * self.noise(time)
        reading = self.digits("pressure", reading + self.faults.pressure_offset + self.faults.pressure_drift * drift)
        if self.faults.mixup == "pressure_hectopascal":
            reading = reading / 100.0
        return self.stream("pressure", time, np.stack([reading, np.zeros(time.size)], axis=1))

    def imu(self) -> Stream:
        """Turn rate and specific force at the centre of rotation."""
        n = self.numbers["imu"]
        time = self.beats(float(self.rng.choice(n["rate"])))
        turn = np.zeros((time.size, 3))
        rate = self.seen(self.shown("imu", time), at.R)[:, 0]
        rate = rate * (1.0 + self.faults.gyro_gain * (1.0 + self.faults.gyro_uneven * np.sign(rate)))
        turn[:, 2] = rate + self.faults.gyro_bias
        turn = self.digits("gyro", turn + self.between(n["gyro"]) * self.noise(time, 3))
        force = self.held(self.shown("imu", time), at.ACCEL, at.ACCEL + 1, at.ACCEL + 2)
        force = force + np.array([0.0, 0.0, at.GRAVITY]) + np.array(self.faults.accel_bias)
        force = self.digits("accel", force + self.between(n["accel"]) * self.noise(time, 3))
        if self.faults.mixup == "imu_frd":
            turn, force = turn * [1.0, -1.0, -1.0], force * [1.0, -1.0, -1.0]
        values = np.zeros((time.size, 37))
        values[:, 3], values[:, 4] = 1.0, -1.0  # no orientation
        values[:, 13:16], values[:, 25:28] = turn, force
        return self.stream("imu", time, values)

    def velocity(self) -> Stream:
        """The robot's own estimate of its motion, here of good quality: through the water, body axes."""
        n = self.numbers["velocity"]
        time = self.beats(n["rate"])
        values = np.zeros((time.size, 6))
        values[:, 5] = self.seen(time, at.R)[:, 0]
        speed = hung(self.seen(time, at.THROUGH_U, at.THROUGH_V, at.W), values[:, 5], self.faults)
        values[:, :3] = logged(time, speed, self.faults)
        sigma = self.between(n["noise"])
        values[:, [0, 1, 2, 5]] += sigma * np.array([1.0, 1.0, 1.0, 5.0]) * self.noise(time, 4)
        values = self.digits("velocity", values)
        return self.stream("velocity", time, values)


def observe(
    rows: FloatArray, commands: FloatArray, faults: Faults, numbers: Numbers, rng: np.random.Generator
) -> list[Stream]:
    """All streams of one robot: trajectory (rows, ROW) and commands (ticks, 3)."""
    eye = Observer(rows, faults, numbers, rng)
    streams = [eye.pose(), eye.compass(commands)]
    if rng.random() >= numbers["pressure"]["missing"]:
        streams.append(eye.pressure())
    # An effect of the IMU is not hidden by leaving the IMU out.
    faulty = (
        faults.gyro_bias != 0.0
        or faults.gyro_gain != 0.0
        or faults.mixup == "imu_frd"
        or "imu" in faults.latency | faults.skew
    )
    if rng.random() >= numbers["imu"]["missing"] or faulty:
        streams.append(eye.imu())
    # Nor is one of the speed log, by leaving that out; nor the span of a gauge, which as well is a camera's scale.
    measured = faults.log_scale != 0.0 or faults.log_turn[0] != 0.0 or faults.gauge_gain != 0.0
    measured = measured or faults.log_place != (0.0, 0.0)
    if rng.random() < numbers["velocity"]["present"] or measured:
        streams.append(eye.velocity())
    streams.append(sent(commands, faults, eye))
    return streams


def sent(commands: FloatArray, faults: Faults, eye: Observer) -> Stream:
    """The commands (ticks, 3) as they were sent and logged, each of which acts at its tick."""
    time = np.arange(len(commands), dtype=np.float64) * at.TICK
    if faults.command_late:
        scatter = faults.command_scatter * eye.rng.uniform(-1.0, 1.0, time.size)
        time = time - faults.command_late * (1.0 + scatter)
    logged = time + eye.transport(time.size)
    kept = time >= 0.0
    return Stream("thruster_command", np.asarray(time[kept]), np.asarray(logged[kept]), commands[kept])
