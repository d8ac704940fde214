"""Fours whose lanes come from several others (see compiling.four)."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from cocorosim_ros.foundation.compiling.four import FOUR, LANES

_INDEX = ir.IntType(32)


@intrinsic  # type: ignore[untyped-decorator]
def lanes_before(typing_context: Any, before: Any, number: Any) -> Any:
    """The four floats that begin one place before those of `number`, whose predecessors are those of `before`."""
    return FOUR(before, number), _picked(LANES - 1)


@intrinsic  # type: ignore[untyped-decorator]
def lanes_after(typing_context: Any, number: Any, after: Any) -> Any:
    """The four floats that begin one place after those of `number`, whose successors are those of `after`."""
    return FOUR(number, after), _picked(1)


def _picked(first: int) -> Any:
    """What generates the four of two fours in a row that begin with lane `first`."""
    which = ir.Constant(ir.VectorType(_INDEX, LANES), list(range(first, first + LANES)))
    return lambda context, builder, found, arguments: builder.shuffle_vector(*arguments, which)


@intrinsic  # type: ignore[untyped-decorator]
def transposed(typing_context: Any, first: Any, second: Any, third: Any, fourth: Any) -> Any:
    """Of four fours the four that hold their first lanes, their second, third and fourth ones."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        def shuffled(one: Any, other: Any, *picked: int) -> Any:
            return builder.shuffle_vector(one, other, ir.Constant(ir.VectorType(_INDEX, LANES), picked))

        even = [shuffled(*arguments[at : at + 2], 0, 4, 2, 6) for at in (0, 2)]
        odd = [shuffled(*arguments[at : at + 2], 1, 5, 3, 7) for at in (0, 2)]
        rows = [shuffled(*pair, *picked) for picked in ((0, 1, 4, 5), (2, 3, 6, 7)) for pair in (even, odd)]
        return context.make_tuple(builder, found.return_type, rows)

    return types.UniTuple(FOUR, LANES)(first, second, third, fourth), generate
