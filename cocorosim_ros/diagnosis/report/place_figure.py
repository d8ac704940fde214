"""The missing force over the tank, seen from above, before and after."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import ResidualForce
from cocorosim_ros.diagnosis.report.binned_means import CellEdges, mean_map
from cocorosim_ros.diagnosis.report.figure_style import INK, QUIET, Drawing, Margins, labelled, largest, style_axes
from cocorosim_ros.diagnosis.report.regressors import OF_BODY, residual_of
from cocorosim_ros.diagnosis.report.residual_figures import Pair
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.quantity_text import handy_scale
from cocorosim_ros.world.state.state import X, Y, Z

_CELLS = 12
# Transparent in the middle: a residual of zero shows the page, light or dark.
_STRONG, _MIDDLE = 1.0, 0.6
_COLOURS = LinearSegmentedColormap.from_list(
    "missing",
    [
        (0.13, 0.40, 0.67, _STRONG),
        (0.26, 0.58, 0.76, _MIDDLE),
        (0.50, 0.50, 0.50, 0.0),
        (0.84, 0.38, 0.30, _MIDDLE),
        (0.70, 0.09, 0.17, _STRONG),
    ],
)


@dataclass(frozen=True)
class ForceMap:
    """Mean residual force by cell of the tank seen from above, (rows, columns) each; NaN in cells with few samples."""

    missing: Floats  # from the equation of the picture [N or N m]
    east: Floats  # along x of the world [N]
    north: Floats  # along y of the world [N]


def over_place(pair: Pair, equation: str) -> Markup:
    """Draw mean residuals in cells of the tank: of the equation as colours, of the horizontal force as arrows."""
    edges = _cells(pair.before)
    if edges is None:
        return Markup("")
    maps = [_map_of(shown.residual, equation, edges) for shown in pair.both]
    found = residual_of(equation, pair.before)
    scale = handy_scale(largest(maps[0].missing), found.unit if found else "N")
    # Residuals within the error bands must look pale and short.
    longest = max(_usual_length(maps[0]), 1.96 * float(np.median(pair.before.spread[:, OF_BODY.index("surge")])))
    top = max(largest(maps[0].missing), 1.96 * float(np.median(found.spread)) if found else 0.0) * scale.factor or 1.0
    with Drawing(1, len(maps), 4.2, Margins(right=1.05)) as drawing:
        for axes, cells, shown in zip(drawing.axes[0], maps, pair.both, strict=True):
            mesh = axes.pcolormesh(
                edges.x, edges.y, cells.missing * scale.factor, cmap=_COLOURS, vmin=-top, vmax=top
            )  # fmt: skip
            _arrows(axes, cells, edges, longest)
            axes.plot(*_path(pair.before), color=QUIET, linewidth=0.4, alpha=0.6)
            axes.set_aspect("equal")
            style_axes(axes)
            axes.set(title=shown.label, xlabel="x [m]", ylabel="y [m]")
        bar = drawing.figure.colorbar(mesh, cax=drawing.figure.add_axes((0.915, 0.2, 0.016, 0.65)))
        bar.set_label(labelled(f"{equation.replace('_', ' ')}, missing", scale))
        bar.outline.set_visible(False)
    return drawing.svg


def _cells(residual: ResidualForce) -> CellEdges | None:
    """Edges of square cells along x and y over the robot's places; None if no place is known."""
    place = residual.place[:, X:Z]
    place = place[np.isfinite(place).all(axis=1)]
    if not len(place):
        return None
    low, high = place.min(axis=0), place.max(axis=0)
    side = max(float(np.max(high - low)), REPORT.least_extent) / _CELLS
    counts = np.maximum(np.ceil((high - low) / side), 1).astype(int)
    return CellEdges(
        *(
            start + side * np.arange(count + 1) + (stop - start - side * count) / 2
            for start, stop, count in zip(low, high, counts, strict=True)
        )
    )


def _map_of(residual: ResidualForce, equation: str, edges: CellEdges) -> ForceMap:
    """Mean residual force of `equation` ('surge', ...) by cell."""
    found = residual_of(equation, residual)
    along = found.values if found else np.full(len(residual.time), np.nan)
    east, north = (residual_of(name, residual) for name in ("world_x", "world_y"))
    values = np.stack([along, east.values if east else along, north.values if north else along], axis=1)
    return ForceMap(*np.moveaxis(mean_map(residual.place[:, X:Z], values, edges, REPORT.fewest_samples), -1, 0))


def _arrows(axes: Axes, cells: ForceMap, edges: CellEdges, longest: float) -> None:
    if longest == 0.0:
        return
    side = float(edges.x[1] - edges.x[0])
    x, y = np.meshgrid(*((edge[1:] + edge[:-1]) / 2 for edge in (edges.x, edges.y)))
    axes.quiver(
        x, y, cells.east, cells.north, color=INK, angles="xy", scale_units="xy", scale=longest / side,
        width=0.004, pivot="middle",
    )  # fmt: skip


def _usual_length(cells: ForceMap) -> float:
    """Length below which nine of ten arrows stay."""
    lengths = np.hypot(cells.east, cells.north)
    known = lengths[np.isfinite(lengths)]
    return float(np.quantile(known, 0.9)) if known.size else 0.0


def _path(residual: ResidualForce) -> tuple[Floats, Floats]:
    every = max(1, len(residual.time) // REPORT.most_places)
    return residual.place[::every, X], residual.place[::every, Y]
