"""The dead man's switch of free runs, by its rules."""

from __future__ import annotations

from cocorosim_ros.world.tick.dead_mans_switch import DeadMansSwitch


def test_silence_longer_than_the_patience_turns_off_once() -> None:
    """Up to the patience the last command holds, afterwards the robot is named once."""
    switch = DeadMansSwitch(2, patience=10.0)
    for moment in (0.0, 5.0, 10.0):
        switch.begin_tick(moment)
        switch.heard(1)
        assert switch.newly_silent(moment) == []
    assert switch.newly_silent(10.5) == [0]
    assert switch.newly_silent(20.0) == [], "said already, and robot 1 has answered the last tick"


def test_a_slow_rate_is_no_silence() -> None:
    """Nothing is owed between an answer and the next tick, however long that is."""
    switch = DeadMansSwitch(1, patience=10.0)
    switch.begin_tick(0.0)
    switch.heard(0)
    switch.begin_tick(100.0)
    assert switch.newly_silent(101.0) == []
    assert switch.newly_silent(111.0) == [0]


def test_who_is_heard_again_has_its_actuators_back() -> None:
    """The first command after the silence says so; a second silence is named again."""
    switch = DeadMansSwitch(1, patience=1.0)
    switch.begin_tick(0.0)
    assert switch.newly_silent(2.0) == [0]
    assert switch.heard(0)
    assert not switch.heard(0)
    switch.begin_tick(3.0)
    assert switch.newly_silent(5.0) == [0]


def test_a_death_needs_no_patience_and_counts_once() -> None:
    """Whoever takes the robot of a dead controller over may command it."""
    switch = DeadMansSwitch(2, patience=10.0)
    switch.begin_tick(0.0)
    assert switch.newly_dead([1]) == [1]
    assert switch.newly_dead([1]) == []
    assert switch.heard(1)
    assert switch.newly_dead([1]) == []


def test_what_is_off_for_another_reason_is_not_named_again() -> None:
    """A controller that was not there at the start has been named then."""
    switch = DeadMansSwitch(1, patience=1.0)
    switch.off(0)
    switch.begin_tick(0.0)
    assert switch.newly_silent(5.0) == []
    assert switch.newly_dead([0]) == []
    assert switch.heard(0)
