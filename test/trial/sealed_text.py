"""The sealed trial's page: how it was run, the issue's table, all figures of the Scorer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from trial.examiner import Outcome

# What is asked for: row, the Scorer's rate, least (or, with a minus, most), goal.
Asked = tuple[str, str, float, float]
ASKED: tuple[Asked, ...] = (
    ("truth in the ambiguity set", "truth in ambiguity set, where something is named", 0.98, 0.995),
    ("first named effect wrong", "first named effect wrong, one or more effects", -0.01, 0.003),
    ("false alarm where nothing is concealed", "false alarm, nothing concealed", -0.01, 0.0),
    ("false alarm where only parameters moved", "false alarm, recalibration only", -0.01, 0.0),
    ("two effects, both and nothing else", "exact, two effects", 0.80, 0.92),
    ("outside the catalogue: flagged", "outside the catalogue: flagged", 0.85, 0.95),
    ("outside the catalogue: named as an entry of it", "outside the catalogue: named as an entry of it", -0.05, 0.02),
    ("recordings that cannot tell: abstains", "cannot tell: abstains", 0.90, 0.98),
)

_PROBABILITIES, _PICTURE = "### Probabilities\n", "![How often what was told came true](reliability.svg)"


def _row(name: str, measured: str, asked: tuple[str, str], held: bool | None) -> str:
    verdict = "-" if held is None else "yes" if held else "no"
    return f"| {name} | {measured} | {asked[0]} | {asked[1]} | {verdict} |"


def _rate_row(row: tuple[str, str, float, float], rates: dict[str, Any]) -> str:
    name, key, least, goal = row
    found = rates.get(key) or {"of": 0}
    asked = f"{'at most ' if least < 0 else ''}{abs(least):.0%}", f"{goal:.1%}"
    if not found["of"]:
        return _row(name, "-", asked, None)
    held = found["rate"] >= least if least > 0 else found["rate"] <= -least
    return _row(name, _measured(found), asked, held)


def _measured(rate: dict[str, Any]) -> str:
    interval = f"{100 * rate['low']:.1f} to {100 * rate['high']:.1f} %"
    return f"{rate['hits']}/{rate['of']} = {rate['rate']:.1%} ({interval})"


def _size_row(size: float | None) -> str:
    held = None if size is None else size <= 1.3
    return _row("mean size of the ambiguity set", "-" if size is None else f"{size:.2f}", ("1.3", "1.15"), held)


def _cover_row(name: str, cover: dict[str, Any]) -> str:
    asked = "92 to 98 %", "94 to 96 %"
    if not cover["of"]:
        return _row(name, "-", asked, None)
    return _row(name, _measured(cover), asked, 0.92 <= cover["rate"] <= 0.98)


def _free_row(free: dict[str, Any] | None) -> str:
    name, asked = "held-out free run, position, against a model that knows the truth", ("1.05", "1.02")
    if not free:
        return _row(name, "-", asked, None)
    text = f"{free['median']:.3f} (quartiles {free['lower']:.3f} to {free['upper']:.3f}, {free['of']} recordings)"
    return _row(name, text, asked, free["median"] <= 1.05)


def of_medium_effects(weaker: str, stronger: str) -> tuple[Asked, ...]:
    """What is asked for of medium effects at two levels of random force [% of thrust]."""
    row = "exact, one medium effect, {}% noise"
    return (
        (f"exact naming, one medium effect, random force {weaker} % of thrust", row.format(weaker), 0.95, 0.99),
        (f"the same at {stronger} %", row.format(stronger), 0.88, 0.95),
    )


WHY = (
    "Why a row falls short is told in [What may be believed](explanation/what_may_be_believed.md#what-was-tried); "
    "each recording that made it so stands below."
)


def asked_table(figures: dict[str, Any], levels: tuple[str, str] = ("1", "3")) -> list[str]:
    """The table of what is asked for, with what was measured and whether the least holds.

    levels: of random force, of which medium effects are asked [% of thrust].
    """
    rows = [_rate_row(row, figures["table"]["rates"]) for row in (*of_medium_effects(*levels), *ASKED)]
    rows.insert(3, _size_row(figures["table"]["ambiguity_set_size"]))
    intervals = figures["intervals"]
    rows.append(_cover_row("95 % intervals that hold the truth", intervals["coverage"]))
    rows.append(_cover_row("the same, of effects alone", intervals["coverage_of_effects"]))
    rows.append(_free_row(figures["held_out"].get("position: augmented / oracle")))
    why = [] if all(row.endswith(("| yes |", "| - |")) for row in rows) else [WHY, ""]
    return [
        "| figure | measured (95 % interval) | must | goal | must holds |",
        "|---|---|---|---|---|",
        *rows,
        "",
        *why,
    ]


def endings(outcomes: Sequence[Outcome]) -> list[str]:
    """How the diagnoses ended and how long they took."""
    good = sorted(o.seconds for o in outcomes if o.status == 0)
    late = [o.name for o in outcomes if o.status is None]
    broken = [f"{o.name} ({o.status}: {o.said.splitlines()[-1] if o.said else ''})" for o in outcomes if o.status]
    lines = [f"{len(good)} of {len(outcomes)} diagnoses ended with status 0."]
    if good:
        middle, most = good[len(good) // 2], good[int(0.9 * (len(good) - 1))]
        lines.append("Seconds for one, start of the interpreter included, as many at a time as the command says:")
        lines.append(f"median {middle:.1f}, nine tenths below {most:.1f}, longest {good[-1]:.1f}.")
    lines += [f"Out of time: {', '.join(late)}."] if late else ["None was out of time."]
    return [*lines, *([f"Failed: {'; '.join(broken)}."] if broken else []), ""]


FAMILIES = (
    "Forms of laws, noise of sensors, programmes of commands and tanks are drawn from families, laws outside the",
    "catalogue by a grammar. The numbers of half of the members follow from the seed word, which could not be chosen",
    "before the code was frozen; the hash of the table with all numbers (`families` below) was printed before the tool",
    "ran, and the table is in [trial_families.json](trial_families.json). What is asked for below is what is asked of",
    "the trial without families.",
    "",
)


ROV = (
    "The vehicle is an ROV with eight thrusters, four of them vectored, in six degrees of freedom, with a Doppler",
    "log, attitude, compass, pressure and sounded places; a tether is among what is concealed. The tool is given its",
    "[platform file](../test/trial/rov_platform.yaml), which tells the vehicle as published; drag, thrust and lift",
    "differ from it in every recording. What is concealed has the plain forms of the catalogue, so that this trial",
    "asks about the vehicle; [that of families](trial_families.md) asks about forms. Random forces are weaker than in",
    "the trials of Lily, since such a vehicle works with a seventh of its thrust. Recordings that cannot tell are not",
    "drawn. What is asked for below is what is asked of the trial of Lily.",
    "",
)
SLENDER = (
    "The vehicle is a made AUV in six degrees of freedom: a hull of revolution, two propellers behind each other,",
    "four tunnel thrusters, a Doppler log over ground, attitude, compass, pressure and sounded places. Its",
    "[platform file](../test/trial/slender_platform.yaml) tells the vehicle as it is drawn; drag, thrust and lift",
    "differ from it in every recording. Lift of the hull, thrust lost in a jet and faults of a log over ground are",
    "concealed in forms of their own, all else in the plain forms of the catalogue. Recordings that cannot tell are",
    "not drawn. What is asked for below is what is asked of the trial of Lily.",
    "",
)


@dataclass(frozen=True)
class Sheet:
    """What stands on a trial's page beside its figures."""

    title: str
    lead: tuple[str, ...] = ()
    levels: tuple[str, str] = ("1", "3")  # of random force, of which medium effects are asked [% of thrust]


