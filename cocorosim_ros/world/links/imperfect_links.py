"""Links that are not perfect: messages get lost, come late, are noisy, or may be sent only so often.

Stacked in the order in which the scenario lists them, on what a perfect link has delivered; only `rate_limit` acts
before, on what is sent. Random numbers belong to the receiver and to the place of a message in its inbox.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.corruption import Corruption
from cocorosim_ros.world.seeding.corruption_at_work import CorruptionAtWork, Swarms, corruptions_at_work
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, PAYLOAD_LIMIT, Inbox

LONG_AGO = -(2**40)  # ticks


@kernel
def keep_messages(inbox: Inbox, chance: Floats, probability: float, robots: Integers) -> None:
    """Drop the messages whose `chance` (runs, len(robots), capacity) is below `probability`; close the gaps."""
    for run in range(inbox.heard.shape[0]):
        for index in range(robots.shape[0]):
            robot, kept = robots[index], 0
            for slot in range(inbox.heard[run, robot]):
                if chance[run, index, slot] < probability:
                    continue
                inbox.sender[run, robot, kept] = inbox.sender[run, robot, slot]
                for column in range(MESSAGE_SIZE):
                    inbox.message[run, robot, kept, column] = inbox.message[run, robot, slot, column]
                inbox.age[run, robot, kept] = inbox.age[run, robot, slot]
                kept += 1
            inbox.heard[run, robot] = kept


class ImperfectLink(CorruptionAtWork):
    """One corruption at work on one link."""

    def __init__(self, corruption: Corruption, purpose: str, swarms: Swarms) -> None:
        super().__init__(corruption, purpose, swarms)
        self._past: list[list[NDArray[Any]] | None] = []
        self._last_sent = np.full((len(swarms.runs), len(swarms.robots)), LONG_AGO)

    def restrict(self, tick: int, said: Floats) -> None:
        """Silence in `said` (runs, robots, MESSAGE_SIZE) who has sent too recently."""
        if self._kind != "rate_limit":
            return
        last = self._last_sent[:, self._chosen]
        speaks = said[:, self._chosen, MESSAGE_LENGTH] > 0.0
        free = (tick - last >= self._numbers["ticks"]) | (last == tick)
        said[:, self._chosen, MESSAGE_LENGTH] *= free
        self._last_sent[:, self._chosen] = np.where(speaks & free, tick, last)

    def spoil(self, tick: int, inbox: Inbox) -> None:
        """Corrupt what was delivered at this tick."""
        if self._kind == "loss":
            chance = self._blocks(inbox.sender.shape[2], normal=False).at(tick)
            keep_messages(inbox, chance, self._numbers["probability"], self._chosen)
        elif self._kind == "noise":
            noise = self._blocks(inbox.sender.shape[2] * PAYLOAD_LIMIT, normal=True).at(tick)
            noise = noise.reshape(*noise.shape[:2], -1, PAYLOAD_LIMIT) * self._numbers["sd"]
            inbox.message[:, self._chosen, :, 1:] += np.where(self._is_payload(inbox), noise, 0.0)
        elif self._kind == "delay":
            self._delay(tick, inbox)

    def _is_payload(self, inbox: Inbox) -> Flags:
        """Which numbers of the rows (runs, chosen, capacity, PAYLOAD_LIMIT) are part of a message."""
        length = inbox.message[:, self._chosen][..., MESSAGE_LENGTH : MESSAGE_LENGTH + 1]
        return np.asarray(np.arange(PAYLOAD_LIMIT) < length)

    def _delay(self, tick: int, inbox: Inbox) -> None:
        ticks = int(self._numbers["ticks"])
        if not self._past:
            self._past = [None] * (ticks + 1)
        self._past[tick % (ticks + 1)] = [part[:, self._chosen].copy() for part in inbox]
        then = self._past[(tick + 1) % (ticks + 1)]
        if then is None:
            inbox.heard[:, self._chosen] = 0
            return
        for part, past in zip(inbox, then, strict=True):
            part[:, self._chosen] = past
        inbox.age[:, self._chosen] += ticks


def imperfect_links(channel: str, corruptions: Sequence[Corruption], swarms: Swarms) -> list[ImperfectLink]:
    """The corruptions of one link at work, in their order."""
    return corruptions_at_work(ImperfectLink, (channel,), corruptions, swarms)
