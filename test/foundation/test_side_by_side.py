"""Work in parts: everything once, in threads or not, and what fails is said."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cocorosim_ros.foundation.compiling.stretch import Stretch
from cocorosim_ros.foundation.side_by_side import SideBySide


@given(total=st.integers(1, 60), at_a_time=st.integers(1, 70))
def test_everything_is_done_once(total: int, at_a_time: int) -> None:
    """Whatever the size of the parts, also a second time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("cocorosim_ros.foundation.side_by_side.processors", lambda: 3)
        done, side_by_side = np.zeros(total, np.int64), SideBySide(total, at_a_time)

    def work(part: Stretch | None) -> None:
        assert (part is None) == (at_a_time >= total)
        some = slice(None) if part is None else slice(part.first, part.last)
        assert done[some].size <= at_a_time
        done[some] += 1

    for times in (1, 2):
        side_by_side.do(work)
        assert (done == times).all()


def test_several_threads_take_part(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two parts wait for each other, which one thread could not."""
    monkeypatch.setattr("cocorosim_ros.foundation.side_by_side.processors", lambda: 2)
    side_by_side, meeting = SideBySide(2, 1), threading.Barrier(2, timeout=30.0)
    assert side_by_side.threaded
    side_by_side.do(lambda part: meeting.wait())


def test_all_at_a_time_needs_no_thread() -> None:
    """The caller does it."""
    side_by_side, who = SideBySide(5, 5), []
    assert not side_by_side.threaded
    side_by_side.do(lambda part: who.append((part, threading.get_ident())))
    assert who == [(None, threading.get_ident())]


@pytest.mark.parametrize("failing", [0, 7])
def test_what_fails_is_raised(failing: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """In the first part, which the caller takes, as in the last, which another thread takes."""

    def work(part: Stretch | None) -> None:
        if part is not None and part.first == failing:
            raise ValueError(failing)

    monkeypatch.setattr("cocorosim_ros.foundation.side_by_side.processors", lambda: 2)
    with pytest.raises(ValueError, match=str(failing)):
        SideBySide(8, 1).do(work)
