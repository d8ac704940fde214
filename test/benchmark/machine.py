"""What this machine can do at most: bytes copied and arithmetic per second, measured, on all cores at once."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.compilation import kernel

Floats = NDArray[np.float64]
COPIED = 32_000_000  # numbers; far more than any cache holds
CHAINS, ROUNDS = 8, 20_000_000


@kernel
def _copy(source: Floats, target: Floats) -> None:
    for index in range(source.shape[0]):
        target[index] = source[index]


@kernel
def _triad(one: Floats, other: Floats, target: Floats) -> None:
    for index in range(target.shape[0]):
        target[index] = one[index] + 3.0 * other[index]


@kernel
def _multiply_and_add(result: Floats) -> None:
    """Eight independent chains of x = x * a + b: what scalar arithmetic can do when it waits for nothing."""
    a, b = 0.999999, 1e-6
    c0, c1, c2, c3, c4, c5, c6, c7 = 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0
    for _ in range(ROUNDS):
        c0, c1, c2, c3 = c0 * a + b, c1 * a + b, c2 * a + b, c3 * a + b
        c4, c5, c6, c7 = c4 * a + b, c5 * a + b, c6 * a + b, c7 * a + b
    result[0] = c0 + c1 + c2 + c3 + c4 + c5 + c6 + c7


def at_once(work: Callable[[int], None], threads: int) -> float:
    """Seconds of wall clock until `work(number)` has ended in all threads."""
    started = [threading.Thread(target=work, args=(number,)) for number in range(threads)]
    began = time.perf_counter()
    for thread in started:
        thread.start()
    for thread in started:
        thread.join()
    return time.perf_counter() - began


def copy_bandwidth(threads: int) -> float:
    """Bytes read and written per second by a plain copy (STREAM's first row), best of five."""
    part = COPIED // threads
    source, target = np.ones((threads, part)), np.zeros((threads, part))
    _copy(source[0][:1], target[0][:1])
    seconds = min(at_once(lambda number: _copy(source[number], target[number]), threads) for _ in range(5))
    return 16.0 * part * threads / seconds


def triad_bandwidth(threads: int, numbers: int = COPIED) -> float:
    """Bytes read and written per second by a = b + 3 c (STREAM's last row) on arrays of so many numbers in all."""
    part = numbers // threads
    arrays = np.ones((3, threads, part))
    rounds = max(1, 2_000_000 // part)
    _triad(arrays[0, 0, :1], arrays[1, 0, :1], arrays[2, 0, :1])

    def work(number: int) -> None:
        for _ in range(rounds):
            _triad(arrays[0, number], arrays[1, number], arrays[2, number])

    seconds = min(at_once(work, threads) for _ in range(7))
    return 24.0 * part * threads * rounds / seconds


def arithmetic(threads: int) -> float:
    """Multiplications and additions of float64 per second, best of three."""
    result = np.zeros((threads, 1))
    _multiply_and_add(result[0])
    seconds = min(at_once(lambda number: _multiply_and_add(result[number]), threads) for _ in range(3))
    return 2.0 * CHAINS * ROUNDS * threads / seconds
