"""Reports of actuators beside a diagnosis: they say which follow late or weakly, and what that means for its names.

They change no name, no tier and no number: what a motor reports is not what its propeller pushes. Angles that are
reported act in the model from the start (`fitting.acting_angles`).
"""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.diagnosis.evidence.following.reports import actuator_reports
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.findings import ActuatorReport, Diagnosis
from cocorosim_ros.diagnosis.showing.actuator_changes import change_sentences
from cocorosim_ros.diagnosis.showing.actuator_names import name_sentences
from cocorosim_ros.diagnosis.showing.actuator_sentences import report_sentences


def with_actuators(found: Diagnosis, evidence: Evidence, good: Evidence | None = None) -> Diagnosis:
    """Add what actuators report, and remarks on it; the same diagnosis where they report nothing.

    good: the recordings that the evidence is compared with, of robots by the same names.
    """
    reports = actuator_reports(evidence)
    if not reports:
        return found
    before = {_key(each): each for each in actuator_reports(good)} if good is not None else {}
    reports = tuple(
        replace(each, before=before[_key(each)].numbers) if _key(each) in before else each for each in reports
    )
    said = (
        *change_sentences(reports),
        *name_sentences(found.effects, reports, compared=good is not None),
        *report_sentences(reports),
    )
    return replace(found, actuators=reports, remarks=(*said, *found.remarks))


def _key(report: ActuatorReport) -> tuple[str, str, str]:
    return report.robot, report.actuator, report.quantity
