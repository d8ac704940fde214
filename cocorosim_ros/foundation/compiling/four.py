"""Four numbers at once: what is written for one robot goes through for four, in one vector of the processor.

A kernel does not say which numbers it is for. Called with arrays of floats it is compiled for one robot; called with
arrays of fours (`in_fours`) the same text is compiled for four robots, one in each lane. Every lane gets bit for bit
what a float would: each operation is the same one of IEEE 754, on four numbers. numba's compiler makes vectors of long
loops alone, so the vectors are written here.

Such a text may use + - * /, minus, abs, comparisons, math.sqrt, sin and cos, the functions of this file, and floats
where a number is the same for all. It cannot branch on the numbers, as robots would go different ways: `chosen` takes
the place of `a if condition else b`, and `everywhere` asks whether a condition holds for all.

With COCOROSIM_VECTORS=off every operation goes through lane by lane instead, by instructions for single numbers.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.datamodel import models, register_default
from numba.core.imputils import lower_builtin, lower_cast
from numba.core.typeconv import Conversion
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

from cocorosim_ros.foundation.compiling.switches import VECTORS

LANES = 4
_WORD, _INDEX = ir.DoubleType(), ir.IntType(32)
_VECTOR, _BITS = ir.VectorType(_WORD, LANES), ir.VectorType(ir.IntType(1), LANES)


class FourFloats(types.Type):  # type: ignore[misc]
    """The numba type of four float64; a float stands for four times itself."""

    def __init__(self) -> None:
        super().__init__(name="four_floats")

    def can_convert_from(self, typing_context: Any, other: Any) -> Any:
        """Floats can stand in."""
        return Conversion.safe if isinstance(other, types.Float) else None


class FourConditions(types.Type):  # type: ignore[misc]
    """The numba type of four booleans."""

    def __init__(self) -> None:
        super().__init__(name="four_conditions")


FOUR, CONDITIONS = FourFloats(), FourConditions()


@register_default(FourFloats)
class _FourFloatsModel(models.PrimitiveModel):  # type: ignore[misc]
    def __init__(self, manager: Any, front_end_type: Any) -> None:
        super().__init__(manager, front_end_type, _VECTOR)


@register_default(FourConditions)
class _FourConditionsModel(models.PrimitiveModel):  # type: ignore[misc]
    def __init__(self, manager: Any, front_end_type: Any) -> None:
        super().__init__(manager, front_end_type, _BITS)


def _joined(builder: Any, parts: Any) -> Any:
    """The vector of four values."""
    vector = ir.Constant(ir.VectorType(parts[0].type, LANES), ir.Undefined)
    for lane, part in enumerate(parts):
        vector = builder.insert_element(vector, part, ir.Constant(_INDEX, lane))
    return vector


def _parts(builder: Any, vector: Any) -> list[Any]:
    """The four values of a vector."""
    return [builder.extract_element(vector, ir.Constant(_INDEX, lane)) for lane in range(LANES)]


def _with_or_without_vectors(generate: Callable[..., Any]) -> Callable[..., Any]:
    """`generate(builder, values)` of vectors as it is, or for each lane by itself where vectors are switched off."""

    def lane_by_lane(builder: Any, values: Any) -> Any:
        if not isinstance(values[0].type, ir.VectorType):
            return generate(builder, values)
        return _joined(
            builder,
            [generate(builder, lane) for lane in zip(*(_parts(builder, value) for value in values), strict=True)],
        )

    return generate if VECTORS else lane_by_lane


@lower_cast(types.Float, FourFloats)  # type: ignore[untyped-decorator]
def _four_times(context: Any, builder: Any, source: Any, target: Any, value: Any) -> Any:
    return _joined(builder, [context.cast(builder, value, source, types.float64)] * LANES)


def _add_operation(function: Any, result: Any, operands: int, generate: Callable[..., Any]) -> None:
    """Let compiled functions call `function` with fours, or a mixture of fours and floats."""

    class Template(AbstractTemplate):  # type: ignore[misc]
        def generic(self, arguments: Any, keywords: Any) -> Any:
            known = all(argument is FOUR or isinstance(argument, types.Float) for argument in arguments)
            if len(arguments) != operands or not known or FOUR not in arguments:
                return None
            return signature(result, *[FOUR] * operands)

    infer_global(function)(Template)
    lower_builtin(function, *[FourFloats] * operands)(
        lambda context, builder, found, values: generate(context, builder, values)
    )


def _of_numbers(generate: Callable[..., Any]) -> Callable[..., Any]:
    """What an operation generates without knowing of numba: of vectors, or lane by lane."""
    made = _with_or_without_vectors(generate)
    return lambda context, builder, values: made(builder, values)


def _of_builder(name: str, *code: str) -> Callable[..., Any]:
    """One instruction that takes vectors as it takes numbers."""
    return _of_numbers(lambda builder, values: getattr(builder, name)(*code, *values))


def _call_compiler(builder: Any, name: str, value: Any) -> Any:
    """Call a function that LLVM has for numbers and for vectors of them."""
    kind = "v4f64" if value.type == _VECTOR else "f64"
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(value.type, [value.type]), f"llvm.{name}.{kind}"
    )
    return builder.call(function, [value])


def _of_compiler(name: str) -> Callable[..., Any]:
    return _of_numbers(lambda builder, values: _call_compiler(builder, name, values[0]))


def _lane_by_lane(function: Any) -> Callable[..., Any]:
    """The function that floats have, one lane after the other: for what is rare."""

    def generate(context: Any, builder: Any, values: Any) -> Any:
        of_one = context.get_function(function, signature(types.float64, types.float64))
        return _joined(builder, [of_one(builder, [part]) for part in _parts(builder, values[0])])

    return generate


for _operators, _instruction in (
    ((operator.add, operator.iadd), "fadd"),
    ((operator.sub, operator.isub), "fsub"),
    ((operator.mul, operator.imul), "fmul"),
    ((operator.truediv, operator.itruediv), "fdiv"),
):
    for _operator in _operators:
        _add_operation(_operator, FOUR, 2, _of_builder(_instruction))
for _operator, _sign in ((operator.lt, "<"), (operator.le, "<="), (operator.gt, ">"), (operator.ge, ">=")):
    _add_operation(_operator, CONDITIONS, 2, _of_builder("fcmp_ordered", _sign))
_add_operation(operator.neg, FOUR, 1, _of_builder("fneg"))
_add_operation(abs, FOUR, 1, _of_compiler("fabs"))
_add_operation(math.sqrt, FOUR, 1, _of_compiler("sqrt"))
_add_operation(math.sin, FOUR, 1, _lane_by_lane(math.sin))
_add_operation(math.cos, FOUR, 1, _lane_by_lane(math.cos))


@intrinsic  # type: ignore[untyped-decorator]
def whole_below(typing_context: Any, number: Any) -> Any:
    """The largest whole number that is not above `number`, as a float; of a float or of four."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        return _of_compiler("floor")(context, builder, arguments)

    return number(number), generate


