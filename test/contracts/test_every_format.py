"""What every entry of FORMATS has to keep, unasked: a good log arrives, any other one is a sentence."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.file_kinds import KINDS, kind_of
from cocorosim_ros.wire.conversion.conversion import Converted, convert
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.formats.format import FileFormat
from cocorosim_ros.wire.conversion.map_file import load_map

from .logs_by_format import COUNT, LOGS

every_format = pytest.mark.parametrize("name", FORMATS)
OPTIONAL = {"ulog": "pyulog", "tlog": "pymavlink"}


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The bytes of a good log by format."""
    folder = tmp_path_factory.mktemp("logs")
    for log in LOGS.values():
        log.write(folder / log.file)
    return {name: (folder / log.file).read_bytes() for name, log in LOGS.items()}


def converted(name: str, content: bytes, folder: Path, table: str = "") -> Converted:
    """What comes of a log of these bytes under the map of a format."""
    (folder / LOGS[name].file).write_bytes(content)
    (folder / "map.yaml").write_text(f"name: m\nformat: {name}\ntables:\n{table or LOGS[name].table}", "utf-8")
    return convert(load_map(folder / "map.yaml"), folder / LOGS[name].file, folder / "ours")[0]


def refusal(name: str, content: bytes, folder: Path, table: str = "") -> str:
    """The sentence that is said of such a log; nothing is left behind."""
    with pytest.raises(CocorosimError) as caught:
        converted(name, content, folder, table)
    assert not (folder / "ours").exists()
    sentence = str(caught.value)
    assert "\n" not in sentence and sentence.endswith(".")
    return sentence


def test_every_format_has_a_log() -> None:
    """A format without a line in LOGS would not be tested."""
    assert LOGS.keys() == FORMATS.keys()


