"""Which code was examined, by which command, and the seed that follows from it."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]


def git(*words: str) -> str:
    """What git says of this repository; nothing where there is none."""
    try:
        done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""


def seed_of(word: str) -> int:
    """A seed that nobody can choose: the first eight bytes of the SHA-256 of a public word, here a commit's name."""
    return int.from_bytes(hashlib.sha256(word.encode()).digest()[:8], "big") >> 1


def provenance(command: str) -> dict[str, Any]:
    """Command, commit, whether files differ from it, interpreter and processors."""
    return {
        "command": command,
        "commit": git("rev-parse", "HEAD"),
        "changed_files": len(git("status", "--porcelain", "--untracked-files=no").splitlines()),
        "python": sys.version.split()[0],
        "machine": f"{platform.machine()}, {os.cpu_count()} processors",
    }


def noted(out: Path, command: str) -> dict[str, Any]:
    """The provenance of what lies in a folder, which may be gone on with later: as it was when it was begun."""
    file = out / "provenance.json"
    if file.exists():
        found: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
        return found
    source = provenance(command)
    note(out, source)
    return source


def note(out: Path, source: dict[str, Any]) -> None:
    """Writes the provenance of what lies in a folder."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "provenance.json").write_text(json.dumps(source, indent=1) + "\n", encoding="utf-8")


def sentence(source: dict[str, Any]) -> str:
    """Command and commit, for a page."""
    return f"Made by `{source['command']}` at commit `{source['commit']}`."
