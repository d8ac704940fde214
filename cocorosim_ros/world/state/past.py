"""What was so long ago: the last values of something that has one at every tick."""

from __future__ import annotations

from collections.abc import Iterable

from cocorosim_ros.foundation.arrays import Floats


class Past:
    """The values of the last ticks, as many as a delay needs.

    delay, tick: how long ago [s], and the time between two values [s]. before: the values before the first one, oldest
    first; without any, the first one has always been.
    """

    def __init__(self, delay: float, tick: float, before: Iterable[Floats] = ()) -> None:
        whole, self.share = divmod(delay / tick, 1.0)
        """What of a tick the delay is longer than a whole number of them [1]."""
        self._whole = int(whole)
        self._values: list[Floats] = list(before)  # the newest last

    def about(self, values: Floats) -> tuple[Floats, Floats]:
        """Return the two values around that of `delay` ago, the newer first; once at every tick, in order."""
        self._values = [*self._values[-(self._whole + 1) :], values.copy()]
        newest = len(self._values) - 1
        return self._values[max(0, newest - self._whole)], self._values[max(0, newest - 1 - self._whole)]
