"""Mixed-up axes, signs and units, which were put right before any physics was blamed, as effects of their own."""

from __future__ import annotations

from cocorosim_ros.diagnosis.evidence.intake import Intake, Mixup
from cocorosim_ros.diagnosis.findings import FoundEffect

CERTAIN = 1e4  # nats, in place of infinity


def mixed_up(intake: Intake) -> tuple[FoundEffect, ...]:
    """What was put right, but for what the platform's file knows of."""
    known = intake.evidence.platform.frame_corrections
    return tuple(
        _effect(part) for part in intake.mixups if part.correction.wrong not in known.get(part.correction.topic, "")
    )


def _effect(part: Mixup) -> FoundEffect:
    correction = part.correction
    return FoundEffect(
        "frame_mixup",
        f"mixed-up frame of {correction.topic}",
        "right = matrix * recorded + offset",
        part.robots,
        "confirmed",
        {},
        min(correction.nats, CERTAIN),
        topic=correction.topic,
        correction=correction.wrong,
    )
