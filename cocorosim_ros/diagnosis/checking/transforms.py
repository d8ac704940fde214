"""Transforms that contradict each other, lag behind the rest, or lack the fixed ones that hold the tree together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from cocorosim_ros.diagnosis.checking.finding import Oddity
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog, Transform
from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.diagnosis.criteria.evidence import CLOCKS
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.entry import listed

_STATIC = "/tf_static"


def check_transforms(topics: Sequence[TopicLog]) -> Iterator[Oddity]:
    """Look at /tf, /tf_static and the frames that the other topics are in."""
    by_child: dict[str, list[Transform]] = {}
    for topic in topics:
        for each in topic.transforms:
            by_child.setdefault(each.child, []).append(each)
    moving = {each.child for topic in topics if topic.name != _STATIC for each in topic.transforms}
    for child, transforms in by_child.items():
        yield from _authorities(child, transforms)
    yield from _skew({child: by_child[child] for child in moving}, topics)
    if by_child:
        yield from _unconnected(by_child, topics)


def _authorities(child: str, transforms: Sequence[Transform]) -> Iterator[Oddity]:
    """Two publishers of one frame: two parents, or two places at one time."""
    parents = sorted({each.parent for each in transforms})
    if len(parents) > 1:
        words = f"the frame {child} has {len(parents)} parents, {listed(parents, 'and')}; in a tree it has one"
        yield Oddity("frames", "/tf", f"/tf: {words}.")
        return
    unlike = _unlike_at_one_stamp(transforms)
    if unlike:
        yield Oddity(
            "frames",
            "/tf",
            f"/tf: two transforms to the frame {child} have one stamp and say different things, {unlike} times: two "
            "nodes publish it.",
        )
    elif _to_and_fro(np.array([each.numbers for each in transforms])):
        yield Oddity(
            "frames", "/tf", f"/tf: the frame {child} jumps to and fro between two courses: two nodes publish it."
        )


def _unlike_at_one_stamp(transforms: Sequence[Transform]) -> int:
    first: dict[int, tuple[float, ...]] = {}
    return sum(first.setdefault(each.stamp_ns, each.numbers) != each.numbers for each in transforms)


def _to_and_fro(numbers: Floats) -> bool:
    """Tell whether every second transform (n, 7) goes on where the one before the last was, and the last does not."""
    if len(numbers) < CHECKING.fewest:
        return False
    one = np.linalg.norm(numbers[1:-1] - numbers[:-2], axis=1)
    two = np.linalg.norm(numbers[2:] - numbers[:-2], axis=1)
    return bool(np.median(one) > 0.0 and np.median(one) > CHECKING.usual_repeats * np.quantile(two, 0.9))


def _skew(moving: Mapping[str, Sequence[Transform]], topics: Sequence[TopicLog]) -> Iterator[Oddity]:
    """Transforms whose stamps lie before or behind those of the other topics, by the times of recording."""
    others = [
        float(np.median(topic.log_ns - topic.stamp_ns)) / 1e9
        for topic in topics
        if topic.stamp_ns is not None and not topic.transforms and topic.stamp_ns.any()
    ]
    for child, transforms in moving.items():
        late = float(np.median([each.log_ns - each.stamp_ns for each in transforms])) / 1e9
        if others and CLOCKS.notable < abs(late - float(np.median(others))) <= CLOCKS.far:
            behind = late - float(np.median(others))
            where = "before" if behind > 0.0 else "after"
            yield Oddity(
                "frames",
                "/tf",
                f"/tf: the transforms to the frame {child} have stamps {abs(behind):.2g} s {where} those of the other "
                "topics that were recorded with them.",
            )


def _unconnected(by_child: Mapping[str, Sequence[Transform]], topics: Sequence[TopicLog]) -> Iterator[Oddity]:
    """Frames of messages that no transform leads to."""
    known = set(by_child) | {each.parent for transforms in by_child.values() for each in transforms}
    used: dict[str, list[str]] = {}
    for topic in topics:
        for frame in {each.strip("/") for each in topic.frames | topic.child_frames} - known - {""}:
            used.setdefault(frame, []).append(topic.name)
    if not used:
        return
    there = any(topic.name == _STATIC for topic in topics)
    why = (
        "though /tf_static was recorded"
        if there
        else (
            "and /tf_static was not recorded: it is sent once, so record from the start, or subscribe transient_local"
        )
    )
    frames = "; ".join(
        f"{frame} ({', '.join(sorted(names)[:2])})" for frame, names in sorted(used.items())[: CHECKING.named]
    )
    more = f" and {len(used) - CHECKING.named} more" if len(used) > CHECKING.named else ""
    yield Oddity("frames", _STATIC, f"No transform leads to the frames of {frames}{more}, {why}.")
