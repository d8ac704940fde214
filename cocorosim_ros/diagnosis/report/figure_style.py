"""Style of all figures of a report, and their form inside its page."""

from __future__ import annotations

import io
import math
import re
from dataclasses import dataclass
from typing import Any

import matplotlib
import numpy as np
from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.quantity_text import Scale

WIDTH = 9.6  # inches
BEFORE, AFTER, NOMINAL, MEASURED = "#d9792b", "#2f7fc1", "#a05195", "#808a94"
QUIET = "#8a94a0"
# Replaced by the colour of the page's text, which is dark on light or light on dark.
INK = "#010203"
_STYLE: dict[Any, Any] = {
    "svg.fonttype": "none",
    "svg.hashsalt": "cocorosim",
    "font.family": "sans-serif",
    "font.size": 9.5,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": QUIET,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.titlelocation": "left",
    "axes.titlesize": 10,
    "legend.frameon": False,
    "axes.unicode_minus": True,
}


@dataclass(frozen=True)
class Margins:
    """Room around the panels, and between them [inches]; a layout found by measuring all texts takes twice as long."""

    left: float = 0.85
    right: float = 0.12
    top: float = 0.34
    bottom: float = 0.52
    across: float = 0.6
    down: float = 0.55


USUAL = Margins()


class Drawing:
    """A figure in the style of the reports: `with Drawing(rows, columns, height) as drawing: drawing.axes[0, 0]...`.

    height and width [inches] of the whole figure; after the block `svg` is its text for the page.
    """

    def __init__(self, rows: int, columns: int, height: float, margins: Margins = USUAL, width: float = WIDTH) -> None:
        self._context = matplotlib.rc_context(_STYLE)
        self._shape = (rows, columns, height)
        self._width = width
        self._margins = margins
        self.svg = Markup("")

    def __enter__(self) -> Drawing:
        self._context.__enter__()
        rows, columns, height = self._shape
        self.figure = Figure(figsize=(self._width, height))
        self.axes = self.figure.subplots(rows, columns, squeeze=False, gridspec_kw=self._grid())
        return self

    def __exit__(self, *error: object) -> None:
        try:
            if error[0] is None:
                self.svg = _inline_svg(self.figure)
        finally:
            self._context.__exit__(None, None, None)

    def legend(self) -> None:
        """Draw the names of the lines of the first panel above the panels, to the right."""
        handles, labels = self.axes[0, 0].get_legend_handles_labels()
        top = 1.0 - 0.02 / self._shape[2]
        self.figure.legend(
            handles, labels, loc="upper right", bbox_to_anchor=(1.0, top), ncols=len(labels), borderaxespad=0.0
        )

    def _grid(self) -> dict[str, float]:
        """Margins as shares of the figure; gaps as shares of a panel."""
        rows, columns, height = self._shape
        room = self._margins
        wide = (self._width - room.left - room.right - room.across * (columns - 1)) / columns
        high = (height - room.top - room.bottom - room.down * (rows - 1)) / rows
        return {
            "left": room.left / self._width,
            "right": 1.0 - room.right / self._width,
            "top": 1.0 - room.top / height,
            "bottom": room.bottom / height,
            "wspace": room.across / wide,
            "hspace": room.down / high,
        }


def style_axes(axes: Axes, ticks: int = 5) -> None:
    """Give axes few ticks in plain numbers, along x about `ticks`, a pale grid and no box."""
    for axis, most in ((axes.xaxis, ticks), (axes.yaxis, 5)):
        axis.set_major_locator(MaxNLocator(most, steps=[1, 2, 2.5, 5, 10]))
        axis.set_major_formatter(FuncFormatter(_tick))
    axes.grid(color=QUIET, alpha=0.25, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def labelled(name: str, scale: Scale, between: str = " ") -> str:
    """The text beside an axis: name and unit, with `between` them a space or a new line."""
    return f"{name}{between}[{scale.unit}]" if scale.unit else name


def thinned(values: Floats, most: int = REPORT.most_points) -> Floats:
    """Means over equal stretches along the first axis, at most `most` of them."""
    if len(values) <= most:
        return values
    return np.array([part.mean(axis=0) for part in np.array_split(values, most)])


def _tick(value: float, position: int | None) -> str:
    return f"{value:.10g}".replace("-", "\u2212") if abs(value) >= 1e-4 or value == 0 else f"{value:.6f}"


def _inline_svg(figure: Figure) -> Markup:
    stream = io.StringIO()
    figure.savefig(stream, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    # Several figures share a page, where names of groups would repeat and fixed sizes would not fit a phone.
    text = re.sub(r'<g id="[^"]*">', "<g>", text)
    text = re.sub(r'(<svg [^>]*?) width="[^"]*"', r"\1", text, count=1, flags=re.DOTALL)
    text = re.sub(r'(<svg [^>]*?) height="[^"]*"', r"\1", text, count=1, flags=re.DOTALL)
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    return Markup(text.replace(INK, "currentColor"))


def largest(values: Floats) -> float:
    """The largest finite magnitude, 0 without any."""
    finite = np.abs(values[np.isfinite(values)])
    return float(finite.max()) if finite.size and math.isfinite(float(finite.max())) else 0.0
