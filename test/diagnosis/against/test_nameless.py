"""A law that is left over counts where alike recordings do not differ from each other by one."""

from __future__ import annotations

import pytest

from cocorosim_ros.diagnosis.against.nameless import differ_namelessly, left_over_words

LAW = "unknown:pressure~speed*speed"


@pytest.mark.parametrize(
    ("control", "alike"), [((), False), (("sensor_latency",), False), (("drag", "unknown:pose~x*x"), True)]
)
def test_what_is_left_over_beside_recordings_that_differ_too(control: tuple[str, ...], alike: bool) -> None:
    """The sentence says which of the two it is; names of the control alone make no law."""
    assert differ_namelessly(control) == alike
    (said,) = left_over_words(LAW, control)
    assert ("so that this is no difference" in said) == alike
    assert ("Something differs that no entry of the catalogue" in said) != alike


def test_nothing_left_over_has_no_words() -> None:
    """Whatever alike recordings differ in."""
    assert left_over_words("", ("unknown:pose~x*x",)) == left_over_words("", ()) == ()
