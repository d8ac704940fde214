"""Pictures of effects: a curve as SVG inside the page, in the style of the reports."""

from __future__ import annotations

import re
from html import escape

from cocorosim_ros.diagnosis.report.figure_style import AFTER, QUIET, Drawing, Margins, labelled, largest, style_axes
from cocorosim_ros.foundation.units.quantity_text import handy_scale
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.sensor_error import SensorError
from cocorosim_ros.world.terms.effect import Description, Effect
from site_builder.curves import Curve
from site_builder.effect_curves import effect_curve
from site_builder.error_curves import error_curve
from site_builder.lily import lily

WIDTH, HEIGHT = 4.6, 1.9  # inches
ROOM = Margins(left=0.72, right=0.15, top=0.1, bottom=0.45)
NOTHING_IN_STILL_WATER = "No picture: a Lily in still water has none of it."
TIME_ALONE = "No picture: it changes no reading and no command, only when one is made or said to be made."


def what_pictures_show() -> str:
    """The paragraph that holds for all pictures."""
    robot = lily()
    return (
        f"The pictures are of a Lily in still water, at the full thrust of {robot.thrust:.2g} N and the "
        f"{robot.speed:.2g} m/s that this gives, far from walls and neighbours unless the axis says otherwise. "
        "Blue: with the numbers of the example; dashed: with neutral ones."
    )


def picture(name: str) -> str:
    """The picture of an effect of EFFECTS or an error of ERRORS, or a sentence on why there is none."""
    described: Description = EFFECTS[name] if name in EFFECTS else ERRORS[name]
    curve = curve_of(name)
    if curve is not None:
        return _figure(curve, described.summary)
    return TIME_ALONE if isinstance(described, SensorError) else NOTHING_IN_STILL_WATER


def curve_of(name: str) -> Curve | None:
    """The curve of an effect of EFFECTS or an error of ERRORS, None without one."""
    if name in ERRORS:
        return error_curve(ERRORS[name])
    effect: Effect = EFFECTS[name]
    return effect_curve(name, effect)


def _figure(curve: Curve, summary: str) -> str:
    """The picture with its caption, without an empty line, which would end the HTML inside the page."""
    words = escape(f"{summary}: {curve.caption[0].lower()}{curve.caption[1:]}", quote=True)
    svg = _svg(curve).replace("<svg ", f'<svg role="img" aria-label="{words}" ', 1)
    style = "max-width: 27rem; margin: 0 0 1rem; stroke-linejoin: round"
    caption = f'<figcaption style="font-size: 0.85em">{escape(curve.caption)}</figcaption>'
    return f'<figure style="{style}">\n{svg}\n{caption}\n</figure>'


def _svg(curve: Curve) -> str:
    across = handy_scale(largest(curve.axis.values), curve.axis.unit)
    upwards = handy_scale(max(largest(curve.with_it), largest(curve.without)), curve.unit)
    at = across.factor * curve.axis.values
    with Drawing(1, 1, HEIGHT, ROOM, WIDTH) as drawing:
        axes = drawing.axes[0, 0]
        style_axes(axes)
        axes.plot(at, upwards.factor * curve.without, color=QUIET, linewidth=1.2, linestyle=(0, (4, 3)))
        axes.plot(at, upwards.factor * curve.with_it, color=AFTER, linewidth=1.8)
        axes.set_xlabel(labelled(curve.axis.label, across))
        axes.set_ylabel(labelled(curve.label, upwards))
        axes.margins(x=0.0, y=0.1)
    # A rule for every element would reach the other pictures of the page.
    svg = re.sub(r"<defs>\s*<style.*?</style>\s*</defs>", "", drawing.svg, count=1, flags=re.DOTALL)
    return re.sub(r"\n\s*\n", "\n", svg).strip()
