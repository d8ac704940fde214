"""Configuration files that differ from another one in a few keys: `based_on: NAME` takes the rest from there."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from cocorosim_ros.scenario.reading.config_files import referenced_config
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.sources import require_sources
from cocorosim_ros.scenario.reading.yaml_file import load_yaml


def with_base(entry: Entry, kind: str, merged: tuple[str, ...] = (), derived: tuple[Path, ...] = ()) -> Entry:
    """The entry with the keys that it lacks taken from the file of the same kind that 'based_on' names.

    kind: 'platforms' or 'controllers'. merged: keys whose mappings are merged too, name by name. derived: the files
    that led here. Raises CocorosimError for a file that is based on itself.
    """
    own = dict(entry.mapping())
    if "based_on" not in own:
        return entry
    named = own.pop("based_on")
    path = referenced_config(kind, named).resolve()
    if path in derived:
        raise named.problem(
            f"has {named.found()}, which is based on this {kind.removesuffix('s')} itself; name another."
        )
    base = load_yaml(path)
    require_sources(base)
    inherited = with_base(base, kind, merged, (*derived, path)).mapping()
    for key in merged:
        if key in own and key in inherited:
            own[key] = replace(own[key], value={**inherited[key].mapping(), **own[key].mapping()})
    return replace(entry, value={**inherited, **own})
