"""What is told of one key."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from cocorosim_ros.foundation.card import Card, Shown

CATALOGUE = "effects"
"""The key of a platform below which the catalogue's effects and errors of sensors stand."""
PLACE = "in a platform file"
"""The fact that says where a platform file has it."""
_MOST_NAMED = 4


@dataclass(frozen=True, repr=False)
class Explanation(Shown):
    """One key of a file, effect, number of an effect, error, metric, topic or controller."""

    name: str
    """Dotted from the top of what it belongs to: 'lockstep.patience', 'wall_effect.gain'."""
    kind: str
    """What it is: 'key of a scenario', 'effect', 'metric', ..."""
    meaning: str
    facts: Mapping[str, str] = field(default_factory=dict)
    """Form or unit, default, where it stands with which values and sources, by their names."""
    used_by: tuple[str, ...] = ()
    """Files of the package that read it, and shipped files that ask for it."""

    @property
    def last_word(self) -> str:
        """The name without what it stands in."""
        return self.name.rpartition(".")[2]

    def tree(self) -> dict[str, Any]:
        """The same as plain values, for JSON."""
        return {**asdict(self), "facts": dict(self.facts), "used_by": list(self.used_by)}

    def card(self) -> Card:
        """The meaning and the facts."""
        users = {"used by": ", ".join(self.used_by)} if self.used_by else {}
        return Card(f"{self.kind} {self.name}", {**self.facts, **users}, remarks=(self.meaning,))


def explanation_of(tree: Mapping[str, Any]) -> Explanation:
    """The explanation that `Explanation.tree` has made plain."""
    return Explanation(tree["name"], tree["kind"], tree["meaning"], dict(tree["facts"]), tuple(tree["used_by"]))


def first_of(names: Iterable[str]) -> str:
    """The first few of many names, and how many more there are."""
    every = list(names)
    rest = f" and {len(every) - _MOST_NAMED} more" if len(every) > _MOST_NAMED else ""
    return ", ".join(every[:_MOST_NAMED]) + rest
