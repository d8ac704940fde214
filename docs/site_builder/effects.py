"""The catalogue of effects: equation, picture, numbers, what shows it, and how it stands in a platform file."""

from __future__ import annotations

import re

from cocorosim_ros.diagnosis.report.advice import MANOEUVRES
from cocorosim_ros.world.effects import BASIC_EFFECTS, CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.effect import Description, Number
from site_builder.effect_pictures import picture, what_pictures_show
from site_builder.markdown import block, plain, table


def catalogue() -> str:
    """All effects of the motion and all errors of sensors, a heading each."""
    parts = [
        what_pictures_show(),
        "## Of every robot\n\nThese are in each simulation; their numbers are top-level keys of the platform.",
        *(_basic(name, effect) for name, effect in BASIC_EFFECTS.items() if effect.whole_equation),
        "## Of the motion",
        *(_section(name, effect) for name, effect in CATALOGUE_EFFECTS.items() if effect.numbers),
        "## Of sensors, cameras and clocks",
        *(_section(name, error) for name, error in ERRORS.items() if error.numbers),
    ]
    return "\n\n".join(parts)


def example(name: str, effect: Description) -> str:
    """An effect with every number, as it stands below `effects:` in a platform file."""
    return "\n".join([f"{name}:", *(_stated(number) for number in effect.numbers)])


def _basic(name: str, effect: Description) -> str:
    return f"{plain(effect.summary).capitalize()}: `{effect.whole_equation}`\n\n{picture(name)}"


def _section(name: str, effect: Description) -> str:
    rows = [[f"`{each.name}`", each.unit, plain(each.meaning), _neutral(each)] for each in effect.numbers]
    parts = [f"### {name}", f"{plain(effect.summary).capitalize()}: `{effect.whole_equation}`", picture(name)]
    parts.append(table(("number", "unit", "meaning", "neutral"), rows))
    parts.append(_shown(effect))
    parts.append(block(example(name, effect), "yaml"))
    return "\n\n".join(part for part in parts if part)


def _neutral(number: Number) -> str:
    return "must be given" if number.needed else f"{number.neutral:g}"


def _shown(effect: Description) -> str:
    """What a diagnosis looks for, and what to do on the robot."""
    sentences = []
    if effect.search is None:
        sentences.append("No diagnosis looks for it.")
    else:
        sentences.append(f"It shows in {effect.search.channel}; to show it, {MANOEUVRES[effect.search.manoeuvre]}.")
    return plain(" ".join([*sentences, effect.check]).strip())


def _stated(number: Number) -> str:
    """One number of an effect."""
    if number.example is None:
        raise ValueError(f"'{number.name}' has no example.")
    unit = '"1"' if number.unit == "1" else number.unit
    value = re.sub(r"e([+-])0", r"e\1", f"{number.example.value:g}")
    return f"  {number.name}: {{value: {value}, unit: {unit}, source: {number.example.source}}}"
