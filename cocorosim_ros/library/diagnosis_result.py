"""What a diagnosis has found, as a record: verdict, numbers, and the texts of the files about it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, FoundEffect, Recalibrated, Verdict
from cocorosim_ros.foundation.card import Card, Shown, card_markdown
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.arguments import Place, place_text

if TYPE_CHECKING:
    import pandas as pd

    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence

JSON, MODEL, REPORT, NEXT = "diagnosis.json", "model.yaml", "report.html", "next_manoeuvre.yaml"


@dataclass(frozen=True, eq=False, repr=False)
class DiagnosisResult(Shown):
    """What a diagnosis has found, and the files that `cocorosim diagnose` writes about it."""

    diagnosis: Diagnosis
    """Everything that was found, typed: also what is located, screened and left over."""
    evidence: Evidence
    """What was taken from the recordings, and the platform that was diagnosed."""

    @property
    def verdict(self) -> Verdict:
        """'consistent', 'recalibrate', 'mismatch' or 'insufficient'."""
        return self.diagnosis.verdict

    @property
    def sentence(self) -> str:
        """The finding as an engineer would say it."""
        return self.diagnosis.sentence

    @property
    def effects(self) -> tuple[FoundEffect, ...]:
        """What the model lacked: identifier, equation, robots, numbers with 95 % intervals, nats, rivals."""
        return self.diagnosis.effects

    @cached_property
    def probabilities(self) -> Mapping[str, float]:
        """How probable each set of suspects is, with 'something else' and 'nothing', in all 1."""
        from cocorosim_ros.diagnosis.showing.probability import probabilities_of

        return probabilities_of(self.diagnosis).told

    @property
    def recalibrated(self) -> tuple[Recalibrated, ...]:
        """The platform's numbers that have moved, with 95 % intervals."""
        return self.diagnosis.recalibrated

    @property
    def remarks(self) -> tuple[str, ...]:
        """What was odd about the recordings, in sentences; first for which reasons nothing could be tested."""
        return (*(each for each in self.diagnosis.reasons if each != self.sentence), *self.diagnosis.remarks)

    @cached_property
    def tree(self) -> dict[str, Any]:
        """The content of diagnosis.json: nested plain values."""
        from cocorosim_ros.diagnosis.report.json_file import diagnosis_tree

        return diagnosis_tree(self.diagnosis)

    @property
    def model_yaml(self) -> str:
        """The text of model.yaml: the platform with the fitted numbers and the missing effects."""
        return self.files[MODEL]

    @property
    def report_html(self) -> str:
        """The text of report.html, a page that needs no other file."""
        return self.files[REPORT]

    @property
    def next_manoeuvre_yaml(self) -> str | None:
        """The text of next_manoeuvre.yaml: a scenario that drives what would show more; None if there is none."""
        return self.files.get(NEXT)

    @cached_property
    def files(self) -> Mapping[str, str]:
        """The texts of all files by name; made when asked for first, which draws the report's figures."""
        return _texts(self.diagnosis, self.evidence)

    @property
    def overlay(self) -> Callable[[Path], None] | None:
        """A function that writes the bag of what is laid over the recording into a folder; None where there is none.

        Ghosts of the models, residual forces and the evidence over time, on the recording's own clock; with several
        recordings a bag for each below the folder.
        """
        from cocorosim_ros.diagnosis.report.overlay import has_overlay, write_overlay

        hull = self.evidence.platform.hull.length
        return (lambda folder: write_overlay(self.diagnosis, hull, folder)) if has_overlay(self.diagnosis) else None

    def save(self, folder: Place, *, force: bool = False) -> Path:
        """Write all files into a folder, which is made if need be; they appear together or not at all.

        Returns the folder. Raises CocorosimError if it holds a diagnosis already (without `force`), is a file, or
        cannot be written.
        """
        from cocorosim_ros.diagnosis.report.output_folder import check_folder, write_folder

        place = Path(place_text(folder, "folder"))
        check_folder(place, force=force, argument="folder")
        write_folder(place, self.files, self.overlay, argument="folder")
        return place

    def junit(self, fail_on: Collection[Verdict] = ()) -> str:
        """The finding as JUnit's XML: the verdicts of `fail_on` fail, 'mismatch' if none is named."""
        from cocorosim_ros.diagnosis.report.junit_file import USUALLY_FAILING, junit_xml

        return junit_xml(self.diagnosis, self.evidence.platform.name, fail_on or USUALLY_FAILING)

    def markdown(self) -> str:
        """The finding as Markdown, for the page of a run or a comment."""
        return card_markdown(self.card())

    def to_frame(self) -> pd.DataFrame:
        """One row a number that was found.

        Columns: `kind` (effect or recalibrated), id, robots, parameter, value, its 95 % interval low and high, unit;
        tier and nats, of effects alone.
        """
        names = ("kind", "id", "robots", "parameter", "value", "low", "high", "unit", "tier", "nats")
        rows = list(self._numbers())
        return data_frame({name: [row[place] for row in rows] for place, name in enumerate(names)})

    def card(self) -> Card:
        """The sentence, and the numbers of what was found."""
        from cocorosim_ros.diagnosis.report.marks import marked_words
        from cocorosim_ros.diagnosis.report.recorded import as_recorded

        shown = as_recorded(self.diagnosis)
        facts = {"verdict": self.verdict, "recordings": str(len(self.evidence.recordings)), "finding": self.sentence}
        rows = [
            (found.id, ", ".join(found.robots), name, *marked_words(estimate))
            for found in shown.effects
            for name, estimate in found.parameters.items()
        ]
        rows += [
            ("recalibrated", ", ".join(found.robots), found.parameter, *marked_words(found.estimate))
            for found in shown.recalibrated
        ]
        headings = ("effect", "robots", "parameter", "value", "95 % interval")
        return Card(f"diagnosis of {self.evidence.platform.name}", facts, headings, rows, self.remarks)

    def _numbers(self) -> Iterator[tuple[Any, ...]]:
        for found in self.effects:
            for name, estimate in found.parameters.items():
                beside = (found.tier, found.nats)
                yield "effect", found.id, ", ".join(found.robots), name, *_interval(estimate), *beside
        for moved in self.recalibrated:
            who = ", ".join(moved.robots)
            yield "recalibrated", moved.parameter, who, moved.parameter, *_interval(moved.estimate), None, float("nan")


