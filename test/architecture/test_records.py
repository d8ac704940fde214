"""What belongs together goes into functions as a record with names, and numbers of effects are not read by place."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "cocorosim_ros"
# By name and annotation of a parameter: why it needs no names.
ALLOWED = {
    ("size", "tuple[float, float, float]"): "a vector: the sides of a box along x, y and z",
    ("shape", "tuple[int, int]"): "the shape of an array, as NumPy has it",
    ("shape", "tuple[int, int, int]"): "the shape of an array, as NumPy has it",
    ("interval", "tuple[float, float]"): "the lowest and the highest value",
    ("colour", "tuple[float, float, float, float]"): "red, green, blue and opacity, as Matplotlib has them",
    ("position", "Vector3"): "a vector: x, y, z",
    ("direction", "Vector3"): "a vector: x, y, z",
    ("pose", "Pose"): "x, y, z and yaw, as they stand in a line of a scenario file",
    ("poses", "tuple[Pose, ...]"): "x, y, z and yaw, as they stand in a line of a scenario file",
    ("messages", "Iterator[RawMessage]"): "one for each message of a file, and taken apart at once: records cost time",
}
# By folder: the annotations that may stay until they are records, `*` for all; and what they wait for.
WAITING = {
    "diagnosis": (("*",), "its tuples become records together"),
    "world/sensors": (("When", "Rates"), "what the filter of the diagnosis hands over becomes records with the rest"),
}
WITHOUT_PLACES = ("world/effects", "world/water")


def is_fixed_tuple(node: ast.AST) -> bool:
    """Tell whether a node is tuple[A, B] or longer, but not tuple[A, ...]."""
    if not (isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id == "tuple"):
        return False
    parts = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    return len(parts) > 1 and ast.unparse(parts[-1]) != "..."


def aliases_of(tree: ast.Module) -> set[str]:
    """Names that a module gives to such tuples."""
    assigned = [node for node in tree.body if isinstance(node, ast.Assign) and is_fixed_tuple(node.value)]
    return {target.id for node in assigned for target in node.targets if isinstance(target, ast.Name)}


def aliases_in(tree: ast.Module, by_module: Mapping[str, set[str]]) -> set[str]:
    """Names of such tuples that a module defines or imports from one that does."""
    found = aliases_of(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module in by_module:
            found |= {each.name for each in node.names} & by_module[node.module]
    return found


def parameters_of(tree: ast.Module) -> Iterator[tuple[int, str, ast.expr]]:
    """Line, name and annotation of every annotated parameter of every function."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            given = node.args
            several = [each for each in (given.vararg, given.kwarg) if each is not None]
            for each in [*given.posonlyargs, *given.args, *given.kwonlyargs, *several]:
                if each.annotation is not None:
                    yield each.lineno, each.arg, each.annotation


def nameless(tree: ast.Module, aliases: set[str]) -> Iterator[tuple[int, str, str]]:
    """Line, name and annotation of every parameter that holds a tuple without names of its members."""
    for line, name, annotation in parameters_of(tree):
        parts = list(ast.walk(annotation))
        named = any(isinstance(part, ast.Name) and part.id in aliases for part in parts)
        if named or any(is_fixed_tuple(part) for part in parts):
            yield line, name, ast.unparse(annotation)


def waits(place: str, annotation: str) -> bool:
    """Tell whether a file may keep such an annotation for now."""
    kept = [word for folder, (words, _) in WAITING.items() if place.startswith(f"{folder}/") for word in words]
    return "*" in kept or annotation in kept


def offences() -> tuple[list[str], set[tuple[str, str]]]:
    """In words, every parameter that is no exception; and the exceptions that there are."""
    trees = {path: ast.parse(path.read_text("utf-8")) for path in sorted(PACKAGE.rglob("*.py"))}
    names = {path: ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts) for path in trees}
    by_module = {names[path]: aliases_of(tree) for path, tree in trees.items()}
    found, met = [], set()
    for path, tree in trees.items():
        place = path.relative_to(PACKAGE).as_posix()
        for line, name, annotation in nameless(tree, aliases_in(tree, by_module)):
            if (name, annotation) in ALLOWED:
                met.add((name, annotation))
            elif not waits(place, annotation):
                found.append(f"{place}:{line} {name}: {annotation}")
    return found, met


def test_no_parameter_is_a_tuple_without_names() -> None:
    """If this fails: make it a NamedTuple (in compiled code) or a frozen dataclass, or say above why it needs none."""
    found, met = offences()
    assert found == []
    assert met == set(ALLOWED), "exceptions that nothing needs"


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("def f(target: tuple[str, bool]): ...", 1),
        ("def f(*, rows: list[tuple[int, str]] | None = None): ...", 1),
        ("def f(*pairs: tuple[int, str]): ...", 1),
        ("class A:\n    async def f(self, pair: dict[str, tuple[int, str]]): ...", 1),
        ("Pair = tuple[int, str]\ndef f(pair: Pair): ...", 1),
        ("from m import Known\ndef f(known: Known): ...", 1),
        ("from n import Known\ndef f(known: Known): ...", 0),
        ("def f(names: tuple[str, ...], one: tuple[str]) -> tuple[int, str]: ...", 0),
    ],
)
def test_a_planted_tuple_is_found(text: str, count: int) -> None:
    """Inside of other types, under a name, from another module; results and sequences are no matter of this test."""
    tree = ast.parse(text)
    assert len(list(nameless(tree, aliases_in(tree, {"m": {"Known"}})))) == count


def read_by_place(tree: ast.Module) -> list[int]:
    """Lines that read one of the `parameters` by a number."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and ast.unparse(node.value) == "parameters":
            index = node.slice.operand if isinstance(node.slice, ast.UnaryOp) else node.slice
            if isinstance(index, ast.Constant):
                found.append(node.lineno)
    return found


@pytest.mark.parametrize("folder", WITHOUT_PLACES)
def test_numbers_of_effects_and_currents_have_names(folder: str) -> None:
    """`parameters[1]` says nothing; `width, ramp = unpack(parameters, 2)` costs the same (compiling.unpacking)."""
    files = sorted((PACKAGE / folder).rglob("*.py"))
    assert files
    found = {path.name: read_by_place(ast.parse(path.read_text("utf-8"))) for path in files}
    assert {name: lines for name, lines in found.items() if lines} == {}


def test_a_planted_place_is_found() -> None:
    """Counted from either end; names and stretches are let be."""
    text = "a = parameters[0]\nb = parameters[-1]\nc = parameters[FIRST]\nd = parameters[2:4]\ne = others[0]"
    assert read_by_place(ast.parse(text)) == [1, 2]
