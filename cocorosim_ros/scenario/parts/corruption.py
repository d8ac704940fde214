"""How far sensors and links are from perfect: a list of corruptions, applied in its order. Default: none.

corruption:
  - {channel: compass, kind: noise, sd: 2 deg}
  - {channel: neighbour_range, kind: range_factor, least: 0.8, most: 1.0}
  - {channel: radio, kind: loss, probability: 20 %, robots: [lily_01]}
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.scenario.reading.quantity import Sign, quantity_text, read_quantity
from cocorosim_ros.scenario.reading.records import form_of, stored

OWN = "that of the channel"
TICKS = "ticks"
PROBABILITY = "probability"
MOST_TICKS = 10_000
# What can be corrupted, and the dimension of its numbers.
SENSOR_CHANNELS: dict[str, str] = {
    "compass": "angle",
    "pressure": "pressure",
    "gyro": "angular velocity",
    "accelerometer": "acceleration",
    "velocity": "speed",
    "ground_velocity": "speed",
    "yaw_rate_estimate": "angular velocity",
    "neighbour_range": "length",
    "obstacle_range": "length",
    "illuminance": "illuminance",
    "concentration": "density",
}
LINK_CHANNELS: dict[str, str] = {"radio": "pure number", "blue_light": "pure number"}
CHANNELS = {**SENSOR_CHANNELS, **LINK_CHANNELS}
RANGES = ("neighbour_range", "obstacle_range")
# Per kind: its numbers, each with its dimension and sign.
KINDS: dict[str, dict[str, tuple[str, Sign]]] = {
    "noise": {"sd": (OWN, "not negative")},
    "bias": {"offset": (OWN, "any")},
    "quantisation": {"step": (OWN, "positive")},
    "dropout": {"probability": (PROBABILITY, "not negative")},
    "delay": {"ticks": (TICKS, "positive")},
    "range_factor": {"least": ("pure number", "not negative"), "most": ("pure number", "not negative")},
    "loss": {"probability": (PROBABILITY, "not negative")},
    "rate_limit": {"ticks": (TICKS, "positive")},
}
SENSOR_KINDS = ("noise", "bias", "quantisation", "dropout", "delay")
RANGE_KINDS = (*SENSOR_KINDS, "range_factor")
LINK_KINDS = ("loss", "delay", "noise", "rate_limit")


@dataclass(frozen=True)
class Corruption:
    """One corruption of one channel.

    noise: gaussian with standard deviation `sd`; bias: `offset`; quantisation: rounded to multiples of `step`;
    dropout: with `probability` a reading is missing (REP 117: +inf for a range, NaN otherwise); delay: what is shown
    was so many ticks ago; range_factor: the range times a number drawn evenly from `least` to `most`; loss: with
    `probability` a message is not heard; rate_limit: a robot sends at most once in so many ticks.
    Numbers are in SI units. `robots`: who is concerned (of a link: who hears or, for rate_limit, who speaks).
    """

    channel: str
    kind: str
    numbers: Mapping[str, float]
    robots: tuple[str, ...] | None = None  # None: all

    def __hash__(self) -> int:
        return hash((self.channel, self.kind, *sorted(self.numbers.items()), self.robots))


def allowed_kinds(channel: str) -> tuple[str, ...]:
    """The kinds of corruption that a channel can have."""
    if channel in LINK_CHANNELS:
        return LINK_KINDS
    return RANGE_KINDS if channel in RANGES else SENSOR_KINDS


def purposes(corruptions: Sequence[Corruption]) -> list[str]:
    """A name for each corruption's random numbers: channel, kind, and how many such stand before it."""
    kinds = [f"{corruption.channel} {corruption.kind}" for corruption in corruptions]
    return [f"{kind} {kinds[:index].count(kind)}" for index, kind in enumerate(kinds)]


def _form(dimension: str, sign: Sign) -> str:
    """In words, what may stand for a number of these dimension and sign."""
    if dimension == TICKS:
        return f"whole number of ticks from 1 to {MOST_TICKS}"
    if dimension == PROBABILITY:
        return "pure number from 0 to 1"
    return (
        f"number in a unit of the channel's{'' if sign == 'any' else ', ' + sign}"
        if dimension == OWN
        else form_of(dimension, sign)
    )


def read_corruptions(entry: Entry) -> tuple[Corruption, ...]:
    """The corruptions that a list describes."""
    return tuple(_read_one(part) for part in entry.items())


def corruptions_tree(corruptions: tuple[Corruption, ...]) -> list[dict[str, Any]]:
    """The corruptions as plain values that `read_corruptions` reads back."""
    return [_tree(corruption) for corruption in corruptions]


CORRUPTIONS = stored(read_corruptions, corruptions_tree, form="list of mappings") | {
    "described_by": Corruption,
    "several": True,
    "also": {
        "channel": listed(CHANNELS),
        "kind": listed(KINDS),
        **{name: _form(*rule) for numbers in KINDS.values() for name, rule in numbers.items()},
        "robots": "list of names of robots; all of them if left out",
    },
}


def longest_delay(corruptions: Sequence[Corruption]) -> int:
    """How many ticks a message can be under way beyond the one that it always takes."""
    delays = [part for part in corruptions if part.channel in LINK_CHANNELS and part.kind == "delay"]
    return int(sum(part.numbers["ticks"] for part in delays))


def _read_one(entry: Entry) -> Corruption:
    given = entry.mapping()
    for key in ("channel", "kind"):
        if key not in given:
            raise entry.problem(f"lacks '{key}'; add it.")
    channel = given["channel"].choice(list(CHANNELS))
    kind = given["kind"].choice(allowed_kinds(channel))
    section = entry.section(("channel", "kind", *KINDS[kind]), ("robots",))
    numbers = {name: _read_number(section[name], channel, *rule) for name, rule in KINDS[kind].items()}
    if numbers.get("least", 0.0) > numbers.get("most", 0.0):
        raise section["least"].problem("is greater than 'most'; exchange them.")
    robots = tuple(part.text() for part in section["robots"].items()) if "robots" in section else None
    return Corruption(channel, kind, numbers, robots)


def _read_number(entry: Entry, channel: str, dimension: str, sign: Sign) -> float:
    if dimension == TICKS:
        return float(entry.whole_number(1, MOST_TICKS))
    if dimension == OWN:
        return read_quantity(entry, CHANNELS[channel], sign)
    value = read_quantity(entry, "pure number", sign)
    if dimension == PROBABILITY and value > 1.0:
        raise entry.problem(f"has {entry.found()}; a probability is from 0 to 1.")
    return value


def _tree(corruption: Corruption) -> dict[str, Any]:
    tree: dict[str, Any] = {"channel": corruption.channel, "kind": corruption.kind}
    for name, (dimension, _) in KINDS[corruption.kind].items():
        value = corruption.numbers[name]
        if dimension == TICKS:
            tree[name] = int(value)
        else:
            tree[name] = quantity_text(value, CHANNELS[corruption.channel] if dimension == OWN else "pure number")
    if corruption.robots is not None:
        tree["robots"] = list(corruption.robots)
    return tree
