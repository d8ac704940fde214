"""An error of one instrument that may as well be one of another instrument gets no name; both are told."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.against.either_instrument import apart, of_either
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect
from cocorosim_ros.diagnosis.report.headline import difference_sentence

LOG, CAMERA, LATE, COMMANDS = (
    ("speed_log_scale", "velocity"), ("camera_scale", "pose"), ("sensor_latency", "pose"), ("command_delay", None)
)  # fmt: skip


def _named(own: tuple[str, str | None], *rivals: tuple[str, str | None]) -> Any:
    """A named effect and its rivals, by identifier and topic."""

    def candidate(identifier: str, topic: str | None) -> Any:
        return SimpleNamespace(entry=SimpleNamespace(id=identifier, topic=topic))

    return SimpleNamespace(candidate=candidate(*own), rivals=[SimpleNamespace(candidate=candidate(*r)) for r in rivals])


def _found(identifier: str, topic: str | None) -> FoundEffect:
    size = {"scale": Estimate(1.09, 1.04, 1.14, "1")}
    return FoundEffect(identifier, identifier, "", ("boat",), "suspected", size, 25.0, topic=topic)


@pytest.mark.parametrize(
    ("named", "either"),
    [
        (_named(LOG, CAMERA), (("speed_log_scale", "camera_scale"),)),
        (_named(LOG), ()),
        (_named(LATE, COMMANDS), ()),
        (_named(COMMANDS, LATE), ()),
    ],
)
def test_a_rival_of_another_stream_takes_the_name(named: Any, either: tuple[tuple[str, ...], ...]) -> None:
    """A rival among motions or commands does not: it is told beside the name."""
    own = named.candidate.entry
    found = _found(own.id, own.topic)
    left, undecided = apart([named], [found])
    assert (left, undecided) == (() if either else (found,), either)


def test_both_are_told() -> None:
    """In the headline and in a sentence that says what to do."""
    names = ("speed_log_scale", "sensor_latency:pose")
    assert difference_sentence("mismatch", (), (), "", (), (names,)) == (
        "Compared with when it was well, these differ: speed log scale or sensor latency, pose, "
        "which of them cannot be told."
    )
    assert all(part in of_either(names) for part in (*names, "cannot tell", "third"))
