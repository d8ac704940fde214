"""A small cache of results, for numbers that are soon asked for again."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

Made = TypeVar("Made")


REMEMBERED = 6
"""Results that are kept: the same numbers are soon asked for again, by a few steps and slopes."""


class Lately(Generic[Made]):
    """A cache of the last few results by key, for any number of threads.

    Two threads that ask for what is not there yet both make it, since a lock that is held meanwhile would make others
    wait that ask for something else.
    """

    def __init__(self, most: int = REMEMBERED) -> None:
        self._most = most
        self._made: OrderedDict[Hashable, Made] = OrderedDict()
        self._lock = Lock()

    def once(self, key: Hashable, make: Callable[[], Made]) -> Made:
        """Return the result kept under this key, or call `make`, keep its result and return that."""
        with self._lock:
            if key in self._made:
                self._made.move_to_end(key)
                return self._made[key]
        made = make()
        with self._lock:
            self._made[key] = made
            self._made.move_to_end(key)
            if len(self._made) > self._most:
                self._made.popitem(last=False)
        return made
