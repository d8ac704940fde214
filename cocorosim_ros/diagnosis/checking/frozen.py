"""Readings that stand still for a while, though the instrument has noise at other times."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.checking.finding import Oddity
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog
from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.foundation.arrays import Floats, Integers


def check_frozen(topic: TopicLog) -> Iterator[Oddity]:
    """Look for the longest stretch of messages that say the same."""
    if len(topic.values) < 2 * CHECKING.frozen_messages or topic.values.shape[1] == 0:
        return
    starts, lengths = _runs(topic.values)
    longest = int(lengths.argmax())
    first, count = int(starts[longest]), int(lengths[longest])
    time = topic.time()
    seconds = float(time[first + count - 1] - time[first])
    usual = float(np.median(np.delete(lengths, longest))) if len(lengths) > 1 else float(count)
    long = count >= max(CHECKING.frozen_messages, CHECKING.usual_repeats * usual) and seconds >= CHECKING.frozen_seconds
    if long and _is_noisy(topic.values[np.delete(starts, longest)]):
        yield Oddity(
            "frozen",
            topic.name,
            f"{topic.name}: {count} messages in a row say the same, from {time[first]:.1f} to "
            f"{time[first + count - 1]:.1f} s, though its readings have noise at other times: it was frozen.",
        )


def _runs(values: Floats) -> tuple[Integers, Integers]:
    """First rows and lengths of the stretches of equal rows."""
    same = ((values[1:] == values[:-1]) | (np.isnan(values[1:]) & np.isnan(values[:-1]))).all(axis=1)
    starts = np.flatnonzero(np.append(True, ~same))
    return starts, np.diff(np.append(starts, len(values)))


def _is_noisy(values: Floats) -> bool:
    """Tell whether the numbers that change at all go up and down as noise does, and not as a smooth motion."""
    steps = np.diff(values, axis=0)
    if len(steps) < CHECKING.frozen_messages:
        return False
    changing = steps[:, (steps != 0.0).mean(axis=0) > 1.0 - CHECKING.noisy]
    if not changing.size:
        return False
    turns = (np.sign(changing[1:]) != np.sign(changing[:-1])).mean(axis=0)
    return bool(turns.max() > CHECKING.noisy)
