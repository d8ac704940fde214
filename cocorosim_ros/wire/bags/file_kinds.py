"""KINDS: what a file is by its first bytes, whatever its name says, and what to do with one that is not read."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

_ZIP = b"PK\x03\x04"
HEAD = 1024  # bytes; HDF5 inside a MATLAB file begins at 512
_ZIPPED = "arrays of NumPy are read by 'format: npz'; save a spreadsheet as CSV, unpack others"
_BY_MAP = "write a map with 'format: {format}' and use `cocorosim convert MAP.yaml {file} --out BAG`"


@dataclass(frozen=True)
class FileKind:
    """A kind of file that begins with certain bytes."""

    key: str  # as formats of maps name it
    name: str  # in sentences, with its article
    magic: bytes
    way_out: str  # where {file} is the file's name
    at: int = 0  # where the magic bytes stand
    eighth: bytes = b""  # what stands behind a time of eight bytes
    first: bytes = b""  # how the name of the first file in a zip archive begins


KINDS: tuple[FileKind, ...] = (
    FileKind("mcap", "an MCAP file", b"\x89MCAP0\r\n", _BY_MAP.replace("{format}", "bag")),
    FileKind("ros1", "a ROS 1 bag", b"#ROSBAG V2.0", _BY_MAP.replace("{format}", "bag")),
    FileKind("ros1_old", "a ROS 1 bag of version 1", b"#ROSBAG V1", "bring it to version 2.0 by `rosbag fix`"),
    FileKind("sqlite", "a SQLite file", b"SQLite format 3\0", _BY_MAP.replace("{format}", "bag")),
    FileKind("ulog", "a ULog", b"ULog\x01\x12\x35", _BY_MAP.replace("{format}", "ulog")),
    FileKind("dataflash", "a DataFlash log", b"\xa3\x95\x80", _BY_MAP.replace("{format}", "dataflash")),
    FileKind("dataflash_text", "a DataFlash log as text", b"FMT, 128", "give the .bin file that it was made from"),
    FileKind("tlog", "a tlog", b"\0", _BY_MAP.replace("{format}", "tlog"), eighth=b"\xfe"),
    FileKind("tlog", "a tlog", b"\0", _BY_MAP.replace("{format}", "tlog"), eighth=b"\xfd"),
    FileKind("parquet", "a Parquet file", b"PAR1\x15", _BY_MAP.replace("{format}", "parquet")),
    FileKind("mat_hdf5", "a MATLAB file of version 7.3", b"MATLAB 7.3 MAT-file", "save it by `save(name, '-v7')`"),
    FileKind("mat", "a MATLAB file", b"MATLAB 5.0 MAT-file", _BY_MAP.replace("{format}", "mat")),
    FileKind("hdf5", "an HDF5 file", b"\x89HDF\r\n\x1a\n", "convert it to CSV or Parquet, for instance with pandas"),
    FileKind("hdf5", "an HDF5 file", b"\x89HDF\r\n\x1a\n", "convert it to CSV or Parquet", at=512),
    FileKind("netcdf", "a netCDF file", b"CDF\x01", "convert it to CSV or Parquet, for instance with xarray"),
    FileKind("npy", "a single NumPy array", b"\x93NUMPY", "save its columns by name with `numpy.savez`"),
    *(FileKind("excel", "an Excel file", _ZIP, "save it as CSV", first=name)
      for name in (b"[Content_Types].xml", b"_rels/", b"docProps/", b"xl/")),
    FileKind("spreadsheet", "a spreadsheet", _ZIP, "save it as CSV", first=b"mimetypeapplication/vnd.oasis"),
    FileKind("npz", "a zip archive", _ZIP, _ZIPPED),
    FileKind("arrow", "an Arrow file", b"ARROW1", "write it as Parquet with pyarrow"),
    FileKind("pickle", "a Python pickle", b"\x80\x04", "save it as Parquet, npz or CSV: a pickle can run code"),
    FileKind("pickle", "a Python pickle", b"\x80\x05", "save it as Parquet, npz or CSV: a pickle can run code"),
    FileKind("gzip", "a gzip archive", b"\x1f\x8b", "unpack it by `gunzip`"),
    FileKind("bzip2", "a bzip2 archive", b"BZh", "unpack it by `bunzip2`"),
    FileKind("zstd", "a zstd archive", b"\x28\xb5\x2f\xfd", "unpack it by `unzstd`"),
    FileKind("xz", "an xz archive", b"\xfd7zXZ\x00", "unpack it by `unxz`"),
    FileKind("seven_zip", "a 7z archive", b"7z\xbc\xaf\x27\x1c", "unpack it"),
    FileKind("excel", "an old Excel file", b"\xd0\xcf\x11\xe0", "save it as CSV"),
)  # fmt: skip


def kind_of(path: Path) -> FileKind | None:
    """The kind of a file by its first bytes; None for text, and for what is not known. Raises OSError if unreadable."""
    with path.open("rb") as file:
        return kind_in(file.read(HEAD))


def kind_in(head: bytes) -> FileKind | None:
    """The kind of a file that begins with these bytes, at least `HEAD` of them if it has so many."""
    return next((kind for kind in KINDS if _begins(head, kind)), None)


def _begins(head: bytes, kind: FileKind) -> bool:
    parts = ((kind.magic, kind.at), (kind.eighth, 8), (kind.first, 30))
    return all(head.startswith(part, at) for part, at in parts if part)


def told(kind: FileKind, file: Path) -> str:
    """The rest of a sentence: the kind of a file, and what to do with it."""
    return f"is {kind.name}; {kind.way_out.replace('{file}', file.name)}"
