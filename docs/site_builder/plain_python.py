"""Compiled functions as plain Python: the few thousand calls for a picture take less time than compiling would."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from types import FunctionType
from typing import Any

import numpy as np

from cocorosim_ros.foundation.compiling.four import chosen, everywhere, whole_below
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.unpacking import unpack

IN_PYTHON: dict[Any, Callable[..., Any]] = {
    unpack: lambda row, count: tuple(float(number) for number in row[:count]),
    stack_array: np.zeros,
    chosen: lambda condition, fulfilled, otherwise: fulfilled if condition else otherwise,
    everywhere: bool,
    whole_below: math.floor,
}
"""Functions that only the compiler knows, as Python has them."""


@cache
def plain(function: Any) -> Callable[..., Any]:
    """Return the text of `function`, and of all that it calls, as Python runs it."""
    if function in IN_PYTHON:
        return IN_PYTHON[function]
    if not hasattr(function, "py_func"):
        untouched: Callable[..., Any] = function
        return untouched
    text = function.py_func
    known = text.__globals__
    used = {name: known[name] for name in text.__code__.co_names if name in known}
    in_python = {name: plain(value) for name, value in used.items() if hasattr(value, "py_func") or _is_ours(value)}
    return FunctionType(text.__code__, {**known, **in_python}, text.__name__, text.__defaults__, text.__closure__)


def _is_ours(value: Any) -> bool:
    return any(value is intrinsic for intrinsic in IN_PYTHON)
