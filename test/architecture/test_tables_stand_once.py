"""Regressors, readings, equations and units stand in one table each: no other module spells such a table again."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from cocorosim_ros.foundation.units.units import DIMENSIONS
from cocorosim_ros.world.laws.readings import READING_CODE
from cocorosim_ros.world.terms.regressors import REGRESSOR

PACKAGE = Path(__file__).parents[2] / "cocorosim_ros"
HOMES = ("world/terms", "world/laws", "foundation/units")
UNITS = {unit.symbol for units in DIMENSIONS.values() for unit in units if unit.symbol != "1"}
PLACE = {"x", "y", "z", "yaw", "t", "1"}  # names of axes and of time, which much else has
# By file: why it may.
ALLOWED = {
    "diagnosis/foretelling/nameless_force.py": "the regressors whose products a force without a name is made of",
    "diagnosis/report/believable.py": "how large a number of each unit can be at all",
    "diagnosis/tracks/vehicle_size.py": "sizes of a vehicle by unit, which are to follow from the units themselves",
    "diagnosis/catalogue/shown_by.py": "which readings show each state that an error of a reading may depend on",
}
TABLES = ((set(REGRESSOR), 3), (UNITS, 3), (set(READING_CODE), 6))
"""Names, and how many of them as keys of a mapping are a table of facts about them; effects have errors of readings."""
ENTRIES = 8
"""So many names in a sequence are the table again; fewer are a choice from it."""


def repeated(tree: ast.AST) -> Iterator[str]:
    """Names of the first kind of table that a literal spells again, of each literal that does."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict):
            parts: list[ast.expr | None] = list(node.keys)
        elif isinstance(node, (ast.Tuple, ast.List, ast.Set)):
            parts = list(node.elts)
        else:
            continue
        words = [part.value for part in parts if isinstance(part, ast.Constant)]
        for table, keys in TABLES:
            found = [word for word in words if isinstance(word, str) and word in table]
            most = keys if isinstance(node, ast.Dict) else ENTRIES
            if len(found) >= most and not set(found) <= PLACE and 2 * len(found) > len(words):
                yield f"line {node.lineno}: {', '.join(found)}"


def offences() -> dict[str, list[str]]:
    """By file of the package, the literals that spell a table again."""
    found = {}
    for file in sorted(PACKAGE.rglob("*.py")):
        name = file.relative_to(PACKAGE).as_posix()
        lines = [] if name.startswith(HOMES) else list(repeated(ast.parse(file.read_text(encoding="utf-8"))))
        if lines:
            found[name] = lines
    return found


def test_no_module_spells_a_table_again() -> None:
    """Beside the few that are allowed to, each with its reason."""
    assert {name: lines for name, lines in offences().items() if name not in ALLOWED} == {}


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ('UNITS = {"u": "m/s", "v": "m/s", "thrust": "N"}', 1),
        ('f({"compass": 1, "pressure": 2, "gyro_z": 3, "pose_x": 4, "pose_y": 5, "pose_z": 6})', 1),
        ('FACTORS = {"m": 1.0, "kg": 1.0, "N": 1.0}', 1),
        ('NAMES = ("1", "x", "y", "z", "t", "u", "v", "w", "r", "speed")', 1),
        ('PLACE = {"x": 0, "y": 1, "z": 2, "yaw": 3}', 0),
        ('CHOSEN = ("u", "thrust", "speed")', 0),
        ('CHANNELS = {"position": "m", "heading": "rad", "depth": "m"}', 0),
    ],
)
def test_a_planted_table_is_found(text: str, lines: int) -> None:
    """Tables are, choices and places are not."""
    assert len(list(repeated(ast.parse(text)))) == lines


def test_the_text_of_a_law_is_spelled_in_one_place() -> None:
    """What begins it stands in world/laws/law.py alone."""
    for file in sorted(PACKAGE.rglob("*.py")):
        strings = {
            node.value
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
            if isinstance(node, ast.Constant) and isinstance(node.value, str)
        }
        spelled = {text for text in strings if text.startswith("unknown:")}
        assert not spelled or (file.name == "law.py" and file.parent.name == "laws"), (file, spelled)
