"""The figures of a trial as Markdown."""

from __future__ import annotations

from typing import Any


def _percent(value: float | None) -> str:
    return "-" if value is None else f"{100.0 * value:.1f} %"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.3g}"


def _rates(title: str, rates: dict[str, Any]) -> list[str]:
    rows = [
        f"| {name} | {_percent(r['rate'])} | {r['hits']}/{r['of']} | {_percent(r['low'])} to {_percent(r['high'])} |"
        for name, r in rates.items()
    ]
    return [f"## {title}", "", "| | rate | | 95 % interval |", "|---|---|---|---|", *rows, ""]


def _spreads(title: str, spreads: dict[str, Any]) -> list[str]:
    rows = [
        f"| {name} | {_number(s['median'])} | {_number(s['lower'])} to {_number(s['upper'])} | {s['of']} |"
        for name, s in spreads.items()
    ]
    return [f"## {title}", "", "| | median | quartiles | of |", "|---|---|---|---|", *rows, ""]


def _reliability(title: str, rows: list[dict[str, Any]]) -> list[str]:
    lines = [
        f"| {_percent(row['from'])} to {_percent(row['to'])} | {_percent(row['mean'])} | {_percent(row['rate'])} "
        f"| {row['hits']}/{row['of']} | {_percent(row['low'])} to {_percent(row['high'])} |"
        for row in rows
    ]
    head = ["| told | in the mean | came true | | 95 % interval |", "|---|---|---|---|---|"]
    return [f"### {title}", "", *head, *lines, ""]


def probabilities_text(found: dict[str, Any]) -> list[str]:
    """Lines about how often what was told as probable came true; none where no probability was told."""
    if not found:
        return []
    best, score, certain = found["most_probable"], found["brier"], found["brier_of_certainty"]
    kinds = [
        f"| {name} | {_percent(row['mean'])} | {_percent(row['rate'])} | {row['hits']}/{row['of']} "
        f"| {_percent(row['low'])} to {_percent(row['high'])} |"
        for name, row in found["by_answer"].items()
    ]
    return [
        "## Probabilities", "",
        f"Brier's score over all answers (0 best, 2 worst): {_interval(score)}; of the same answers without a doubt, "
        f"the most probable one told as certain: {_interval(certain)}.",
        "",
        f"Of the most probable answer alone: score {best['score']:.4f} = reliability {best['reliability']:.4f} - "
        f"resolution {best['resolution']:.4f} + uncertainty {best['uncertainty']:.4f}, as far as forecasts within a "
        "class are equal; the last is also the score of always telling how often it is right.",
        "",
        *_reliability("The most probable answer", found["by_most_probable"]),
        *_reliability("All answers", found["by_any"]),
        *_reliability("Each named effect by itself, whatever is hidden beside it", found["by_effect"]),
        "| answer | told in the mean | came true | | 95 % interval |", "|---|---|---|---|---|", *kinds, "",
    ]  # fmt: skip


def _interval(score: dict[str, Any]) -> str:
    ends = "" if score["low"] is None else f" ({score['low']:.3f} to {score['high']:.3f})"
    return f"{score['mean']:.3f}{ends}"


def as_text(figures: dict[str, Any]) -> str:
    """The whole report."""
    table, intervals = figures["table"], figures["intervals"]
    lines = [f"# {figures['recordings']} concealed recordings", ""]
    lines += [", ".join(f"{count} {kind}" for kind, count in sorted(figures["composition"].items())), ""]
    covered = {
        "95 % intervals that hold the truth": intervals["coverage"],
        "95 % intervals of effects that hold the truth": intervals["coverage_of_effects"],
        "95 % intervals of the platform's parameters that hold the truth": intervals["coverage_of_platform"],
    }
    lines += _rates("The table", table["rates"] | covered)
    lines += [f"Mean size of the ambiguity set: {_number(table['ambiguity_set_size'])}", ""]
    for key in ("effect", "size", "noise", "size_and_noise"):
        lines += _rates(f"Exact naming of one effect, by {key.replace('_', ' ')}", figures[f"exact_by_{key}"])
    lines += _rates(
        "Outside the catalogue: flagged and not named as an entry of it, by what was hidden", figures["flagged_by_law"]
    )
    lines += ["## Power", "", "Size (fraction of large) at which half and nine tenths are named exactly.", ""]
    lines += ["| | half | nine tenths | smallest right | largest wrong | of |", "|---|---|---|---|---|---|"]
    for name, curve in figures["power"].items():
        cells = [_number(curve[key]) for key in ("half", "nine_tenths", "smallest_right", "largest_wrong")]
        lines.append(f"| {name} | {' | '.join(cells)} | {curve['of']} |")
    lines += ["", *_rates("Coverage by parameter", intervals["coverage_by_parameter"])]
    relative = {"all": intervals["relative_error"]} | intervals["relative_error_by_parameter"]
    lines += _spreads("Relative error of parameters", relative)
    lines += _spreads("Held-out free runs", figures["held_out"])
    lines += probabilities_text(figures.get("probabilities") or {})
    for title, rates in (figures.get("families") or {}).items():
        lines += _rates(f"Families: {title}", rates)
    lines += ["## First named effect by what was hidden", "", "| hidden | first named effect: how often |", "|---|---|"]
    for truth, counts in figures["confusion"].items():
        lines.append(f"| `{truth}` | " + ", ".join(f"`{name}`: {n}" for name, n in counts.items()) + " |")
    lines += ["", f"## Failures ({len(figures['failures'])})", "", *[f"- {line}" for line in figures["failures"]], ""]
    return "\n".join(lines)
