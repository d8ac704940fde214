"""A diagnosis in the terminal: the findings with their numbers, and the gain of the model."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect
from cocorosim_ros.diagnosis.report.actuator_table import reported_headings, reported_rows
from cocorosim_ros.diagnosis.report.advice import manoeuvre_words
from cocorosim_ros.diagnosis.report.marks import marked_words, unlike_words
from cocorosim_ros.diagnosis.report.nameless_force import NO_BOUND, is_no_bound
from cocorosim_ros.diagnosis.report.nats_words import NATS_IN_WORDS
from cocorosim_ros.diagnosis.report.number_text import in_unit_of
from cocorosim_ros.diagnosis.report.probability_words import told_probabilities
from cocorosim_ros.diagnosis.report.recorded import as_recorded
from cocorosim_ros.diagnosis.report.significance import may_be_nothing, not_shown_numbers
from cocorosim_ros.diagnosis.showing.doubt import SIZE_MAY_BE_NOTHING
from cocorosim_ros.foundation.units.quantity_text import NONE, handy_scale, plain_number, with_unit


def terminal_tables(diagnosis: Diagnosis) -> RenderableType:
    """Tables of effects, moved parameters and held-out errors, empty ones left out; probabilities, and warnings."""
    shown_probabilities = told_probabilities(diagnosis)
    diagnosis = as_recorded(diagnosis)
    tables = [
        _effects(diagnosis),
        _passed_over(diagnosis),
        _parameters(diagnosis),
        _errors(diagnosis),
        _actuators(diagnosis),
    ]
    shown: list[RenderableType] = [table for table in tables if table.row_count]
    said = (*diagnosis.warnings, *diagnosis.remarks)
    if diagnosis.effects or diagnosis.passed_over or any("nats" in sentence for sentence in said):
        shown.insert(0, Text(f"nats: what speaks for an effect, {NATS_IN_WORDS}"))
    if diagnosis.effects or (diagnosis.screened and diagnosis.verdict != "insufficient"):  # else those of before
        shown.append(Text(f"probability: {shown_probabilities}"))
    shown += [Text(f"take care: {warning}") for warning in diagnosis.warnings]
    if diagnosis.manoeuvres:
        shown.append(Text(f"next: {manoeuvre_words(diagnosis.manoeuvres)}"))
    return Group(*shown)


def _effects(diagnosis: Diagnosis) -> Table:
    title = "what is missing" if diagnosis.against is None else "what differs"
    table = _table(title, ("effect", "robots", "parameter", "value", "95 % interval", "nats", "rivals"))
    for found in diagnosis.effects:
        rivals = ", ".join(f"{rival.id} (\u2212{plain_number(rival.nats_behind, 2)})" for rival in found.ambiguous_with)
        doubt = f"; {SIZE_MAY_BE_NOTHING}" if may_be_nothing(found) else ""
        first = [f"{_name(found)}, {found.tier}{doubt}", ", ".join(found.robots)]
        numbers = _numbers(found)
        if found.correction is not None:
            numbers.append(("correction", found.correction, ""))
        _add(table, first, numbers, [plain_number(found.nats), rivals or NONE])
    return table


def _passed_over(diagnosis: Diagnosis) -> Table:
    table = _table(
        "explains something, but is not named",
        ("most like", "robots", "parameter", "value", "95 % interval", "nats", "since"),
    )
    for passed in diagnosis.passed_over:
        found = passed.found
        numbers = _numbers(found)
        _add(table, [_name(found), ", ".join(found.robots)], numbers, [plain_number(found.nats), passed.shortly])
    return table


def _numbers(found: FoundEffect) -> list[tuple[str, str, str]]:
    """Name, value and 95 % interval of each number, those marked that may as well be nothing beside others."""
    doubtful = not_shown_numbers(found)
    return [(name, *marked_words(each, doubtful=name in doubtful)) for name, each in found.parameters.items()]


def _add(table: Table, start: Sequence[str], numbers: Sequence[Sequence[str]], end: Sequence[str]) -> None:
    """Add a row for each number of an effect; what stands before and behind the numbers is in the first alone."""
    for index, number in enumerate(numbers or [("", "", "")]):
        before, behind = (start, end) if index == 0 else ([""] * len(start), [""] * len(end))
        table.add_row(*(Text(cell) for cell in (*before, *number, *behind)))


def _parameters(diagnosis: Diagnosis) -> Table:
    before = "platform" if diagnosis.against is None else "before"
    table = _table("recalibrated", ("parameter", "robots", before, "fitted", "95 % interval"))
    for found in diagnosis.recalibrated:
        nominal = in_unit_of(found.nominal, found.estimate)
        cells = (found.parameter, ", ".join(found.robots), nominal, *marked_words(found.estimate))
        table.add_row(*(Text(cell) for cell in cells))
    return table


def _errors(diagnosis: Diagnosis) -> Table:
    headings = ("channel", "platform", "recalibrated", "with the effects", "with a force without a name", "against")
    table = _table("error of free runs on data that no fit saw", headings)
    for channel, found in diagnosis.fit.items():
        numbers = (found.nominal, found.recalibrated, found.augmented, found.noise_floor)
        scale = handy_scale(max((each for each in numbers if math.isfinite(each)), default=0.0), found.unit)
        against = "; ".join(part for part in (found.against, unlike_words(diagnosis.unlike)) if part)
        cells = [with_unit(plain_number(each * scale.factor), scale.unit) for each in numbers]
        cells[-1] += f"; {NO_BOUND}" if is_no_bound(channel, found) else ""
        table.add_row(*(Text(cell) for cell in (channel, *cells, against)))
    return table


def _actuators(diagnosis: Diagnosis) -> Table:
    table = _table("what actuators report, against their commands", reported_headings(diagnosis.actuators))
    for row in reported_rows(diagnosis.actuators):
        table.add_row(*(Text(cell) for cell in row))
    return table


def _table(title: str, headings: tuple[str, ...]) -> Table:
    table = Table(title=title, title_justify="left")
    for heading in headings:
        table.add_column(heading)
    return table


def _name(found: FoundEffect) -> str:
    return f"{found.id} of {found.topic}" if found.topic else found.id
