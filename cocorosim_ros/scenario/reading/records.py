"""Frozen records whose fields know how they stand in YAML: one declaration serves reading and writing.

A field is declared as `mass: float = field(metadata=quantity("mass", "positive"))`. Its YAML key is its name,
and it must be in the file unless it has a default.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.scenario.reading.quantity import (
    Sign,
    quantity_text,
    read_list,
    read_quantity,
    read_vector,
    si_unit,
)

Record = TypeVar("Record")
Rule = dict[str, Any]


def stored(read: Callable[[Entry], Any], write: Callable[[Any], Any], key: str = "", *, form: str = "") -> Rule:
    """The rule of a field with its own reader and writer.

    key: where YAML calls it otherwise. form: in words, what may stand there.
    """
    return {"read": read, "write": write, "key": key, "form": form}


def form_of(dimension: str, sign: Sign = "any") -> str:
    """The words for one number of a dimension: "length [m], greater than zero"."""
    unit = "" if dimension == "pure number" else f" [{si_unit(dimension)}]"
    limit = {"any": "", "not negative": ", not negative", "positive": ", greater than zero"}[sign]
    return f"{dimension}{unit}{limit}"


TIME_FORM = form_of("time", "positive")


def quantity(dimension: str, sign: Sign = "any") -> Rule:
    """The rule of a field that holds one SI number."""
    return stored(
        lambda entry: read_quantity(entry, dimension, sign),
        lambda value: quantity_text(value, dimension),
        form=form_of(dimension, sign),
    )


def vector(dimension: str, size: int, sign: Sign = "any") -> Rule:
    """The rule of a field that holds a tuple of `size` SI numbers."""
    return stored(
        lambda entry: read_vector(entry, [dimension] * size, sign),
        lambda values: [quantity_text(value, dimension) for value in values],
        form=f"list of {size}: {form_of(dimension, sign)}",
    )


def quantities(dimension: str) -> Rule:
    """The rule of a field that holds a tuple of any number of SI numbers."""
    return stored(
        lambda entry: read_list(entry, dimension),
        lambda values: [quantity_text(value, dimension) for value in values],
        form=f"list of any length: {form_of(dimension)}",
    )


def other_flags() -> Rule:
    """The rule of a field that holds, by key, the flags that no other field of the record has; the reader checks them.

    Such a field is a mapping, empty by default.
    """
    return {"read": Entry.flag, "write": dict, "key": "", "form": "true or false", "others": True}


TEXT: Rule = stored(Entry.text, str, form="text")
FLAG: Rule = stored(Entry.flag, bool, form="true or false")


def choice(*options: str) -> Rule:
    """The rule of a field that holds one of some words."""
    return stored(lambda entry: entry.choice(options), str, form=listed(options))


def nested(kind: type[Any]) -> Rule:
    """The rule of a field that holds another record."""
    return stored(lambda entry: read_record(kind, entry), record_tree, form="mapping") | {"inside": kind}


def list_of(kind: type[Any] | Mapping[str, type[Any]]) -> Rule:
    """The rule of a field that holds a tuple of records of one type, or of the type that 'kind' names."""

    def read(entry: Entry) -> tuple[Any, ...]:
        return tuple(read_record(_type_of(part, kind), part) for part in entry.items())

    rule = stored(read, lambda records: [record_tree(record) for record in records], form="list of mappings")
    return rule | {"inside": kind, "several": True}


def read_record(kind: type[Record], entry: Entry) -> Record:
    """The record that a mapping describes; CocorosimError for unknown or missing keys and bad values."""
    readable = [field for field in dataclasses.fields(kind) if "read" in field.metadata]  # type: ignore[arg-type]
    rules = {key_of(field): field for field in readable if not field.metadata.get("others")}
    required = [key for key, field in rules.items() if is_required(field)]
    collected = next((field for field in readable if field.metadata.get("others")), None)
    others = {} if collected is None else _flags_beside(rules, entry)
    section = entry.section(required, (*rules, *others))
    values = {rules[key].name: rules[key].metadata["read"](part) for key, part in section.items() if key in rules}
    if collected is not None:
        values[collected.name] = others
    return kind(**values)


def record_tree(record: Any) -> dict[str, Any]:
    """The record as nested plain values, as `read_record` reads them; without None and empty mappings."""
    fields = [field for field in dataclasses.fields(record) if "write" in field.metadata]
    values = [(field, getattr(record, field.name)) for field in fields]
    tree: dict[str, Any] = {}
    for field, value in values:
        if value is not None and value != {}:
            written = field.metadata["write"](value)
            tree |= written if field.metadata.get("others") else {key_of(field): written}
    return tree


def _flags_beside(rules: Mapping[str, Any], entry: Entry) -> dict[str, bool]:
    """What stands in a mapping beside the keys of `rules`, as far as it is true or false."""
    return {
        key: part.flag() for key, part in entry.mapping().items() if key not in rules and isinstance(part.value, bool)
    }


def key_of(field: dataclasses.Field[Any]) -> str:
    """How YAML calls a field."""
    return field.metadata["key"] or field.name


def is_required(field: dataclasses.Field[Any]) -> bool:
    """Whether the key of a field must be there."""
    return field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING


def _type_of(entry: Entry, kind: type[Any] | Mapping[str, type[Any]]) -> type[Any]:
    if isinstance(kind, type):
        return kind
    entries = entry.mapping()
    if "kind" not in entries:
        raise entry.problem("lacks 'kind'; allowed: " + ", ".join(kind) + ".")
    return kind[entries["kind"].choice(list(kind))]
