"""The numbers of a row by name, in compiled functions: numba unpacks tuples alone, whose length it knows."""

from __future__ import annotations

import operator
from typing import Any

import numba
from numba import types
from numba.extending import intrinsic


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def unpack(typing_context: Any, row: Any, count: Any) -> Any:
    """The first `count` (a literal) numbers of a row, to be given names: `width, ramp = unpack(parameters, 2)`.

    The row holds floats or fours (see compiling.four). Like the indices of kernels, the count is not compared with the
    row's length. What is not used afterwards is not read either, so that names cost nothing.
    """
    if not isinstance(count, types.IntegerLiteral):
        raise numba.errors.TypingError("unpack needs a number that is written out")
    numbers = types.UniTuple(row.dtype, count.literal_value)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        reading = row.dtype(row, types.uint64)
        read = context.get_function(operator.getitem, reading)
        places = [context.get_constant(types.uint64, place) for place in range(count.literal_value)]
        found = [read(builder, (arguments[0], place)) for place in places]
        return context.make_tuple(builder, signature.return_type, found)

    return numbers(row, count), generate
