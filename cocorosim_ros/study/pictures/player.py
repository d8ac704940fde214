"""A recording as a page that plays it, from above and from the side: one HTML file that needs nothing else."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from jinja2 import Environment, FileSystemLoader
from markupsafe import Markup
from matplotlib.colors import to_hex
from numpy.typing import NDArray

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.study.pictures.colours import robot_colours
from cocorosim_ros.study.pictures.decimation import MOST_GROUPS, envelope, every_nth, longest_interval
from cocorosim_ros.study.pictures.extent import extent
from cocorosim_ros.study.pictures.facts import BOUNDED, MetricSeries, ScenarioFacts
from cocorosim_ros.world.state.pose_track import Poses

MOST_POSES = 500_000
"""Poses of all robots beyond which every robot's are thinned; 500 000 make a page of 11 MB."""

_TEMPLATE = "player.html.jinja"
_SPEEDS = (0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
_TRAILS = ((0, "none"), (10, "10 s"), (30, "30 s"), (120, "2 min"), (10**9, "all"))
_WATCHED_IN = 60.0  # s that a recording takes at most, at the speed that is offered first
_IN_SCRIPT = str.maketrans({sign: f"\\u{ord(sign):04x}" for sign in "<>&'"})  # none may end the script element


def page_pieces(
    tracks: Mapping[str, Poses],
    facts: ScenarioFacts,
    findings: Sequence[str] = (),
    series: MetricSeries | None = None,
) -> Iterator[str]:
    """The text of the page, piece by piece: poses of one robot after the other, so that memory never holds all.

    tracks: poses per robot; robots without any are left out. findings: sentences to be shown above the picture.
    series: the metrics, of which the paper's six are drawn as curves. Raises CocorosimError if nothing is to be shown.
    """
    seen = {name: track for name, track in sorted(tracks.items()) if track.stamp_ns.size}
    if not seen:
        raise CocorosimError(f"{facts.name} has no poses, so there is nothing to look at.")
    recording = _recording(seen, facts, list(findings))
    start = min(int(track.stamp_ns[0]) for track in seen.values())
    recording["curves"] = [] if series is None else [_curve(name, series, start) for name in PAPER_METRICS]
    speed = next((factor for factor in _SPEEDS[2:] if recording["seconds"] <= factor * _WATCHED_IN), _SPEEDS[-1])
    folder = Path(__file__).parent
    environment = Environment(loader=FileSystemLoader(folder), autoescape=True, trim_blocks=True, lstrip_blocks=True)
    template = environment.get_template(_TEMPLATE)
    return template.generate(
        recording=recording, in_json=_in_json(recording), speeds=_SPEEDS, speed=speed, trails=_TRAILS
    )


def _recording(tracks: Mapping[str, Poses], facts: ScenarioFacts, findings: list[str]) -> dict[str, Any]:
    """What the page plays, ready for `_in_json`; numbers that come in thousands are float32 in base64."""
    low, high = extent(tracks, facts)
    start = min(int(track.stamp_ns[0]) for track in tracks.values())
    end = max(int(track.stamp_ns[-1]) for track in tracks.values())
    colours = robot_colours(list(tracks))
    clocks: list[str] = []
    robots: list[dict[str, Any]] = []
    thinned, most = 1, max(2, MOST_POSES // len(tracks))
    for name, track in tracks.items():
        kept, step = every_nth(track.stamp_ns, most)
        thinned = max(thinned, step)
        clock = _packed((track.stamp_ns[kept] - start) * 1e-9)
        if clock not in clocks:
            clocks.append(clock)
        gap = longest_interval(track.stamp_ns[kept]) * 1e-9
        told = {"name": name, "colour": to_hex(colours[name]), "clock": clocks.index(clock), "gap": gap}
        robots.append({**told, "poses": _PosesLater(track, most)})
    if thinned > 1:
        findings = [*findings, f"Of long tracks only every {thinned}th pose is shown."]
    return {
        "name": facts.name,
        "seed": facts.seed,
        "seconds": (end - start) * 1e-9,
        "findings": findings,
        "view": [low.tolist(), high.tolist()],
        "tank": None if facts.low_corner is None else [facts.low_corner, facts.high_corner],
        "spheres": facts.spheres,
        "boxes": facts.boxes,
        "clocks": clocks,
        "robots": robots,
    }


def _curve(name: str, series: MetricSeries, start: int) -> dict[str, Any]:
    """One metric over time [s since `start` in ns]: lowest, mean and highest of groups of moments."""
    groups = envelope(np.asarray((series.stamp_ns - start) * 1e-9, np.float64), series.column(name), MOST_GROUPS)
    unit, highest = METRICS[name].unit, float(np.nanmax(groups.high, initial=0.0))
    words = name.replace("_", " ").capitalize()
    return {
        "name": name,
        "label": words if unit == "1" else f"{words} [{unit}]",
        "unit": unit,
        "top": 1.0 if name in BOUNDED or highest <= 0.0 else highest + 1.0 if unit == "1" else 1.08 * highest,
        "time": _packed(groups.time),
        "low": _packed(groups.low),
        "mean": _packed(groups.mean),
        "high": _packed(groups.high),
    }


@dataclass(frozen=True)
class _PosesLater:
    """Poses of a robot, about `most` of them, which become text when their turn comes."""

    track: Poses
    most: int

    def text(self) -> str:
        """Position [m; world] and yaw [rad; world] of each, packed."""
        kept, _ = every_nth(self.track.stamp_ns, self.most)
        return _packed(np.column_stack(self.track.at(kept)))


def _in_json(recording: Mapping[str, Any]) -> Iterator[Markup]:
    """The recording as JSON that may stand in a script element, piece by piece."""
    encoder = json.JSONEncoder(sort_keys=True, default=_PosesLater.text)
    return (Markup(piece.translate(_IN_SCRIPT)) for piece in encoder.iterencode(recording))


def _packed(numbers: NDArray[np.floating]) -> str:
    return base64.b64encode(numbers.astype("<f4").tobytes()).decode("ascii")
