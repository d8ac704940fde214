"""Primitives of CDR, with the package `rosbags` as referee, and that nobody else puts them together."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

import cocorosim_ros
from cocorosim_ros.wire.cdr.alignment import MALFORMED, aligned
from cocorosim_ros.wire.cdr.kernels.places import after_text, aligned_place, length_at
from cocorosim_ros.wire.cdr.primitives import (
    ENCAPSULATION,
    NANOSECONDS,
    Reader,
    pack_counter,
    pack_length,
    pack_numbers,
    pack_stamp,
    pack_text,
    padding,
    stamp_words,
)

TYPE = "test_msgs/msg/Mixture"
TEXT = "builtin_interfaces/Time when\nstring first\nstring[] more\nfloat64[] values\nstring last\nuint64 count\n"
STORE = get_typestore(Stores.ROS2_JAZZY)
STORE.register(get_types_from_msg(TEXT, TYPE))
TIMES = some.integers(-(2**31) * NANOSECONDS, 2**31 * NANOSECONDS - 1)
WORDS = some.text(some.characters(codec="utf-8", exclude_characters="\0"), max_size=9)
MIXTURES = some.tuples(
    TIMES, WORDS, some.lists(WORDS, max_size=4), some.lists(some.floats(), max_size=4), WORDS, some.integers(0, 2**63)
)
Mixture = tuple[int, str, list[str], list[float], str, int]
OWN = Path(cocorosim_ros.__file__).parent
BY_HAND = {  # what knows bytes by itself: CDR here, MCAP and the head of a digest in the bags
    "wire/bags/bag_writer.py",
    "wire/bags/digest.py",
    "wire/bags/mcap_file.py",
    "wire/bags/mcap_format.py",
    "wire/bags/mcap_writer.py",
    "wire/cdr/acoustic_messages.py",
    "wire/cdr/named_numbers.py",
    "wire/cdr/packed.py",
    "wire/cdr/primitives.py",
    "wire/cdr/radio_messages.py",
    "wire/topics/markers.py",
}


def by_rosbags(mixture: Mixture, *, little_endian: bool = True) -> bytes:
    """The message as the referee writes it."""
    when, first, more, values, last, count = mixture
    time = STORE.types["builtin_interfaces/msg/Time"](*divmod(when, NANOSECONDS))
    message = STORE.types[TYPE](time, first, more, np.array(values), last, count)
    return bytes(STORE.serialize_cdr(message, TYPE, little_endian=little_endian))


@given(MIXTURES)
def test_written_as_the_referee_writes(mixture: Mixture) -> None:
    """Stamp, texts, lists and counter one after the other, whatever their lengths."""
    when, first, more, values, last, count = mixture
    body = pack_stamp(when) + pack_text(first) + pack_length(len(more)) + b"".join(map(pack_text, more))
    body += pack_numbers(values, len(body))
    body += pack_text(last)
    body += padding(len(body), 8) + pack_counter(count)
    assert ENCAPSULATION + body == by_rosbags(mixture)


@given(MIXTURES, some.booleans())
def test_read_as_the_referee_wrote(mixture: Mixture, little_endian: bool) -> None:
    """What went in comes out again, in either byte order."""
    reader = Reader(by_rosbags(mixture, little_endian=little_endian))
    when, first = reader.stamp_ns(), reader.text()
    more = [reader.text() for _ in range(reader.length())]
    read = when, first, more, list(reader.numbers()), reader.text(), reader.counter()
    assert repr(read) == repr(mixture)  # equal NaNs, too


@given(MIXTURES, some.data())
def test_bytes_that_end_too_early(mixture: Mixture, draw: some.DataObject) -> None:
    """Cut anywhere, reading to the end ends in an error that callers turn into a sentence."""
    whole = by_rosbags(mixture)
    reader = Reader(whole[: draw.draw(some.integers(0, len(whole) - 1))])
    with pytest.raises((ValueError, struct.error)):
        reader.stamp_ns()
        reader.text_bytes()
        for _ in range(reader.length()):
            reader.text_bytes()
        reader.numbers()
        reader.text_bytes()
        reader.counter()


@given(some.lists(TIMES, min_size=1, max_size=5))
def test_stamps_as_words(times: list[int]) -> None:
    """One or many at once, they are the bytes of the single ones."""
    expected = b"".join(map(pack_stamp, times))
    assert stamp_words(np.array(times, dtype=np.int64)).astype("<i8").tobytes() == expected
    assert b"".join((stamp_words(time) & (2**64 - 1)).to_bytes(8, "little") for time in times) == expected


@settings(deadline=None)  # the first call compiles
@given(some.binary(max_size=24), some.integers(4, 24))
def test_compiled_functions_find_what_the_reader_finds(body: bytes, start: int) -> None:
    """Places, lengths and ends of texts in any bytes; where the reader refuses, there is MALFORMED."""
    data = ENCAPSULATION + body
    array = np.frombuffer(data, np.uint8)
    assert [aligned_place(start, size) for size in (4, 8)] == [aligned(start, size) for size in (4, 8)]
    reader = Reader(data)
    reader.place = start
    try:
        expected = reader.length(), reader.place
    except (ValueError, struct.error):
        expected = MALFORMED, len(data)
    assert length_at(array, start) == expected
    assert after_text(array, start) == min(expected[1] + max(expected[0], 0), len(data))


def test_nobody_else_packs_bytes() -> None:
    """`struct` and encapsulation headers are used where bytes are known by hand, and nowhere else."""
    found = {
        path.relative_to(OWN).as_posix()
        for path in OWN.rglob("*.py")
        if "import struct\n" in (text := path.read_text("utf-8")) or r"\x00\x01\x00\x00" in text
    }
    assert found == BY_HAND
