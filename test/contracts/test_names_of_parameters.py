"""Compiled functions of effects and currents call their numbers as these are declared, in the same order."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Iterator, Sequence
from typing import Any

import pytest

from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.water.currents import CURRENTS

PLACES = ("wrench", "inertia", "water", "command", "thrust", "response")


def functions() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Name and source of every compiled function that is given `parameters`, with the declared names of these."""
    for name, effect in EFFECTS.items():
        declared = tuple(parameter.name for parameter in effect.parameters)
        hooks = {place: getattr(effect, place) for place in PLACES}
        yield from ((f"{name}.{place}", source(hook), declared) for place, hook in hooks.items() if hook is not None)
    for name, current in CURRENTS.items():
        if current.parameters:  # a table of values has a layout of its own
            yield f"{name}.velocity", source(current.velocity), current.parameters


def source(function: Any) -> str:
    """Text of what was compiled."""
    return textwrap.dedent(inspect.getsource(function.py_func))


def offences(text: str, declared: Sequence[str]) -> list[str]:
    """In words, what a function does with `parameters` beside naming all of them once, in the declared order."""
    tree, found, unpacked = ast.parse(text), [], 0
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and ast.unparse(node.value).startswith("unpack(parameters, "):
            unpacked += 1
            target = node.targets[0]
            given = [ast.unparse(each).removesuffix("_") for each in getattr(target, "elts", [target])]
            wrong = [pair for pair in zip(given, declared, strict=False) if pair[0] not in (pair[1], "")]
            if (
                wrong
                or len(given) != len(declared)
                or ast.unparse(node.value) != f"unpack(parameters, {len(declared)})"
            ):
                found.append(f"{ast.unparse(node)} where {', '.join(declared)} are declared")
    uses = sum(isinstance(node, ast.Name) and node.id == "parameters" for node in ast.walk(tree))
    if (unpacked, uses) != (1, 1):
        found.append(f"unpacks the parameters {unpacked} times and uses them {uses} times")
    return found


@pytest.mark.parametrize(("name", "text", "declared"), list(functions()), ids=lambda part: str(part)[:40])
def test_numbers_have_their_declared_names(name: str, text: str, declared: tuple[str, ...]) -> None:
    """A name that stood at another place would be another number, and nothing else would notice it."""
    assert offences(text, declared) == [], name


@pytest.mark.parametrize(
    "body",
    [
        "x, stiffness = unpack(parameters, 2)",
        "stiffness, x = unpack(parameters, 3)",
        "(stiffness,) = unpack(parameters, 1)",
        "pull = parameters[0]",
        "stiffness, x = unpack(parameters, 2); pull = parameters[1]",
        "stiffness = unpack(parameters, 2)",
    ],
)
def test_a_planted_disorder_is_found(body: str) -> None:
    """Names at other places, too few or too many of them, numbers by index."""
    assert offences(f"def tether(parameters, total): {body}", ("stiffness", "x"))


@pytest.mark.parametrize("body", ["stiffness, x = unpack(parameters, 2)", "_, x_ = unpack(parameters, 2)"])
def test_order_is_let_be(body: str) -> None:
    """What is not used needs no name, and a name that Python has taken may end in an underscore."""
    assert offences(f"def tether(parameters, total): {body}", ("stiffness", "x")) == []
