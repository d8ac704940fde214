"""Links that lose, delay, blur and restrict messages."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import stats

from cocorosim_ros.scenario.parts.corruption import Corruption
from cocorosim_ros.world.links.imperfect_links import imperfect_links
from cocorosim_ros.world.seeding.corruption_at_work import Swarms
from cocorosim_ros.world.state.radio import MESSAGE_SIZE, Inbox, empty_inbox

NAMES = ("a", "b", "c", "d")


def full_inbox(tick: int = 0, runs: int = 1) -> Inbox:
    """Everybody hears the three others, who say the tick and their own number."""
    inbox = empty_inbox(runs, 4, 3)
    inbox.heard[...] = 3
    for robot in range(4):
        senders = [other for other in range(4) if other != robot]
        inbox.sender[:, robot] = senders
        inbox.message[:, robot, :, 0] = 2.0
        inbox.message[:, robot, :, 1] = tick
        inbox.message[:, robot, :, 2] = senders
    return inbox


def spoiled(ticks: int, *corruptions: Corruption, runs: range = range(1)) -> list[Any]:
    """What each tick's inbox is after the link."""
    links = imperfect_links("radio", corruptions, Swarms(3, NAMES, runs))
    inboxes = []
    for tick in range(ticks):
        inbox = full_inbox(tick, len(runs))
        for link in links:
            link.spoil(tick, inbox)
        inboxes.append(inbox)
    return inboxes


def test_loss_has_its_probability_and_keeps_order() -> None:
    """30 % of 12000 messages are lost; what is left stands in order, each with its own words."""
    inboxes = spoiled(1000, Corruption("radio", "loss", {"probability": 0.3}))
    left = sum(int(inbox.heard.sum()) for inbox in inboxes)
    assert stats.binomtest(left, 12000, 0.7).pvalue > 1e-4
    for inbox in inboxes:
        for robot in range(4):
            senders = inbox.sender[0, robot, : inbox.heard[0, robot]].tolist()
            assert senders == sorted(set(senders) - {robot})
            assert inbox.message[0, robot, : len(senders), 2].tolist() == senders


def test_delay_shows_the_words_of_then() -> None:
    """Two ticks late: nothing, nothing, then tick 0, three ticks old in all."""
    inboxes = spoiled(5, Corruption("radio", "delay", {"ticks": 2.0}))
    assert [int(inbox.heard.sum()) for inbox in inboxes] == [0, 0, 12, 12, 12]
    assert [inbox.message[0, 0, 0, 1] for inbox in inboxes[2:]] == [0.0, 1.0, 2.0]
    assert (inboxes[4].age == 3).all()


def test_noise_blurs_the_payload_alone() -> None:
    """The two numbers said have a scatter of 0.5, those not said stay zero, the length stays."""
    inboxes = spoiled(500, Corruption("radio", "noise", {"sd": 0.5}))
    left = np.array([inbox.message - full_inbox(tick).message for tick, inbox in enumerate(inboxes)])
    assert stats.kstest(left[..., 1:3].ravel() / 0.5, "norm").pvalue > 1e-4
    assert not left[..., 0].any()
    assert not left[..., 3:].any()


def test_rate_limit_counts_what_was_sent() -> None:
    """Once in three ticks: who always speaks is heard at 0, 3, 6; who spoke at 1 first, at 1 and 4."""
    link = imperfect_links("radio", [Corruption("radio", "rate_limit", {"ticks": 3.0})], Swarms(3, NAMES, range(1)))[0]
    heard = []
    for tick in range(7):
        said = np.zeros((1, 4, MESSAGE_SIZE))
        said[0, :, 0] = [1.0, 0.0 if tick == 0 else 1.0, 0.0, 1.0]
        link.restrict(tick, said)
        heard.append(said[0, :, 0].tolist())
    assert [tick for tick in range(7) if heard[tick][0]] == [0, 3, 6]
    assert [tick for tick in range(7) if heard[tick][1]] == [1, 4]
    assert not any(row[2] for row in heard)


def test_only_the_chosen_receivers_lose() -> None:
    """With probability 1 for b alone, b hears nobody and all others everybody."""
    inbox = spoiled(1, Corruption("radio", "loss", {"probability": 1.0}, ("b",)))[0]
    assert inbox.heard[0].tolist() == [3, 0, 3, 3]


def test_corruptions_stack_and_batches_are_heaps_of_runs() -> None:
    """Loss, then delay: run 2 of three is run 2 alone, bit for bit."""
    chain = (Corruption("radio", "loss", {"probability": 0.5}), Corruption("radio", "delay", {"ticks": 1.0}))
    batch, alone = spoiled(20, *chain, runs=range(3)), spoiled(20, *chain, runs=range(2, 3))
    for many, one in zip(batch, alone, strict=True):
        for part, single in zip(many, one, strict=True):
            np.testing.assert_array_equal(part[2], single[0])


@pytest.mark.parametrize("channel", ["blue_light", "compass"])
def test_other_channels_are_not_concerned(channel: str) -> None:
    """What spoils blue light or a sensor leaves the radio alone."""
    kind, numbers = ("loss", {"probability": 1.0}) if channel == "blue_light" else ("bias", {"offset": 1.0})
    assert spoiled(1, Corruption(channel, kind, numbers))[0].heard.tolist() == [[3, 3, 3, 3]]
