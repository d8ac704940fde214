"""Without rclpy's internals messages go through an executor, and the recording stays the same."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import rclpy
from rclpy.context import Context

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.nodes import rclpy_internals, wiring
from cocorosim_ros.graph.nodes.path_choice import PATH_VARIABLE, plain_path_asked
from cocorosim_ros.wire.bags.bag_reader import read_bag

ROBOTS, TICKS = 3, 12
NODES = Path(wiring.__file__).parent
WITHOUT_INTERNALS = Path(__file__).with_name("without_internals.py")
PLAIN = {PATH_VARIABLE: "plain"}
INTERNAL = re.compile(r"\.handle\b|implementation_singleton|rclpy_implementation|rclpy\.(_|type_support|impl)|node\._")


@pytest.fixture
def run(start: Callable[..., Any], scenario: Callable[..., Path], tmp_path: Path) -> Callable[..., Path]:
    """Function of a name, a command and its options: the folder of a run that went well."""

    def begin(name: str, command: str | Path, *options: str, env: dict[str, str] | None = None) -> Path:
        folder = tmp_path / name
        process = start(command, "run", scenario(ROBOTS, TICKS), "--out", folder, *options, env=env)
        assert process.finish() == 0, process.output
        (folder / "output.txt").write_text(process.output)
        return folder

    return begin


@pytest.fixture
def node() -> Iterator[Any]:
    """What a path is chosen by: a context of its own and a log; no participant is made."""
    context = Context()
    rclpy.init(args=[], context=context)
    said: list[str] = []
    log = SimpleNamespace(info=said.append, warning=said.append)
    yield SimpleNamespace(context=context, get_logger=lambda: log, said=said)
    context.shutdown()


def recording(folder: Path) -> bytes:
    """The whole file of a run, which has a message of every tick."""
    topics = {topic.topic: topic.count for topic in read_bag(folder / "bag").summary.topics}
    assert topics["/clock"] == topics["/lily_03/radio_tx"] == topics["/shoal_statistics"] == TICKS
    return (folder / "bag" / "bag_0.mcap").read_bytes()


def test_both_paths_give_the_same_recording(run: Callable[..., Path]) -> None:
    """As processes and composed, asked for or needed: the file of a run without ROS; the plain path says so once."""
    alone = recording(run("alone", "cocorosim", "--in-process"))
    fast = run("fast", "cocorosim")
    asked, composed = run("asked", "cocorosim", env=PLAIN), run("composed", "cocorosim", "--composed", env=PLAIN)
    needed = run("needed", WITHOUT_INTERNALS)
    assert [recording(folder) for folder in (fast, asked, composed, needed)] == [alone] * 4

    logs = {folder: [log.read_text() for log in (folder / "log").glob("*.txt")] for folder in (fast, asked, needed)}
    assert all(len(texts) == ROBOTS + 2 for texts in logs.values())
    assert not [text for text in logs[fast] if "executor" in text]
    assert [text.count(wiring.PLAIN_CHOSEN) for text in logs[asked]] == [1] * (ROBOTS + 2)
    assert [text.count("rclpy.impl.moved_elsewhere") for text in logs[needed]] == [1] * (ROBOTS + 2)
    assert (composed / "output.txt").read_text().count(wiring.PLAIN_CHOSEN) == 1


def test_the_fast_path_is_taken_where_it_can(node: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the rclpy of this project, silently."""
    monkeypatch.delenv(PATH_VARIABLE, raising=False)
    assert rclpy_internals.what_is_missing(node) == ""
    assert wiring.path_of(node) is wiring.FAST
    assert node.said == []


def refuse(*sizes: object) -> None:
    """What rclpy raises where it refuses."""
    raise RuntimeError("no such set")


@pytest.mark.parametrize(
    ("implementation", "words"),
    [
        (SimpleNamespace(), "WaitSet"),
        (SimpleNamespace(WaitSet=refuse), "no such set"),
        (SimpleNamespace(WaitSet=lambda few, context: None), "argument"),
        ("take_message", "take_message"),
        ("publish_raw", "publish_raw"),
    ],
)
def test_the_plain_path_is_taken_where_something_is_missing(
    node: Any, monkeypatch: pytest.MonkeyPatch, implementation: Any, words: str
) -> None:
    """A part that is gone, or takes other arguments: the log names it, once for all nodes of a process."""
    monkeypatch.delenv(PATH_VARIABLE, raising=False)
    if isinstance(implementation, str):
        real = rclpy_internals._implementation()
        kept = {
            "Subscription": real.Subscription if implementation != "take_message" else SimpleNamespace(),
            "Publisher": real.Publisher if implementation != "publish_raw" else SimpleNamespace(),
        }
        implementation = SimpleNamespace(WaitSet=real.WaitSet, **kept)
    monkeypatch.setattr(rclpy_internals, "_implementation", lambda: implementation)
    assert [wiring.path_of(node) for _ in range(3)] == [wiring.PLAIN] * 3
    (said,) = node.said
    assert words in said


def test_what_the_environment_may_ask_for(node: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """The plain path by name, nothing else."""
    monkeypatch.setenv(PATH_VARIABLE, "plain")
    assert wiring.path_of(node) is wiring.PLAIN
    assert node.said == [wiring.PLAIN_CHOSEN]
    monkeypatch.setenv(PATH_VARIABLE, "slow")
    with pytest.raises(CocorosimError, match=f"{PATH_VARIABLE} is 'slow'; set it to 'plain', or unset it"):
        plain_path_asked()


def test_a_wrong_path_is_refused_before_the_run(
    start: Callable[..., Any], scenario: Callable[..., Path], tmp_path: Path
) -> None:
    """Status 2, one sentence, and no folder."""
    process = start("cocorosim", "run", scenario(1, 2), "--out", tmp_path / "run", env={PATH_VARIABLE: "slow"})
    assert process.finish() == 2
    assert f"{PATH_VARIABLE} is 'slow'" in process.output
    assert not (tmp_path / "run").exists()


def test_only_one_module_knows_the_internals() -> None:
    """The nodes use rclpy's public interface; what goes beyond it stands in rclpy_internals alone."""
    found = {
        path.name for path in NODES.glob("*.py") if any(map(INTERNAL.search, path.read_text("utf-8").splitlines()))
    }
    assert found == {"rclpy_internals.py"}
