"""A page about experiments: figures and tables in one HTML file that needs nothing else."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.pictures.page import page_template
from cocorosim_ros.study.results.box_plots import figure_of
from cocorosim_ros.study.results.effect_size import Effect
from cocorosim_ros.study.results.results import Results, Spread
from cocorosim_ros.study.results.sample_size import Consistency, baseline_consistency, median_by_chance

_SIGNS = {"higher": "\u25b2", "lower": "\u25bc", "same": "="}
_TEMPLATE = "report.html.jinja"


def render_report(experiments: Sequence[Results]) -> str:
    """The page as text."""
    template = page_template(Path(__file__).parent, _TEMPLATE)
    return template.render(experiments=[_chapter(results) for results in experiments])


def _chapter(results: Results) -> dict[str, Any]:
    against = {group: results.baseline_of(group) for group in results.groups}
    runs = min(_runs(results, kind, group) for kind in results.numerics for group in results.groups)
    return {
        "about": results.about,
        "runs": results.table.num_rows,
        "asked": results.about["replicates"] * len(results.about["cells"]),
        "per_group": runs,
        "hours": sum(results.table["wall_seconds"].to_pylist()) / 3600,
        "auv_ticks": sum(results.table["ticks"].to_pylist()) * results.about["robots"],
        "versions": sorted(set(results.table["version"].to_pylist())),
        "groups": {cell["group"]: cell["description"] for cell in results.about["cells"]},
        "against": against,
        "own_baselines": set(against.values()) != {results.baseline},
        "sections": [_section(results, kind) for kind in results.numerics],
    }


def _section(results: Results, numerics: str) -> dict[str, Any]:
    metrics = results.about["metrics"]
    others = [group for group in results.groups if group != results.baseline]
    return {
        "numerics": numerics,
        "figure": figure_of(results, numerics, list(metrics)),
        "effects": [
            (group, [_shown_effect(results.effect(numerics, group, name)) for name in metrics]) for group in others
        ],
        "consistency": [_shown_consistency(found) for found in baseline_consistency(results, numerics, metrics)],
        "spreads": [_all_spreads(results, numerics, name) for name in METRICS],
        "scenarios": [cell for cell in results.about["cells"] if cell["numerics"] == numerics],
    }


def _all_spreads(results: Results, numerics: str, name: str) -> dict[str, Any]:
    """A metric in all groups, as its own definition sums up a run and as mean and median over time."""
    metric = METRICS[name]
    columns = {"value": name, "time mean": f"{name}_time_mean", "time median": f"{name}_time_median"}
    return {
        "name": name,
        "unit": "" if metric.unit == "1" else metric.unit,
        "formula": metric.formula,
        "summary": metric.summary,
        "paper": metric.paper,
        "lines": [
            (label, [_shown_cell(results, numerics, group, column) for group in results.groups])
            for label, column in columns.items()
        ],
    }


def _shown_cell(results: Results, numerics: str, group: str, column: str) -> dict[str, str]:
    shown = {"spread": _shown_spread(results.spread(numerics, group, column)), "effect": "", "size": "baseline"}
    if group != results.baseline:
        found = results.effect(numerics, group, column)
        shown |= {"effect": _two(found.value), "size": found.size}
    return shown


def _shown_spread(spread: Spread) -> str:
    if spread.runs == 0:
        return "\u2013"
    return f"{_digits(spread.median)} ({_digits(spread.lower)} \u2026 {_digits(spread.upper)})"


def _shown_effect(found: Effect) -> dict[str, str]:
    return {
        "value": _two(found.value),
        "interval": f"{_two(found.low)} \u2026 {_two(found.high)}",
        "size": found.size,
        "sign": _SIGNS[found.direction],
    }


def _shown_consistency(found: Consistency) -> dict[str, Any]:
    low, high = (100 * share for share in found.enough_interval)
    return {
        "runs": found.runs,
        "each": [_two(score) for score in found.each],
        "all": _two(found.median_of_largest),
        "enough": f"{100 * found.enough:.0f} % ({low:.0f} \u2026 {high:.0f} %)",
        "chance": _two(median_by_chance(found.runs)),
    }


def _runs(results: Results, numerics: str, group: str) -> int:
    return int(results.values(numerics, group, "replicate").size)


def _two(value: float) -> str:
    return "\u2013" if math.isnan(value) else f"{value:.3f}"


def _digits(value: float) -> str:
    return f"{value:.4g}"
