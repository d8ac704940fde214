"""Effects of one half of the recordings that the other half shows too: by hand."""

from __future__ import annotations

from typing import Any

import pytest


def effect(identifier: str, tier: str = "confirmed", topic: str = "", **numbers: tuple[float, float, float]) -> Any:
    """An effect of lily_01; numbers: value and the ends of its interval."""
    parameters = {name: {"value": value, "ci95": [low, high]} for name, (value, low, high) in numbers.items()}
    tree = {"id": identifier, "tier": tier, "robots": ["lily_01"], "parameters": parameters}
    return tree | ({"topic": topic} if topic else {})


BIAS = effect("torque_bias", torque=(1.0, 0.8, 1.2))
SCALE = effect("camera_scale", topic="pose", scale=(1.1, 1.05, 1.15))  # without it the scale is 1


@pytest.mark.parametrize(
    ("one", "two", "sign", "size"),
    [
        (BIAS, effect("torque_bias", "suspected", torque=(1.3, 1.1, 1.5)), 1, 1),
        (BIAS, effect("torque_bias", torque=(2.0, 1.9, 2.1)), 1, 0),
        (BIAS, effect("torque_bias", torque=(-1.0, -3.0, 1.0)), 0, 0),  # the intervals meet, the signs do not
        (BIAS, effect("thruster_asymmetry", difference=(1.0, 0.8, 1.2)), 0, 0),
        (SCALE, effect("camera_scale", topic="pose", scale=(0.95, 0.9, 1.2)), 0, 0),  # below 1, though above 0
        (SCALE, effect("camera_scale", topic="pose", scale=(1.05, 1.0, 1.1)), 1, 1),
        (SCALE, effect("camera_scale", topic="velocity", scale=(1.1, 1.05, 1.15)), 0, 0),
    ],
)
def test_sign_and_size_on_the_other_half(one: Any, two: Any, sign: int, size: int) -> None:
    """A name, its stream, the side of the neutral value, and intervals that meet."""
    from trial.other_half import kept

    assert kept({"effects": [one]}, {"effects": [two]}, "confirmed") == (1, sign, size)
    assert kept({"effects": [one]}, {"effects": []}, "confirmed") == (1, 0, 0)
    assert kept({"effects": [one]}, {"effects": [two]}, "suspected") == (0, 0, 0)


def test_an_amplitude_that_is_nothing_is_not_asked_for() -> None:
    """Of a current along x, y may have any sign; what the diagnosis put right is asked for its words."""
    from trial.other_half import kept

    one = effect("steady_current", x=(0.1, 0.05, 0.15), y=(0.01, -0.05, 0.07))
    two = effect("steady_current", x=(0.12, 0.1, 0.14), y=(-0.2, -0.3, -0.1))
    assert kept({"effects": [one]}, {"effects": [two]}, "confirmed") == (1, 1, 1)
    mixed, other = (
        {**effect("frame_mixup", topic="pose"), "parameters": {"correction": {"value": words, "ci95": [None, None]}}}
        for words in ("x and y", "z")
    )
    assert kept({"effects": [mixed]}, {"effects": [mixed]}, "confirmed") == (1, 1, 1)
    assert kept({"effects": [mixed]}, {"effects": [other]}, "confirmed") == (1, 0, 0)


def test_both_halves_are_asked() -> None:
    """What the second half alone confirms counts: a name that the first has with another size, one that it lacks."""
    from trial.other_half import NOT_NAMED, OTHER_SIZE, Kept, answers, both_ways

    first = {"effects": [effect("torque_bias", "suspected", torque=(2.0, 1.9, 2.1))]}
    second = {"effects": [BIAS, SCALE]}
    assert both_ways(first, second, "confirmed") == both_ways(second, first, "confirmed") == Kept(2, 1, 0)
    assert both_ways(first, second, "suspected") == Kept(1, 1, 0)
    assert both_ways(first, None, "confirmed") == Kept(0, 0, 0)
    assert [said for _, said in answers(second, first, "confirmed")] == [OTHER_SIZE, NOT_NAMED]


def test_what_is_not_clear_has_no_sign() -> None:
    """An effect of which every interval holds its absence is not kept, whatever the other half says."""
    from trial.other_half import NOTHING_CLEAR, answers, kept

    vague = effect("torque_bias", torque=(1.0, -0.5, 2.5))
    assert kept({"effects": [vague]}, {"effects": [BIAS]}, "confirmed") == (1, 0, 0)
    ((_, said),) = answers({"effects": [vague]}, {"effects": [BIAS]}, "confirmed")
    assert said == NOTHING_CLEAR
