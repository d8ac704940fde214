"""One copy of the package for all recipes, since each copy compiles everything anew."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from .recipes import ONE_FILE_ONE_LINE, python_in, tree_with

OTHERS = ("Add a controller", "Add a metric", "Add a current", "Add a message", "Add a format of logs")


@pytest.fixture(scope="session")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy in which all recipes were followed."""
    return tree_with((*ONE_FILE_ONE_LINE, *OTHERS), tmp_path_factory.mktemp("recipes"))


@pytest.fixture(scope="session")
def python(tree: Path) -> Callable[..., str]:
    """Function of words: what Python prints, with the copy first on its path, and with a cache of its own."""
    return python_in(tree)
