"""The page about a fleet: fleet.html, which needs no other file."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from cocorosim_ros import __version__
from cocorosim_ros.diagnosis.criteria.fleet import COMMON, DRIFT, FLEET_PAGE, LIKENESS
from cocorosim_ros.diagnosis.fleet.alike import Group, Groups
from cocorosim_ros.diagnosis.fleet.drift import Drift
from cocorosim_ros.diagnosis.fleet.figures import all_drifts, drift_pictures
from cocorosim_ros.diagnosis.fleet.findings import FleetFindings
from cocorosim_ros.diagnosis.fleet.in_common import InCommon
from cocorosim_ros.diagnosis.fleet.rows import Effect, Row
from cocorosim_ros.diagnosis.fleet.sentence import THRUST, few, fleet_sentence, number_words, rate_words
from cocorosim_ros.diagnosis.report.number_text import estimate_words, in_unit_of
from cocorosim_ros.diagnosis.report.words import effect_words
from cocorosim_ros.foundation.units.quantity_text import plain_number
from cocorosim_ros.study.pictures.page import page_template

Context = dict[str, Any]
_DATED = {
    "stamps": "by the stamps of their messages",
    "log times": "by the times at which messages were logged, as their stamps count from zero",
    "name": "by the date in their names, as stamps and log times count from zero",
    "nothing": "not at all: neither stamps nor log times nor names hold a date, so that they say nothing of drift",
}


@dataclass(frozen=True)
class FleetOrigin:
    """Subject of a page. remarks: what happened while the fleet was diagnosed, in sentences."""

    fleet: str
    platform: str
    remarks: tuple[str, ...] = ()


def render_fleet(found: FleetFindings, origin: FleetOrigin) -> str:
    """The page as text."""
    template = page_template(Path(__file__).parent, "fleet.html.jinja")
    return template.render(
        origin=origin,
        version=__version__,
        sentence=fleet_sentence(found),
        missing=found.missing,
        problems=found.problems,
        **_facts(found),
        **_drifts(found),
        what_was_found=_what_was_found(found.rows),
        **_alike(found.groups),
        **_common(found.common),
        **_unshown(found.rows),
    )


def drift_cells(drift: Drift) -> tuple[str, ...]:
    """Robot, number, drift a week and its 95 % interval, recordings, weeks."""
    count, weeks = len(drift.series.recordings), plain_number(drift.span, 2)
    return drift.series.robot, number_words(drift.series.parameter), *rate_words(drift.per_week), str(count), weeks


def _facts(found: FleetFindings) -> Context:
    verdicts = Counter(row.verdict for row in found.rows if row.verdict)
    dates = Counter(dict(sorted({row.recording: row.dated_by for row in found.rows if row.diagnosed}.items())).values())
    starts = [row.start_ns for row in found.rows if row.start_ns is not None]
    return {
        "recordings": found.recordings,
        "robots": found.robots,
        "verdicts": [(name, count) for name, count in sorted(verdicts.items())],
        "between": tuple(_day(each) for each in (min(starts), max(starts))) if starts else None,
        "dated": [(count, _DATED[by]) for by, count in sorted(dates.items())],
        "undated": dates["nothing"],
    }


def _day(start_ns: int) -> str:
    return datetime.fromtimestamp(start_ns // 10**9, UTC).strftime("%Y-%m-%d")


def _drifts(found: FleetFindings) -> Context:
    """Tables and pictures of drifts: those that are clear, then the leading number of each robot, then all."""
    names = [each.series.parameter for each in found.drifts]
    leading = THRUST if THRUST in names or not names else sorted(names)[0]
    of_leading = [each for each in found.drifts if each.series.parameter == leading]
    untested = [name for name in found.robots if name not in found.tested]
    return {
        "drifting": [_drift(each) for each in found.drifting],
        "leading": number_words(leading),
        "of_leading": [_drift(each) for each in of_leading],
        "all_drifts": [_drift(each) for each in found.drifts],
        "pictures": drift_pictures(found.drifting[: FLEET_PAGE.most_pictures]),
        "more_pictures": len(found.drifting[FLEET_PAGE.most_pictures :]),
        "picture_of_all": all_drifts(of_leading),
        "untested": few(untested, FLEET_PAGE.most_names),
        "fewest": DRIFT.fewest_recordings,
        "sure": f"{100.0 * DRIFT.sure:g}",
        "tests": len(found.drifts),
    }


def _drift(drift: Drift) -> Context:
    robot, number, value, interval, count, weeks = drift_cells(drift)
    scatter = (
        f"{plain_number(100.0 * drift.scatter, 2)}\u00a0%" if drift.series.relative else plain_number(drift.scatter)
    )
    return {
        "robot": robot,
        "number": number,
        "value": value,
        "interval": interval,
        "scatter": scatter,
        "recordings": count,
        "weeks": weeks,
        "chance": _chance(drift.adjusted),
        "drifts": drift.clear,
    }


def _chance(p: float) -> str:
    return f"below {FLEET_PAGE.least_chance:.4f}" if p < FLEET_PAGE.least_chance else f"{p:.2g}"


def _alike(groups: Groups) -> Context:
    several = [each for each in groups.groups if len(each.rows) > 1]
    counts = Counter(row.robot for each in groups.groups for row in each.rows)
    own = [each for each in several if len(each.robots) == 1 and len(each.rows) == counts[each.robots[0]]]
    mixed = [each for each in several if each not in own]
    return {
        "groups": [_group(each) for each in mixed[: FLEET_PAGE.most_groups]],
        "more_groups": len(mixed[FLEET_PAGE.most_groups :]),
        "own_groups": [(each.robots[0], len(each.rows), _effects(each)) for each in own],
        "alone": sum(len(each.rows) == 1 for each in groups.groups),
        "not_compared": groups.not_compared,
        "limit": plain_number(groups.limit, 2) if math.isfinite(groups.limit) else "",
        "apart": f"{100.0 * LIKENESS.apart:g}",
        "usual": [
            (number_words(name), f"{plain_number(100.0 * each, 2)}\u00a0%") for name, each in groups.scatter.items()
        ],
    }


def _group(group: Group) -> Context:
    verdicts = Counter(row.verdict for row in group.rows if row.verdict)
    return {
        "count": len(group.rows),
        "robots": few(group.robots, FLEET_PAGE.most_names),
        "effects": _effects(group) or "none confirmed",
        "verdicts": ", ".join(f"{count} {name}" for name, count in sorted(verdicts.items())),
        "recordings": few([row.recording for row in group.rows], FLEET_PAGE.most_names),
    }


def _effects(group: Group) -> str:
    return ", ".join(map(effect_words, group.effects))


def _common(common: InCommon) -> Context:
    return {
        "common_effects": [
            {
                "name": effect_words(each.id),
                "share": f"{each.found} of {each.able}",
                "confirmed": each.confirmed,
                "numbers": [(name.replace("_", " "), estimate_words(part)) for name, part in each.parameters.items()],
            }
            for each in common.effects
        ],
        "common_shifts": [
            {
                "name": number_words(each.parameter),
                "nominal": in_unit_of(each.nominal, each.pooled),
                "value": estimate_words(each.pooled)[0],
                "interval": estimate_words(each.pooled)[1],
                "share": f"{each.same_side} of {each.robots}",
            }
            for each in common.shifts
        ],
        "nearly_all": f"{100.0 * COMMON.nearly_all:g}",
    }


def _what_was_found(rows: Sequence[Row]) -> list[Context]:
    """Effects that were named, by robot: in how many recordings, how many of these confirmed, and between which sizes.

    They are not followed over the weeks, so that a fault of one robot that grows is seen here.
    """
    told = Counter(row.robot for row in rows if row.diagnosed)
    found: dict[tuple[str, str], list[Effect]] = {}
    for row in rows:
        for effect in row.effects:
            found.setdefault((effect.id, row.robot), []).append(effect)
    order = sorted(found.items(), key=lambda pair: (-len(pair[1]), pair[0]))
    return [
        {
            "name": effect_words(name),
            "robot": robot,
            "share": f"{len(effects)} of {told[robot]}",
            "confirmed": sum(each.tier == "confirmed" for each in effects),
            "sizes": _sizes(effects),
        }
        for (name, robot), effects in order[: FLEET_PAGE.most_effects]
    ]


def _sizes(effects: Sequence[Effect]) -> str:
    """The least and the greatest value of each number of an effect, over recordings."""
    words = []
    for name in effects[0].parameters:
        values = [each.parameters[name] for each in effects if name in each.parameters]
        ends = [min(values, key=lambda part: part.value), max(values, key=lambda part: part.value)]
        texts = list(dict.fromkeys(estimate_words(each)[0] for each in ends))
        words.append(f"{name.replace('_', ' ')} {' to '.join(texts)}")
    return ", ".join(words)


def _unshown(rows: Sequence[Row]) -> Context:
    """Count the recordings of robots that could not have shown an effect, the most first."""
    told = [row for row in rows if row.diagnosed]
    counts = Counter(name for row in told for name in row.not_shown)
    ordered = sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))
    return {"unshown": [(effect_words(name), f"{count} of {len(told)}") for name, count in ordered]}
