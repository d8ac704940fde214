"""Roll and pitch as recorded: known inputs by which body axes are turned into level ones, heading kept.

The models of a diagnosis move in surge, sway, heave and yaw, along axes that stay level. A vehicle that rolls and
pitches has its velocities and specific forces read, and its thrust delivered, along axes that do not. With roll phi
and pitch theta recorded, v_level = R_y(theta) R_x(phi) v_body, for forces alike, and the rate of the heading is
psi_dot = (r + theta_dot sin(phi)) / (cos(phi) cos(theta)) with the rate r about the body's own upward axis.
Source: Fossen (2021), section 2.2, with the axes of REP 103: pitch is positive where the nose points down.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import TILT
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.six_degrees.attitude import angles_of

LEVEL = np.empty((0, 2))


@dataclass(frozen=True)
class Attitude:
    """Roll and pitch (n,) [rad; body axes forward-left-up in a world with z up] at times (n,) [s], ascending."""

    time: Floats
    roll: Floats
    pitch: Floats

    def roll_at(self, moments: Floats) -> Floats:
        """Roll (m,) [rad] at moments (m,) [s]; beyond the first and the last reading it stays."""
        return np.asarray(np.interp(moments, self.time, self.roll))

    def pitch_at(self, moments: Floats) -> Floats:
        """Pitch (m,) [rad] at moments (m,) [s]; beyond the first and the last reading it stays."""
        return np.asarray(np.interp(moments, self.time, self.pitch))

    def pitch_rate_at(self, moments: Floats) -> Floats:
        """Rate of the pitch (m,) [rad/s], by differences over TILT.rate_span, which noise of readings does not fill."""
        half = 0.5 * TILT.rate_span
        return (self.pitch_at(moments + half) - self.pitch_at(moments - half)) / TILT.rate_span

    def own_turn_rate(self, moments: Floats, heading_rate: Floats) -> Floats:
        """Rate (m,) [rad/s] about the body's own upward axis, of the heading's (m,) [rad/s] at moments (m,) [s]."""
        roll, pitch = self.roll_at(moments), self.pitch_at(moments)
        return np.asarray(heading_rate * np.cos(roll) * np.cos(pitch) - self.pitch_rate_at(moments) * np.sin(roll))

    def turns(self, moments: Floats) -> Floats:
        """Rotation matrices (m, 3, 3) from body axes to level axes of the same heading."""
        roll, pitch = self.roll_at(moments), self.pitch_at(moments)
        (sin_r, cos_r), (sin_p, cos_p) = (np.sin(roll), np.cos(roll)), (np.sin(pitch), np.cos(pitch))
        zero = np.zeros_like(roll)
        rows = [
            [cos_p, sin_p * sin_r, sin_p * cos_r],
            [zero, cos_r, -sin_r],
            [-sin_p, cos_p * sin_r, cos_p * cos_r],
        ]
        return np.moveaxis(np.array(rows), 2, 0)


def tilt_of(topic: str, quaternion: Floats) -> tuple[Floats, str]:
    """Roll and pitch (n, 2) [rad] of quaternions x y z w (n, 4), and a sentence on those that are none.

    A quaternion of length zero, or NaN, tells nothing; one of a length that is not near 1 is no attitude, and is taken
    as not measured. LEVEL (0, 2) where all are level.
    """
    length = np.sqrt((quaternion**2).sum(axis=1))
    there = np.isfinite(length) & (length > 0.0)
    wrong = there & (np.abs(length - 1.0) > TILT.length)
    unit = np.where((there & ~wrong)[:, None], quaternion / np.where(there, length, 1.0)[:, None], np.nan)
    roll, pitch, _ = angles_of(unit)
    tilt = np.column_stack([roll, pitch])
    said = ""
    if wrong.any():
        said = (
            f"{topic}: {np.count_nonzero(wrong)} of {len(wrong)} orientations are no unit quaternions (the first has "
            f"the length {length[wrong][0]:.3g}); their roll and pitch are not used. Write x, y, z, w of length 1."
        )
    level = not np.isfinite(tilt).any() or float(np.nanmax(np.abs(tilt))) < TILT.level
    return (LEVEL if level else tilt), said


def attitude_of(time: Floats, tilt: Floats) -> Attitude | None:
    """Make the attitude from times (n,) [s] and roll and pitch (n, 2) [rad]; None where too few are given."""
    given = np.isfinite(tilt).all(axis=1) if len(tilt) else np.zeros(0, dtype=bool)
    if np.count_nonzero(given) < TILT.fewest:
        return None
    return Attitude(time[given], np.unwrap(tilt[given, 0]), tilt[given, 1])
