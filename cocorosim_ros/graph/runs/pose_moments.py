"""Which poses belong to one moment, while they come in robot by robot, late, or not at all.

Robots whose stamps coincide (a simulation, a replay of one, cameras that see all) are measured at each common stamp,
whatever the order and the bursts in which the poses arrive: the same poses give the same moments. Where stamps do not
coincide, the latest pose of each robot is taken once per period. Nothing is measured before every robot has shown a
pose as late as that; a robot that has fallen silent is not waited for and counts as absent.
"""

from __future__ import annotations

from typing import NamedTuple

SILENCE = 2.0  # s of wall clock without a pose after which a robot that is behind is no longer waited for
_SHORTEST_GAP_NS = 1_000_000_000  # a robot's last pose is no longer used, and it may be given up, after so long
_PERIODS_IN_GAP = 3


class Moment(NamedTuple):
    """The poses of all robots at one moment."""

    stamp_ns: int
    poses: list[bytes | None]  # CDR bytes in the order of the robots; None for a robot that is absent


class PoseMoments:
    """Collects poses and hands them out moment by moment, in the order of time."""

    def __init__(self, robots: int, period_ns: int) -> None:
        """`period_ns`: how often poses whose stamps do not coincide make a moment."""
        self.late = 0  # poses that came after their moment had been handed out
        self._period_ns = period_ns
        self._gap_ns = max(_SHORTEST_GAP_NS, _PERIODS_IN_GAP * period_ns)
        self._poses: list[dict[int, bytes]] = [{} for _ in range(robots)]
        self._newest: list[int | None] = [None] * robots
        self._heard = [0.0] * robots
        self._first: tuple[int, float] | None = None  # stamp and wall clock of the first pose of all
        self._last: int | None = None

    def add(self, robot: int, stamp_ns: int, pose: bytes, now: float) -> None:
        """Take a robot's pose, which came in at `now` [s, any clock that does not jump]."""
        if self._first is None:
            self._first = (stamp_ns, now)
        if self._last is not None and stamp_ns <= self._last:
            self.late += 1
            return
        newest = self._newest[robot]
        self._newest[robot] = stamp_ns if newest is None else max(newest, stamp_ns)
        self._heard[robot] = now
        self._poses[robot].setdefault(stamp_ns, pose)

    def take(self, now: float) -> list[Moment]:
        """The moments that are complete by now."""
        awaited = self._awaited(now)
        watermark = self._watermark(awaited)
        if watermark is None:
            return []
        shared = set.intersection(*(set(self._poses[robot]) for robot in awaited))
        stamps = sorted(stamp for stamp in shared if stamp <= watermark and not self._is_done(stamp))
        moments = [Moment(stamp, [poses.get(stamp) for poses in self._poses]) for stamp in stamps]
        if not moments and self._is_due(watermark):
            moments = [Moment(watermark, [self._latest(robot, watermark) for robot in range(len(self._poses))])]
        if moments:
            self._last = moments[-1].stamp_ns
            self._forget(self._last - self._gap_ns)
        return moments

    def _awaited(self, now: float) -> list[int]:
        """The robots without whose poses nothing is measured."""
        seen = [stamp for stamp in self._newest if stamp is not None]
        if self._first is None or not seen:
            return []
        most, awaited = max(seen), []
        for robot, newest in enumerate(self._newest):
            stamp, heard = self._first if newest is None else (newest, self._heard[robot])
            if most - stamp <= self._gap_ns or now - heard <= SILENCE:
                awaited.append(robot)
        return awaited

    def _watermark(self, awaited: list[int]) -> int | None:
        """The stamp that all awaited robots have reached; None if one has not shown itself."""
        reached = [newest for newest in (self._newest[robot] for robot in awaited) if newest is not None]
        return min(reached) if reached and len(reached) == len(awaited) else None

    def _is_done(self, stamp_ns: int) -> bool:
        return self._last is not None and stamp_ns <= self._last

    def _is_due(self, watermark: int) -> bool:
        since = self._first[0] if self._last is None and self._first is not None else self._last
        return since is not None and watermark - since >= self._period_ns

    def _latest(self, robot: int, stamp_ns: int) -> bytes | None:
        """The robot's latest pose at this moment; None if it is too old."""
        poses = self._poses[robot]
        latest = max((stamp for stamp in poses if stamp_ns - self._gap_ns <= stamp <= stamp_ns), default=None)
        return None if latest is None else poses[latest]

    def _forget(self, before_ns: int) -> None:
        for poses in self._poses:
            for stamp in [stamp for stamp in poses if stamp < before_ns]:
                del poses[stamp]
