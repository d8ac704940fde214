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
# Constants with numbers that are no thresholds, by file and name, with the reason.
NO_THRESHOLDS = {
    "catalogue/eddies.py": {"_AROUND": "follows from the form of a vortex"},
    "catalogue/laws.py": {"LAWS_OF": "the powers of the laws themselves"},
    "evidence/frames/orientation.py": {"USUAL_ANGLES": "numbers of quarter turns"},
    "evidence/frames/units.py": {"DEGREE": "a unit"},
    "evidence/streams/noise.py": {
        "LOW_ORDER": "order of a difference",
        "HIGH_ORDER": "order of a difference",
        "WITHIN_ONE_SIGMA": "a share of the normal distribution",
    },
    "evidence/streams/outliers.py": {"NEIGHBOURHOOD": "the length of a median, on which its sentences build"},
    "evidence/streams/turning.py": {"FULL_TURN": "2 pi"},
    "filter/motion.py": {
        "AT_POINT": "counts the stages of an integrator's step",
        "NUDGE": "compiled; the width of a difference quotient",
    },
    "filter/products.py": {"CHUNK": "readings that fit a processor's cache", "LANES": "numbers of a vector register"},
    "filter/random_force.py": {"EQUAL": "compiled; chooses between two forms of the same number"},
    "filter/smoother.py": {"WIDE": "columns of a state", "HIGH": "columns of a state"},
    "fitting/climbing.py": {"STEP_HALVINGS": "length of a search, which ends earlier by itself"},
    "fitting/starts.py": {"SPACING_HALVINGS": "length of a search, each step of which is half as long"},
    "naming/single_thrusters.py": {"SIDES": "left and right"},
    "tracks/columns.py": {"MOST_THRUSTERS": "columns of a row"},
    "report/figure_style.py": {"WIDTH": "inches of a page", "_STYLE": "sizes of letters"},
    "report/manoeuvre_scenario.py": {
        "VARIED": "a manoeuvre itself",
        "AHEAD_AND_BACK": "a manoeuvre itself",
        "PROGRAMMES": "the manoeuvres themselves",
    },
    "report/overlay.py": {"_RED": "a colour", "_GREEN": "a colour"},
    "report/place_figure.py": {
        "_CELLS": "size of a grid",
        "_STRONG": "a colour",
        "_MIDDLE": "a colour",
        "_COLOURS": "colours",
    },
    "showing/actuator_sentences.py": {"_FINEST": "decimals of a text"},
    "fleet/series.py": {"WEEK": "a unit"},
    "foretelling/bootstrap.py": {"SAMPLES": "length of a calculation"},
    "foretelling/gains.py": {"SURE": "the end of a 95 % interval"},
    "fitting/unknowns.py": {"Z95": "a quantile of the normal distribution"},
    "tracks/averaging.py": {"NOTHING": "a shape"},
    "tracks/lately.py": {"REMEMBERED": "size of a cache, which changes no result"},
    "tracks/passes.py": {"COURSE_SIZE": "a number of columns"},
    "tracks/surroundings.py": {"FAR": "stands for a wall that is nowhere", "OPEN_WATER": "a shape"},
    "tracks/track_filter.py": {"NO_PUSH": "a shape"},
    "tracks/tracks_at_once.py": {"MOST": "threads, which change no result"},
    "tracks/vehicle_size.py": {"LILY": "the numbers of a Lily", "LILY_COASTING": "what follows from them"},
}
# Limits that are written as numbers where they are used and are no thresholds, by file and text, with the reason.
NO_LIMITS = {
    ("evidence/cleaning.py", "len(time) < 3"): "two intervals have a usual one",
    ("evidence/frames/agreement.py", "np.count_nonzero(given) < 3"): "two points always lie on a line",
    ("evidence/streams/turning.py", "len(imu.time) < 3"): "two points always lie on a line",
    ("evidence/streams/turning.py", "np.count_nonzero(given) < 3"): "two points always lie on a line",
    ("evidence/streams/vehicle_scales.py", "max(platform.drag, 1e-09)"): "keeps from dividing by zero",
    ("report/figure_style.py", "abs(value) >= 0.0001"): "decimals of a text",
    (
        "report/place_figure.py",
        "max(_usual_length(maps[0]), 1.96 * float(np.median(pair.before.spread[:, OF_BODY.index('surge')])))",
    ): "a quantile of the normal distribution",
    (
        "tracks/grid.py",
        "max(GRID.shortest_step, math.floor(step * 100.0 + 1e-09) / 100.0)",
    ): "whole hundredths of a second",
    ("showing/location.py", "min(last + 1, 30)"): "the number of the bins",
}
ORDINARY = (0, 1, 2)
"""Numbers that compare signs, shares of a whole, and lengths of pairs."""
TINY = 1e-100
"""Smaller numbers keep from dividing by zero."""


def sources() -> list[Path]:
    """All modules of the diagnosis outside `criteria`."""
    return sorted(path for path in DIAGNOSIS.rglob("*.py") if path.parent.name != "criteria")


def numbers_in(value: ast.expr) -> list[float]:
    """Numbers that an expression is made of; those of ranges, slices and indices only count or point."""
    if isinstance(value, ast.Constant):
        return [value.value] if isinstance(value.value, int | float) and not isinstance(value.value, bool) else []
    if isinstance(value, ast.Call):
        counts = isinstance(value.func, ast.Name) and value.func.id in {"range", "slice", "enumerate"}
        return [] if counts else [each for part in call_arguments(value) for each in numbers_in(part)]
    if isinstance(value, ast.Dict):
        return [each for part in value.values for each in numbers_in(part)]
    if isinstance(value, ast.UnaryOp | ast.BinOp | ast.Tuple | ast.List | ast.Set | ast.Starred):
        return [each for part in ast.iter_child_nodes(value) if isinstance(part, ast.expr) for each in numbers_in(part)]
    return []


