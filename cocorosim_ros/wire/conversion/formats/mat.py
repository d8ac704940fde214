"""mat: variables of MATLAB to version 7; `log.speed` is a field of a struct."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from cocorosim_ros.wire.conversion.conversion_map import CsvLayout
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.formats.format import FileFormat, unreadable

_SUMMARY = "a MATLAB file"


def _rows(path: Path, origin: str, layout: CsvLayout) -> ColumnRows:
    from scipy.io import loadmat  # noqa: PLC0415 - maps of other formats do without its weight

    try:
        with path.open("rb") as file:
            variables = loadmat(file, simplify_cells=True)
    except Exception as error:  # a parser that meets damage may raise anything
        raise unreadable(origin, _SUMMARY, error) from error
    return ColumnRows(origin, dict(_arrays({k: v for k, v in variables.items() if not k.startswith("__")}, "")))


def _arrays(value: Any, name: str) -> list[tuple[str, npt.NDArray[Any]]]:
    """The arrays in variables and in fields of structs, by their paths."""
    if isinstance(value, dict):
        found = []
        for key, part in value.items():
            found += _arrays(part, f"{name}.{key}" if name else key)
        return found
    array = np.asarray(value)
    return [(name, array)] if array.dtype.kind in "biuf" and array.ndim else []


MAT = FileFormat(summary=_SUMMARY, kinds=("mat",), rows=_rows)
