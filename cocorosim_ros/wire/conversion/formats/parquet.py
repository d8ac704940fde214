"""Parquet: one table with named columns."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from cocorosim_ros.wire.conversion.conversion_map import CsvLayout
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.formats.format import FileFormat, unreadable

_SUMMARY = "a Parquet file"


def _rows(path: Path, origin: str, layout: CsvLayout) -> ColumnRows:
    import pyarrow as arrow  # noqa: PLC0415 - maps of other formats do without its weight
    from pyarrow import parquet  # noqa: PLC0415

    try:
        table = parquet.ParquetFile(path).read()
    except (arrow.ArrowException, OSError) as error:
        raise unreadable(origin, _SUMMARY, error) from error
    return ColumnRows(origin, {name: _array(table.column(name)) for name in table.column_names})


def _array(column: Any) -> npt.NDArray[Any]:
    """(n,) the cells of a column; whole numbers with gaps stay whole numbers, since stamps may be such."""
    values = column.to_numpy()
    if column.null_count and values.dtype.kind == "f" and str(column.type).startswith(("int", "uint")):
        return np.array(column.to_pylist(), dtype=object)
    return np.asarray(values)


PARQUET = FileFormat(summary=_SUMMARY, kinds=("parquet",), rows=_rows)
