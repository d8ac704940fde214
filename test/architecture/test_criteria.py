"""Every threshold of the diagnosis stands in `criteria`, with its unit, its reason and where it comes from."""

from __future__ import annotations

import ast
import dataclasses
import importlib
import inspect
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

DIAGNOSIS = Path(__file__).parents[2] / "cocorosim_ros" / "diagnosis"
CRITERIA = sorted(path for path in (DIAGNOSIS / "criteria").glob("*.py") if path.name != "__init__.py")
# Constants that are compared with and are no thresholds, by file and name, with the reason.
NO_THRESHOLDS = {
    ("evidence/streams/turning.py", "FULL_TURN"): "2 pi",
    ("filter/covariance.py", "GATE"): "compiled; a part of the filter's equations, beside which it stands",
    ("evidence/streams/noise.py", "WITHIN_ONE_SIGMA"): "a share of the normal distribution",
    ("filter/motion.py", "AT_POINT"): "counts the stages of an integrator's step",
    ("filter/random_force.py", "EQUAL"): "compiled; chooses between two forms of the same number",
    ("tracks/surroundings.py", "FAR"): "stands for a wall that is nowhere",
}


def sources() -> list[Path]:
    """All modules of the diagnosis outside `criteria`."""
    return sorted(path for path in DIAGNOSIS.rglob("*.py") if path.parent.name != "criteria")


def is_numeric(value: ast.expr) -> bool:
    """Tell whether an expression is made of numbers; an enumeration by `range` is not."""
    if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id == "range":
        return False
    constants = [node.value for node in ast.walk(value) if isinstance(node, ast.Constant)]
    numbers = [each for each in constants if isinstance(each, int | float) and not isinstance(each, bool)]
    return bool(numbers) and all(each == "inf" or not isinstance(each, str) for each in constants)


def constants_of(tree: ast.Module) -> Iterator[str]:
    """Upper-case names that a module binds to numbers."""
    for node in tree.body:
        if isinstance(node, ast.Assign):
            targets, value = node.targets, node.value
        elif isinstance(node, ast.AnnAssign) and node.value is not None:
            targets, value = [node.target], node.value
        else:
            continue
        names = [each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)]
        yield from (name for name in names if name.isupper() and is_numeric(value))


def is_order(node: ast.AST) -> bool:
    """Tell whether a node compares sizes."""
    return isinstance(node, ast.Compare) and any(
        isinstance(each, ast.Lt | ast.LtE | ast.Gt | ast.GtE) for each in node.ops
    )


def compared_names(tree: ast.Module) -> set[str]:
    """Names and attributes that stand beside <, <=, > or >=; codes are compared by == alone."""
    inside = [each for node in ast.walk(tree) if is_order(node) for each in ast.walk(node)]
    names = {each.id for each in inside if isinstance(each, ast.Name)}
    return names | {each.attr for each in inside if isinstance(each, ast.Attribute)}


def imported_from(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Module and name of everything that a module imports by name."""
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.module:
            yield from ((node.module, each.name) for each in node.names)


def thresholds_outside(paths: list[Path], root: Path) -> set[tuple[str, str]]:
    """File and name of every numeric constant that its own module, or one that imports it, compares with."""
    trees = {path: ast.parse(path.read_text("utf-8")) for path in paths}
    defined = {path: set(constants_of(tree)) for path, tree in trees.items()}
    found = {(path, name) for path, tree in trees.items() for name in defined[path] & compared_names(tree)}
    for tree in trees.values():
        compared = compared_names(tree)
        for module, name in imported_from(tree):
            home = root.parents[1] / (module.replace(".", "/") + ".py")
            if name in compared and name in defined.get(home, ()):
                found.add((home, name))
    return {(str(path.relative_to(root)), name) for path, name in found}


def test_no_threshold_stands_outside_the_criteria() -> None:
    """If this fails: give the number a field in `criteria`, or say above why it is no threshold."""
    assert thresholds_outside(sources(), DIAGNOSIS) == set(NO_THRESHOLDS)


def test_a_planted_threshold_is_found(tmp_path: Path) -> None:
    """The search sees thresholds of the module itself, in tuples and sums, and those of another module."""
    root = tmp_path / "cocorosim_ros" / "diagnosis"
    root.mkdir(parents=True)
    (root / "planted.py").write_text("FAR, NEAR = 2.0, 1.0\nUSED = 3\nSURE = -0.5\ndef f(x): return x > 2 * FAR\n")
    (root / "other.py").write_text(
        "from cocorosim_ros.diagnosis.planted import SURE, USED\ndef f(x): return SURE < x, range(USED)\n"
    )
    assert thresholds_outside(sorted(root.glob("*.py")), root) == {("planted.py", "FAR"), ("planted.py", "SURE")}


def described_numbers(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Name and following docstring of every field of a record and of every constant with numbers; '' without one."""
    bodies = [tree.body, *(node.body for node in tree.body if isinstance(node, ast.ClassDef) and node.decorator_list)]
    for body in bodies:
        for node, after in zip(body, [*body[1:], None], strict=True):
            if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
                is_text = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
                yield node.target.id, str(after.value.value) if is_text else ""  # type: ignore[union-attr, attr-defined]


@pytest.mark.parametrize("path", CRITERIA, ids=lambda path: path.stem)
def test_every_number_has_unit_reason_and_origin(path: Path) -> None:
    """A field without these cannot be changed by anybody but its author."""
    texts = dict(described_numbers(ast.parse(path.read_text("utf-8"))))
    assert texts
    origin = re.compile(r"[Cc]hosen, not measured|[Mm]easured:|Known of|Reckoned from|The unit of")
    lacking = [
        name for name, text in texts.items() if not text.startswith("[") or not origin.search(" ".join(text.split()))
    ]
    assert lacking == []


@pytest.mark.parametrize("path", CRITERIA, ids=lambda path: path.stem)
def test_the_records_cannot_be_changed(path: Path) -> None:
    """A threshold that one module changes would be another one for all modules that run after it."""
    module = importlib.import_module(f"cocorosim_ros.diagnosis.criteria.{path.stem}")
    records = [each for _, each in inspect.getmembers(module) if dataclasses.is_dataclass(type(each))]
    assert records
    for record in records:
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(record, dataclasses.fields(record)[0].name, 0.0)
