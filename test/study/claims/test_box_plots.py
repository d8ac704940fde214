"""Box plots: names of groups do not lie over each other, however many there are."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest
from matplotlib.figure import Figure

from cocorosim_ros.study.metrics import PAPER_METRICS
from cocorosim_ros.study.results.box_plots import figure_of


@pytest.mark.parametrize("count", [3, 6, 18])
def test_names_can_be_read(made_up: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    """Of three groups as in the paper and of eighteen with names as long as those of choices."""
    drawn: list[Figure] = []
    save = Figure.savefig

    def keep(figure: Figure, *arguments: Any, **options: Any) -> None:
        save(figure, *arguments, **options)
        drawn.append(figure)

    monkeypatch.setattr(Figure, "savefig", keep)
    groups = tuple(f"BLC, units + {place}" if count > 6 else f"T5e-{place}" for place in range(count))
    figure_of(made_up("boids_choices", groups, {}), "paper", list(PAPER_METRICS))
    assert len(drawn[0].axes) == 6
    for axes in drawn[0].axes:
        labels = [label.get_window_extent() for label in axes.get_xticklabels()]
        assert len(labels) == count and all(left.x1 <= right.x0 for left, right in pairwise(labels))
