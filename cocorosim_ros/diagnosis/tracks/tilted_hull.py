"""Forces and yaw moment that roll and pitch add to those of a hull, along level axes of the same heading.

What a hull resists with stands along its own axes: with the matrix M of mass and added mass its momentum is M v, and
its drag and lift D(v), of the velocity v in body axes. The models of a diagnosis have both along level axes. With the
rotation R from body axes to level ones and the velocity V = R v there, what is missing is

    -(d/dt + psi_dot z x) (R M R^T - M) V - (R D(R^T V) - D(V)).

About its own upward axis the hull turns at the rate r = psi_dot cos(phi) cos(theta) - theta_dot sin(phi), and the
thrusters' moment is about that axis. With the moment K(r) of its drag and the added mass A sideways, what is missing is

    I d/dt (psi_dot - r) - (K(r) - K(psi_dot)) - A (u v - U V).

A tilt of two degrees that swings within two seconds moves an ROV upwards by as much as random forces do, and what it
climbs at a pitch of six turns it by more. Velocity, turn rate and attitude are those recorded: known inputs, as the
tilt of the thrust is. All is linear in masses and drags, so that each has a template, which is made once. Left out are
products of the rates of roll and pitch, which need the inertia about other axes.
Source: Fossen (2021), sections 2.2, 6.3 and 6.4; levelled axes as in `streams.attitude`.
"""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.signal import savgol_filter

from cocorosim_ros.diagnosis.criteria.evidence import TILT
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.steadied import steadied
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import TURN_RATE
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities
from cocorosim_ros.diagnosis.evidence.streams.whole_velocity import whole_velocity
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, OWN_SURGE_DRAG
from cocorosim_ros.diagnosis.tracks.surge_drag import with_surge_drag
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects.anisotropic_drag import FORM_BY_NAME
from cocorosim_ros.world.state.state import X, Y, Z

TOTAL_SPEED = FORM_BY_NAME["total_speed"]
_MASS, _SWAY, _HEAVE = (
    COLUMN[name] for name in ("mass", "added_mass.sway_minus_surge", "added_mass.heave_minus_surge")
)
_LINEAR = [COLUMN[f"linear_drag.{axis}"] for axis in ("surge", "sway", "heave")]
_DRAG, _FORM = COLUMN["drag"], COLUMN["anisotropic_drag.form"]
_RATIOS = [COLUMN["anisotropic_drag.sway_ratio"], COLUMN["anisotropic_drag.heave_ratio"]]
_INERTIA, _ADDED_INERTIA = COLUMN["yaw_inertia"], COLUMN["added_mass.yaw"]
_YAW_LINEAR, _YAW_DRAG = COLUMN["linear_drag.yaw"], COLUMN["yaw_drag"]
_LIFTS = [COLUMN["hull_lift.sway_by_drift"], COLUMN["hull_lift.heave_by_climb"]]
_AROUND = [_INERTIA, _ADDED_INERTIA, _YAW_LINEAR, _YAW_DRAG]
TAKEN = [_MASS, _SWAY, _HEAVE, *_LINEAR, _DRAG, COLUMN[OWN_SURGE_DRAG], _FORM, *_RATIOS, *_LIFTS, *_AROUND]
"""Columns of the numbers that these forces depend on."""


class Motion(NamedTuple):
    """Velocity (points, 3) [m/s], and rates (points,) of turning and pitching [rad/s], along and about some axes."""

    velocity: Floats
    turn_rate: Floats
    pitch_rate: Floats


class Flow(NamedTuple):
    """Recorded motion between the grid points of a track, along its level axes and the body's own.

    turns: rotations (points, 3, 3) from the body's to level ones.
    """

    turns: Floats
    level: Motion
    body: Motion


