"""What this machine can do at most: bytes copied and arithmetic per second, measured, on all cores at once."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.compiling.kernel import kernel

Floats = NDArray[np.float64]
COPIED = 32_000_000  # numbers; far more than any cache holds
CHAINS, ROUNDS = 24, 10_000_000  # enough that none waits for the one before it
IN_CACHE, TIMES = 512, 5_000  # numbers of one array, on which the compiler may use vectors, and how often
POLYNOMIALS, DEGREE = 8, 16  # of each number


@kernel
def _copy(source: Floats, target: Floats) -> None:
    for index in range(source.shape[0]):
        target[index] = source[index]


@kernel
def _triad(one: Floats, other: Floats, target: Floats) -> None:
    for index in range(target.shape[0]):
        target[index] = one[index] + 3.0 * other[index]


@kernel
def _in_chains(result: Floats) -> None:
    """Independent chains of x = x * a + b, each from another number: scalar arithmetic that waits for nothing."""
    a, b = result[0] + 0.999999, result[0] + 1e-6
    c0, c1, c2, c3, c4, c5, c6, c7 = 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0
    c8, c9, c10, c11, c12, c13, c14, c15 = 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0
    c16, c17, c18, c19, c20, c21, c22, c23 = 17.0, 18.0, 19.0, 20.0, 21.0, 22.0, 23.0, 24.0
    for _ in range(ROUNDS):
        c0, c1, c2, c3 = c0 * a + b, c1 * a + b, c2 * a + b, c3 * a + b
        c4, c5, c6, c7 = c4 * a + b, c5 * a + b, c6 * a + b, c7 * a + b
        c8, c9, c10, c11 = c8 * a + b, c9 * a + b, c10 * a + b, c11 * a + b
        c12, c13, c14, c15 = c12 * a + b, c13 * a + b, c14 * a + b, c15 * a + b
        c16, c17, c18, c19 = c16 * a + b, c17 * a + b, c18 * a + b, c19 * a + b
        c20, c21, c22, c23 = c20 * a + b, c21 * a + b, c22 * a + b, c23 * a + b
    result[0] = c0 + c1 + c2 + c3 + c4 + c5 + c6 + c7
    result[0] += c8 + c9 + c10 + c11 + c12 + c13 + c14 + c15
    result[0] += c16 + c17 + c18 + c19 + c20 + c21 + c22 + c23


@kernel
def _in_vectors(numbers: Floats, result: Floats) -> None:
    """Eight polynomials of each number by Horner's rule: arithmetic in vectors, on numbers of the first cache."""
    for _ in range(TIMES):
        for index in range(numbers.shape[0]):
            x = numbers[index]
            p0, p1, p2, p3, p4, p5, p6, p7 = x, x + 0.1, x + 0.2, x + 0.3, x + 0.4, x + 0.5, x + 0.6, x + 0.7
            for _ in range(DEGREE):
                p0, p1, p2, p3 = p0 * x + 0.5, p1 * x + 0.5, p2 * x + 0.5, p3 * x + 0.5
                p4, p5, p6, p7 = p4 * x + 0.5, p5 * x + 0.5, p6 * x + 0.5, p7 * x + 0.5
            result[index] = (p0 + p1) + (p2 + p3) + ((p4 + p5) + (p6 + p7))


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


def scalar_arithmetic(threads: int) -> float:
    """Multiplications and additions of float64 per second, one number at a time, best of three."""
    result = np.zeros((threads, 1))
    _in_chains(result[0])

    def work(number: int) -> None:
        result[number] = 0.0
        _in_chains(result[number])

    return 2.0 * CHAINS * ROUNDS * threads / min(at_once(work, threads) for _ in range(3))


def vector_arithmetic(threads: int) -> float:
    """The same in vectors, multiplied and added as our own code is compiled (without fused operations)."""
    numbers, result = np.full((threads, IN_CACHE), 0.5), np.zeros((threads, IN_CACHE))
    _in_vectors(numbers[0], result[0])
    seconds = min(at_once(lambda number: _in_vectors(numbers[number], result[number]), threads) for _ in range(3))
    return 2.0 * POLYNOMIALS * DEGREE * IN_CACHE * TIMES * threads / seconds
