"""CSV: text with separators; how it is written is the map's `layout`."""

from __future__ import annotations

from cocorosim_ros.wire.conversion.csv_rows import CsvRows
from cocorosim_ros.wire.conversion.formats.format import FileFormat

CSV = FileFormat(summary="a CSV file", kinds=(), rows=CsvRows)
