"""Which sources a module is made of: its own and those of all that it imports from this package, one after the other.

Imports are read as text, those below `if` and inside functions too: a module that is named is a module that counts. The
package itself (`from cocorosim_ros import __version__`) does not, as it names every wing for its users' convenience.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parents[2]
_FROM = re.compile(r"^[ \t]*from[ \t]+cocorosim_ros\.([\w.]+)[ \t]+import[ \t]+(\([^)]*\)|[^\n#]+)", re.MULTILINE)
_PLAIN = re.compile(r"^[ \t]*import[ \t]+cocorosim_ros\.([\w.]+)", re.MULTILINE)
_NAME = re.compile(r"(\w+)(?:\s+as\s+\w+)?")


def sources_of(file: Path, package: Path = PACKAGE) -> frozenset[Path]:
    """The file and every file of the package that it needs, directly or through others."""
    found, waiting = set(), [file]
    while waiting:
        source = waiting.pop()
        if source not in found:
            found.add(source)
            waiting += _imported(source, package)
    return frozenset(found)


def digest_of(files: Iterable[Path], *words: str) -> str:
    """First 16 hex digits of the SHA-256 over these files, their places in the package, and words."""
    digest = hashlib.sha256(" ".join(words).encode())
    for name, content in sorted((_name(file), _content_digest(file)) for file in files):
        digest.update(name.encode() + content)
    return digest.hexdigest()[:16]


def _imported(source: Path, package: Path) -> tuple[Path, ...]:
    return _imported_now(source, package, *_state(source))


@cache
def _imported_now(source: Path, package: Path, *_: int) -> tuple[Path, ...]:
    text = source.read_text(encoding="utf-8")
    files: list[Path | None] = [_file_of(module, package) for module in _PLAIN.findall(text)]
    for module, names in _FROM.findall(text):
        files.append(_file_of(module, package))
        files += [_file_of(f"{module}.{name}", package) for name in _NAME.findall(names)]
    return tuple(file for file in files if file is not None)


def _file_of(module: str, package: Path) -> Path | None:
    """The file of a module by its name below the package; None for what is none, as a function of a module."""
    place = package.joinpath(*module.split("."))
    candidates = (place.with_name(f"{place.name}.py"), place / "__init__.py")
    return next((file for file in candidates if file.is_file()), None)


def _content_digest(file: Path) -> bytes:
    return _content_digest_now(file, *_state(file))


@cache
def _content_digest_now(file: Path, *_: int) -> bytes:
    return hashlib.sha256(file.read_bytes()).digest()


def _state(file: Path) -> tuple[int, int]:
    """What changes when a file is written again: what was read of it before then counts no more."""
    status = file.stat()
    return status.st_mtime_ns, status.st_size


def _name(file: Path) -> str:
    """The same name for the same file of the package, wherever the package lies."""
    parts = file.parts
    last = max((place for place, part in enumerate(parts) if part == PACKAGE.name), default=len(parts) - 2)
    return "/".join(parts[last:])
