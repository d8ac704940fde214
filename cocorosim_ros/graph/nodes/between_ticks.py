"""Between two ticks of a run by the wall clock: `/clock` goes on, and `/tf` as soon as it is known where to."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.graph.nodes.wiring import Speaker
from cocorosim_ros.graph.runs.between_ticks import between
from cocorosim_ros.wire.topics.swarm_messages import SwarmMessages

LONGEST_NAP = 0.1  # s; whether the run is to stop is looked at in between


class BetweenTicks:
    """Tells the steps of one tick after the other, each when its time has come.

    The clock tells every step. Transforms are interpolated between the states of two ticks, so that they begin when the
    second one is known, which is when all controllers have answered the first.
    """

    def __init__(self, messages: SwarmMessages, clock: Speaker, transforms: Speaker, tick_ns: int, steps: int) -> None:
        """`steps` of a tick; with 1 there is nothing between ticks."""
        self._messages, self._clock, self._transforms = messages, clock, transforms
        self._tick_ns, self._steps = tick_ns, steps
        self.newest_ns = 0  # on `/clock`

    @property
    def wanted(self) -> bool:
        """Whether there is anything to tell between ticks."""
        return self._steps > 1

    def begin_tick(self, stamp_ns: int, due: float) -> None:
        """A tick of this stamp has been published; the next one is `due` [s, monotonic clock]."""
        self._stamp_ns = self.newest_ns = stamp_ns
        self._begin, self._due, self._next = time.monotonic(), due, 1
        self._course: tuple[Floats, Floats] | None = None

    def tell(self, moment: float) -> float:
        """Publish the steps until `moment` [s, monotonic clock]; return that of the next step, or of the next tick."""
        while self._next < self._steps and self._moment(self._next) <= moment:
            stamp_ns = self._stamp_ns + self._next * self._tick_ns // self._steps
            if self._course is not None:
                state = between(*self._course, self._next / self._steps)
                self._transforms.publish(self._messages.transforms(stamp_ns, state))
            self._clock.publish(self._messages.clock(stamp_ns))
            self.newest_ns = stamp_ns
            self._next += 1
        return self._moment(self._next) if self._next < self._steps else self._due

    def follow(self, before: Floats, after: Floats, stopped: Callable[[], bool]) -> None:
        """Tell the rest of the tick, in which robots go from one state (robots, columns) to another."""
        self._course = before, after
        while self.wanted and not stopped() and (now := time.monotonic()) < self._due:
            time.sleep(max(0.0, min(LONGEST_NAP, self.tell(now) - time.monotonic())))
        if not stopped():
            self.tell(math.inf)

    def _moment(self, step: int) -> float:
        return self._begin + (self._due - self._begin) * step / self._steps
