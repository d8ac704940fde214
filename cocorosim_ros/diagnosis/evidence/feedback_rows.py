"""ActuatorFeedback messages as series of the platform's actuators; what cannot be used is said."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.topic_rows import unreadable
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.named_numbers import read_named_numbers
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps
from cocorosim_ros.wire.topics.actuator_feedback import QUANTITIES, feedback_name, reported


@dataclass(frozen=True)
class FeedbackRows:
    """Contents of the messages of one topic: a series for each number, and a sentence for all that was left out.

    readable (n,): which messages could be read; stamp_ns: their header stamps, in recorded order [ns].
    """

    series: tuple[Feedback, ...]
    remarks: tuple[str, ...]
    readable: Flags
    stamp_ns: Stamps


def read_feedback_rows(topic: str, messages: Sequence[bytes], actuators: Sequence[str], start_ns: int) -> FeedbackRows:
    """Read what the actuators of a platform report, time counting from `start_ns`.

    Raises CocorosimError if none of the actuators is the platform's: nothing could be compared with a command.
    """
    names = [feedback_name(actuator, quantity) for actuator in actuators for quantity in QUANTITIES]
    read = read_named_numbers(messages, names)
    remarks = [*_check_names(topic, read.names, actuators), *unreadable(topic, read.readable)]
    series, backwards = [], False
    for name, values in zip(names, read.numbers.T, strict=True):
        given = np.flatnonzero(read.readable & np.isfinite(values))
        if given.size:
            stamps = read.stamp_ns[given]
            backwards = backwards or bool((np.diff(stamps) < 0).any())
            series.append(_series(name, stamps, values[given], start_ns))
    if backwards:
        remarks.append(f"{topic}: time runs backwards; its reports were sorted by their stamps.")
    return FeedbackRows(tuple(series), tuple(remarks), read.readable, read.stamp_ns[read.readable])


def _series(name: str, stamps: Stamps, values: Floats, start_ns: int) -> Feedback:
    """A series in the order of its stamps, each stamp once."""
    moments, first = np.unique(stamps, return_index=True)
    return Feedback(*reported(name), np.asarray((moments - start_ns) / NANOSECONDS), values[first])


def _check_names(topic: str, found: Sequence[str], actuators: Sequence[str]) -> list[str]:
    """Sentences about actuators and quantities that are not known. Raises CocorosimError if no actuator is."""
    given = [reported(name) for name in dict.fromkeys(found)]
    strange = list(dict.fromkeys(each.actuator for each in given if each.quantity and each.actuator not in actuators))
    if strange and not any(each.actuator in actuators for each in given):
        raise CocorosimError(
            f"{topic} reports of the actuators {', '.join(strange)}, and the platform has none of these but "
            f"{', '.join(actuators)}; give the platform of this robot, or name the actuators in the map as it does."
        )
    remarks = []
    if strange:
        remarks.append(f"{topic}: the platform has no actuator {', '.join(strange)}; what it reports is not used.")
    unknown = [each.actuator for each in given if not each.quantity]
    if unknown:
        remarks.append(
            f"{topic}: {', '.join(unknown)} names no quantity that is known ({', '.join(QUANTITIES)}), as in "
            f"{feedback_name('left', 'rotation')}; it is not used."
        )
    return remarks
