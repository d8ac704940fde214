"""FORMATS: the logs that a map can be written for, by the word in its `format`."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.wire.conversion.formats.bag import BAG
from cocorosim_ros.wire.conversion.formats.csv import CSV
from cocorosim_ros.wire.conversion.formats.dataflash import DATAFLASH
from cocorosim_ros.wire.conversion.formats.format import Format
from cocorosim_ros.wire.conversion.formats.mat import MAT
from cocorosim_ros.wire.conversion.formats.npz import NPZ
from cocorosim_ros.wire.conversion.formats.parquet import PARQUET
from cocorosim_ros.wire.conversion.formats.tlog import TLOG
from cocorosim_ros.wire.conversion.formats.ulog import ULOG

FORMATS: Mapping[str, Format] = {
    "csv": CSV,
    "parquet": PARQUET,
    "npz": NPZ,
    "mat": MAT,
    "bag": BAG,
    "ulog": ULOG,
    "dataflash": DATAFLASH,
    "tlog": TLOG,
}