_select = _with_or_without_vectors(lambda builder, values: builder.select(*values))


@intrinsic  # type: ignore[untyped-decorator]
def chosen(typing_context: Any, condition: Any, fulfilled: Any, otherwise: Any) -> Any:
    """`fulfilled if condition else otherwise`, both computed: of floats, or of fours lane by lane."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        return _select(builder, arguments)

    return fulfilled(condition, fulfilled, fulfilled), generate


@intrinsic  # type: ignore[untyped-decorator]
def everywhere(typing_context: Any, condition: Any) -> Any:
    """Whether a condition holds, for fours in all lanes."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        if condition is not CONDITIONS:
            return arguments[0]
        bits = builder.bitcast(arguments[0], ir.IntType(LANES))
        return builder.icmp_unsigned("==", bits, ir.Constant(ir.IntType(LANES), 2**LANES - 1))

    return types.boolean(condition), generate


@intrinsic  # type: ignore[untyped-decorator]
def four(typing_context: Any, first: Any, second: Any, third: Any, fourth: Any) -> Any:
    """Four floats at once."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        return _joined(builder, arguments)

    return FOUR(*[types.float64] * LANES), generate


@intrinsic  # type: ignore[untyped-decorator]
def lanes(typing_context: Any, number: Any) -> Any:
    """The four floats, as a tuple."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        return context.make_tuple(builder, found.return_type, _parts(builder, arguments[0]))

    return types.UniTuple(types.float64, LANES)(number), generate


@intrinsic  # type: ignore[untyped-decorator]
def in_fours(typing_context: Any, array: Any) -> Any:
    """The same memory as fours: of a contiguous float64 array (..., 4) the array (...) of its rows.

    A view that keeps nothing alive: to be passed down from where the array is an argument, never up.
    """
    if array.layout != "C" or array.dtype != types.float64:
        return None
    fours = types.Array(FOUR, array.ndim - 1, "C", aligned=False)

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        source = context.make_array(array)(context, builder, arguments[0])
        made = context.make_array(fours)(context, builder)
        populate_array(
            made,
            data=builder.bitcast(source.data, _VECTOR.as_pointer()),
            shape=cgutils.unpack_tuple(builder, source.shape)[:-1],
            strides=cgutils.unpack_tuple(builder, source.strides)[:-1],
            itemsize=context.get_constant(types.intp, LANES * 8),
            meminfo=None,
        )
        return made._getvalue()

    return fours(array), generate


@intrinsic  # type: ignore[untyped-decorator]
def four_at(typing_context: Any, row: Any, first: Any) -> Any:
    """`row[first : first + 4]` of a contiguous float64 row as one number of four; the index is not checked."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        return builder.load(_place(context, builder, row, arguments), align=8)

    return FOUR(row, types.intp), generate


@intrinsic  # type: ignore[untyped-decorator]
def put_four_at(typing_context: Any, row: Any, first: Any, number: Any) -> Any:
    """`row[first : first + 4] = number`, the four floats of it; the index is not checked."""

    def generate(context: Any, builder: Any, found: Any, arguments: Any) -> Any:
        builder.store(arguments[2], _place(context, builder, row, arguments), align=8)
        return context.get_dummy_value()

    return types.void(row, types.intp, FOUR), generate


def _place(context: Any, builder: Any, row: Any, arguments: Any) -> Any:
    start = context.make_array(row)(context, builder, arguments[0]).data
    return builder.bitcast(builder.gep(start, [arguments[1]]), _VECTOR.as_pointer())
