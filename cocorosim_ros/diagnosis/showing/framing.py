"""Mixed-up axes, signs and units as effects of their own: they were put right before any physics was fitted."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.criteria.showing import FRAMING
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.findings import FoundEffect, Rival
from cocorosim_ros.diagnosis.showing.case import Objection


def mixed_up(intake: Intake) -> tuple[FoundEffect, ...]:
    """Make a found effect `frame_mixup` of each correction of axes, signs or units that the platform's file lacks.

    It is suspected where another stream may be the faulty one as well.
    """
    known = intake.evidence.platform.frame_corrections
    return tuple(
        _effect(mixup) for mixup in intake.mixups if mixup.correction.wrong not in known.get(mixup.correction.topic, "")
    )


def unexplained(intake: Intake) -> tuple[Objection, ...]:
    """Object to all effects of robots of which a stream contradicts another and was not surely put right."""
    return (*_not_put_right(intake), *_perhaps_another(intake))


def _not_put_right(intake: Intake) -> Iterator[Objection]:
    return (
        Objection(
            f"The {mixup.correction.topic} of {', '.join(mixup.robots)} contradicts other readings ("
            f"{mixup.correction.wrong}) and is not used; until its columns are put right, nothing is sure.",
            mixup.robots,
        )
        for mixup in intake.mixups
        if mixup.correction.matrix is None
    )


def _perhaps_another(intake: Intake) -> Iterator[Objection]:
    return (
        Objection(
            f"Either the {mixup.correction.topic} of {', '.join(mixup.robots)} is in other axes, and was rightly put "
            f"right, or its {mixup.correction.rival.replace('_', ' ')}s are exchanged; these recordings cannot tell, a "
            "gyroscope or a compass would. If the commands are, sides and signs of what is named are the other ones.",
            mixup.robots,
        )
        for mixup in intake.mixups
        if mixup.correction.rival
    )


def _effect(mixup: Mixup) -> FoundEffect:
    correction = mixup.correction
    rivals = (Rival(f"frame_mixup:{correction.rival}", 0.0),) if correction.rival else ()
    return FoundEffect(
        "frame_mixup",
        f"mixed-up frame of {correction.topic}",
        "right = matrix * recorded + offset",
        mixup.robots,
        "suspected" if rivals else "confirmed",
        {},
        min(correction.nats, FRAMING.certain),
        rivals,
        topic=correction.topic,
        correction=correction.wrong,
    )
