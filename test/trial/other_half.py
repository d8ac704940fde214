"""Whether effects that one half of a vehicle's recordings shows are found in the other half too, with sign and size."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

Tree = dict[str, Any]
TIERS = ("confirmed", "suspected")


NOT_NAMED, NOTHING_CLEAR = "not named there", "named there, but no amplitude is clear here, so that it has no sign"
OTHER_SIGN, OTHER_SIZE, KEPT = "named with another sign there", "named with another size there", "kept"


class Kept(NamedTuple):
    """Counts of effects of one half: all, those that keep their sign in the other half, and their size too."""

    all: int
    sign: int
    size: int

    def __add__(self, other: tuple[Any, ...]) -> Kept:
        return Kept(*(mine + others for mine, others in zip(self, other, strict=True)))

    @property
    def words(self) -> str:
        """The counts in words."""
        return f"{self.sign} of {self.all} keep the sign, {self.size} the size" if self.all else "none"


def kept(first: Tree | None, second: Tree | None, tier: str) -> Kept | None:
    """Counts of the effects of a tier that a diagnosis of one half names, against that of the other half.

    None where there is no diagnosis.
    """
    if first is None or second is None:
        return None
    found = [answer for _, answer in answers(first, second, tier)]
    return Kept(len(found), sum(each in (KEPT, OTHER_SIZE) for each in found), found.count(KEPT))


def both_ways(first: Tree | None, second: Tree | None, tier: str) -> Kept:
    """Counts of both halves, each against the other; nothing where there is no diagnosis."""
    return (kept(first, second, tier) or Kept(0, 0, 0)) + (kept(second, first, tier) or Kept(0, 0, 0))


def answers(first: Tree, second: Tree, tier: str) -> list[tuple[Tree, str]]:
    """Effects of a tier that one half names, each with what the other half says of it.

    Asked are the amplitudes that are clear in the first half: those whose interval does not hold the value without the
    effect; and of axes that were put right, the words.
    """
    return [(each, _answer(each, _same(each, second))) for each in first["effects"] if each["tier"] == tier]


def _same(effect: Tree, other: Tree) -> Tree | None:
    """The effect of the other half that has the same name, stream and robots."""
    return next((each for each in other["effects"] if _identity(each) == _identity(effect)), None)


def _identity(effect: Tree) -> tuple[str, str, tuple[str, ...]]:
    return effect["id"], effect.get("topic") or "", tuple(sorted(effect["robots"]))


def _answer(effect: Tree, other: Tree | None) -> str:
    """What the other half says of an effect: whether it keeps its sign, and its size within both 95 % intervals."""
    if other is None:
        return NOT_NAMED
    one, two = effect["parameters"], other["parameters"]
    if "correction" in one:
        return KEPT if one["correction"]["value"] == two["correction"]["value"] else OTHER_SIGN
    without = neutral(effect["id"], effect.get("topic"))
    clear = [name for name, value in without.items() if name in one and not _holds(one[name], value)]
    if not clear or not all(name in two for name in clear):
        return NOTHING_CLEAR
    sides = [(one[name]["value"] > without[name], two[name]["value"] > without[name]) for name in clear]
    if not all(mine == others for mine, others in sides):
        return OTHER_SIGN
    return KEPT if all(_meet(one[name], two[name]) for name in clear) else OTHER_SIZE


def neutral(identifier: str, topic: str | None) -> Mapping[str, float]:
    """Amplitudes of an effect by name, each with its value where the effect is absent."""
    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES

    if identifier.startswith("unknown:"):
        return {"coefficient": 0.0}
    own = [each for each in ENTRIES if (each.id, each.topic or "") == (identifier, topic or "")]
    return {amplitude.name: amplitude.neutral for each in own for amplitude in each.amplitudes}


def _ends(number: Tree) -> tuple[float, float]:
    low, high = (number["value"] if end is None else end for end in number["ci95"])
    return min(low, high), max(low, high)


def _holds(number: Tree, value: float) -> bool:
    low, high = _ends(number)
    return bool(low <= value <= high)


def _meet(one: Tree, two: Tree) -> bool:
    """Whether two intervals have anything in common."""
    (low, high), (other_low, other_high) = _ends(one), _ends(two)
    return bool(low <= other_high and other_low <= high)
