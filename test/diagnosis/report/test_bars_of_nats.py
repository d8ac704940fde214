"""The picture of the evidence has bars for laws outside the catalogue too."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace

from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, FoundEffect, PassedOver, Rival, ScreenedEffect
from cocorosim_ros.diagnosis.report.bars_of_nats import bars_of, bars_of_nats, bars_words
from cocorosim_ros.world.laws.law import Law

Example = Callable[[str], Diagnosis]
OTHERS = tuple(ScreenedEffect(f"unknown:yaw~{name}", nats, {}) for name, nats in
               (("x", 40.0), ("y", 30.0), ("z", 20.0), ("t", 10.0), ("sin_yaw", 5.0)))  # fmt: skip
ORANGE, BLUE = "#d9792b", "#2f7fc1"


def law(identifier: str, nats: float) -> FoundEffect:
    """A law that was found."""
    numbers = {"coefficient": Estimate(0.124, 0.09, 0.157, "N/((m/s) (rad/s))")}
    return FoundEffect(identifier, "a law", "", ("blimp",), "suspected", numbers, nats, law=Law.parse(identifier))


def labels(diagnosis: Diagnosis) -> list[str]:
    """Texts of the picture."""
    return re.findall(r"<text[^>]*>([^<]*)</text>", bars_of_nats(diagnosis))


def test_a_law_that_was_found_has_a_bar(example: Example) -> None:
    """With its evidence when it was screened, in its place among the catalogue, beside the best three of the others."""
    screened = (ScreenedEffect("unknown:sway~u*r", 900.0, {}), *OTHERS)
    found = replace(example("mismatch"), effects=(law("unknown:sway~u*r", 1038.0),), screened_laws=screened)
    bars = bars_of(found)
    assert [(bar.id, bar.nats) for bar in bars[:5]] == [
        ("unknown:sway~u*r", 900.0), ("added_mass", 560.0), ("unknown:yaw~x", 40.0), ("unknown:yaw~y", 30.0),
        ("unknown:yaw~z", 20.0),
    ]  # fmt: skip
    assert not {"unknown:yaw~t", "unknown:yaw~sin_yaw"} & {bar.id for bar in bars}
    assert "law: sway \u223c u\u00b7r" in labels(found)
    assert ORANGE in bars_of_nats(found)
    assert "Of 6 laws tried" in bars_words(found) and "Orange: found." in bars_words(found)


def test_a_law_that_was_looked_for_later_has_a_bar_too(example: Example) -> None:
    """What the model would lose without it, hatched and said; an infinite or tiny evidence has none."""
    found = replace(example("mismatch"), effects=(law("unknown:heave~x", 12.0), law("unknown:heave~y", 0.01)))
    (bar,) = [each for each in bars_of(found) if each.beside]
    assert (bar.id, bar.nats) == ("unknown:heave~x", 12.0)
    assert "Hatched" in bars_words(found) and "<pattern" in bars_of_nats(found)
    unknown = replace(found, effects=(law("unknown:heave~x", math.nan),))
    assert not any(each.beside for each in bars_of(unknown))


def test_laws_without_a_name_and_rivals_are_told_apart(example: Example) -> None:
    """A passed-over law has an outline, a rival law is blue, though both lie behind the best of the others."""
    passed = PassedOver(law("unknown:yaw~t", 10.0), stands=True, because=("free runs do not gain",), shortly="")
    effect = replace(example("mismatch").effects[0], ambiguous_with=(Rival("unknown:yaw~sin_yaw", 1.0),))
    found = replace(example("mismatch"), effects=(effect,), passed_over=(passed,), screened_laws=OTHERS)
    assert {bar.id for bar in bars_of(found)} >= {each.id for each in OTHERS}
    assert {"Orange: found.", "Orange outline: without a name.", "Blue: rivals of what was found."} <= {
        f"{sentence}." for sentence in re.split(r"\.\s*", bars_words(found))
    }
    assert f"fill: none; stroke: {ORANGE}" in bars_of_nats(found) and BLUE in bars_of_nats(found)


def test_without_laws_the_caption_tells_none(example: Example) -> None:
    """Neither laws nor colours that the picture does not have."""
    words = bars_words(example("recalibrate"))
    assert not any(word in words for word in ("Law:", "Orange", "Blue", "Hatched"))
