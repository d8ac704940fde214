"""Mixed-up axes, signs and units as effects of their own: they were put right before any physics was fitted."""

from __future__ import annotations

from cocorosim_ros.diagnosis.criteria.showing import FRAMING
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.showing.case import Objection


def mixed_up(intake: Intake) -> tuple[FoundEffect, ...]:
    """Make a found effect `frame_mixup` of each correction of axes, signs or units that the platform's file lacks."""
    known = intake.evidence.platform.frame_corrections
    return tuple(
        _effect(mixup) for mixup in intake.mixups if mixup.correction.wrong not in known.get(mixup.correction.topic, "")
    )


def unexplained(intake: Intake) -> tuple[Objection, ...]:
    """Object to all effects of robots of which a stream contradicts another and could not be put right."""
    return tuple(
        Objection(
            f"The {mixup.correction.topic} of {', '.join(mixup.robots)} contradicts other readings ("
            f"{mixup.correction.wrong}) and is not used; until its columns are put right, nothing is sure.",
            mixup.robots,
        )
        for mixup in intake.mixups
        if mixup.correction.matrix is None
    )


def _effect(mixup: Mixup) -> FoundEffect:
    correction = mixup.correction
    return FoundEffect(
        "frame_mixup",
        f"mixed-up frame of {correction.topic}",
        "right = matrix * recorded + offset",
        mixup.robots,
        "confirmed",
        {},
        min(correction.nats, FRAMING.certain),
        topic=correction.topic,
        correction=correction.wrong,
    )
