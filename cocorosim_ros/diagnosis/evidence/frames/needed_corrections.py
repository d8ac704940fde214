"""Corrections of streams in other axes, signs or units than the contract's, found by comparing the streams."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES
from cocorosim_ros.diagnosis.evidence.frames import units
from cocorosim_ros.diagnosis.evidence.frames.correction import COMMAND, Fault, FrameCorrection, affine, corrected
from cocorosim_ros.diagnosis.evidence.frames.inertial import inertial_axes
from cocorosim_ros.diagnosis.evidence.frames.mirrored_poses import mirrored_poses
from cocorosim_ros.diagnosis.evidence.frames.motion import motion_together
from cocorosim_ros.diagnosis.evidence.frames.orientation import EXCHANGED_COMMANDS, Orientation, best_orientation
from cocorosim_ros.diagnosis.evidence.frames.turned import (
    SAME,
    SWAPPED,
    Turned,
    angle_words,
    matrix_of,
    on_angle,
    position_words,
)
from cocorosim_ros.diagnosis.evidence.frames.upright import (
    force_unit,
    gravity_of,
    height_upside_down,
    lift_upside_down,
)
from cocorosim_ros.diagnosis.evidence.frames.velocity_axes import velocity_axes
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, TURN_RATE, VELOCITIES, YAW, Z
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import AHEAD
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform

Found = list[FrameCorrection]
Logs = Sequence[RobotLog]


def needed_corrections(
    logs: RobotLog | Sequence[RobotLog], platform: Platform, beside: Sequence[RobotLog] = ()
) -> tuple[FrameCorrection, ...]:
    """Every correction that the data support by a clear margin, in the order in which `corrected` applies them.

    Several logs must have been recorded in the same way: a correction that each of them is too short to show may show
    in all together. beside: logs of the same robot that are right.

    Units come first, by magnitudes that no physics explains; then axes and directions of turning, by the fewest
    changes that make all streams agree with each other and with the commands. A world that is turned as a whole, poses
    and compass alike, shows nowhere and is no error. Where two streams contradict each other and no third one decides,
    the stream that is wrong more often is corrected.
    """
    together = [logs] if isinstance(logs, RobotLog) else list(logs)
    found = _corrections(together, platform, beside)
    if len([correction for correction in found if correction.nats < np.inf]) < 2:
        return tuple(found)
    # Several streams that contradict the commands in the same way are right, and the commands are not.
    for turned in EXCHANGED_COMMANDS:
        commands = _commands(Orientation(command=turned, nats=min(correction.nats for correction in found)), platform)
        rest = _corrections(_all_corrected(together, commands), platform, beside)
        if commands[0].matrix is not None and len(rest) + 1 < len(found):
            found = [*commands, *rest]
    return tuple(found)


def _corrections(logs: Logs, platform: Platform, beside: Logs) -> Found:
    found = _units(logs, platform)
    found += _axes(_all_corrected(logs, found), platform, beside)
    return found + _own_axes(_all_corrected(logs, found), platform)


def _all_corrected(logs: Logs, found: Found) -> list[RobotLog]:
    return [corrected(log, found) for log in logs]


def _units(logs: Logs, platform: Platform) -> Found:
    pressure = units.pressure_unit(logs, motion_together(logs, platform), platform)
    motion = motion_together(_all_corrected(logs, [pressure] if pressure else []), platform)
    expected = np.abs(motion.advance)
    pose = units.length_unit("pose", np.abs(motion.course), expected, motion, "the commands let")
    found = [
        units.heading_in_degrees(logs, motion),
        units.rate_in_degrees(motion),
        pressure,
        pose or units.height_unit(logs, motion, platform),
        *(
            units.length_unit(topic, np.abs(moved), expected, motion, "the commands let")
            for topic, moved in motion.moved.items()
        ),
        force_unit(logs, platform),
    ]
    return [correction for correction in found if correction]


def _axes(logs: Logs, platform: Platform, beside: Logs) -> Found:
    """Corrections of the axes of poses, compass and commands, and, after these, of the IMU."""
    motion = motion_together(logs, platform)
    down = height_upside_down(motion)
    known = motion_together(beside, platform) if beside else None
    turned = best_orientation(motion, known, upside_down=down > AXES.margin)
    found = [*_pose(turned, down), *_compass(turned), *_commands(turned, platform)]
    rival = COMMAND if turned.or_commands != SAME and _exchange_of(turned.or_commands, platform) is not None else ""
    found = [replace(each, rival=rival) for each in found]
    motion = motion_together(_all_corrected(logs, found), platform)
    imu = inertial_axes(motion, gravity_of(logs, platform), _gyro_nats(turned))
    return [*found, *([replace(imu, rival=rival if _is_gyro_alone(imu) else "")] if imu else [])]


def _own_axes(logs: Logs, platform: Platform) -> Found:
    """Corrections of poses and velocities that contradict one another, found after all other streams are right."""
    motion = motion_together(logs, platform)
    poses = mirrored_poses(motion)
    if poses:
        motion = motion_together(_all_corrected(logs, [poses]), platform)
    velocities = [velocity_axes(motion, topic, lift_upside_down(motion, topic)) for topic in VELOCITIES]
    return [correction for correction in (poses, *velocities) if correction]


def _is_gyro_alone(imu: FrameCorrection) -> bool:
    """Tell whether a correction of an IMU leaves its accelerometer as it is, so that gravity says nothing for it."""
    if imu.matrix is None:
        return False
    as_recorded = np.eye(len(imu.matrix))
    as_recorded[TURN_RATE] = imu.matrix[TURN_RATE]
    return bool(np.array_equal(imu.matrix, as_recorded))


def _gyro_nats(turned: Orientation) -> float:
    return turned.nats if turned.gyro else 0.0


def _pose(turned: Orientation, down: float) -> Found:
    upside_down = down > AXES.margin
    if turned.position == turned.yaw == SAME and not upside_down:
        return []
    nats = (down if upside_down else 0.0) + (turned.nats if (turned.position, turned.yaw) != (SAME, SAME) else 0.0)
    because = "only so the poses agree with " + (
        "pressure and pump" if turned.position == turned.yaw == SAME else "the other streams and the commands"
    )
    return [replace(pose_correction(turned, because, upside_down=upside_down), nats=nats)]


def pose_correction(turned: Orientation, because: str, *, upside_down: bool = False) -> FrameCorrection:
    """Make the correction of poses whose positions and yaw are turned, and whose z may point down; of no nats yet."""
    matrix, offset = np.eye(4), np.zeros(4)
    matrix[PLANE, PLANE] = matrix_of(turned.position)
    matrix[Z, Z] = -1.0 if upside_down else 1.0
    matrix[YAW, YAW], offset[YAW] = on_angle(turned.yaw)
    fault = Fault(_pose_words(turned.position, turned.yaw, upside_down), because)
    return affine("pose", fault, 0.0, matrix, offset)


def _pose_words(position: Turned, yaw: Turned, upside_down: bool) -> str:
    if position == yaw == SWAPPED and upside_down:
        return "the poses are in north-east-down axes: x and y swapped, z down, yaw clockwise from north"
    parts = [position_words(position)] if position != SAME else []
    parts += [f"as to the yaw, {angle_words(yaw)}"] if yaw != SAME else []
    parts += ["z points down (depth counts positive)"] if upside_down else []
    return "; ".join(parts)


def _compass(turned: Orientation) -> Found:
    if turned.compass == SAME:
        return []
    factor, summand = on_angle(turned.compass)
    fault = Fault(f"as to the heading, {angle_words(turned.compass)}", "only so it agrees with the other streams")
    return [affine("compass", fault, turned.nats, np.array([[factor]]), np.array([summand]))]


def _commands(turned: Orientation, platform: Platform) -> Found:
    mirrored, backwards = bool(turned.command.mirrored), bool(turned.command.quarters)
    if turned.command == SAME:
        return []
    parts = ["forwards and backwards are exchanged"] if backwards else []
    parts += ["left and right are exchanged"] if mirrored != backwards else []
    exchange = _exchange_of(turned.command, platform)
    because = "only so the robot moves as it is commanded"
    words = ", and ".join(parts) if parts else "the yaw moment is reversed"
    return [FrameCorrection(COMMAND, words, because, turned.nats, exchange, np.zeros(len(platform.actuators)))]


def _exchange_of(command: Turned, platform: Platform) -> Floats | None:
    """Signed exchange of actuators that reverses surge or yaw moment and leaves the rest; None if no exchange does."""
    forwards, turning = bool(command.quarters), bool(command.mirrored)
    wrenches = platform.actuator_wrenches() * platform.full_forces()[:, AHEAD]
    count = len(wrenches)
    matrix = np.zeros((count, count))
    goal = wrenches * np.array([-1.0 if forwards else 1.0, 1.0, 1.0, -1.0 if turning else 1.0])
    for target in range(count):
        for source, sign in ((source, sign) for source in range(count) for sign in (1.0, -1.0)):
            if np.allclose(sign * wrenches[source], goal[target], rtol=1e-6, atol=1e-12):
                matrix[source, target] = sign
                break
        else:
            return None
    return matrix
