"""Families of the registered table families.yaml: which members there are, and which of them a recording draws.

Numbers of sealed members are drawn by a seed that follows from a public word; see `table_of`.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from ruamel.yaml import YAML

FAMILIES = Path(__file__).with_name("families.yaml")
DRAWN = ("forms", "noises", "plans", "arenas")
Numbers = dict[str, Any]


@dataclass(frozen=True)
class Members:
    """What one recording drew: a member of each family, by name and by numbers."""

    forms: dict[str, str] = field(default_factory=dict)  # name of the form by effect
    noise: str = "white"
    plan: str = "rich"
    arena: str = "square"


def seed_of(word: str) -> int:
    """The first eight bytes of the SHA-256 of a public word and of what the seed is for."""
    return int.from_bytes(hashlib.sha256(f"{word} families".encode()).digest()[:8], "big") >> 1


def _drawn(rng: np.random.Generator, numbers: Numbers) -> Numbers:
    """A member's numbers, to four digits: those that are ranges are drawn."""
    return {
        key: float(f"{rng.uniform(*value):.4g}") if isinstance(value, list) else value for key, value in numbers.items()
    }


def _family(rng: np.random.Generator, family: Numbers, members: int) -> Numbers:
    """All members by name, each saying whether it was sealed."""
    out = {name: numbers | {"sealed": False} for name, numbers in family["open"].items()}
    for name, numbers in family["sealed"].items():
        for k in range(members):
            out[f"{name}_{k + 1}"] = _drawn(rng, numbers) | {"sealed": True}
    return out


def table_of(word: str, path: Path = FAMILIES) -> Numbers:
    """The table with all numbers, of a public word that is not known before the code is frozen: a commit's name.

    Raises ValueError if the word is empty.
    """
    if not word:
        raise ValueError("families need a public word that gives the numbers of their sealed members")
    registered = dict(YAML(typ="safe").load(path.read_text(encoding="utf-8")))
    rng = np.random.default_rng(seed_of(word))
    table = registered | {name: _family(rng, registered[name], int(registered["members"])) for name in DRAWN}
    grammar, sealed = registered["grammar"], registered["grammar"]["sealed"]
    factors = {n: {"scale": s, "powers": grammar["open"]["powers"]} for n, s in grammar["open"]["regressors"].items()}
    for name, scale in sealed["regressors"].items():
        powers = [round(float(rng.uniform(*sealed["powers"])), 1) for _ in grammar["open"]["powers"]]
        factors[name] = {"scale": scale, "powers": powers}
    period = float(f"{rng.uniform(*sealed['period']):.3g}")
    shared = {"equations": grammar["equations"], "second": grammar["second"]}
    return table | {"word": word, "grammar": shared | {"regressors": factors, "period": period}}


def digest(table: Numbers) -> str:
    """SHA-256 of a table: what is published before the tool runs."""
    return hashlib.sha256(json.dumps(table, sort_keys=True).encode()).hexdigest()


def _form_of(rng: np.random.Generator, table: Numbers, effect: str) -> str:
    """A form that the effect may take; each registered kind is as probable as another."""
    kinds = table["forms_of"].get(effect, ["plain"])
    kind = str(rng.choice(kinds))
    members = [name for name in table["forms"] if name == kind or name.rpartition("_")[0] == kind]
    return str(rng.choice(members))


def members(rng: np.random.Generator, table: Numbers, effects: list[str]) -> Members:
    """What a recording with these effects draws; half of noises, plans and arenas are open ones."""
    chosen = {}
    for family in DRAWN[1:]:
        sealed = bool(rng.random() < 0.5)
        names = [name for name, numbers in table[family].items() if numbers["sealed"] == sealed]
        chosen[family] = str(rng.choice(names))
    forms = {effect: _form_of(rng, table, effect) for effect in effects}
    return Members(forms, chosen["noises"], chosen["plans"], chosen["arenas"])
