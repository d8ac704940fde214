"""What actuators report: in SI, each at its own times, and every mistake in one sentence."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Convert = Callable[..., SimpleNamespace]
GOOD = """\
  - files: a.csv
    time: {column: t, unit: s}
    robot: boat
    streams:
      actuator_feedback:
        left: {rotation: {column: n, unit: rpm}, current: {column: i, unit: mA}}
        rudder: {fraction: {column: d, unit: deg, stop: 0 deg, forward: 35 deg, reverse: -35 deg}}
"""
LOG = "t,n,i,d\n0,60,1500,7\n1,-30,,-70\n"


def by_name(message: Any) -> dict[str, float]:
    """The numbers of a message."""
    return dict(zip(message.content.name, message.content.value.tolist(), strict=True))


def test_numbers_are_in_si(convert_csv: Convert) -> None:
    """60 rpm are 2 pi rad/s, 7 of 35 deg a fifth; what is beyond the maximum stays, for it was measured."""
    first, second = map(by_name, convert_csv(GOOD, {"a.csv": LOG}).topics["/boat/actuator_feedback"])
    assert first == pytest.approx({"left.rotation": 2 * math.pi, "left.current": 1.5, "rudder.fraction": 0.2})
    assert (second["left.rotation"], second["rudder.fraction"]) == pytest.approx((-math.pi, -2.0))
    assert math.isnan(second["left.current"])


def test_each_reports_at_its_own_times(convert_csv: Convert) -> None:
    """Two files are two kinds of messages on one topic, in the order of time; nothing is held until another reports."""
    tables = (
        GOOD.replace("left: {rotation: {column: n, unit: rpm}, current: {column: i, unit: mA}}", "")
        + GOOD.replace("a.csv", "b.csv").partition("        rudder:")[0]
    )
    files = {"a.csv": "t,d\n0,35\n2,-35\n", "b.csv": "t,n,i\n1,30,0\n3,60,0\n"}
    made = convert_csv(tables, files)
    messages = made.topics["/boat/actuator_feedback"]
    assert [message.at for message in messages] == [0, 10**9, 2 * 10**9, 3 * 10**9]
    assert [list(by_name(message)) for message in messages[:2]] == [
        ["rudder.fraction"],
        ["left.rotation", "left.current"],
    ]


def test_one_topic_is_told_once(convert_csv: Convert) -> None:
    """The extent of the topic is that of all its messages."""
    from cocorosim_ros.library.convert import _described

    tables = GOOD + GOOD.replace("a.csv", "b.csv").replace("left:", "right:").replace("rudder:", "fin:")
    done = convert_csv(tables, {"a.csv": LOG, "b.csv": LOG.replace("\n1,", "\n4,")}).done
    (extent,) = _described(done[0]).topics
    assert (extent.topic, extent.messages, extent.duration) == ("actuator_feedback", 4, 4.0)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("unit: rpm", "unit: furlong", "map.yaml line 9: .*left.rotation.unit' has 'furlong', which is no unit of"),
        ("unit: mA", "unit: V", "left.current.unit' has 'V', which is no unit of this number; allowed: 'A' or 'mA'"),
        ("rotation: {", "rpm: {", "left.rpm' is not a known key"),
        ("left: {rotation", "'1': {rotation", "is no name of an actuator"),
        ("stop: 0 deg, forward: 35 deg, ", "", "lacks 'stop' and 'forward'"),
        ("{column: n, unit: rpm}", "{column: n}", "left.rotation' lacks 'unit'"),
        ("left: {rotation: {column: n, unit: rpm}, current: {column: i, unit: mA}}", "left: {}",
         "names nothing that this actuator reports; add one of fraction, rotation"),
        ("        left:", "        axes: ned_frd\n        left:", "says nothing here; turn the sign of an angle"),
    ],
)  # fmt: skip
def test_a_wrong_map(convert_csv: Convert, old: str, new: str, sentence: str) -> None:
    """One piece of a good map replaced: the sentence names the place and the way out."""
    assert old in GOOD
    with pytest.raises(CocorosimError, match=sentence) as caught:
        convert_csv(GOOD.replace(old, new, 1), {"a.csv": LOG})
    assert "\n" not in str(caught.value)


def test_a_number_is_given_once(convert_csv: Convert) -> None:
    """Two tables that both give the angle of one rudder contradict each other."""
    again = GOOD.replace("a.csv", "b.csv").replace("left:", "right:")
    with pytest.raises(CocorosimError, match=r"rudder\.fraction is given by several tables; give it by one of them"):
        convert_csv(GOOD + again, {"a.csv": LOG, "b.csv": LOG})
