"""Salted hashes of envelopes: published before the tool runs, checked when the envelopes are opened."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

LEDGER = "ledger.json"


def canonical(truth: dict[str, Any]) -> bytes:
    """The bytes of an envelope: JSON with sorted keys; it holds its own salt."""
    return (json.dumps(truth, sort_keys=True, indent=1, ensure_ascii=True) + "\n").encode()


def seal(truth: dict[str, Any]) -> str:
    """SHA-256 of an envelope. Raises ValueError if it has no salt of 16 bytes, which would let sizes be guessed."""
    if len(str(truth.get("salt", ""))) < 32:
        raise ValueError("the envelope has no salt of 16 bytes")
    return hashlib.sha256(canonical(truth)).hexdigest()


def file_digest(path: Path) -> str:
    """SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def publish(folder: Path, entries: dict[str, dict[str, str]]) -> Path:
    """Writes the ledger: by recording, the hash of its envelope and that of its data. Refuses to replace one."""
    path = folder / LEDGER
    with path.open("x", encoding="utf-8") as file:
        json.dump({"hash": "sha256", "recordings": entries}, file, indent=1, sort_keys=True)
        file.write("\n")
    return path


def broken_seals(ledger: Path, envelopes: Path, recordings: Path | None = None) -> list[str]:
    """What does not agree with the ledger, one sentence each; nothing where all seals hold."""
    faults = []
    entries = json.loads(ledger.read_text(encoding="utf-8"))["recordings"]
    for name, entry in sorted(entries.items()):
        envelope = envelopes / f"{name}.json"
        if not envelope.exists():
            faults.append(f"{name}: the envelope is missing")
        elif file_digest(envelope) != entry["envelope"]:
            faults.append(f"{name}: the envelope is not the one that was sealed")
        data = None if recordings is None else recordings / name / f"{name}.mcap"
        if data is not None and (not data.exists() or file_digest(data) != entry["recording"]):
            faults.append(f"{name}: the recording is not the one that was sealed")
    strangers = {path.stem for path in envelopes.glob("*.json")} - set(entries)
    return faults + [f"{name}: not in the ledger" for name in sorted(strangers)]
