"""What a function of the library cannot use is refused by one sentence that names the argument."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError

SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"
TIME, PLACES, YAW = [0.0, 0.5], np.zeros((2, 2, 3)), np.zeros((2, 2))
Call = Callable[[Any, Path], Any]

WRONG: dict[str, tuple[str, tuple[Any, ...], Call]] = {
    # call: the argument, what it is given, and the call with that and a folder that does not exist
    "load_scenario source": ("source", (None, 5, [], {}, b"one_lily"), lambda x, out: cocorosim.load_scenario(x)),
    "load_scenario seed": (
        "seed",
        (-1, 1.5, "7", True, [7], 2**63, float("nan")),
        lambda x, out: cocorosim.load_scenario("one_lily", seed=x),
    ),
    "load_scenario duration": (
        "duration",
        ([1], True, {}, "60", -1, 0, float("nan"), 10**400, 1e300, "1e300 s", 1j, np.ones(2), 1e-12),
        lambda x, out: cocorosim.load_scenario("one_lily", duration=x),
    ),
    "load_scenario external": (
        "external",
        (5, [5], {"lily_01": 1}, "lily_77", [["lily_01"]]),
        lambda x, out: cocorosim.load_scenario("one_lily", external=x),
    ),
    "load_scenario controller": (
        "controller",
        (5, [], "idel", "mine.py"),
        lambda x, out: cocorosim.load_scenario("one_lily", controller=x),
    ),
    "of a record: seed": (
        "seed",
        (-1, 1.5),
        lambda x, out: cocorosim.load_scenario(cocorosim.load_scenario("one_lily"), seed=x),
    ),
    "load_platform": ("name_or_path", (None, 5, []), lambda x, out: cocorosim.load_platform(x)),
    "load_design": ("name_or_path", (None, 5, []), lambda x, out: cocorosim.load_design(x)),
    "load_design replicates": (
        "replicates",
        (0, 1.5, "2", [2], np.int64(0), 10**9),
        lambda x, out: cocorosim.load_design("smoke", x),
    ),
    "load_design groups": ("groups", (5, [5]), lambda x, out: cocorosim.load_design("smoke", groups=x)),
    "load_design numerics": ("numerics", (5, [5]), lambda x, out: cocorosim.load_design("smoke", numerics=x)),
    "load_design controller": ("controller", (5, "idel"), lambda x, out: cocorosim.load_design("smoke", controller=x)),
    "simulate scenario": ("scenario", (None, 5, []), lambda x, out: cocorosim.simulate(x)),
    "simulate run": (
        "run",
        (-1, 1.5, "0", [0], True, None, 2**63),
        lambda x, out: cocorosim.simulate("one_lily", duration=5, run=x),
    ),
    "simulate duration": ("duration", ([1], True, 1e9), lambda x, out: cocorosim.simulate("five_lilys", duration=x)),
    "simulate_runs scenario": ("scenario", (5,), lambda x, out: cocorosim.simulate_runs(x, 2)),
    "simulate_runs runs": (
        "runs",
        (0, 1.5, "2", [2], True, None, 2**62),
        lambda x, out: cocorosim.simulate_runs("one_lily", x, duration=5),
    ),
    "simulate_runs first": (
        "first",
        (-1, 1.5, "0", True),
        lambda x, out: cocorosim.simulate_runs("one_lily", 1, first=x, duration=5),
    ),
    "record scenario": ("scenario", (5,), cocorosim.record),
    "record out": ("out", (None, 5, [], {}), lambda x, out: cocorosim.record("one_lily", x)),
    "record run": ("run", (-1, 1.5, "0"), lambda x, out: cocorosim.record("one_lily", out, run=x)),
    "read_recording": ("path", (None, 5, [], {}), lambda x, out: cocorosim.read_recording(x)),
    "measure source": ("source", (None, 5, [1]), lambda x, out: cocorosim.measure(x)),
    "measure time": (
        "time",
        (5, [[0.0, 0.5]], "ab", [0.0, 1e300], [0.0, 1e10], [0.0, 10**400], [0.0], [0.0, 0.5, 1.0], [0.5, 0.0], 1j),
        lambda x, out: cocorosim.measure(x, PLACES, YAW),
    ),
    "measure position": (
        "position",
        (5, [[0.0]], "ab", PLACES[..., :2], PLACES[:1], PLACES + 1j, [[["a"]]], [[1.0], [1.0, 2.0]]),
        lambda x, out: cocorosim.measure(TIME, x, YAW),
    ),
    "measure yaw": ("yaw", ("ab", [["a"]], YAW + 1j, None), lambda x, out: cocorosim.measure(TIME, PLACES, x)),
    "measure robots": (
        "robots",
        (5, [1, 2], "ab", ["a"], ["a", "a"], ["a", "b", "a"], [["a"], ["b"]], {"a": 1, "b": 2}),
        lambda x, out: cocorosim.measure(TIME, PLACES, YAW, robots=x),
    ),
    "measure interval": (
        "interval",
        ([1], True, "5", 0, -1.0, {}, float("inf"), 10**400, 1e300),
        lambda x, out: cocorosim.measure(TIME, PLACES, YAW, interval=x),
    ),
    "measure tracks": (
        "source",
        (
            {"a": 5},
            {"a": ([0], [[0, 0, 0]], [0])},
            {5: cocorosim.PoseTrack(np.arange(2), PLACES[:, 0], YAW[:, 0])},
            {"a": cocorosim.PoseTrack([0.0, 0.5], [[0, 0, 0]] * 2, [0, 0])},  # type: ignore[arg-type]
            {"a": cocorosim.PoseTrack([[0, 1]], [[0, 0, 0]] * 2, [0, 0])},  # type: ignore[arg-type]
            {"a": cocorosim.PoseTrack([0, 1], [[0, 0, 0]], [0, 0])},  # type: ignore[arg-type]
            {"a": cocorosim.PoseTrack([0, 1], [[0, 0, "z"]] * 2, [0, 0])},  # type: ignore[arg-type]
            {"a": cocorosim.PoseTrack([0, 1], [[0, 0, 0]] * 2, None)},  # type: ignore[arg-type]
        ),
        lambda x, out: cocorosim.measure(x),
    ),
    "Recording.measure": ("interval", ([1], True, "5"), lambda x, out: cocorosim.read_recording(SHIPPED).measure(x)),
    "Recording.to_frame": ("topic", (5, [], "sonar"), lambda x, out: cocorosim.read_recording(SHIPPED).to_frame(x)),
    "Recording.draw out": ("out", (None, 5), lambda x, out: cocorosim.read_recording(SHIPPED).draw(x)),
    "Recording.draw statistics": (
        "statistics",
        (5, {}),
        lambda x, out: cocorosim.read_recording(SHIPPED).draw(out, x),
    ),
    "convert map": ("map", (None, 5, [], {}), lambda x, out: cocorosim.convert(x, "logs", out)),
    "convert source": ("source", (None, 5, [], {}), lambda x, out: cocorosim.convert("haizhe_auv", x, out)),
    "convert out": ("out", (None, 5), lambda x, out: cocorosim.convert("haizhe_auv", "logs", x)),
    "convert progress": (
        "progress",
        (None, 5),
        lambda x, out: cocorosim.convert("haizhe_auv", "logs", out, progress=x),
    ),
    "diagnose bags": ("bags", (None, 5, [], {}, [5]), lambda x, out: cocorosim.diagnose(x, "lily")),
    "diagnose platform": ("platform", (None, 5, [], {}), lambda x, out: cocorosim.diagnose("bag", x)),
    "diagnose known": ("known", (5, [], {}), lambda x, out: cocorosim.diagnose("bag", "lily", known=x)),
    "diagnose out": ("out", (5, [], {}), lambda x, out: cocorosim.diagnose("bag", "lily", out=x)),
    "diagnose progress": ("progress", (None, 5), lambda x, out: cocorosim.diagnose("bag", "lily", progress=x)),
    "run_design design": ("design", (None, 5, [], {}), cocorosim.run_design),
    "run_design out": ("out", (None, 5, [], {}), lambda x, out: cocorosim.run_design("smoke", x)),
    "run_design workers": (
        "workers",
        (0, -1, 1.5, True, [1]),
        lambda x, out: cocorosim.run_design("smoke", out, workers=x),
    ),
    "run_design replicates": (
        "replicates",
        (0, 1.5, "2", float("nan"), True),
        lambda x, out: cocorosim.run_design(cocorosim.load_design("smoke"), out, replicates=x),
    ),
    "run_design watch": ("watch", (None, 5), lambda x, out: cocorosim.run_design("smoke", out, watch=x)),
    "Watch": ("progress", (None, 5), lambda x, out: cocorosim.Watch(progress=x)),
}
CALLS = [(argument, wrong, call, what) for what, (argument, wrongs, call) in WRONG.items() for wrong in wrongs]


@pytest.mark.parametrize(
    ("argument", "wrong", "call"),
    [each[:3] for each in CALLS],
    ids=[f"{what} {' '.join(str(wrong).split())[:30]}" for _, wrong, _, what in CALLS],
)
def test_what_cannot_be_used(argument: str, wrong: Any, call: Call, tmp_path: Path) -> None:
    """The project's own error: one line that names the argument and no option of a command; nothing is written."""
    with pytest.raises(CocorosimError) as refused:
        call(wrong, tmp_path / "out")
    sentence = str(refused.value)
    assert f"'{argument}" in sentence and sentence.endswith(".") and "\n" not in sentence and "--" not in sentence
    assert isinstance(refused.value, ArgumentError) and argument in refused.value.arguments
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("wrong", [0, None, [1], "polarization"], ids=repr)
def test_what_is_no_metric(wrong: Any) -> None:
    """What stands in the brackets of the statistics is named, with the metrics that there are."""
    with pytest.raises(CocorosimError, match=r"There is no metric .* polarisation"):
        cocorosim.measure(TIME, PLACES, YAW)[wrong]


