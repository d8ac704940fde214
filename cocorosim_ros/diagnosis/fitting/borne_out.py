"""Changes of axes and signs that commands ask for, and whether the vehicle's physics bears them out.

What streams show is compared with rough motion under the commands. Where a turn is short beside a drift, or a hull is
turned by its speed more than by its thrusters, that motion may be the opposite of the true one, and commands or streams
look exchanged in one recording of many. The platform's model, fitted to the readings, knows better: where commands
really are exchanged and stay so, it explains the readings worse by hundreds of nats.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES
from cocorosim_ros.diagnosis.evidence.intake import Intake, take_in
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog
from cocorosim_ros.diagnosis.fitting.fit import finite
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit


def soundly_taken_in(
    evidence: Evidence, beside: Sequence[RecordingLog] = (), right: Sequence[RecordingLog] = ()
) -> Intake:
    """Take evidence in, as `evidence.intake` does, with those changes alone that are borne out.

    beside: further recordings of the same robots that the evidence is fitted together with. right: recordings of the
    same robots that are in axes and units of the contract.
    """
    return borne_out(take_in(evidence, beside, right), lambda: take_in(evidence, beside, right, by_commands=False))


def borne_out(intake: Intake, without_commands: Callable[[], Intake]) -> Intake:
    """Choose between an intake and one in which no commands were compared, the former unless physics clearly objects.

    Nothing is asked where both change the same, or where not both keep all readings.
    """
    if not intake.mixups:
        return intake
    other = without_commands()
    if other.reasons or _changes(other) == _changes(intake) or _readings(other) != _readings(intake):
        return intake
    return other if _explained(other) > _explained(intake) + AXES.margin else intake


def _explained(intake: Intake) -> float:
    """Objective [nats] of the platform's model, fitted to the readings of an intake; -inf where it runs away."""
    fit = base_fit(intake.evidence)
    return fit.objective if finite(fit) else -math.inf


def _changes(intake: Intake) -> set[tuple[str, str, tuple[str, ...]]]:
    """Topic, fault and robots of each change."""
    return {(each.correction.topic, each.correction.wrong, each.robots) for each in intake.mixups}


def _readings(intake: Intake) -> int:
    logs = (log for recording in intake.evidence.recordings for log in recording.robots)
    return sum(int(np.isfinite(stream.value).sum()) for log in logs for stream in log.streams.values())
