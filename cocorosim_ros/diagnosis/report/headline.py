"""The headline of a diagnosis: one sentence of at most `REPORT.most_words` words, whatever was found.

It is told in several ways, each shorter than the one before, and the first that is short enough is taken: all names,
fewer of them and the number of the others, the same in the shortest words, the number alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.law_words import short_law_words, short_words
from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import FoundEffect, PassedOver, Recalibrated, Verdict
from cocorosim_ros.diagnosis.report.significance import may_be_nothing
from cocorosim_ros.diagnosis.report.verdict_words import is_of_instruments
from cocorosim_ros.diagnosis.report.words import effect_words

_NAMELESS = "something that no entry of the catalogue explains"
_SHIFTED = "Nothing is shown to be missing, but the model's numbers have shifted:"
_BEGIN = "Compared with when it was well"


class Name(NamedTuple):
    """Words for something that was found, and the fewest words for it."""

    words: str
    short: str


def sentence_of(
    verdict: Verdict,
    effects: Sequence[FoundEffect],
    moved: Sequence[Recalibrated],
    passed: Sequence[PassedOver] = (),
    *,
    collapsed: bool = False,
    beyond_floor: Sequence[str] = (),
) -> str:
    """The headline of a diagnosis against a platform.

    passed: what gets no name; told only where nothing has one. collapsed: whether the recalibrated model foretells
    unseen data worse than the platform as given. beyond_floor: channels in which free runs lack what nothing
    stands for.
    """
    of_fit = [each for each in effects if each.correction is None]  # axes are put right before any fit
    if collapsed and (of_fit or not effects):
        return _of_collapsed(of_fit)
    if verdict == "insufficient":
        return _of_blind(moved)
    if verdict == "consistent":
        return "The model explains the recordings: nothing is missing that they could show."
    if verdict == "recalibrate":
        return _named(_numbers(moved), lambda told: f"{_SHIFTED} {told}.", "numbers")
    if not effects:
        return _of_nameless(passed, beyond_floor, moved)
    whose = whose_words(effects[0].robots) if len({each.robots for each in effects}) == 1 else ""
    certain, doubtful = ([each for each in effects if each.tier == tier] for tier in ("confirmed", "suspected"))
    names = [*map(_name, certain), *(_name(each, "perhaps " if certain else "") for each in doubtful)]
    if all(map(is_of_instruments, effects)):
        begin = f"{'The' if certain else 'Perhaps the'} readings{whose} err"
    else:
        begin = f"{'Missing' if certain else 'Perhaps missing'} from the model{whose}"
    return _named(names, lambda told: f"{begin}: {told}.", "effects")


def difference_sentence(
    verdict: Verdict,
    effects: Sequence[FoundEffect],
    moved: Sequence[Recalibrated],
    nameless: str = "",
    vague: Sequence[str] = (),
    either: Sequence[Sequence[str]] = (),
) -> str:
    """The headline of a comparison with recordings of the same vehicle when it was well.

    nameless: the law that explains what no entry of the catalogue does, "" for none. vague: names of what differs by an
    amount that may as well be nothing. either: names of instruments' errors of which one or the other differs.
    """
    if verdict == "insufficient":
        return f"{_BEGIN}: these recordings do not excite the vehicle enough to tell what differs."
    if verdict == "consistent":
        return f"{_BEGIN}, nothing differs that these recordings could show."
    found = [_name(each, "perhaps " if each.tier == "suspected" else "") for each in effects]
    names = [*_numbers(moved), *found, *([Name(_NAMELESS, "something")] if nameless else [])]
    names += [_unsure("most likely ", effect_words(each), ", by how much cannot be told", each) for each in vague]
    names += [_of_either(each) for each in either]
    return _named(list(dict.fromkeys(names)), lambda told: f"{_BEGIN}, these differ: {told}.", "findings")


def other_vehicle_headline(robot: str, factors: Mapping[str, float]) -> str:
    """The headline where recordings do not look like those of the same vehicle.

    factors: words of the numbers of a robot that say so, and how many times what it was each is.
    """
    words = [f"{name} {factor:.2g}" for name, factor in factors.items()]
    tellings = [f"{', '.join(words[:count])} times as before" for count in range(len(words), 0, -1)]
    most = [f"{robot} does not look like the same vehicle: {told}; nothing is named." for told in tellings]
    return _short_enough((*most, "These recordings do not look like those of the same vehicle; nothing is named."))


def not_followed_headline(platform: str, *, against: bool = False) -> str:
    """The headline where a model does not follow its recordings, or those of --against."""
    which = "the recordings of --against" if against else "these recordings"
    return _short_enough(
        (
            f"The model of {platform} does not follow {which}; nothing is named.",
            f"The model does not follow {which}; nothing is named.",
        )
    )


def unable_sentence(reasons: Sequence[str]) -> str:
    """The headline where nothing could be tested: the reason, if it is a single short one."""
    return _short_enough((*reasons[: len(reasons) == 1], _UNABLE))


_UNABLE = "These recordings cannot tell what the model lacks, for the reasons below."


def whose_words(robots: Sequence[str]) -> str:
    """Words such as ' of lily_01, lily_02', '' without robots; many are counted."""
    if not robots:
        return ""
    return f" of {', '.join(robots) if len(robots) <= REPORT.most_robots else f'{len(robots)} robots'}"


def plain(name: str) -> str:
    """A name of the catalogue or of a number, without underscores."""
    return name.replace("_", " ")


def _of_blind(moved: Sequence[Recalibrated]) -> str:
    begin = "These recordings do not excite the vehicle enough to tell what its model lacks"
    if not moved:
        return f"{begin}."
    return _named(_numbers(moved), lambda told: f"{begin}; its numbers have shifted: {told}.", "numbers")


def _of_collapsed(effects: Sequence[FoundEffect]) -> str:
    if not effects:
        return "The fit has collapsed: whether anything is missing from the model is not known."
    begin = "The fit has collapsed, so that nothing is sure; perhaps"
    return _named([_name(each) for each in effects], lambda told: f"{begin} {told}.", "effects")


def _of_nameless(passed: Sequence[PassedOver], beyond_floor: Sequence[str], moved: Sequence[Recalibrated]) -> str:
    """The headline where something is missing that has no name: by evidence for some effect, or by free runs alone."""
    if any(each.stands for each in passed):
        return _short_enough(_without_name(passed))
    begin = f"Something without a name is missing in {' and '.join(beyond_floor)}"
    shifted = f"{begin}; the model's numbers have shifted:"
    return _named(_numbers(moved), lambda told: f"{shifted} {told}.", "numbers") if moved else f"{begin}."


def _without_name(passed: Sequence[PassedOver]) -> Iterator[str]:
    likeliest = max((each for each in passed if each.stands), key=lambda each: each.found.nats)
    name = _name(replace(likeliest.found, parameters={}))  # without its size: why it has no name is said behind it
    for words in (name.words, name.short):
        yield f"Something is missing, most like {words}, but {likeliest.shortly}."
    yield f"Something is missing, but {likeliest.shortly}."
    yield "Something is missing that has no name yet."


def _name(found: FoundEffect, before: str = "") -> Name:
    short = short_law_words(found.law) if found.law is not None else short_words(found.id)
    doubt = " (may be nothing)" if may_be_nothing(found) else ""
    return Name(f"{before}{found.name}{doubt}", f"{before}{short}{doubt}")


def _numbers(moved: Sequence[Recalibrated]) -> list[Name]:
    return [Name(words, words) for words in dict.fromkeys(parameter_words(part.parameter) for part in moved)]


def _unsure(before: str, words: str, behind: str, name: str) -> Name:
    return Name(f"{before}{words}{behind}", f"{before}{short_words(name)}")


def _of_either(names: Sequence[str]) -> Name:
    return Name(f"{' or '.join(map(effect_words, names))}, which of them cannot be told",
                " or ".join(map(short_words, names)))  # fmt: skip


def _named(names: Sequence[Name], sentence: Callable[[str], str], kind: str) -> str:
    """The sentence with as many names as its words allow; kind: what they are, in the plural."""
    return _short_enough(_tellings(names, sentence, kind))


def _tellings(names: Sequence[Name], sentence: Callable[[str], str], kind: str) -> Iterator[str]:
    for words in ([each.words for each in names], list(dict.fromkeys(each.short for each in names))):
        for count in range(len(words), 0, -1):
            yield sentence(_listed(words[:count], len(words) - count))
    yield sentence(f"{len(names)} {kind}, named below")


def _short_enough(tellings: Iterable[str]) -> str:
    """The first of some tellings that is one sentence and short enough; the last one is short whatever was found."""
    *longer, shortest = tellings
    return next((told for told in longer if len(told.split()) <= REPORT.most_words and ". " not in told), shortest)


def _listed(names: Sequence[str], more: int) -> str:
    if more:
        return f"{'; '.join(names)}; and {more} more"
    return names[0] if len(names) == 1 else f"{'; '.join(names[:-1])}; and {names[-1]}"
