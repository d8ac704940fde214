"""fleet.parquet: the rows of a fleet, a column each with its meaning and unit in the field's metadata."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.diagnosis.fleet.rows import Effect, Number, Row

_ESTIMATE = [("value", pa.float64()), ("low", pa.float64()), ("high", pa.float64()), ("unit", pa.string())]
EFFECT = pa.struct(
    [
        ("id", pa.string()),
        ("tier", pa.string()),
        ("nats", pa.float64()),
        ("parameters", pa.list_(pa.struct([("name", pa.string()), *_ESTIMATE]))),
        ("ambiguous_with", pa.list_(pa.string())),
    ]
)
_TEXTS = pa.list_(pa.string())
_Column = tuple[pa.DataType, str, str, Callable[[Row], Any]]
COLUMNS: dict[str, _Column] = {
    "recording": (pa.string(), "", "path below the folder of the fleet", lambda row: row.recording),
    "robot": (
        pa.string(),
        "",
        "its namespace; null where the recording was not diagnosed",
        lambda row: row.robot or None,
    ),
    "start": (
        pa.timestamp("ns", "UTC"),
        "",
        "when the recording began; null if nothing tells",
        lambda row: row.start_ns,
    ),
    "dated_by": (pa.string(), "", "stamps, log times, name or nothing", lambda row: row.dated_by),
    "duration": (pa.float64(), "s", "of the recording", lambda row: _finite(row.duration)),
    "verdict": (pa.string(), "", "about this robot, as in diagnosis.json", lambda row: row.verdict),
    "recording_verdict": (pa.string(), "", "about the whole recording", lambda row: row.of_recording),
    "sentence": (pa.string(), "", "the finding about the recording", lambda row: row.sentence or None),
    "nats": (
        pa.float64(),
        "nats",
        "evidence of the strongest effect",
        lambda row: _finite(max((each.nats for each in row.effects), default=math.nan)),
    ),
    "effects": (
        pa.list_(EFFECT),
        "",
        "what the model of this robot lacked, strongest first, each number with its 95 % interval and unit",
        lambda row: [_effect(each) for each in row.effects] if row.diagnosed else None,
    ),
    "not_shown": (
        _TEXTS,
        "",
        "effects that this recording could not have shown",
        lambda row: list(row.not_shown) if row.diagnosed else None,
    ),
    "cannot_be_told": (
        _TEXTS,
        "",
        "errors of readings that no other reading tells",
        lambda row: list(row.cannot_be_told) if row.diagnosed else None,
    ),
    "probabilities": (
        pa.map_(pa.string(), pa.float64()),
        "1",
        "of sets of suspects; null where diagnosis.json has none",
        lambda row: list(row.probabilities.items()) if row.probabilities else None,
    ),
    "warnings": (
        _TEXTS,
        "",
        "why nothing found is more than suspected",
        lambda row: list(row.warnings) if row.diagnosed else None,
    ),
    "remarks": (
        _TEXTS,
        "",
        "what was odd about the recording",
        lambda row: list(row.remarks) if row.diagnosed else None,
    ),
    "problem": (pa.string(), "", "why there is no diagnosis", lambda row: row.problem or None),
}
"""Type, unit, meaning and value for a row, by the name of a column."""
PARTS: dict[str, tuple[str, Callable[[Number], Any]]] = {
    "": ("fitted to this recording", lambda number: _finite(number.estimate.value)),
    "_low": ("lower end of its 95 % interval", lambda number: _finite(number.estimate.low)),
    "_high": ("upper end of its 95 % interval", lambda number: _finite(number.estimate.high)),
    "_nominal": ("as the platform has it", lambda number: _finite(number.nominal)),
    "_moved": ("whether it clearly differs from that", lambda number: number.moved),
}
"""Columns of each number of the platform, by what follows its name: meaning, and value."""


def table_of(rows: Sequence[Row]) -> pa.Table:
    """Make the table of a fleet, a row for each robot and recording."""
    fields, columns = [], []
    for name, (kind, unit, meaning, value) in COLUMNS.items():
        fields.append(_field(name, kind, unit, meaning))
        columns.append(pa.array([value(row) for row in rows], kind))
    for parameter in parameters_of(rows):
        mine = [next((each for each in row.numbers if each.parameter == parameter), None) for row in rows]
        unit = next(each.estimate.unit for each in mine if each)
        for suffix, (meaning, part) in PARTS.items():
            kind = pa.bool_() if suffix == "_moved" else pa.float64()
            fields.append(_field(parameter + suffix, kind, "" if suffix == "_moved" else unit, meaning))
            columns.append(pa.array([None if each is None else part(each) for each in mine], kind))
    return pa.Table.from_arrays(columns, schema=pa.schema(fields))


def parquet_bytes(table: pa.Table) -> bytes:
    """Encode a table as the content of a Parquet file."""
    buffer = pa.BufferOutputStream()
    pq.write_table(table, buffer, compression="zstd")
    content: bytes = buffer.getvalue().to_pybytes()
    return content


def parameters_of(rows: Iterable[Row]) -> list[str]:
    """Names of all fitted numbers: those of the contract in its order, then a platform's own by the alphabet."""
    usual = [name for name, _ in RECALIBRATED.values()]
    found = {number.parameter for row in rows for number in row.numbers}
    return [*(name for name in usual if name in found), *sorted(found - set(usual))]


def _field(name: str, kind: pa.DataType, unit: str, meaning: str) -> pa.Field:
    return pa.field(name, kind, metadata={"meaning": meaning, **({"unit": unit} if unit else {})})


def _effect(found: Effect) -> dict[str, Any]:
    parameters = [{"name": name, **_estimate(each)} for name, each in found.parameters.items()]
    return {
        "id": found.id,
        "tier": found.tier,
        "nats": _finite(found.nats),
        "parameters": parameters,
        "ambiguous_with": list(found.rivals),
    }


def _estimate(found: Estimate) -> dict[str, Any]:
    return {
        "value": _finite(found.value),
        "low": _finite(found.low),
        "high": _finite(found.high),
        "unit": found.unit,
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
