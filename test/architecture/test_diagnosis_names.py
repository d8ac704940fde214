"""Names in the diagnosis: records in place of tuples, columns by name, and one value for each constant."""

from __future__ import annotations

import ast
import importlib
from collections.abc import Iterator
from pathlib import Path

import pytest

DIAGNOSIS = Path(__file__).parents[2] / "cocorosim_ros" / "diagnosis"
SOURCES = sorted(DIAGNOSIS.rglob("*.py"))
# Numbered columns that may stay, by file and text, with the reason.
ONE_COLUMN = {
    ("evidence/streams/noise.py", "times[:, -1]"): "the ends of a window of time",
    ("evidence/streams/noise.py", "times[:, 0]"): "the ends of a window of time",
    ("fitting/fit.py", "weighted_products(felt.slopes, passed.innovation[:, None], passed.variance)[:, 0]"): "the only",
    ("fitting/noise_information.py", "weighted_products(moved, passed.innovation[:, None], passed.variance)[:, 0]"):
        "the only one",
    ("fitting/noise_information.py", "weighted_products(swollen, excess[:, None], one)[:, 0]"): "the only one",
    ("fitting/screening.py", "self._sum(self._directions[number], innovations)[:, 0]"): "the only one",
    ("report/residual_figures.py", "drawing.axes[:, 0]"): "the only column of a figure's panels",
    ("report/residual_figures.py", "drawing.axes[:-1, 0]"): "the only column of a figure's panels",
}  # fmt: skip


def is_tuple_of_parts(node: ast.AST) -> bool:
    """Tell whether a node is a type tuple[A, B, ...] of two members or more; tuple[A, ...] is a sequence."""
    if not (isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id == "tuple"):
        return False
    parts = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    return len(parts) > 1 and not (isinstance(parts[1], ast.Constant) and parts[1].value is Ellipsis)


def tuple_parameters(tree: ast.AST) -> Iterator[str]:
    """Function and parameter whose type has an anonymous tuple in it."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.FunctionDef):
            continue
        for each in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
            if each.annotation is not None and any(map(is_tuple_of_parts, ast.walk(each.annotation))):
                yield f"{node.name}({each.arg})"


def numbered_columns(tree: ast.AST) -> Iterator[str]:
    """Texts like table[:, 3], table[..., 1] or table[:, :2]."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Tuple):
            first, *others = node.slice.elts
            rows = isinstance(first, ast.Slice) or (isinstance(first, ast.Constant) and first.value is Ellipsis)
            if rows and any(map(is_numbered, others)):
                yield ast.unparse(node)


def is_numbered(index: ast.expr) -> bool:
    """Tell whether an index is a number, or a slice with a number as an end."""
    ends = [index.lower, index.upper] if isinstance(index, ast.Slice) else [index]
    plain = [end.operand if isinstance(end, ast.UnaryOp) else end for end in ends]
    return any(isinstance(end, ast.Constant) and isinstance(end.value, int) for end in plain)


def public_constants(tree: ast.Module) -> Iterator[str]:
    """Upper-case names that a module binds itself."""
    for node in tree.body:
        if isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = [each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)]
            yield from (name for name in names if name.isupper() and not name.startswith("_"))


def contradictions(values: dict[str, dict[str, object]]) -> dict[str, list[str]]:
    """Modules by constant, of constants that have different values in two of the modules; values: by module and name.

    Values are compared as they are written out, because arrays have no single truth.
    """
    homes: dict[str, dict[str, str]] = {}
    for module, constants in values.items():
        for name, value in constants.items():
            homes.setdefault(name, {})[module] = repr(value)
    return {name: sorted(found) for name, found in homes.items() if len(set(found.values())) > 1}


def test_no_parameter_is_an_anonymous_tuple() -> None:
    """What has parts of different meaning is a record, whose parts have names."""
    found = {path.relative_to(DIAGNOSIS).as_posix(): list(tuple_parameters(ast.parse(path.read_text("utf-8"))))
             for path in SOURCES}  # fmt: skip
    assert {file: names for file, names in found.items() if names} == {}


def test_columns_have_names() -> None:
    """A number says nothing of what stands in a column."""
    found = {(path.relative_to(DIAGNOSIS).as_posix(), text)
             for path in SOURCES for text in numbered_columns(ast.parse(path.read_text("utf-8")))}  # fmt: skip
    assert found == set(ONE_COLUMN)


def test_a_constant_has_one_value() -> None:
    """The same name for two values in two modules is read wrongly in one of them."""
    values = {}
    for path in SOURCES:
        words = path.relative_to(DIAGNOSIS.parents[1]).with_suffix("").parts
        module = importlib.import_module(".".join(words).removesuffix(".__init__"))
        values[module.__name__] = {
            name: getattr(module, name) for name in public_constants(ast.parse(path.read_text("utf-8")))
        }
    assert contradictions(values) == {}


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("def f(edges: tuple[int, str]): ...", ["f(edges)"]),
        ("def f(*, a: int, pairs: Sequence[tuple[A, B]] | None = None): ...", ["f(pairs)"]),
        ("def f(many: tuple[int, ...], one: tuple[int]) -> tuple[int, str]: ...", []),
    ],
)
def test_a_planted_tuple_is_found(text: str, found: list[str]) -> None:
    """Tuples of parts are; sequences and results are not."""
    assert list(tuple_parameters(ast.parse(text))) == found


@pytest.mark.parametrize(
    ("text", "count"),
    [("a[:, 3]", 1), ("a[..., 1]", 1), ("a[:, :2]", 1), ("a[1:, -1]", 1), ("a[:, X] + a[:, X:Z] + a[0, 1]", 0)],
)  # fmt: skip
def test_a_planted_column_is_found(text: str, count: int) -> None:
    """Numbers behind a slice are; names, single entries and new axes are not."""
    assert len(list(numbered_columns(ast.parse(text)))) == count


def test_a_planted_contradiction_is_found() -> None:
    """Different values are, equal ones are not; nor are names of one module."""
    values: dict[str, dict[str, object]] = {
        "a": {"MOST": 3, "TOPIC": "imu"},
        "b": {"MOST": 4, "TOPIC": "imu"},
        "c": {"N": 1},
    }
    assert contradictions(values) == {"MOST": ["a", "b"]}