class TiltedHull:
    """Forces and moments that the tilt of one robot adds between the grid points of its track."""

    def __init__(self, log: RobotLog, grid: Grid) -> None:
        self._log, self._grid = log, grid

    @property
    def is_known(self) -> bool:
        """Attitude and velocity were both recorded."""
        return self._log.attitude is not None and self._velocity is not None

    def wrench(self, row: Floats) -> Floats:
        """Forces and moment (points, 4) [N, N, N, N m; level axes] under the numbers of a model, row (columns,)."""
        return np.column_stack([self._force(with_surge_drag(row)), self._moment(row)])

    @cached_property
    def nodding(self) -> Floats:
        """Rate of the pitch over the speed ahead (points,) [rad/m], between the grid points; 0 where the hull rests."""
        ahead = self.flow.level.velocity[:, X]
        return np.asarray(self.flow.body.pitch_rate * ahead / (ahead**2 + TILT.at_rest**2))

    @cached_property
    def flow(self) -> Flow:
        """The recorded motion, where it is known."""
        moments = self._middles
        seen, turns = self._seen(moments), self._attitude.turns(moments)
        heading, own = self._turn_rates(moments)
        pitching = self._attitude.pitch_rate_at(moments)
        body = Motion(np.einsum("nji,nj->ni", turns, seen), own, pitching)
        return Flow(turns, Motion(seen, heading, np.zeros_like(pitching)), body)

    def _force(self, row: Floats) -> Floats:
        """Force (points, 3) [N; level axes] under the numbers of a model, row (columns,)."""
        mass = row[_MASS] + np.array([0.0, row[_SWAY], row[_HEAVE]])
        drag = row[_DRAG] * np.array([1.0, *row[_RATIOS]])
        inertia, linear, along, each, lift = self._templates
        quadratic = along if row[_FORM] == TOTAL_SPEED else each
        numbers = ((mass, inertia), (row[_LINEAR], linear), (drag, quadratic), (row[_LIFTS], lift))
        return np.asarray(sum(np.tensordot(own, template, 1) for own, template in numbers))

    def _moment(self, row: Floats) -> Floats:
        """Yaw moment (points,) [N m] under the numbers of a model, row (columns,)."""
        numbers = np.array([row[_INERTIA] + row[_ADDED_INERTIA], row[_YAW_LINEAR], row[_YAW_DRAG], row[_SWAY]])
        return np.asarray(numbers @ self._moments)

    @cached_property
    def _moments(self) -> Floats:
        """Yaw moment (4, points) of a unit of inertia, linear drag, drag, and added mass sideways less forwards."""
        moments, half = self._middles, 0.5 * self._span
        (level, heading, _), (body, own, _) = self.flow.level, self.flow.body
        early, late = (np.subtract(*self._turn_rates(moments + shift)) for shift in (-half, half))
        sways = level[:, X] * level[:, Y] - body[:, X] * body[:, Y]
        resisted = np.abs(heading) * heading - np.abs(own) * own
        return np.stack([(late - early) / (2.0 * half), heading - own, resisted, sways])

    @property
    def _middles(self) -> Floats:
        """Moments (points,) [s] in the middle between grid points."""
        return np.asarray(self._grid.begin + (np.arange(self._grid.points) + 0.5) * self._grid.step)

    @cached_property
    def _templates(self) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """Force (3, points, 3) of a unit of each axis: of mass, linear drag, drag with |V| and drag with each |v_k|.

        Then (2, points, 3) of the lift across, by the speeds to the left and upwards.
        """
        moments, half = self._middles, 0.5 * self._span
        turns, (level, turn_rate, _), (body, _, _) = self.flow
        swing = (self._turned_less_level(moments + half) - self._turned_less_level(moments - half)) / (2.0 * half)
        now = self._turned_less_level(moments)
        around = np.cross(np.array([0.0, 0.0, 1.0]), now) * turn_rate[:, None]
        own = np.einsum("nik,nk->kni", turns, np.abs(body) * body) - np.einsum(
            "nk,ki->kni", np.abs(level) * level, np.eye(3)
        )
        lift = _lifted(turns, body) - _lifted(np.broadcast_to(np.eye(3), turns.shape), level)
        speed = np.linalg.norm(level, axis=1)[:, None]
        return -(swing + around), -now, -speed * now, -own, -lift

    def _turned_less_level(self, moments: Floats) -> Floats:
        """(R E_k R^T - E_k) V (3, m, 3) of each axis k, with E_k = e_k e_k^T."""
        turns, level = self._attitude.turns(moments), self._seen(moments)
        turned = np.einsum("nik,njk,nj->kni", turns, turns, level)
        return np.asarray(turned - np.einsum("nk,ki->kni", level, np.eye(3)))

    @cached_property
    def _velocity(self) -> Velocities | None:
        """Level velocities without the noise of single readings; None without."""
        seen = self._log.way or whole_velocity(self._log.streams)
        return None if seen is None else steadied(seen)

    def _seen(self, moments: Floats) -> Floats:
        """Level velocity (m, 3) [m/s]."""
        assert self._velocity is not None
        return np.column_stack([np.interp(moments, self._velocity.time, part) for part in self._velocity.value.T])

    def _turn_rate(self, moments: Floats) -> Floats:
        """Rate of the heading (m,) [rad/s]; 0 where none was recorded."""
        imu = self._log.streams.get("imu")
        known = np.zeros(0, dtype=bool) if imu is None else np.isfinite(imu.value[:, TURN_RATE])
        if imu is None or not known.any():
            return np.zeros(len(moments))
        return np.asarray(np.interp(moments, imu.time[known], imu.value[known, TURN_RATE]))

    def _turn_rates(self, moments: Floats) -> tuple[Floats, Floats]:
        """Rates (m,) [rad/s] of the heading and about the hull's own upward axis; 0 where none was recorded."""
        heading = self._turn_rate(moments)
        if not heading.any():
            return heading, heading
        return heading, self._attitude.own_turn_rate(moments, heading)

    @cached_property
    def _gap(self) -> float:
        """Time between readings of the attitude [s]."""
        assert self._log.attitude is not None
        return float(np.median(np.diff(self._log.attitude.time)))

    @property
    def _span(self) -> float:
        """Time [s] over which momentum is differenced: no less than two readings of the attitude."""
        return max(TILT.rate_span, 2.0 * self._gap)

    @cached_property
    def _attitude(self) -> Attitude:
        """The attitude without the noise of single readings, by a parabola through its neighbours."""
        attitude = self._log.attitude
        assert attitude is not None
        width = 2 * int(0.5 * TILT.smoothed / self._gap) + 1
        if width < TILT.fewest_smoothed or len(attitude.time) < width:
            return attitude
        roll, pitch = (savgol_filter(angle, width, 2) for angle in (attitude.roll, attitude.pitch))
        return Attitude(attitude.time, roll, pitch)


def _lifted(turns: Floats, velocity: Floats) -> Floats:
    """|u| v_k (2, n, 3), level axes, of the speeds v_k to the left and upwards; velocity (n, 3), turns (n, 3, 3)."""
    across = np.abs(velocity[:, X, None]) * velocity[:, Y : Z + 1]
    return np.asarray(np.einsum("nik,nk->kni", turns[:, :, Y : Z + 1], across))
