"""Arrays of results, which stay as they are; apart from `arrays`, on which every compiled function stands."""

from __future__ import annotations

from typing import TypeVar

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers

AnyArray = TypeVar("AnyArray", Floats, Flags, Integers)


def read_only(array: AnyArray) -> AnyArray:
    """The same numbers, which cannot be written to; the array itself stays as it is."""
    view = array.view()
    view.flags.writeable = False
    return view
