"""A file that a scenario names: its place, and the digest of its bytes, by which a recorded run stays what it was."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from cocorosim_ros.scenario.reading.entry import Entry


@dataclass(frozen=True)
class StatedFile:
    """A file by its absolute path and the SHA-256 of its bytes."""

    path: str
    sha256: str


def stated_file_text(file: StatedFile) -> dict[str, str]:
    """The file as YAML holds it."""
    return {"path": file.path, "sha256": file.sha256}


def read_stated_file(entry: Entry) -> StatedFile:
    """The file that `path` or {path, sha256} names; a relative path counts from the scenario's folder.

    Raises CocorosimError: no such file, or its bytes differ from the stated digest.
    """
    stated, named = "", naming_entry(entry)
    if named is not entry and "sha256" in (section := entry.mapping()):
        stated = section["sha256"].text()
    path = (Path(entry.file).parent / named.text()).resolve()
    if not path.is_file():
        raise named.problem(f"has '{named.value}', which is no file ({path}); check the path.")
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    if stated and stated != digest:
        raise entry.problem(
            f"names '{named.value}', whose content has changed (SHA-256 {digest[:12]}..., stated {stated[:12]}...); "
            "take the file of then, or remove 'sha256'."
        )
    return StatedFile(str(path), digest)


def naming_entry(entry: Entry) -> Entry:
    """The entry that holds the path: the entry itself, or `path` of its mapping."""
    return entry.section(("path",), ("sha256",))["path"] if isinstance(entry.value, dict) else entry
