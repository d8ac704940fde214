"""The rules of lock-step, robot by robot, without ROS and without clocks."""

from __future__ import annotations

from cocorosim_ros.world.tick.step_barrier import COMMAND, RADIO_MESSAGE, REJOIN_LIMIT, StepBarrier


def test_everybody_is_waited_for_until_all_parts_are_there() -> None:
    """A speaker owes two parts, the others one."""
    barrier = StepBarrier(2, speakers=[1])
    barrier.begin_tick()
    assert barrier.answered(0, COMMAND)
    assert barrier.answered(1, COMMAND)
    assert barrier.waiting_for() == [1]
    assert barrier.answered(1, RADIO_MESSAGE)
    assert barrier.waiting_for() == []
    barrier.begin_tick()
    assert barrier.waiting_for() == [0, 1]


def test_a_second_answer_is_refused() -> None:
    """Two commands are no command and a radio message."""
    barrier = StepBarrier(1, speakers=[0])
    barrier.begin_tick()
    assert barrier.answered(0, COMMAND)
    assert not barrier.answered(0, COMMAND)
    assert barrier.waiting_for() == [0]


def test_a_silent_robot_is_not_waited_for_but_stays_unanswered() -> None:
    """Until it answers in time, from when on it is waited for again."""
    barrier = StepBarrier(2)
    barrier.begin_tick()
    barrier.answered(0, COMMAND)
    barrier.declare_silent(1)
    assert barrier.waiting_for() == []
    assert barrier.unanswered() == [1]
    barrier.begin_tick()
    assert barrier.waiting_for() == [0]
    assert barrier.answered(1, COMMAND)
    assert barrier.silent == []
    barrier.begin_tick()
    assert barrier.waiting_for() == [0, 1]


def test_one_that_is_always_late_is_given_up_in_the_end() -> None:
    """It is waited for again so often and no more: else every tick would last as long as the patience with it."""
    barrier = StepBarrier(1)
    waits = 0
    for _ in range(10):
        barrier.begin_tick()
        barrier.heard(0, in_time=True)
        if barrier.waiting_for():
            waits += 1
            barrier.declare_silent(0)
    assert waits == 1 + REJOIN_LIMIT


def test_an_answer_from_long_ago_does_not_bring_it_back() -> None:
    """It does not follow the clock."""
    barrier = StepBarrier(1)
    barrier.begin_tick()
    barrier.declare_silent(0)
    barrier.heard(0, in_time=False)
    assert barrier.waiting_for() == []
