"""Working space on the stack for compiled functions, and the one vector operation on plain arrays."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numba
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

from cocorosim_ros.foundation.compiling.switches import VECTORS


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def stack_array(typing_context: Any, size: Any) -> Any:
    """Working space of `size` (a literal) float64 zeros on the stack, gone when the function returns.

    Takes the place of `np.zeros(size)` in a kernel. The result must not outlive the compiled function that asked for
    it: it is to be passed down, never up.
    """
    array_type = types.Array(types.float64, 1, "C")
    return array_type(size), _stack_space(array_type, size)


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def unset_stack_array(typing_context: Any, size: Any) -> Any:
    """`stack_array(size)` without the zeros, which take their time: for what is written before it is read."""
    array_type = types.Array(types.float64, 1, "C")
    return array_type(size), _stack_space(array_type, size, cleared=False)


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def unset_stack_rows(typing_context: Any, rows: Any, columns: Any) -> Any:
    """`unset_stack_array` of rows: (rows, columns), both literals. To reshape one would be a call in a hot loop."""
    array_type = types.Array(types.float64, 2, "C")
    return array_type(rows, columns), _stack_space(array_type, rows, columns, cleared=False)


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def stack_like(typing_context: Any, array: Any, size: Any) -> Any:
    """`stack_array(size)` of the numbers that `array` has: floats or fours (see compiling.four)."""
    array_type = types.Array(array.dtype, 1, "C", aligned=array.aligned)
    return array_type(array, size), _stack_space(array_type, size)


def _stack_space(array_type: Any, *sizes: Any, cleared: bool = True) -> Callable[..., Any]:
    """What generates the working space of `stack_array`, of so many numbers along each axis."""
    if not all(isinstance(size, types.IntegerLiteral) for size in sizes):
        raise numba.errors.TypingError("stack_array and its like need a number that is written out")
    shape = [size.literal_value for size in sizes]
    count = math.prod(shape)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        word = context.get_value_type(array_type.dtype)
        size = context.get_abi_sizeof(word)
        space = cgutils.alloca_once(builder, word, size=count)
        if cleared:
            cgutils.memset(builder, space, context.get_constant(types.intp, count * size), 0)
        array = context.make_array(array_type)(context, builder)
        steps = [size * math.prod(shape[axis + 1 :]) for axis in range(len(shape))]
        populate_array(
            array,
            data=space,
            shape=[context.get_constant(types.intp, length) for length in shape],
            strides=[context.get_constant(types.intp, step) for step in steps],
            itemsize=context.get_constant(types.intp, size),
            meminfo=None,
        )
        return array._getvalue()

    return generate


@intrinsic  # type: ignore[untyped-decorator]
def add_four(typing_context: Any, target: Any, at: Any, source: Any, first: Any, factor: Any) -> Any:
    """target[at : at + 4] += factor * source[first : first + 4], for contiguous float64 arrays and unsigned indices.

    The same numbers as in a loop, in one vector: numba's compiler makes vectors of long loops alone. Like the indices
    of kernels, these are not checked.
    """

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        width = 4 if VECTORS else 1
        word = ir.VectorType(ir.DoubleType(), width) if VECTORS else ir.DoubleType()

        def place(array: int, lane: int) -> Any:
            start = context.make_array(signature.args[array])(context, builder, arguments[array]).data
            index = builder.add(arguments[array + 1], context.get_constant(types.uint64, lane))
            return builder.bitcast(builder.gep(start, [index]), word.as_pointer())

        scale = arguments[4]
        if VECTORS:
            scale = ir.Constant(word, ir.Undefined)
            for lane in range(width):
                scale = builder.insert_element(scale, arguments[4], ir.Constant(ir.IntType(32), lane))
        for lane in range(0, 4, width):
            into = place(0, lane)
            product = builder.fmul(scale, builder.load(place(2, lane), align=8))
            builder.store(builder.fadd(builder.load(into, align=8), product), into, align=8)
        return context.get_dummy_value()

    return types.void(target, types.uint64, source, types.uint64, types.float64), generate


@intrinsic  # type: ignore[untyped-decorator]
def fetch_ahead(typing_context: Any, array: Any, at: Any) -> Any:
    """Ask memory for array[at] of a contiguous float64 array, which is read soon; it may lie beyond the array."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        start = context.make_array(array)(context, builder, arguments[0]).data
        place = builder.bitcast(builder.gep(start, [arguments[1]]), cgutils.voidptr_t)
        word = ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [cgutils.voidptr_t, word, word, word])
        prefetch = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0i8")
        builder.call(prefetch, [place, *(ir.Constant(word, code) for code in (0, 3, 1))])  # to read, near, data
        return context.get_dummy_value()

    return types.void(array, types.intp), generate
