"""Sums over rows of small matrices, kept in registers: what loops over `add_four` give, without a store for each row.

Numbers are added in the same order as there, so that every bit is the same. Nothing is checked.
"""

from __future__ import annotations

from typing import Any

import numba
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from cocorosim_ros.foundation.compiling.switches import VECTORS


def _place(context: Any, builder: Any, signature: Any, arguments: Any, array: int, index: Any) -> Any:
    """Pointer to the number at `index` of the array that is argument `array` of an intrinsic."""
    start = context.make_array(signature.args[array])(context, builder, arguments[array]).data
    return builder.gep(start, [index])


def _spread_out(builder: Any, factor: Any) -> Any:
    """A number in all lanes of a vector."""
    if not VECTORS:
        return factor
    scale = ir.Constant(ir.VectorType(ir.DoubleType(), 4), ir.Undefined)
    for lane in range(4):
        scale = builder.insert_element(scale, factor, ir.Constant(ir.IntType(32), lane))
    return scale


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def take_off_products(typing_context: Any, target: Any, factors: Any, source: Any, size: Any) -> Any:
    """target[i size : + size] -= factors[i] * source[: size] for all i < size, a literal multiple of four.

    What `add_four` gives when it is called for each row with its factor negated, but `source` stays in registers.
    """
    if not isinstance(size, types.IntegerLiteral):
        raise numba.errors.TypingError("take_off_products needs a size that is written out")
    count = size.literal_value

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        width = 4 if VECTORS else 1
        word = ir.VectorType(ir.DoubleType(), width) if VECTORS else ir.DoubleType()

        def place(array: int, number: int) -> Any:
            index = context.get_constant(types.uint64, number)
            return _place(context, builder, signature, arguments, array, index)

        def four(array: int, number: int) -> Any:
            return builder.bitcast(place(array, number), word.as_pointer())

        values = [builder.load(four(2, column), align=8) for column in range(0, count, width)]
        scales = [builder.load(place(1, row)) for row in range(count)]
        for row in range(count):
            scale = _spread_out(builder, builder.fneg(scales[row]))
            for column, value in zip(range(0, count, width), values, strict=True):
                into = four(0, row * count + column)
                builder.store(builder.fadd(builder.load(into, align=8), builder.fmul(scale, value)), into, align=8)
        return context.get_dummy_value()

    return types.void(target, factors, source, size), generate


@intrinsic(prefer_literal=True)  # type: ignore[untyped-decorator]
def set_sum_of_rows(
    typing_context: Any, target: Any, at: Any, factors: Any, begin: Any, source: Any, first: Any, size: Any, rows: Any
) -> Any:
    """target[at : at + 4] = sum over k < `rows` of factors[begin + k] * source[first + k size : + 4], k ascending.

    What `add_four` gives when it is called for each row in turn on a target of zeros, but the sum stays in a register.
    size and rows are literals, indices unsigned; nothing is checked.
    """
    if not (isinstance(size, types.IntegerLiteral) and isinstance(rows, types.IntegerLiteral)):
        raise numba.errors.TypingError("set_sum_of_rows needs sizes that are written out")
    stride, count = size.literal_value, rows.literal_value

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        width = 4 if VECTORS else 1
        word = ir.VectorType(ir.DoubleType(), width) if VECTORS else ir.DoubleType()

        def place(array: int, index: int, further: int) -> Any:
            number = builder.add(arguments[index], context.get_constant(types.uint64, further))
            return _place(context, builder, signature, arguments, array, number)

        scales = [_spread_out(builder, builder.load(place(2, 3, row))) for row in range(count)]
        for lane in range(0, 4, width):
            total = ir.Constant(word, [0.0] * width) if VECTORS else ir.Constant(word, 0.0)
            for row in range(count):
                values = builder.load(builder.bitcast(place(4, 5, row * stride + lane), word.as_pointer()), align=8)
                total = builder.fadd(total, builder.fmul(scales[row], values))
            builder.store(total, builder.bitcast(place(0, 1, lane), word.as_pointer()), align=8)
        return context.get_dummy_value()

    return types.void(target, types.uint64, factors, types.uint64, source, types.uint64, size, rows), generate
