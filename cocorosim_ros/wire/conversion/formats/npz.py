"""npz: arrays of NumPy by name in one archive."""

from __future__ import annotations

import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.conversion.conversion_map import CsvLayout
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.formats.format import FileFormat, unreadable

_SUMMARY = "an npz file"


def _rows(path: Path, origin: str, layout: CsvLayout) -> ColumnRows:
    found: dict[str, npt.NDArray[Any]] = {}
    name = ""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:  # a pickle can run code
            for name in archive.files:
                found[name] = np.asarray(archive[name])
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError) as error:
        raise unreadable(origin, _SUMMARY, error) from error
    except ValueError as error:
        if not name:
            raise unreadable(origin, _SUMMARY, "no zip archive") from error
        raise CocorosimError(
            f"{origin} holds '{name}', an array of objects, which is not read since it can run code; save it again "
            "with columns of numbers alone."
        ) from error
    fields = {f"{name}.{field}": array[field] for name, array in found.items() for field in array.dtype.names or ()}
    return ColumnRows(origin, {**{name: array for name, array in found.items() if not array.dtype.names}, **fields})


NPZ = FileFormat(summary=_SUMMARY, kinds=("npz", "zip"), rows=_rows)
