"""KINDS: what a file is by its first bytes, whatever its name says, and what to do where another is asked for."""

from __future__ import annotations

import shlex
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from cocorosim_ros.wire.bags.text_tables import TABLE_HEAD, is_text_table

_ZIP = b"PK\x03\x04"
HEAD = 1024  # bytes; HDF5 inside a MATLAB file begins at 512
_NAME_LENGTH, _NAME = slice(26, 28), 30  # where the length of the first file's name and the name stand in a zip archive
_BY_GUESS = (
    "write a map with 'format: {format}', by hand or by `cocorosim convert --guess {file} --out MAP.yaml`, and use "
    "`cocorosim convert MAP.yaml {file} --out BAG`"
)
_READY = "use `cocorosim convert {map} {file} --out BAG`, with the map that ships, or write one with 'format: {format}'"
_WITH_H5PY = "open it with h5py (`pip install h5py`) and write its columns as CSV or Parquet"


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
    last: bytes = b""  # how that name ends


def _by_guess(key: str, name: str, magic: bytes, way: str = "", last: bytes = b"") -> FileKind:
    """A kind for which a map can be guessed; `way` is its format where that is called otherwise."""
    return FileKind(key, name, magic, _BY_GUESS.replace("{format}", way or key), last=last)


def _by_ready_map(key: str, name: str, magic: bytes, ready: str, eighth: bytes = b"") -> FileKind:
    """A kind for which a map ships."""
    return FileKind(key, name, magic, _READY.replace("{format}", key).replace("{map}", ready), eighth=eighth)


TEXT_TABLE = _by_guess("csv", "a text table (CSV)", b"")
"""What is told by no first bytes."""
KINDS: tuple[FileKind, ...] = (
    _by_guess("mcap", "an MCAP file", b"\x89MCAP0\r\n", "bag"),
    _by_guess("ros1", "a ROS 1 bag", b"#ROSBAG V2.0", "bag"),
    FileKind("ros1_old", "a ROS 1 bag of version 1", b"#ROSBAG V1", "bring it to version 2.0 by `rosbag fix`"),
    _by_guess("sqlite", "a SQLite file", b"SQLite format 3\0", "bag"),
    _by_guess("ulog", "a ULog", b"ULog\x01\x12\x35"),
    _by_ready_map("dataflash", "a DataFlash log", b"\xa3\x95\x80", "ardusub_dataflash"),
    FileKind("dataflash_text", "a DataFlash log as text", b"FMT, 128", "give the .bin file that it was made from"),
    _by_ready_map("tlog", "a tlog", b"\0", "ardusub_tlog", eighth=b"\xfe"),
    _by_ready_map("tlog", "a tlog", b"\0", "ardusub_tlog", eighth=b"\xfd"),
    _by_guess("parquet", "a Parquet file", b"PAR1"),
    FileKind("mat_hdf5", "a MATLAB file of version 7.3", b"MATLAB 7.3 MAT-file", "save it by `save(name, '-v7')`"),
    _by_guess("mat", "a MATLAB file", b"MATLAB 5.0 MAT-file"),
    FileKind("hdf5", "an HDF5 file", b"\x89HDF\r\n\x1a\n", _WITH_H5PY),
    FileKind("hdf5", "an HDF5 file", b"\x89HDF\r\n\x1a\n", _WITH_H5PY, at=512),
    FileKind("netcdf", "a netCDF file", b"CDF\x01", "convert it to CSV or Parquet, for instance with xarray"),
    FileKind("npy", "a single NumPy array", b"\x93NUMPY", "save its columns by name with `numpy.savez`"),
    *(FileKind("excel", "an Excel file", _ZIP, "save it as CSV", first=name)
      for name in (b"[Content_Types].xml", b"_rels/", b"docProps/", b"xl/")),
    FileKind("spreadsheet", "a spreadsheet", _ZIP, "save it as CSV", first=b"mimetypeapplication/vnd.oasis"),
    _by_guess("npz", "an npz file of NumPy", _ZIP, last=b".npy"),
    FileKind("zip", "a zip archive", _ZIP, "unpack it and give what is in it"),
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
    return kind_in(_head(path, HEAD))


def kind_or_table(path: Path) -> FileKind | None:
    """The kind of a file as `kind_of` has it, or the text table that it is. Raises OSError if unreadable."""
    return kind_or_table_in(_head(path, TABLE_HEAD))


def kind_or_table_in(head: bytes) -> FileKind | None:
    """The kind of a file that begins with these bytes, at least `TABLE_HEAD` of them if it has so many."""
    return kind_in(head) or (TEXT_TABLE if is_text_table(head) else None)


def kind_in(head: bytes) -> FileKind | None:
    """The kind of a file that begins with these bytes, at least `HEAD` of them if it has so many."""
    return next((kind for kind in KINDS if _begins(head, kind)), None)


def _head(path: Path, size: int) -> bytes:
    with path.open("rb") as file:
        return file.read(size)


def _begins(head: bytes, kind: FileKind) -> bool:
    parts = ((kind.magic, kind.at), (kind.eighth, 8), (kind.first, _NAME))
    name = head[_NAME : _NAME + int.from_bytes(head[_NAME_LENGTH], "little")]
    return all(head.startswith(part, at) for part, at in parts if part) and name.endswith(kind.last)


def told(kind: FileKind, file: Path) -> str:
    """The rest of a sentence: the kind of a file, and what to do with it."""
    return f"is {kind.name}; {kind.way_out.replace('{file}', shlex.quote(str(file)))}"


def told_of_folder(folder: Path, tables: Iterable[str] = ("csv", "parquet", "npz", "mat")) -> str:
    """The rest of a sentence on a folder that holds no recording: what its first known file is; '' without any.

    tables: the kinds of which a whole folder is converted at once.
    """
    for file in sorted(each for each in folder.iterdir() if each.is_file()):
        kind = kind_or_table(file)
        if kind is not None:
            return f"holds {file.name}, which {told(kind, folder if kind.key in tables else file)}"
    return ""
