"""The table of what is asked of the tool on real recordings: must and goal, what was measured, and why if it fails."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from concealer.figures import wilson
from trial.other_half import KEPT, TIERS, Kept, answers, both_ways
from trial.real_figures import AGAIN, HALVES, ONE, OTHER, diagnosis, unseen_ratios
from trial.real_words import HALF_WORDS, title
from trial.ships import BAR, TANKER, WIND_BAR, WINDY

Tree = dict[str, Any]
BLIMP, GLIDER = "rgblimp", "slocum_glider"
COLLAPSED, AT_A_BOUND = "its fit has collapsed", "the end of its range"  # of warnings of a diagnosis
OF_A_GLIDER = {"stratification", "hull_compressibility", "hull_lift"}  # density, hull, angle of attack
DRAWN = 200  # altered logs that are asked for
ALTERED = "altered logs against unaltered ones ([against](against.md))"


class Asked(NamedTuple):
    """What is asked of a figure: a share or ratio that is at least, or at most, `least`; must and goal in words."""

    figure: str
    must: str
    goal: str
    least: float = 0.0
    most: float = 1.0


class Row(NamedTuple):
    """A row of the table: `held` is None where nothing was measured; why: what keeps it from holding, one by one."""

    asked: Asked
    measured: str
    held: bool | None
    why: tuple[str, ...] = ()


def musts(figures: Tree, altered: Sequence[Tree]) -> list[Row]:
    """All rows; altered: judgements of altered logs and of their controls (`against.json`)."""
    of_groups = [make(figures) for make in (halves_row, kept_row, unseen_row, again_row)]
    of_sets = [make(figures) for make in (wind_row, tanker_row, blimp_row, glider_row)]
    return [*altered_rows(altered), *of_groups, *of_sets]


def _share(asked: Asked, hits: int, of: int, why: Iterable[str], measured: str = "{}") -> Row:
    """A row of a rate, which `measured` may put into words."""
    if not of:
        return Row(asked, "0 of 0", None)
    low, high = wilson(hits, of)
    rate = f"{hits} of {of} = {100 * hits / of:.1f} % ({100 * low:.0f} to {100 * high:.0f} %)"
    held = asked.least <= hits / of <= asked.most
    return Row(asked, measured.format(rate), held, () if held else tuple(why))


def altered_rows(altered: Sequence[Tree]) -> list[Row]:
    """Of altered logs: right or silent with a reason, named as something else; of their controls: anything named."""
    put_in = [row for row in altered if row["way"] != "control"]
    controls = [row for row in altered if row["way"] == "control"]
    wrong = [row for row in put_in if row["outcome"] == "something else"]
    named = [row for row in controls if row["outcome"] == "something else"]
    good = [row for row in put_in if row["outcome"] in ("right", "cannot be seen")]
    rest = [_altered(row) for row in put_in if row not in good]
    drawn = f"{{}}, of {len(put_in)} drawn for {DRAWN}" if len(put_in) < DRAWN else "{}"
    right = Asked(f"{ALTERED}: right name and number, or said to be out of sight", "90 %", "97 %", least=0.90)
    other = Asked(f"{ALTERED}: something else is named", "at most 5 %", "2 %", most=0.05)
    of_controls = Asked(f"{ALTERED}: nothing altered, anything named", "at most 5 %", "2 %", most=0.05)
    return [
        _share(right, len(good), len(put_in), rest, drawn),
        _share(other, len(wrong), len(put_in), map(_altered, wrong), drawn),
        _share(of_controls, len(named), len(controls), map(_altered, named)),
    ]


def _altered(row: Tree) -> str:
    return f"{row['group']}, {row['way']}: {row['outcome']}{''.join(f', `{name}`' for name in row['named'])}"


def halves_row(figures: Tree) -> Row:
    """Groups of this page whose halves, compared with one another, have anything named."""
    said = {name: diagnosis(group, HALVES) for name, group in figures["groups"].items()}
    told = {name: each for name, each in said.items() if each is not None}
    differing = {name: _differing(each) for name, each in told.items()}
    named = [f"{name}: {', '.join(names)}" for name, names in differing.items() if names]
    asked = Asked("one half against the other, below: anything named", "at most 5 %", "2 %", most=0.05)
    silent = sum(each["verdict"] == "insufficient" for each in told.values())
    nameless = sum(each["verdict"] == "mismatch" and not differing[name] for name, each in told.items())
    measured = f"{{}}; in {silent} the recordings tell too little, in {nameless} something differs without a name"
    return _share(asked, len(named), len(told), named, measured)


def _differing(said: Tree) -> list[str]:
    """Names of effects and of numbers by which recordings differ."""
    return [*map(title, said["effects"]), *(each["parameter"] for each in said.get("recalibrated", ()))]


def kept_row(figures: Tree) -> Row:
    """Confirmed effects of either half that keep their size on the other one."""
    found = kept_in_all(figures, TIERS[0])
    asked = Asked(
        "confirmed effects of either half that keep sign, and size within intervals, on the other half",
        "90 %",
        "97 %",
        least=0.90,
    )
    return _share(asked, found.size, found.all, not_kept(figures, TIERS[0]), f"{{}}; the sign alone {found.sign}")


def kept_in_all(figures: Tree, tier: str) -> Kept:
    """Counts over all groups and both halves."""
    total = Kept(0, 0, 0)
    for group in figures["groups"].values():
        total += both_ways(diagnosis(group, ONE), diagnosis(group, OTHER), tier)
    return total


def not_kept(figures: Tree, tier: str) -> list[str]:
    """Effects of a tier that the other half does not bear out, with what it says."""
    lines = []
    for name, group in figures["groups"].items():
        for half, against in ((ONE, OTHER), (OTHER, ONE)):
            first, second = diagnosis(group, half), diagnosis(group, against)
            if first is None or second is None:
                continue
            found = [(title(each), said) for each, said in answers(first, second, tier) if said != KEPT]
            lines += [f"{name}, {HALF_WORDS[half]}: {each} is {said}" for each, said in found]
    return lines


def unseen_row(figures: Tree) -> Row:
    """The worst ratio over all channels of all groups, and the worst of each channel."""
    asked = Asked(
        "free runs on unseen recordings, found model over the platform's own, worst set and channel", "1.0", "0.8"
    )
    found = list(unseen_ratios(figures))
    if not found:
        return Row(asked, "-", None)
    worst: dict[str, tuple[float, str]] = {}
    for name, channel, ratio in found:
        worst[channel] = max(worst.get(channel, (0.0, "")), (ratio, name))
    told = ", ".join(f"{channel} {ratio:.2f} ({name})" for channel, (ratio, name) in sorted(worst.items()))
    most = max(ratio for ratio, _ in worst.values())
    return Row(asked, f"{most:.2f}: {told}", most <= 1.0, tuple(worse_than_own(figures)))


def worse_than_own(figures: Tree) -> list[str]:
    """Channels of unseen recordings in which the found model errs more, each with what the diagnosis warned of."""
    return [
        f"{name}, {channel}: {ratio:.2f} ({figures['groups'][name]['unseen'][channel]['windows']} windows). "
        f"{_warning(diagnosis(figures['groups'][name], ONE))}"
        for name, channel, ratio in unseen_ratios(figures)
        if ratio > 1.0
    ]


def _warning(said: Tree | None) -> str:
    """The first warning that tells of a collapsed fit, or else of a number at a bound, or else the first of all."""
    warnings = (said or {}).get("warnings") or []
    first = [each for sign in (COLLAPSED, AT_A_BOUND, "") for each in warnings if sign in each]
    return first[0] if first else "The diagnosis warned of nothing."


def again_row(figures: Tree) -> Row:
    """Groups whose recordings are consistent with the model found in them."""
    said = {name: diagnosis(group, AGAIN) for name, group in figures["groups"].items()}
    told = {name: each for name, each in said.items() if each is not None}
    good = [name for name, each in told.items() if each["verdict"] == "consistent"]
    asked = Asked("the same recordings with the model found in them: `consistent`", "all", "all", least=1.0)
    why = (
        f"{name}: {_again(diagnosis(figures['groups'][name], ONE), told[name])}" for name in told if name not in good
    )
    return _share(asked, len(good), len(told), why)


def _again(once: Tree | None, said: Tree) -> str:
    if once is not None and once["verdict"] == said["verdict"] == "insufficient":
        return "insufficient both times; the model that was found is the platform's file or hardly more."
    named = "".join(f", {title(each)}" for each in said["effects"])
    return f"{said['verdict']}{named}. {_warning(said)}"


def wind_row(figures: Tree) -> Row:
    """The hidden wind's direction."""
    asked = Asked(f"{WINDY}, wind columns hidden: wind is named, its direction within", f"{WIND_BAR:g} deg", "15 deg")
    told = figures["ships"].get(WINDY)
    if told is None or "named" not in told:
        return Row(asked, "-" if told is None else "not named", None if told is None else False)
    tiers = [_tier_of_wind(diagnosis(figures["groups"][WINDY], half)) for half in (ONE, OTHER)]
    return Row(
        asked, f"{told['beside']:.0f} deg ({tiers[0]}; by the other half {tiers[1]})", told["beside"] <= WIND_BAR
    )


