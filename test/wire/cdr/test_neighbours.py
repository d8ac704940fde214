"""The bytes of `neighbours`, with an independent encoder as referee."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.neighbours import TYPE, encode_neighbours, read_neighbours


@pytest.mark.parametrize(
    "names", [[], ["a"], ["lily_02"], ["lily_02", "jeff_1", "x" * 13], ["ab", "abc", "abcd", "abcde"]]
)
@pytest.mark.parametrize("frame", ["lily_01/base_link", "b"])
def test_bytes_are_those_of_the_general_encoder(names: list[str], frame: str) -> None:
    """Whatever the lengths of the names, the bytes are those of rosbags, and reading gives back what went in."""
    draw = np.random.default_rng(len(names))
    offset, velocity = draw.normal(size=(2, len(names), 3))
    data = encode_neighbours(3_000_000_007, frame, names, offset, velocity)
    values = {
        "header": {"stamp": {"sec": 3, "nanosec": 7}, "frame_id": frame},
        "name": names,
        "offset": [dict(zip("xyz", row, strict=True)) for row in offset.tolist()],
        "velocity": [dict(zip("xyz", row, strict=True)) for row in velocity.tolist()],
    }
    referee = type_store.serialize(type_store.build(TYPE, values))
    assert data == referee[: len(data)]
    assert not any(referee[len(data) :])
    found, places, speeds = read_neighbours(data)
    assert list(found) == names
    assert np.array_equal(places, offset)
    assert np.array_equal(speeds, velocity)
