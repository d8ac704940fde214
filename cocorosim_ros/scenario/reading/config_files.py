"""Where configuration files lie: by name in the project's config folder, or by path."""

from __future__ import annotations

import os
from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.installation import PACKAGE, ament_prefixes, own_prefixes
from cocorosim_ros.scenario.reading.entry import Entry, nearest

_CHECKOUT = Path(__file__).resolve().parents[3]


def config_folders() -> list[Path]:
    """The config folders there are: the checkout's, those of this installation, then those of AMENT_PREFIX_PATH."""
    installed = [prefix / "share" / PACKAGE / "config" for prefix in (*own_prefixes(), *ament_prefixes())]
    # A bare `config` beside an installed package would be somebody else's.
    checkout = [_CHECKOUT / "config"] if (_CHECKOUT / "package.xml").is_file() else []
    return [folder for folder in (*checkout, *installed) if folder.is_dir()]


def shipped_file(relative: str) -> Path:
    """A file that ships in the config folder, such as middleware/fastdds_local.xml.

    Raises CocorosimError if the installation lacks it.
    """
    for folder in config_folders():
        if (folder / relative).is_file():
            return folder / relative
    raise CocorosimError(f"The file config/{relative} is missing; install cocorosim_ros again.")


def config_names(kind: str) -> list[str]:
    """The sorted names of all files of a kind: 'scenarios', 'platforms' or 'controllers'."""
    return sorted({path.stem for folder in config_folders() for path in (folder / kind).glob("*.yaml")})


def find_config(kind: str, name_or_path: str) -> Path:
    """The path of a configuration file by name or by path; kind: 'scenarios', 'platforms', 'controllers'.

    Raises CocorosimError for a name that nothing has; a path that does not exist is left to whoever reads it.
    """
    path = _located(kind, name_or_path, Path())
    if path is None:
        name = name_or_path
        if os.path.isdir(name):
            raise CocorosimError(f"'{name}' is a folder, no {_singular(kind)}; name the YAML file in it.")
        raise CocorosimError(
            f"'{name}' is the name of no {_singular(kind)}{nearest(name, config_names(kind))}, or a path."
        )
    return path


def referenced_config(kind: str, entry: Entry) -> Path:
    """The path of the configuration file that an entry names; relative paths count from the entry's own file.

    Raises CocorosimError, naming the entry, for an unknown name and for a path that is no file.
    """
    name = entry.text()
    path = _located(kind, name, Path(entry.file).parent)
    if path is None:
        raise entry.problem(
            f"has '{name}', the name of no {_singular(kind)}{nearest(name, config_names(kind))}, or a path."
        )
    if not os.path.isfile(path):
        raise entry.problem(f"names the file '{path}', which does not exist; correct the path.")
    return path


def _located(kind: str, name_or_path: str, base: Path) -> Path | None:
    if "/" in name_or_path or name_or_path.endswith((".yaml", ".yml")):
        return base / Path(name_or_path).expanduser()
    candidates = (folder / kind / f"{name_or_path}.yaml" for folder in config_folders())
    return next((path for path in candidates if os.path.isfile(path)), None)


def _singular(kind: str) -> str:
    return kind.removesuffix("s")
