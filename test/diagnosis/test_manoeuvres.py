"""Which manoeuvre is advised."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from cocorosim_ros.diagnosis.manoeuvres import MANOEUVRES, advise, advised, manoeuvre_of


def effect(name: str, *rivals: str) -> Any:
    """One that was found, with what is nearly as good."""
    return SimpleNamespace(id=name, ambiguous_with=tuple(SimpleNamespace(id=rival) for rival in rivals))


def test_rivals_come_before_what_was_not_seen() -> None:
    """What separates the found effect from its rival."""
    found = [effect("thruster_lag", "pump_lag")]
    assert set(advised(found, ["wall_effect"])) == {manoeuvre_of("thruster_lag"), manoeuvre_of("pump_lag")}


def test_what_was_not_seen_is_shown_whatever_was_found() -> None:
    """A mismatch without rivals leaves as much out of sight as no mismatch does."""
    for found in ([], [effect("thruster_lag")]):
        assert advised(found, ["wall_effect"]) == ("along_wall",)
        assert advise(found, ["wall_effect"]) == MANOEUVRES["along_wall"].capitalize() + "."
    assert advise([effect("thruster_lag")], []) is None