def call_arguments(call: ast.Call) -> list[ast.expr]:
    """Arguments of a call, named ones too."""
    return [*call.args, *(each.value for each in call.keywords)]


def constants_of(tree: ast.Module) -> Iterator[tuple[str, list[float]]]:
    """Upper-case names that a module binds to numbers, and the numbers; infinity in words is one."""
    for node in tree.body:
        if isinstance(node, ast.Assign):
            targets, value = node.targets, node.value
        elif isinstance(node, ast.AnnAssign) and node.value is not None:
            targets, value = [node.target], node.value
        else:
            continue
        numbers = numbers_in(value)
        names = [each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)]
        yield from ((name, numbers) for name in names if name.isupper() and numbers)


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


def constants_outside(paths: list[Path], root: Path) -> set[tuple[str, str]]:
    """File and name of every constant with a number that is not ordinary, or with which any module compares."""
    trees = {path: ast.parse(path.read_text("utf-8")) for path in paths}
    defined = {path: dict(constants_of(tree)) for path, tree in trees.items()}
    found = {
        (path, name)
        for path, constants in defined.items()
        for name, numbers in constants.items()
        if name in compared_names(trees[path]) or not set(numbers) <= set(ORDINARY)
    }
    for tree in trees.values():
        compared = compared_names(tree)
        for module, name in imported_from(tree):
            home = root.parents[1] / (module.replace(".", "/") + ".py")
            if name in compared and name in defined.get(home, ()):
                found.add((home, name))
    return {(str(path.relative_to(root)), name) for path, name in found}


def is_limiting(node: ast.AST) -> bool:
    """Tell whether a node takes the smaller or the greater of its arguments."""
    return isinstance(node, ast.Call) and ast.unparse(node.func).removeprefix("np.") in {
        "min", "max", "minimum", "maximum", "fmin", "fmax", "clip",
    }  # fmt: skip


def factors_in(value: ast.expr) -> list[float]:
    """Numbers of a sum or a product, without those inside of the calls in it."""
    if isinstance(value, ast.UnaryOp | ast.BinOp):
        return [each for part in ast.iter_child_nodes(value) if isinstance(part, ast.expr) for each in factors_in(part)]
    return numbers_in(value) if isinstance(value, ast.Constant) else []


def limits_outside(paths: list[Path], root: Path) -> set[tuple[str, str]]:
    """File and text of every comparison, minimum or maximum with a number that is not ordinary."""
    found = set()
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Compare):
                sides = [node.left, *node.comparators]
            elif is_limiting(node):
                sides = call_arguments(node)  # type: ignore[arg-type]
            else:
                continue
            plain = [each for side in sides for each in factors_in(side)]
            if any(each not in ORDINARY and abs(each) > TINY for each in plain):
                found.add((str(path.relative_to(root)), ast.unparse(node)))
    return found


def test_no_threshold_stands_outside_the_criteria() -> None:
    """If this fails: give the number a field in `criteria`, or say above why it is no threshold."""
    excepted = {(file, name) for file, names in NO_THRESHOLDS.items() for name in names}
    assert constants_outside(sources(), DIAGNOSIS) == excepted


def test_no_limit_is_written_where_it_is_used() -> None:
    """If this fails: give the number a field in `criteria`, or say above why it is no threshold."""
    assert limits_outside(sources(), DIAGNOSIS) == set(NO_LIMITS)


def planted(folder: Path, **modules: str) -> tuple[list[Path], Path]:
    """Modules of a diagnosis by name, written into a folder: their files, and the folder of the diagnosis."""
    root = folder / "cocorosim_ros" / "diagnosis"
    root.mkdir(parents=True)
    for name, text in modules.items():
        (root / f"{name}.py").write_text(text)
    return sorted(root.glob("*.py")), root


def test_a_planted_threshold_is_found(tmp_path: Path) -> None:
    """The search sees thresholds in tuples, sums, calls and mappings, and those that another module compares with."""
    files, root = planted(
        tmp_path,
        planted='FAR, NEAR = 2.0, 1.0\nUSED = 2\nSURE = -1\n_BAD = {"u": 0.5}\nWIDE = log(10.0)\nSIZE = range(9)\n'
        "def f(x): return x > 2 * FAR\n",
        other="from cocorosim_ros.diagnosis.planted import SURE, USED\ndef f(x): return SURE < x, range(USED)\n",
    )
    assert constants_outside(files, root) == {("planted.py", name) for name in ("FAR", "SURE", "_BAD", "WIDE")}


def test_a_planted_limit_is_found(tmp_path: Path) -> None:
    """Numbers in comparisons and limits, factors too; lengths, signs and guards are left out."""
    files, root = planted(
        tmp_path,
        planted="def f(x, y):\n    if x > 5 or len(x) < 2 or x == 0.0: return max(x, -0.1)\n"
        "    return min(y, 0.1 * x), np.maximum(x, 1e-300), y < round(x, 3)\n",
    )
    assert limits_outside(files, root) == {
        ("planted.py", text) for text in ("x > 5", "max(x, -0.1)", "min(y, 0.1 * x)")
    }  # fmt: skip


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
