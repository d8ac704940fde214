"""Arithmetic between the columns of a row, as a map writes it: `rpm**2`, `cos(radians(angle)) * force`.

A formula is parsed once and walked over; only what stands in `OPERATORS`, `COMPARISONS` and `FUNCTIONS` is known, so
that a map cannot run code. Comparisons give 1 or 0.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.wire.conversion.run_wise import Number, number_of

LONGEST = 1000  # characters; chosen, far more than a reader follows
_DEEPEST = 60  # operations inside each other; chosen

Operation = Callable[..., Floats]


class Columns(Protocol):
    """The rows that a formula is computed for."""

    origin: str
    count: int

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column."""

    def row_name(self, row: int) -> str:
        """The row as sentences name it."""


def _where(condition: Floats, yes: Floats, no: Floats) -> Floats:
    return np.where(np.isnan(condition), np.nan, np.where(condition != 0, yes, no))


def _comparison(compare: Callable[[Floats, Floats], Flags]) -> Operation:
    def compared(left: Floats, right: Floats) -> Floats:
        return np.where(np.isnan(left) | np.isnan(right), np.nan, compare(left, right).astype(np.float64))

    return compared


OPERATORS: Mapping[type[ast.operator], Operation] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Mod: np.mod,
    ast.Pow: np.power,
}
SIGNS: Mapping[type[ast.unaryop], Operation] = {ast.USub: np.negative, ast.UAdd: np.positive}
COMPARISONS: Mapping[type[ast.cmpop], Operation] = {
    ast.Lt: _comparison(operator.lt),
    ast.LtE: _comparison(operator.le),
    ast.Gt: _comparison(operator.gt),
    ast.GtE: _comparison(operator.ge),
    ast.Eq: _comparison(operator.eq),
    ast.NotEq: _comparison(operator.ne),
}
FUNCTIONS: Mapping[str, tuple[int, Operation]] = {
    "abs": (1, np.abs),
    "sign": (1, np.sign),
    "sqrt": (1, np.sqrt),
    "exp": (1, np.exp),
    "log": (1, np.log),
    "sin": (1, np.sin),
    "cos": (1, np.cos),
    "tan": (1, np.tan),
    "asin": (1, np.arcsin),
    "acos": (1, np.arccos),
    "atan": (1, np.arctan),
    "atan2": (2, np.arctan2),
    "hypot": (2, np.hypot),
    "radians": (1, np.radians),
    "degrees": (1, np.degrees),
    "min": (2, np.minimum),
    "max": (2, np.maximum),
    "where": (3, _where),
}
"""Functions by name, with how many numbers each takes; angles in rad."""
NAMED: Mapping[str, float] = {"pi": np.pi, "missing": np.nan}
"""Numbers that formulas know by name; `missing` is none, and the row is left out."""
_DIVISIONS = (ast.Div, ast.Mod)


@dataclass(frozen=True)
class Formula:
    """A formula as a map has it, with what its names stand for."""

    tree: ast.expr
    text: str
    names: Mapping[str, Entry]  # short names of columns
    constants: Mapping[str, Number]  # [SI]
    place: Entry

    def for_recording(self, recording: str) -> Formula:
        """The formula with the constants of that recording."""
        return replace(self, constants={name: number_of(value, recording) for name, value in self.constants.items()})

    def numbers(self, rows: Columns) -> Floats:
        """(n,) the formula's value for every row; NaN where a column holds no number.

        Raises CocorosimError for an unknown column and for rows where it is not a finite number.
        """
        with np.errstate(all="ignore"):
            return _Walk(self, rows).value(self.tree, np.ones(rows.count, dtype=bool))


def parse(entry: Entry, names: Mapping[str, Entry], constants: Mapping[str, Number]) -> Formula:
    """The formula in an entry. Raises CocorosimError for what is no arithmetic."""
    text = entry.text()
    if len(text) > LONGEST:
        raise entry.problem(f"has {len(text)} characters; a formula has at most {LONGEST}.")
    try:
        tree = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise entry.problem(f"has {entry.found()}, which is no formula like 'rpm**2'; correct it.") from error
    _check(tree, entry, 0)
    return Formula(tree, text, names, constants, entry)


def _check(node: ast.expr, entry: Entry, depth: int) -> None:
    """Nothing, if a node and all below it are arithmetic."""
    if depth > _DEEPEST:
        raise entry.problem("has a formula that is nested too deeply; split it.")
    for part in _parts(node, entry):
        _check(part, entry, depth + 1)


def _parts(node: ast.expr, entry: Entry) -> Iterable[ast.expr]:
    """The parts of a node that are formulas themselves; those of a column's path are not."""
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
        return (node.left, node.right)
    if isinstance(node, ast.UnaryOp) and type(node.op) in SIGNS:
        return (node.operand,)
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in COMPARISONS:
        return (node.left, node.comparators[0])
    if isinstance(node, ast.Call):
        return _arguments(node, entry)
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        return ()
    if isinstance(node, (ast.Name, ast.Attribute, ast.Subscript)) and _is_path(node):
        return ()
    words = "+, -, *, /, %, **, comparisons, numbers, columns and " + ", ".join(FUNCTIONS)
    raise entry.problem(f"has '{_text(node, entry)}', which a formula must not have; allowed: {words}.")


