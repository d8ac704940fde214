"""The keys of scenarios and platforms, from the records that read them; those of maps, from their manual."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.library.explaining.explanation import Explanation, first_of
from cocorosim_ros.library.explaining.readers import readers
from cocorosim_ros.library.explaining.shipped import rows_of_manual, values
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.records import is_required, key_of
from cocorosim_ros.scenario.scenario import Scenario

_SENTENCES = re.compile(r"(?<=\.)\s+|;\s+(?![^\[(]*[\])])")


@dataclass(frozen=True)
class _Kind:
    """One kind of file: its folder below config, how its keys are called, and the heading of its manual."""

    folder: str
    called: str
    record: type
    owner: str  # what the code calls such a record
    heading: str


_KINDS = (
    _Kind("scenarios", "key of a scenario", Scenario, "scenario", "A scenario, key by key"),
    _Kind("platforms", "key of a platform", Platform, "platform", "A platform, key by key"),
)


def file_keys() -> Iterator[Explanation]:
    """Every key of scenarios, platforms and maps."""
    for kind in _KINDS:
        yield from _keys_of(kind, kind.record, "", kind.owner)
    for key, words in rows_of_manual("A map, key by key").items():
        yield Explanation(key, "key of a map", words, {"stands in": _stands_in("maps", key)})


def _keys_of(kind: _Kind, record: type, above: str, owner: str) -> Iterator[Explanation]:
    """The keys of a record and of those inside it."""
    for field in dataclasses.fields(record):
        if "read" not in field.metadata or field.metadata.get("others"):
            continue
        key = f"{above}{key_of(field)}"
        yield _explained(kind, key, field, record, owner)
        for name, form in field.metadata.get("also", {}).items():
            described = field.metadata.get("described_by", field.metadata.get("inside", record))
            yield _of_words(kind, f"{key}.{name}", form, described)
        for inside in _records(field.metadata.get("inside")):
            yield from _keys_of(kind, inside, f"{key}.", field.name)


def _records(inside: Any) -> tuple[type, ...]:
    """The records that may stand under a key."""
    if inside is None:
        return ()
    return tuple(inside.values()) if isinstance(inside, Mapping) else (inside,)


def _explained(kind: _Kind, key: str, field: dataclasses.Field[Any], record: type, owner: str) -> Explanation:
    facts = {"form": field.metadata["form"], "default": _default(field)}
    manual = _row(kind, key)
    if manual:
        facts["manual"] = manual
    facts["stands in"] = _stands_in(kind.folder, key)
    names = (field.name, field.name.removesuffix("_ns"))
    users = readers((owner, owner.removesuffix("s"), owner.removesuffix("es")), names)
    return Explanation(key, kind.called, _clause(record, field.name, key_of(field)), _without_empty(facts), users)


def _of_words(kind: _Kind, key: str, form: str, record: type) -> Explanation:
    """A key that is read beside the fields of its record."""
    facts = {"form": form, "manual": _row(kind, key), "stands in": _stands_in(kind.folder, key)}
    return Explanation(key, kind.called, _clause(record, key.rpartition(".")[2], ""), _without_empty(facts))


def _without_empty(facts: Mapping[str, str]) -> dict[str, str]:
    return {name: words for name, words in facts.items() if words}


def _default(field: dataclasses.Field[Any]) -> str:
    if is_required(field):
        return "none: it must be given"
    value = field.default if field.default is not dataclasses.MISSING else None
    if value is None or value == ():
        return "none: it may be left out"
    written = field.metadata["write"](value)
    return str(written).lower() if isinstance(written, bool) else str(written)


def _clause(record: type, *names: str) -> str:
    """What the record's own text says of one of its fields: the first sentence that names it, or the first one."""
    text = " ".join((record.__doc__ or "").split("Args:")[0].split())
    sentences = [part.strip() for part in _SENTENCES.split(text)]
    named = [part for part in sentences if any(re.search(rf"\b{re.escape(name)}\b", part) for name in names if name)]
    return f"{(named or sentences)[0].rstrip('.')}."


def _row(kind: _Kind, key: str) -> str:
    """What the manual says of the key, or of what it stands in."""
    rows = rows_of_manual(kind.heading)
    while key and key not in rows:
        key = key.rpartition(".")[0]
    return rows.get(key, "")


def _stands_in(folder: str, key: str) -> str:
    """The shipped files that have the key, and what they say there, files that say the same together."""
    alike: dict[str, list[str]] = {}
    for name, words in values(folder).get(key, {}).items():
        alike.setdefault("; ".join(words[:3]), []).append(name)
    return "; ".join(f"{first_of(names)}: {words}" if words else first_of(names) for words, names in alike.items())
