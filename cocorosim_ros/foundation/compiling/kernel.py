"""How the hot loops are compiled: three decorators. What they compile is kept in a cache that is never stale."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import njit

from cocorosim_ros.foundation.compiling.cache import cached_with_its_sources

_OPTIONS: dict[str, Any] = {"cache": True, "nogil": True, "error_model": "numpy", "no_cfunc_wrapper": True}
# Nothing here is called from C, and a second way into a function would be compiled with all that is inlined in it.


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` to machine code: strict IEEE arithmetic, cached, releases the GIL.

    No fast-math: a batch of a thousand runs must give bit for bit what one run gives. No allocation either: the
    compiler refuses `np.zeros` and its like, and in return no view of an array is counted. The counting would be
    atomic and cost more than the arithmetic. Small working space comes from `stack_array`, large one as argument;
    an array cannot be the result.
    """
    return cached_with_its_sources(njit(**_OPTIONS, forceinline=True, _nrt=False), function)


def allocating_kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` as `kernel` does, with allocation: for what is called once per tick, not once per robot."""
    return cached_with_its_sources(njit(**_OPTIONS, _nrt=True), function)


def outlined_kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` as `kernel` does, but leave it out of line: for what is rarely called from a hot loop."""
    return cached_with_its_sources(njit(**_OPTIONS, _nrt=False), function)