def _interval(estimate: Estimate) -> tuple[float, float, float, str]:
    return estimate.value, estimate.low, estimate.high, estimate.unit


def _texts(diagnosis: Diagnosis, evidence: Evidence) -> dict[str, str]:
    """The files by name."""
    from cocorosim_ros.diagnosis.report.changed_vehicle import as_platform
    from cocorosim_ros.diagnosis.report.json_file import diagnosis_json
    from cocorosim_ros.diagnosis.report.model_file import Origin, model_yaml
    from cocorosim_ros.diagnosis.report.report import render_report

    recordings = tuple(recording.origin for recording in evidence.recordings)
    recorded = [robot.name for recording in evidence.recordings for robot in recording.robots]
    # Robots that could not be fitted at all say nothing about what the others have in common.
    fitted = [robot for found in as_platform(diagnosis, evidence.platform).all_recalibrated for robot in found.robots]
    robots = dict.fromkeys(fitted or recorded)
    duration = max(recording.duration for recording in evidence.recordings)
    origin = Origin(evidence.platform, recordings, tuple(robots), duration)
    return {
        **_next_manoeuvre(diagnosis, evidence.platform),
        JSON: diagnosis_json(diagnosis),
        MODEL: model_yaml(as_platform(diagnosis, evidence.platform), origin),
        REPORT: render_report(diagnosis, origin),
    }


def _next_manoeuvre(diagnosis: Diagnosis, platform: Platform) -> dict[str, str]:
    """The first of the advised manoeuvres as a scenario, where there is one that the platform can be driven through."""
    from cocorosim_ros.diagnosis.report.manoeuvre_scenario import can_be_driven, scenario_of

    if not diagnosis.manoeuvres or not can_be_driven(platform):
        return {}
    return {NEXT: scenario_of(diagnosis.manoeuvres[0], platform, MODEL)}
