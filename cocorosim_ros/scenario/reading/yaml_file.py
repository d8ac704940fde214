"""YAML files as entries that know their line, and plain values as YAML text.

YAML 1.2 without anchors and tags: a file says each thing once, in words that any reader understands.
"""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry

_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_WORDS_WITH_A_MEANING = frozenset({"true", "false", "null", "yes", "no", "on", "off", "y", "n"})
_STANDARD_TAG = "tag:yaml.org,2002:"


def load_yaml(path: Path) -> Entry:
    """The mapping at the top of a YAML file.

    Raises CocorosimError: missing, unreadable, not UTF-8, empty, not YAML, duplicate keys, not a mapping.
    """
    shown = shown_path(path)
    return parse_yaml(_file_text(path, shown), shown)


def parse_yaml(text: str, shown: str) -> Entry:
    """The mapping at the top of a YAML text; complaints name `shown` as the file."""
    yaml = YAML(typ="safe", pure=True)
    try:
        node = yaml.compose(text)
    except YAMLError as error:
        raise _syntax_problem(error, text, shown) from error
    if node is None:
        raise CocorosimError(f"{shown} is empty; write 'name: value' lines into it.")
    top = _Tree(yaml, shown).entry(node, "", 1)
    if not isinstance(top.value, dict):
        kind = "a list" if isinstance(top.value, list) else f"only {top.found()}"
        raise CocorosimError(f"{shown} holds {kind} at its top; a mapping, 'name: value' lines, is needed there.")
    return top


def shown_path(path: Path) -> str:
    """The path as sentences show it: relative when it lies below the working folder."""
    try:
        return str(path.resolve().relative_to(Path(os.getcwd()).resolve()))
    except (ValueError, OSError):
        return str(path)


def yaml_text(tree: Any, indent: int = 0) -> str:
    """Nested dict, list, text, numbers and truth values as block YAML, the same bytes each time."""
    pad = "  " * indent
    if isinstance(tree, dict):
        return "".join(f"{pad}{_scalar_text(name)}:{_after_colon(part, indent)}" for name, part in tree.items())
    return "".join(f"{pad}-{_after_colon(part, indent)}" for part in tree)


def _file_text(path: Path, shown: str) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except FileNotFoundError as error:
        raise CocorosimError(f"{shown} does not exist; check the path.") from error
    except UnicodeDecodeError as error:
        raise CocorosimError(
            f"{shown} is not UTF-8 text (byte {error.start} is {error.object[error.start]:#04x}); save it as UTF-8."
        ) from error
    except IsADirectoryError as error:
        raise CocorosimError(f"{shown} is a folder; name a YAML file.") from error
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise CocorosimError(f"{shown} cannot be read ({reason}); check its name and permissions.") from error


def _syntax_problem(error: YAMLError, text: str, shown: str) -> CocorosimError:
    for number, line in enumerate(text.splitlines(), start=1):
        if re.match(r" *\t", line):
            return CocorosimError(f"{shown} line {number} is indented with a tab; YAML allows spaces only there.")
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    place = f"{shown} line {mark.line + 1}" if mark is not None else shown
    reason = error.problem if isinstance(error, MarkedYAMLError) and error.problem else str(error).splitlines()[0]
    return CocorosimError(f"{place} is not valid YAML: {reason}; correct that line or the one before it.")


class _Tree:
    """Turns the nodes of one file into entries."""

    def __init__(self, yaml: YAML, file: str) -> None:
        self._construct = yaml.constructor
        self._file = file
        self._seen: set[int] = set()

    def entry(self, node: Node, key: str, line: int) -> Entry:
        here = Entry(None, self._file, line, key)
        # An alias gives the same node again, and could contain itself.
        if id(node) in self._seen:
            raise here.problem("is reached through a YAML alias ('*name'); write the value out instead.")
        self._seen.add(id(node))
        value: Any
        if isinstance(node, MappingNode):
            value = self._mapping(node, here)
        elif isinstance(node, SequenceNode):
            value = [self.entry(part, f"{key}[{i}]", _line(part)) for i, part in enumerate(node.value)]
        elif isinstance(node, ScalarNode):
            value = self._scalar(node, here)
        else:
            raise here.problem("has a kind of YAML that is not allowed; write a plain value.")
        return Entry(value, here.file, here.line, key)

    def _mapping(self, node: MappingNode, here: Entry) -> dict[str, Entry]:
        entries: dict[str, Entry] = {}
        for name_node, part in node.value:
            line = _line(name_node)
            name = name_node.value
            if not isinstance(name_node, ScalarNode) or name_node.tag != f"{_STANDARD_TAG}str":
                raise Entry(None, self._file, line, here.key).problem(
                    "has a key that is not a word; write a name there."
                )
            key = f"{here.key}.{name}" if here.key else name
            if name in entries:
                first = entries[name].line
                raise Entry(None, self._file, line, key).problem(
                    f"appears twice (first on line {first}); keep one of them."
                )
            entries[name] = self.entry(part, key, line)
        return entries

    def _scalar(self, node: ScalarNode, here: Entry) -> Any:
        tag = str(node.tag)
        if not tag.startswith(_STANDARD_TAG) or "/" in tag:
            raise here.problem(f"has the YAML tag '{tag}', which is not allowed; write a plain value.")
        kind = tag.removeprefix(_STANDARD_TAG)
        try:
            if kind == "int":
                return self._construct.construct_yaml_int(node)
            if kind == "float":
                return self._construct.construct_yaml_float(node)
        except (ValueError, OverflowError) as error:
            raise here.problem("has a number that cannot be read; write it with fewer digits.") from error
        if kind == "bool":
            return node.value.lower() == "true"
        return None if kind == "null" else node.value


def _line(node: Node) -> int:
    return int(node.start_mark.line) + 1


def _after_colon(tree: Any, indent: int) -> str:
    if isinstance(tree, dict) and tree:
        return "\n" + yaml_text(tree, indent + 1)
    if isinstance(tree, (list, tuple)) and any(isinstance(part, (dict, list, tuple)) for part in tree):
        return "\n" + yaml_text(tree, indent + 1)
    if isinstance(tree, (list, tuple)):
        return f" [{', '.join(_scalar_text(part) for part in tree)}]\n"
    return " {}\n" if tree == {} else f" {_scalar_text(tree)}\n"


def _scalar_text(value: Any) -> str:
    if isinstance(value, str) and _PLAIN.fullmatch(value) and value.lower() not in _WORDS_WITH_A_MEANING:
        return value
    return json.dumps(value, ensure_ascii=False)
