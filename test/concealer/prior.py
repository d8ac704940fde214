"""Draws what a recording holds from the registered prior."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from ruamel.yaml import YAML

from concealer.manoeuvres import CANNOT_SHOW

PRIOR = Path(__file__).with_name("prior.yaml")
KINDS = ("nothing", "recalibration", "single", "several", "outside", "cannot_tell")


@dataclass(frozen=True)
class Wish:
    """What is asked for instead of drawn; None and empty are drawn."""

    kind: str | None = None
    effects: tuple[str, ...] = ()
    size: float | None = None
    noise: float | None = None
    robots: int | None = None
    manoeuvre: str | None = None
    duration: float | None = None


@dataclass
class Plot:
    """What one recording will hold."""

    kind: str
    hidden: dict[str, float] = field(default_factory=dict)  # size (fraction of large) by effect
    noise: float = 0.0
    correlation: float = 2.0
    robots: int = 1
    manoeuvre: str = "rich"
    duration: float = 600.0
    side: float = 5.0
    arena: tuple[float, float, float] = (1.0, 1.0, 1.0)  # factors of the side along x and y, and of the depth
    style: tuple[float, float, float] = (1.0, 1.0, 0.0)  # of the programmes: manoeuvres.py


def load(path: Path = PRIOR) -> dict[str, Any]:
    """The prior as plain dictionaries."""
    return dict(YAML(typ="safe").load(path.read_text(encoding="utf-8")))


def entries(numbers: dict[str, Any]) -> dict[str, Any]:
    """All that may be hidden, by name: what is drawn, and what is hidden only where it is asked for."""
    return dict(numbers["effects"] | numbers.get("asked_for", {}) | numbers["outside"])


def pick(rng: np.random.Generator, weights: dict[Any, float]) -> Any:
    """A key by its weight."""
    keys = list(weights)
    share = np.array([weights[key] for key in keys], dtype=float)
    return keys[int(rng.choice(len(keys), p=share / share.sum()))]


def size(rng: np.random.Generator, prior: dict[str, Any], kind: str) -> float:
    """A size, log-uniform from the kind's smallest to 1."""
    return float(np.exp(rng.uniform(np.log(prior["smallest"][kind]), 0.0)))


def suspects(rng: np.random.Generator, prior: dict[str, Any], kind: str, manoeuvre: str) -> list[str]:
    """Names of what is hidden in a recording of this kind."""
    if kind in ("nothing", "recalibration"):
        return []
    if kind == "outside":
        return [str(rng.choice(list(prior["outside"])))]
    if kind == "cannot_tell":
        return [str(rng.choice(CANNOT_SHOW[manoeuvre]))]
    if kind == "single":
        return [str(rng.choice(list(prior["effects"])))]
    count = 3 if rng.random() < prior["three_of_several"] else 2
    sociable = [name for name in prior["effects"] if name not in prior["alone"]]
    return [str(name) for name in rng.choice(sociable, count, replace=False)]


def draw(rng: np.random.Generator, prior: dict[str, Any], wish: Wish) -> Plot:
    """What one recording holds. Every draw is made whether or not it is used, so wishes do not shift the others."""
    kind = pick(rng, prior["composition"])
    poor = str(rng.choice(prior["cannot_tell"]))
    noise, robots = pick(rng, prior["noise"]), pick(rng, prior["robots"])
    correlation = float(np.exp(rng.uniform(*np.log(prior["correlation"]))))
    side = float(rng.uniform(*prior["tank"]["side"]))
    kind = wish.kind or kind
    manoeuvre = wish.manoeuvre or (poor if kind == "cannot_tell" else "rich")
    names = list(wish.effects) or suspects(rng, prior, kind, manoeuvre)
    hidden = {name: wish.size or size(rng, prior, kind) for name in names}
    if "frame_mixup" in hidden:
        hidden["frame_mixup"] = 1.0  # it is there or not
    plot = Plot(kind, hidden, float(noise if wish.noise is None else wish.noise), correlation)
    plot.robots, plot.manoeuvre, plot.side = int(wish.robots or robots), manoeuvre, side
    plot.duration = float(wish.duration or prior["duration"])
    if "neighbour_wake" in hidden:
        plot.robots = max(plot.robots, 2)
    if manoeuvre == "idle":
        plot.noise, plot.correlation, plot.side = min(plot.noise, 0.01), min(correlation, 3.0), 6.0
    return plot
