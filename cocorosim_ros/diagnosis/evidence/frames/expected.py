"""Rough motion under the recorded commands: exact enough to tell signs, axes and powers of ten apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.criteria.frames import ROUGH_MOTION
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import FORWARD, LEFT, TURN, UP, coasting_time
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.vehicle_model.curves import forces_at

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class ExpectedCourse:
    """A course (n,) [world], x + iy: its velocity [m/s] and its acceleration [m/s^2]."""

    velocity: Complex
    acceleration: Complex


@dataclass(frozen=True)
class Expected:
    """Motion in still water: time (n,) [s]; push: horizontal force per mass, forward + i left (n,) [m/s^2; body].

    dive: heave velocity (n,) [m/s; up] and spin: yaw rate (n,) [rad/s], each as if the robot moved in no other way.
    drag: per mass [1/m].
    """

    time: Floats
    push: Complex
    dive: Floats
    spin: Floats
    drag: float

    def course(self, angle: Floats, *, mirrored: bool = False) -> ExpectedCourse:
        """The course of a robot that heads along `angle` (n,) [rad].

        m dV/dt = X - k |V| V, with a force X that turns with the heading and drag by the total speed. mirrored: left
        and right of the force are exchanged.
        """
        push = np.conj(self.push) if mirrored else self.push
        world = push * np.exp(1j * angle)
        velocity = _free_run(world, self.drag, float(self.time[1] - self.time[0]))
        return ExpectedCourse(velocity, np.asarray(world - self.drag * np.abs(velocity) * velocity))

    def led(self, angle: Floats, *, mirrored: bool = False) -> Complex:
        """Velocity (n,) [m/s; world] of a robot that heads along `angle` (n,) [rad] and that its hull leads there.

        m dv/dt = X - k |v| v along the axes of the body, whatever it turns.
        """
        push = np.conj(self.push) if mirrored else self.push
        return np.asarray(_free_run(push, self.drag, float(self.time[1] - self.time[0])) * np.exp(1j * angle))


def expected_motion(log: RobotLog, platform: Platform) -> Expected | None:
    """Motion of the platform under the commands of a log; None without commands.

    The mean of the vertical force is subtracted, because a robot that keeps its depth is in balance, however it is
    trimmed.
    """
    if not len(log.command_time):
        return None
    last = max([float(log.command_time[-1]), *(float(stream.time[-1]) for stream in log.streams.values())])
    coasting = coasting_time(platform)
    longest = ROUGH_MOTION.longest_step
    step = min(longest, coasting / ROUGH_MOTION.steps) if coasting > 0.0 else longest
    time = np.arange(float(log.command_time[0]), last, step)
    if len(time) < 2:
        return None
    held = log.command[np.searchsorted(log.command_time, time, side="right") - 1]
    force: Any = forces_at(platform, held) @ platform.actuator_wrenches()
    lift, torque = force[:, UP] - force[:, UP].mean(), force[:, TURN]
    return Expected(
        time,
        np.asarray((force[:, FORWARD] + 1j * force[:, LEFT]) / platform.mass),
        _free_run(lift / platform.mass + 0j, platform.drag / platform.mass, step).real,
        _free_run(torque / platform.yaw_inertia + 0j, platform.yaw_drag / platform.yaw_inertia, step).real,
        platform.drag / platform.mass,
    )


def _free_run(push: Complex, drag: float, step: float) -> Complex:
    """Velocity under `push` per mass: dV/dt = push - drag |V| V; drag is implicit, so that no step is too long."""
    velocity, run = 0.0j, []
    for acceleration in push.tolist():
        velocity = (velocity + step * acceleration) / (1.0 + step * drag * abs(velocity))
        run.append(velocity)
    return np.array(run)