@pytest.mark.parametrize("there", ["folder", "file"])
def test_what_may_not_be_replaced(there: str, tmp_path: Path) -> None:
    """The sentence names the arguments of the library, none of a command's options."""
    out = tmp_path / "out"
    if there == "folder":
        out.mkdir()
        (out / "diagnosis.json").touch()
    else:
        out.touch()
    calls: list[Callable[[], Any]] = [
        lambda: cocorosim.record("one_lily", out, duration=1.0),
        lambda: cocorosim.convert("haizhe_auv", "logs", out),
        lambda: cocorosim.diagnose("bag", "lily", out=out),
        lambda: cocorosim.run_design("smoke", out, replicates=1, workers=1),
        lambda: cocorosim.read_recording(SHIPPED).draw(out),
    ]
    for call in calls:
        with pytest.raises(CocorosimError) as refused:
            call()
        assert "--" not in str(refused.value) and "\n" not in str(refused.value)


def test_what_numbers_may_be() -> None:
    """Numbers of NumPy and fractions are times and seeds; lists are tracks, and one text is one name."""
    for duration in (5, 5.0, np.float32(5.0), np.int16(5), Fraction(10, 2), "5 s"):
        assert cocorosim.load_scenario("one_lily", duration=duration, seed=np.uint8(3)).duration == 5.0  # type: ignore[arg-type]
    assert cocorosim.load_design("smoke", np.int64(2), groups="BLT").runs == 4
    track = cocorosim.PoseTrack([0, 10**9], [[0, 0, 0], [1, 0, 0]], [0, 0])  # type: ignore[arg-type]
    assert cocorosim.measure({"a": track})["shoal_speed"][1] == 1.0
    scenario = cocorosim.load_scenario("eleven_lilys", external="lily_*")
    assert all(robot.external for robot in scenario.robots)
