"""A row for each robot and recording: what was found of it, from the outcomes of a fleet."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from cocorosim_ros.diagnosis.findings import Estimate, Tier, Verdict
from cocorosim_ros.diagnosis.fleet.dating import DatedBy
from cocorosim_ros.diagnosis.fleet.outcome import Outcome


@dataclass(frozen=True)
class Number:
    """A number of the platform, fitted to one robot in one recording. moved: it clearly differs from the nominal."""

    parameter: str
    nominal: float
    estimate: Estimate
    moved: bool


@dataclass(frozen=True)
class Effect:
    """An effect that the model of a robot lacked in one recording."""

    id: str
    tier: Tier
    nats: float
    parameters: Mapping[str, Estimate]
    rivals: tuple[str, ...]


@dataclass(frozen=True)
class Row:
    """One robot in one recording; of a recording that could not be diagnosed one row without a robot.

    start_ns [ns since 1970]: when it was made, None if nothing tells it. duration [s]. verdict: about this robot;
    of_recording: about the whole recording. not_shown: effects that this recording could not have shown.
    probabilities: of sets of suspects, empty where diagnosis.json has none. problem: why there is no diagnosis.
    """

    recording: str
    robot: str = ""
    start_ns: int | None = None
    dated_by: DatedBy = "nothing"
    duration: float = float("nan")
    verdict: Verdict | None = None
    of_recording: Verdict | None = None
    sentence: str = ""
    numbers: tuple[Number, ...] = ()
    effects: tuple[Effect, ...] = ()
    not_shown: tuple[str, ...] = ()
    cannot_be_told: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    probabilities: Mapping[str, float] | None = None
    problem: str = ""

    @property
    def diagnosed(self) -> bool:
        """Tell whether there is a diagnosis."""
        return not self.problem


def rows_of(outcomes: Iterable[Outcome]) -> tuple[Row, ...]:
    """Make the rows of a fleet, by recording and robot; a copy of another recording has a problem instead."""
    ordered = sorted(outcomes, key=lambda each: each.recording)
    first: dict[str, str] = {}
    rows: list[Row] = []
    for outcome in ordered:
        name, digest = outcome.recording, outcome.found.get("sha256")
        earlier = first.setdefault(digest, name) if digest else name
        told = f"{name} is a copy of {earlier}, byte by byte; it would count twice: remove one of them."
        rows += _rows(outcome if earlier == name else replace(outcome, problem=told))
    return tuple(rows)


def _tried_and_not_shown(tree: Mapping[str, Any]) -> tuple[str, ...]:
    """List the effects that a recording could not have shown, without those that the vehicle cannot have.

    tree: of diagnosis.json.
    """
    tried = tree["screened"].keys()
    return tuple(name for name in tree["not_shown_by_this_recording"] if name in tried or not tried)


def _rows(outcome: Outcome) -> Iterator[Row]:
    if outcome.problem:
        yield Row(outcome.recording, problem=outcome.problem)
        return
    found = outcome.found
    tree = found["diagnosis"]
    shared = Row(
        outcome.recording,
        start_ns=found["start_ns"],
        dated_by=found["dated_by"],
        duration=found["duration"],
        of_recording=tree["verdict"],
        sentence=found["sentence"],
        not_shown=_tried_and_not_shown(tree),
        cannot_be_told=tuple(tree["cannot_be_told"]),
        warnings=tuple(tree["warnings"]),
        remarks=tuple(found["remarks"]),
        probabilities=tree.get("probabilities"),
    )
    for robot in found["robots"]:
        mine = replace(shared, robot=robot, numbers=_numbers(robot, found), effects=_effects(robot, tree["effects"]))
        yield replace(mine, verdict="mismatch" if _misses_something(robot, tree) else _verdict(mine))


def _misses_something(robot: str, tree: Mapping[str, Any]) -> bool:
    """Tell whether a robot lacks something that has no name; which of several errs in free runs is not told."""
    if tree["missing_in"] and tree["verdict"] == "mismatch" and not tree["effects"]:
        return True
    return any(each["missing"] and robot in each["robots"] for each in tree.get("passed_over", ()))


def _verdict(row: Row) -> Verdict | None:
    """The verdict about one robot of a recording, whose own verdict is about all of them."""
    if row.effects:
        return "mismatch"
    if row.of_recording == "insufficient" or not row.numbers:
        return "insufficient"
    return "recalibrate" if any(number.moved for number in row.numbers) else "consistent"


def _numbers(robot: str, found: Mapping[str, Any]) -> tuple[Number, ...]:
    moved = {each["parameter"] for each in found["diagnosis"]["recalibrated"] if robot in each["robots"]}
    return tuple(
        Number(each["parameter"], _number(each["nominal"]), _estimate(each), each["parameter"] in moved)
        for each in found["numbers"]
        if robot in each["robots"]
    )


def _effects(robot: str, effects: Sequence[Mapping[str, Any]]) -> tuple[Effect, ...]:
    return tuple(
        Effect(
            each["id"],
            each["tier"],
            _number(each["nats"]),
            {
                name: _estimate(part)
                for name, part in each["parameters"].items()
                if not isinstance(part["value"], str)  # a frame mix-up is put right in words
            },
            tuple(rival["id"] for rival in each["ambiguous_with"]),
        )
        for each in effects
        if robot in each["robots"] or not each["robots"]
    )


def _estimate(tree: Mapping[str, Any]) -> Estimate:
    low, high = tree["ci95"]
    return Estimate(_number(tree["value"]), _number(low), _number(high), tree["unit"])


def _number(value: float | None) -> float:
    return float("nan") if value is None else float(value)
