"""A force that is left over beside a named effect: which effects it speaks against, and that it is found."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.criteria.showing import REMAINDER
from cocorosim_ros.diagnosis.showing import remainder as room
from cocorosim_ros.diagnosis.showing.remainder import LeftOver, left_over, remainder
from cocorosim_ros.world.laws.law import Law


@pytest.mark.parametrize(
    ("channel", "of", "robots", "share", "objected"),
    [
        ("sway", "sway", ("a",), 1.1, True),
        ("sway", "world_y", ("a", "b"), 1.1, True),  # the same force in other axes
        ("sway", "yaw", ("a",), 1.1, False),
        ("yaw", "yaw", ("a",), 1.1, True),
        ("yaw", "sway", ("a",), 1.1, False),
        ("sway", "sway", ("b",), 1.1, False),
        ("sway", "sway", ("a",), 0.9, False),
        ("pressure", "heave", ("a",), 9.0, False),
    ],
)
def test_what_a_remainder_speaks_against(
    channel: str, of: str, robots: tuple[str, ...], share: float, objected: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An effect of motion in the same equation of the same robot, of whose evidence it has more than a share."""
    left = LeftOver(Law.parse(f"unknown:{of}~|v|*thrust"), share * REMAINDER.share * 100.0, robots)
    objections = spoken_against("steady_current", channel, left, monkeypatch)
    assert len(objections) == objected
    assert all("|v|*thrust" in each.sentence for each in objections)


def spoken_against(effect: str, channel: str, left: LeftOver, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Objections to an effect of 100 nats of robot a beside which this is left over."""
    found = SimpleNamespace(nats=100.0, robots=("a",))
    named = SimpleNamespace(candidate=SimpleNamespace(entry=SimpleNamespace(id=effect, channel=channel)))
    monkeypatch.setattr(room, "effects_of", lambda case: [(found, named)])
    monkeypatch.setattr(room, "left_over", lambda fit, courses: (left,))
    case: Any = SimpleNamespace(final=None, courses=())
    objections = list(remainder(case))
    assert all(each.effect is found for each in objections)
    return objections


@pytest.mark.parametrize(("effect", "objected"), [("battery_sag", 1), ("linear_drag", 0)])
def test_what_one_thruster_loses_alone_turns_the_vehicle(
    effect: str, objected: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A moment that is left over speaks against an effect of thrust ahead, and not against one of drag ahead."""
    left = LeftOver(Law.parse("unknown:yaw~thrust*t"), 1.1 * REMAINDER.share * 100.0, ("a",))
    assert len(spoken_against(effect, "surge", left, monkeypatch)) == objected


def test_a_force_without_a_name_is_left_over(swim: Any) -> None:
    """A force that goes with the amount of the diving speed, in a recalibrated model that names nothing."""
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.law_text import LawText

    plain = load_platform("lily")
    pushed = replace(plain, effect_quantities={"law_1": {"world_x": LawText(0.02, "|w|")}})
    fit = base_fit(swim(pushed, 200.0, seed=12, base=plain))
    assert left_over(fit, smoothed_tracks(fit))[0].law.text == "unknown:world_x~|w|"
    sound = base_fit(swim(plain, 200.0, seed=12))
    assert left_over(sound, smoothed_tracks(sound)) == ()
