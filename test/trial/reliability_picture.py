"""The reliability diagram: how often what was told with a probability came true, with 95 % intervals."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.figure import Figure

TITLES = {"by_most_probable": "the most probable answer", "by_any": "all answers"}


def draw(found: Mapping[str, Any], path: Path) -> None:
    """Writes an SVG of the classes of `calibration` of the Scorer; the same classes make the same bytes."""
    with rc_context({"svg.hashsalt": "reliability", "font.size": 9.0}):
        figure = Figure(figsize=(7.0, 4.2), layout="constrained")
        for axes, (key, title) in zip(figure.subplots(1, len(TITLES), sharey=True), TITLES.items(), strict=True):
            _panel(axes, found[key])
            axes.set(title=title, xlabel="told [%]", xlim=(-3, 103), ylim=(-3, 103), aspect="equal")
        figure.axes[0].set_ylabel("came true [%]")
        figure.savefig(path, format="svg", metadata={"Date": None})


def _panel(axes: Any, rows: list[dict[str, Any]]) -> None:
    """A dot for each class, its interval, and how many answers it holds; grey: told as it happens."""
    axes.plot([0, 100], [0, 100], color="0.7", linewidth=1.0)
    for row in rows:
        mean, came, low, high = (100.0 * row[key] for key in ("mean", "rate", "low", "high"))
        axes.plot([mean, mean], [low, high], color="tab:blue", linewidth=1.0)
        axes.plot(mean, came, "o", color="tab:blue", markersize=4.0)
        axes.annotate(str(row["of"]), (mean, came), (4, -9), textcoords="offset points", fontsize=7.0)
