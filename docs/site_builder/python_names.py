"""The public names of `import cocorosim_ros`, from their docstrings."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import cocorosim_ros
from site_builder.markdown import block, plain

_LINE = 80  # characters


def public_names() -> str:
    """Functions first, then the records that they take and return."""
    things = {name: getattr(cocorosim_ros, name) for name in cocorosim_ros.__all__}
    functions = [_function(name, thing) for name, thing in things.items() if not inspect.isclass(thing)]
    records = [_record(name, thing) for name, thing in things.items() if inspect.isclass(thing)]
    return "\n\n".join(["## Functions", *functions, "## Records", *records])


def _function(name: str, function: Any) -> str:
    called = block(_called(name, function), "python")
    return f"### {name}\n\n{called}\n\n{_text(inspect.getdoc(function) or '')}"


def _record(name: str, kind: type) -> str:
    parts = [f"### {name}", _text(inspect.getdoc(kind) or "")]
    if is_dataclass(kind):
        named = [f"`{each.name}`" for each in fields(kind) if not each.name.startswith("_")]
        parts += [f"Fields: {', '.join(named)}"] if named else []
    return "\n\n".join([*parts, *_members(kind)])


def _members(kind: type) -> Iterator[str]:
    """Public properties and methods that the package itself gives a record."""
    for name, member in inspect.getmembers(kind):
        described = inspect.getdoc(member)
        if name.startswith("_") or not described or name in {each.name for each in _fields(kind)}:
            continue
        if isinstance(member, property) or not callable(member):
            yield f"`.{name}`: {_text(described)}"
        elif (getattr(member, "__module__", None) or "").startswith("cocorosim_ros"):
            yield f"`.{_called(name, member)}`: {_text(described)}"


def _fields(kind: type) -> tuple[Any, ...]:
    return fields(kind) if is_dataclass(kind) else ()


def _called(name: str, function: Any) -> str:
    """How a function is called, an argument a line if it is long; without `self`, and types without quotes."""
    signature = inspect.signature(function)
    shown = [str(part).replace("'", "") for part in signature.parameters.values() if part.name != "self"]
    starred = [number for number, part in enumerate(signature.parameters.values()) if part.kind is part.KEYWORD_ONLY]
    if starred:
        shown.insert(starred[0] - (len(signature.parameters) - len(shown)), "*")
    inside, gives = ", ".join(shown), str(signature).rpartition(" -> ")[2].replace("'", "")
    if len(inside) > _LINE:
        inside = "".join(f"\n    {words}," for words in shown) + "\n"
    return f"{name}({inside}) -> {gives}"


def _text(docstring: str) -> str:
    """A docstring as Markdown: paragraphs, and what is indented as a block."""
    paragraphs = re.split(r"\n\s*\n", docstring)
    return "\n\n".join(
        block(inspect.cleandoc(part)) if part.startswith("    ") else plain(part.strip()) for part in paragraphs
    )