def _tier_of_wind(said: Tree | None) -> str:
    return next((each["tier"] for each in (said or {"effects": []})["effects"] if each["id"] == "wind"), "not named")


def tanker_row(figures: Tree) -> Row:
    """Shares of u, v and r that free runs of the fitted tanker explain."""
    asked = Asked(
        f"{TANKER}: fitted to four zigzags, R2 (u, v, r) of free runs of 40 s on the others",
        ", ".join(f"{bar:g}" for bar in BAR),
        "0.99",
    )
    told = figures["ships"].get(TANKER)
    if told is None:
        return Row(asked, "-", None)
    shares = list(told["explained"].values())
    held = all(share >= bar for share, bar in zip(shares, BAR, strict=True))
    return Row(asked, ", ".join(f"{share:.3f}" for share in shares), held)


def blimp_row(figures: Tree) -> Row:
    """The blimp's position on unseen flights."""
    asked = Asked(f"{BLIMP}: half of the flights, position after free runs on the others over the own", "0.09", "0.05")
    ratio = next((r for name, channel, r in unseen_ratios(figures) if (name, channel) == (BLIMP, "position")), None)
    return Row(asked, "-", None) if ratio is None else Row(asked, f"{ratio:.3f}", ratio <= 0.09)


def glider_row(figures: Tree) -> Row:
    """The glider: no fit that has collapsed, and causes of its own kind or none.

    Numbers at the end of their ranges are told beside it. Its speed through the water, the goal, is not in the data.
    """
    asked = Asked(
        f"{GLIDER}: no collapsed fit, a cause that concerns density, hull or angle of attack, or silence",
        "yes",
        "its withheld speed within 3 cm/s (not in the data: not measured)",
    )
    if GLIDER not in figures["groups"]:
        return Row(asked, "-", None)
    said = [diagnosis(figures["groups"][GLIDER], half) for half in (ONE, OTHER)]
    made = [half for half in said if half is not None]
    effects = [each for half in made for each in half["effects"]]
    verdicts = ", ".join("no diagnosis" if half is None else half["verdict"] for half in said)
    told = f"{verdicts} (one half, the other): {', '.join(map(title, effects)) or 'nothing is named'}"
    warnings = [warning for half in made for warning in half["warnings"]]
    at_ends = sum(AT_A_BOUND in warning for warning in warnings)
    collapsed = any(COLLAPSED in warning for warning in warnings)
    told += "; a fit has collapsed" if collapsed else f"; {at_ends} number at the end of its range" if at_ends else ""
    causes = {each["id"] for each in effects}
    return Row(asked, told, None not in said and not collapsed and causes <= OF_A_GLIDER)


def table(rows: Sequence[Row]) -> list[str]:
    """Lines of the page: the table, and what keeps rows from holding."""
    words = {True: "yes", False: "no", None: "-"}
    lines = ["| figure | must | goal | measured (95 % interval) | must holds |", "|---|---|---|---|---|"]
    lines += [f"| {r.asked.figure} | {r.asked.must} | {r.asked.goal} | {r.measured} | {words[r.held]} |" for r in rows]
    for row in rows:
        if row.held is False and row.why:
            lines += ["", f"Why not, {row.asked.figure}:", "", *(f"- {each}" for each in row.why)]
    return lines