SHEETS = {
    "trial": Sheet("The sealed trial"),
    "trial_families": Sheet("The sealed trial, with families of forms", FAMILIES),
    "trial_rov": Sheet("The sealed trial of a second vehicle, an ROV", ROV, ("0.5", "1.5")),
    "trial_slender": Sheet("The sealed trial of a third vehicle, a slender AUV", SLENDER, ("0.5", "1.5")),
}


def page(score: dict[str, Any], source: dict[str, Any], outcomes: Sequence[Outcome], name: str = "trial") -> str:
    """The whole page in Markdown; name: of its file."""
    figures, sheet = score["figures"], SHEETS[name]
    lines = [f"# {sheet.title}", ""]
    lines += [
        "Recordings in which something is concealed by a program that shares no code with the tool; the truth was"
    ]
    lines += ["sealed by salted hashes before the tool ran. [How it works](../test/trial/README.md).", ""]
    lines += sheet.lead
    facts = [f"| {key.replace('_', ' ')} | `{value}` |" for key, value in source.items()]
    lines += ["| | |", "|---|---|", *facts, ""]
    lines += [*endings(outcomes), "## What is asked for", "", *asked_table(figures, sheet.levels)]
    text = score["text"].replace("\n### ", "\n#### ").replace("\n## ", "\n### ").replace("# ", "## ", 1)
    picture = _PICTURE if name == "trial" else _PICTURE.replace("reliability", f"reliability_{name}")
    return "\n".join(lines) + "\n" + text.replace(_PROBABILITIES, f"{_PROBABILITIES}\n{picture}\n", 1)
