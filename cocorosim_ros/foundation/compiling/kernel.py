"""How the hot loops are compiled: one decorator, one cache that can never be stale.

numba keys its cache on the file of a function alone; a change in a function that it calls, in another
file, would go unnoticed. The cache folder therefore carries the digest of all sources of the package.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numba
import numpy
from llvmlite import ir
from numba import njit, types
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

COMPILED_FOLDERS = ("foundation/compiling", "world", "study/metrics", "wire/cdr/kernels", "diagnosis/filter")


def digest_of_sources(package: Path, parts: Iterable[str]) -> str:
    """First 16 hex digits of the SHA-256 over these files and folders of a package, and what compiles them."""
    digest = hashlib.sha256(f"{numba.__version__} {numpy.__version__}".encode())
    sources = {path for part in parts for path in (package / part, *(package / part).rglob("*.py"))}
    for path in sorted(path for path in sources if path.is_file()):
        digest.update(path.relative_to(package).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()[:16]


def source_digest() -> str:
    """The digest of every source that holds compiled functions."""
    return digest_of_sources(Path(__file__).parents[2], COMPILED_FOLDERS)


def _cache_folder() -> str:
    """The folder for this very source, below NUMBA_CACHE_DIR, XDG_CACHE_HOME or the user's own cache."""
    base = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return str(Path(base) / "cocorosim_ros" / source_digest())


numba.config.CACHE_DIR = _cache_folder()


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` to machine code: strict IEEE arithmetic, cached, releases the GIL.

    No fast-math: a batch of a thousand runs must give bit for bit what one run gives. No allocation either: the
    compiler refuses `np.zeros` and its like, and in return no view of an array is counted. The counting would be
    atomic and cost more than the arithmetic. Small working space comes from `stack_array`, large one as argument;
    an array cannot be the result.
    """
    compiled: Callable[..., Any] = njit(cache=True, nogil=True, error_model="numpy", forceinline=True, _nrt=False)(
        function
    )
    return compiled


def allocating_kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` as `kernel` does, with allocation: for what is called once per tick, not once per robot."""
    compiled: Callable[..., Any] = njit(cache=True, nogil=True, error_model="numpy", _nrt=True)(function)
    return compiled


def outlined_kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile `function` as `kernel` does, but leave it out of line: for what is rarely called from a hot loop."""
    compiled: Callable[..., Any] = njit(cache=True, nogil=True, error_model="numpy", _nrt=False)(function)
    return compiled


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
def stack_like(typing_context: Any, array: Any, size: Any) -> Any:
    """`stack_array(size)` of the numbers that `array` has: floats or fours (see compiling.four)."""
    array_type = types.Array(array.dtype, 1, "C", aligned=array.aligned)
    return array_type(array, size), _stack_space(array_type, size)


def _stack_space(array_type: Any, size: Any, cleared: bool = True) -> Callable[..., Any]:
    """What generates the working space of `stack_array`."""
    if not isinstance(size, types.IntegerLiteral):
        raise numba.errors.TypingError("stack_array and its like need a number that is written out")
    count = size.literal_value

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        word = context.get_value_type(array_type.dtype)
        length = context.get_constant(types.intp, count)
        stride = context.get_constant(types.intp, context.get_abi_sizeof(word))
        space = cgutils.alloca_once(builder, word, size=count)
        if cleared:
            cgutils.memset(builder, space, context.get_constant(types.intp, count * context.get_abi_sizeof(word)), 0)
        array = context.make_array(array_type)(context, builder)
        populate_array(
            array,
            data=space,
            shape=[length],
            strides=[stride],
            itemsize=stride,
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
        four = ir.VectorType(ir.DoubleType(), 4)

        def place(array: int) -> Any:
            start = context.make_array(signature.args[array])(context, builder, arguments[array]).data
            return builder.bitcast(builder.gep(start, [arguments[array + 1]]), four.as_pointer())

        scale = ir.Constant(four, ir.Undefined)
        for lane in range(4):
            scale = builder.insert_element(scale, arguments[4], ir.Constant(ir.IntType(32), lane))
        into = place(0)
        product = builder.fmul(scale, builder.load(place(2), align=8))
        builder.store(builder.fadd(builder.load(into, align=8), product), into, align=8)
        return context.get_dummy_value()

    return types.void(target, types.uint64, source, types.uint64, types.float64), generate


def compile_lines(
    name: str,
    arguments: str,
    lines: Sequence[str],
    functions: Mapping[str, Callable[..., Any]],
    compiler: Callable[..., Any] = kernel,
) -> Callable[..., Any]:
    """Return the compiled function `name(arguments)` whose body is `lines`, which may call `functions`.

    Turns a table of functions into one function, so that a new effect or controller is a file and a line in a
    table. numba can neither cache closures over compiled functions nor loop over a tuple of different ones;
    a function written out from the table has neither problem, and an entry that is switched off costs one
    predictable branch.
    """
    body = "\n".join(f"    {line}" for line in lines) or "    pass"
    source = f"def {name}({arguments}):\n{body}\n"
    namespace: dict[str, Any] = dict(functions)
    # The file name must exist on disk, or numba cannot place its cache.
    exec(compile(source, __file__, "exec"), namespace)
    namespace[name].__module__ = __name__
    made: Callable[..., Any] = compiler(namespace[name])
    return made