def _arguments(node: ast.Call, entry: Entry) -> Iterable[ast.expr]:
    name = node.func.id if isinstance(node.func, ast.Name) else ""
    if name not in FUNCTIONS:
        called = _text(node.func, entry)
        raise entry.problem(f"calls '{called}', no function of formulas{nearest(called, FUNCTIONS)}.")
    count = FUNCTIONS[name][0]
    if node.keywords or len(node.args) != count or any(isinstance(part, ast.Starred) for part in node.args):
        raise entry.problem(f"has '{_text(node, entry)}', and {name} takes {count} numbers; correct it.")
    return node.args


def _is_path(node: ast.expr) -> bool:
    """Tell whether a node is a column, `motor.rpm[0]`; brackets hold a word and no formula."""
    while isinstance(node, (ast.Attribute, ast.Subscript)):
        node = node.value
    return isinstance(node, ast.Name)


def _text(node: ast.expr, entry: Entry) -> str:
    return ast.get_source_segment(str(entry.value), node) or ast.unparse(node)


class _Walk:
    """One computation for all rows of a file or topic."""

    def __init__(self, formula: Formula, rows: Columns) -> None:
        self._formula = formula
        self._rows = rows

    def value(self, node: ast.expr, counts: Flags) -> Floats:
        """(n,) the value of a node; `counts` (n,) says in which rows it has to be a number."""
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
            return self._finite(np.full(self._rows.count, _as_float(node.value)), (), node, counts)
        if isinstance(node, (ast.Name, ast.Attribute, ast.Subscript)):
            return self._column(node)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "where":
            condition = self.value(node.args[0], counts)
            yes = self.value(node.args[1], counts & (condition != 0))
            return _where(condition, yes, self.value(node.args[2], counts & (condition == 0)))
        operation, parts = _operation(node)
        values = [self.value(part, counts) for part in parts]
        if isinstance(node, ast.BinOp) and isinstance(node.op, _DIVISIONS):
            self._check_divisor(values, parts[1], node, counts)
        return self._finite(operation(*values), values, node, counts)

    def _column(self, node: ast.expr) -> Floats:
        name = _text(node, self._formula.place)
        if name in self._formula.constants:
            return np.full(self._rows.count, self._formula.constants[name])
        if name in NAMED:
            return np.full(self._rows.count, NAMED[name])
        column = self._formula.names.get(name, replace(self._formula.place, value=name))
        numbers = self._rows.numbers(column)
        return np.where(np.isfinite(numbers), numbers, np.nan)

    def _check_divisor(self, values: list[Floats], divisor: ast.expr, node: ast.expr, counts: Flags) -> None:
        zero = counts & (values[1] == 0) & ~np.isnan(values[0])
        if zero.any():
            name = _text(divisor, self._formula.place)
            if not any(isinstance(part, ast.Name) for part in ast.walk(divisor)):
                raise self._problem(node, zero, f"divides by '{name}', which is zero; correct the formula")
            raise self._problem(node, zero, f"divides by zero; write where({name} != 0, ..., 0) around it")

    def _finite(self, result: Floats, inputs: Iterable[Floats], node: ast.expr, counts: Flags) -> Floats:
        """The result, if it is finite wherever all its inputs are numbers."""
        known = counts.copy()
        for numbers in inputs:
            known &= ~np.isnan(numbers)
        lost = known & ~np.isfinite(result)
        if lost.any():
            raise self._problem(node, lost, "is no finite number; correct the formula or the unit of its columns")
        return result

    def _problem(self, node: ast.expr, rows: Flags, what: str) -> CocorosimError:
        row = self._rows.row_name(int(np.argmax(rows)))
        others = np.count_nonzero(rows) - 1
        more = f" and {others} more" if others else ""
        return self._formula.place.problem(
            f"has '{_text(node, self._formula.place)}', which in {self._rows.origin} {row}{more} {what}."
        )


def _as_float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        return np.inf


def _operation(node: ast.expr) -> tuple[Operation, list[ast.expr]]:
    """The operation of a node and its parts."""
    if isinstance(node, ast.BinOp):
        return OPERATORS[type(node.op)], [node.left, node.right]
    if isinstance(node, ast.UnaryOp):
        return SIGNS[type(node.op)], [node.operand]
    if isinstance(node, ast.Compare):
        return COMPARISONS[type(node.ops[0])], [node.left, node.comparators[0]]
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return FUNCTIONS[node.func.id][1], node.args
    raise TypeError(f"{ast.dump(node)} was let through")