@every_format
def test_a_good_log_arrives(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """Every number and every stamp, without a remark."""
    made = converted(name, logs[name], tmp_path).conversion
    (stream,) = made.streams
    assert (stream.robot, stream.topic, made.findings) == ("boat", "velocity", ())
    np.testing.assert_array_equal(stream.rows.values[:, 0], 0.25 * np.arange(COUNT))
    np.testing.assert_array_equal(stream.stamp_ns, 10**9 + 500_000_000 * np.arange(COUNT))


@every_format
def test_the_same_log_gives_the_same_recording(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """Digests are equal, wherever the log lies."""
    folders = [tmp_path / "a", tmp_path / "b"]
    for folder in folders:
        folder.mkdir()
    first, second = (converted(name, logs[name], folder).digest for folder in folders)
    assert first == second


@every_format
@pytest.mark.parametrize("part", [0.0213, 0.317, 0.611, 0.913, 0.9999])
def test_a_log_that_ends_early(name: str, part: float, logs: dict[str, bytes], tmp_path: Path) -> None:
    """It is refused in a sentence, or what is left is converted and that is said; text alone cannot show it."""
    whole = logs[name]
    try:
        made = converted(name, whole[: int(part * len(whole))], tmp_path).conversion
    except CocorosimError as error:
        assert LOGS[name].file in str(error) and "\n" not in str(error)
    else:
        assert made.findings or name == "csv"
        values = made.streams[0].rows.values[:-1, 0]
        np.testing.assert_array_equal(values, 0.25 * np.arange(len(values)))


@every_format
def test_a_log_with_other_bytes_inside(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """Bytes that are not what they were: a sentence or a recording, and no other error."""
    rng = np.random.default_rng(8)
    for _ in range(20):
        content = bytearray(logs[name])
        places = rng.integers(20, len(content), 8)
        for place in places:
            content[place] = int(rng.integers(256))
        try:
            convert_again = tmp_path / f"{rng.integers(1 << 60)}"
            convert_again.mkdir()
            converted(name, bytes(content), convert_again)
        except CocorosimError as error:
            assert "\n" not in str(error)


@every_format
def test_an_empty_log(name: str, tmp_path: Path) -> None:
    """Nothing at all."""
    assert "empty" in (found := refusal(name, b"", tmp_path)) or "holds no row" in found


@every_format
def test_a_log_of_another_format(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """What it is instead and the way out are said, except that any text may be CSV."""
    for other, content in logs.items():
        if other == name:
            continue
        found = refusal(name, content, tmp_path)
        assert "is not " in found or name == "csv", found
        assert f"'format: {other}'" in found, found


@every_format
def test_unknown_topics_and_columns(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """The place in the map is named, and what there is."""
    table = LOGS[name].table
    if not isinstance(FORMATS[name], FileFormat):
        topic = table.partition("topic: ")[2].partition(",")[0]
        found = refusal(name, logs[name], tmp_path, table.replace(topic, "nowhere", 1))
        assert "names nowhere, which has no message in" in found and topic in found
    column = table.rpartition("column: ")[2].partition(",")[0]
    found = refusal(name, logs[name], tmp_path, table.replace(f"column: {column}", "column: nothing", 1))
    assert "streams.velocity.x.column' has 'nothing', no " in found and column.strip('"') in found


@pytest.mark.parametrize("name", [name for name in FORMATS if not isinstance(FORMATS[name], FileFormat)])
def test_an_optional_topic(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """One that the log lacks is told; where nothing else shows motion, or it is not optional, the log is refused."""
    table = LOGS[name].table
    topic = table.partition("topic: ")[2].partition(",")[0]
    lacking = table.replace(f"topic: {topic}", "topic: nowhere, optional: true", 1)
    found = converted(name, logs[name], tmp_path, lacking + table).conversion
    assert [stream.topic for stream in found.streams] == ["velocity"]
    (told,) = found.findings
    assert told.startswith("The log lacks nowhere (for velocity), which the map calls optional")
    (tmp_path / "again").mkdir()
    assert "nothing shows how the vehicle moved" in refusal(name, logs[name], tmp_path / "again", lacking)
    required = lacking.replace(", optional: true", "")
    assert "names nowhere, which has no message" in refusal(name, logs[name], tmp_path / "again", required + table)


@pytest.mark.parametrize("name", [name for name in FORMATS if not isinstance(FORMATS[name], FileFormat)])
def test_a_topic_that_stands_in(name: str, logs: dict[str, bytes], tmp_path: Path) -> None:
    """With `unless` it is taken only where no table before it gives that of the robot, and the order is the map's."""
    table = LOGS[name].table
    second = table.replace("robot: boat", "optional: {unless: velocity}, robot: boat").replace("x: {", "y: {")
    found = converted(name, logs[name], tmp_path, table + second).conversion
    (stream,) = found.streams
    np.testing.assert_array_equal(stream.rows.values[:, 0], 0.25 * np.arange(COUNT))
    assert np.isnan(stream.rows.values[:, 1]).all() and found.findings == ()
    (tmp_path / "again").mkdir()
    other = second.replace("robot: boat", "robot: other")
    found = converted(name, logs[name], tmp_path / "again", table + other).conversion
    assert [stream.robot for stream in found.streams] == ["boat", "other"]


@pytest.mark.parametrize("name", OPTIONAL)
def test_a_library_that_is_missing(
    name: str, logs: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What to install is said."""
    for module in (OPTIONAL[name], "pymavlink.dialects.v20"):
        monkeypatch.setitem(sys.modules, module, None)
    assert f"`pip install {OPTIONAL[name]}`" in refusal(name, logs[name], tmp_path)


@pytest.mark.parametrize(
    ("first", "kind"),
    [
        ("[Content_Types].xml", "excel"),
        ("docProps/app.xml", "excel"),
        ("mimetype", "spreadsheet"),
        ("x.npy", "npz"),
        ("log.csv", "zip"),
    ],
)
def test_zip_archives_are_told_by_their_first_file(first: str, kind: str, tmp_path: Path) -> None:
    """As Excel, libraries that write its files, LibreOffice and NumPy begin theirs."""
    content = "application/vnd.oasis.opendocument.spreadsheet" if first == "mimetype" else "<xml/>"
    with zipfile.ZipFile(tmp_path / "log", "w") as archive:
        archive.writestr(first, content)
    found = kind_of(tmp_path / "log")
    assert found is not None and found.key == kind
    if kind not in ("npz", "zip"):
        assert "; save it as CSV" in refusal("csv", (tmp_path / "log").read_bytes(), tmp_path)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.key)
def test_every_kind_of_file_is_known(kind: object, tmp_path: Path) -> None:
    """A file that begins so is called by its name, with a way out, where CSV is asked for and where a bag is."""
    content = (bytes(8) if kind.eighth else bytes(kind.at)) + kind.eighth + (b"" if kind.eighth else kind.magic)
    if name := kind.first or (b"x" + kind.last if kind.last else b""):
        content = content.ljust(26, b"\1") + bytes([len(name), 0, 0, 0]) + name
    file = tmp_path / "log.csv"
    file.write_bytes(content + b"\1" * 600)
    assert kind_of(file).key == kind.key
    found = refusal("csv", file.read_bytes(), tmp_path)
    assert f"is {kind.name}; " in found
