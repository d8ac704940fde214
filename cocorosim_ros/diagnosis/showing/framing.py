"""Mixed-up axes, signs and units as effects of their own: they were put right before any physics was fitted."""

from __future__ import annotations

from cocorosim_ros.diagnosis.criteria.showing import FRAMING
from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.findings import FoundEffect


def mixed_up(intake: Intake) -> tuple[FoundEffect, ...]:
    """Make a found effect `frame_mixup` of each correction of axes, signs or units that the platform's file lacks."""
    known = intake.evidence.platform.frame_corrections
    return tuple(
        _effect(mixup) for mixup in intake.mixups if mixup.correction.wrong not in known.get(mixup.correction.topic, "")
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
