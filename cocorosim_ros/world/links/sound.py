"""Sound as a link: messages take their time, destroy each other where they meet, and tell from how far they came.

A message goes out at the tick at which it is said and lasts `duration_ns`. At a receiver it begins after the distance
at the moment of sending over the speed of sound; it is heard at the first tick that is not before its end, at the
next at the earliest. Times are whole nanoseconds, so which tick that is does not depend on rounding.
Half duplex: what arrives, in any part, while the receiver sends is not heard. Two messages that overlap at a receiver
are both lost (no capture). A robot that is still sending says nothing more. With slots, robots send in turn, each at
the beginning of its slot what it says at that tick. Of what is left, noise takes some, and ranges are off, as
links.acoustic_channel says.
Assumes: clocks of all robots in step; nobody moves while a message is under way; from beyond the range nothing is heard
and nothing disturbs.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.world.links.acoustic_channel import (
    NO_SLOTS,
    Channel,
    loss_probability,
    range_variance,
    signal_to_noise,
    travel_ns,
)
from cocorosim_ros.world.seeding.corruption_at_work import Swarms
from cocorosim_ros.world.seeding.random_blocks import RandomBlocks, standard_normal, uniform
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, Inbox
from cocorosim_ros.world.state.sound import RANGE, VARIANCE
from cocorosim_ros.world.state.state import X, Z

LONG_AGO = -(2**40)  # ticks


class OnAir(NamedTuple):
    """What was sent in the last ticks, tick k in place k modulo the window."""

    tick: Integers  # (window,) that stands in each place; LONG_AGO for none
    said: Floats  # (window, runs, robots, MESSAGE_SIZE)
    place: Floats  # (window, runs, robots, 3) [m; world]


class Ears(NamedTuple):
    """Who listens, with what luck, and what comes of it."""

    listens: Flags  # (robots,)
    chance: Floats  # (runs, robots, capacity) from 0 to 1: below the probability of its loss, a message is lost
    normal: Floats  # (runs, robots, capacity) error of a range in standard deviations
    inbox: Inbox
    garbled: Integers  # (runs, robots) sounds that could not be understood


class Arrivals(NamedTuple):
    """What arrives at one receiver, in the order of the senders, then of time."""

    begin: Integers  # (arrivals,) of its first sound [ns]
    sender: Integers
    place: Integers  # in the ring of OnAir
    distance: Floats  # m
    clear: Flags  # overlaps no other


class Hearing(NamedTuple):
    """The arrivals at one receiver, how many they are, and where they are heard."""

    number: int
    found: Arrivals
    ears: Ears


@kernel
def _find_arrivals(run: int, receiver: int, tick: int, on_air: OnAir, channel: Channel, found: Arrivals) -> int:
    """Fill `found`, but for `clear`, with all that is within range; return how many."""
    count = 0
    for sender in range(on_air.said.shape[2]):
        for back in range(channel.window - 1, -1, -1):
            place = (tick - back) % channel.window
            if on_air.tick[place] != tick - back or on_air.said[place, run, sender, MESSAGE_LENGTH] == 0.0:
                continue
            squared, there = 0.0, on_air.place[place, run]
            for axis in range(3):
                squared += (there[sender, axis] - there[receiver, axis]) ** 2
            distance = math.sqrt(squared)
            if sender == receiver or distance > channel.reach:
                continue
            found.begin[count] = (tick - back) * channel.tick_ns + travel_ns(distance, channel.speed)
            found.sender[count], found.place[count], found.distance[count] = sender, place, distance
            count += 1
    return count


@kernel
def _is_sending(run: int, robot: int, begin: int, on_air: OnAir, channel: Channel) -> bool:
    """Whether a robot sends during any part of a message that begins [ns] at it."""
    for place in range(channel.window):
        if on_air.tick[place] != LONG_AGO and on_air.said[place, run, robot, MESSAGE_LENGTH] > 0.0:
            if abs(on_air.tick[place] * channel.tick_ns - begin) < channel.duration_ns:
                return True
    return False


@kernel
def _mark_clear(found: Arrivals, order: Integers, duration_ns: int) -> None:
    """Write which of the arrivals, of which `order` is the order in time, overlap no other."""
    begin, clear = found.begin, found.clear
    for index in range(order.shape[0]):
        here = order[index]
        clear[here] = index == 0 or begin[here] - begin[order[index - 1]] >= duration_ns
        if index + 1 < order.shape[0] and begin[order[index + 1]] - begin[here] < duration_ns:
            clear[here] = False


@kernel
def _understand(run: int, receiver: int, index: int, found: Arrivals, channel: Channel, ears: Ears) -> bool:
    """Put how far an arrival came into the next free place of the inbox, unless noise takes the message."""
    inbox, count = ears.inbox, ears.inbox.heard[run, receiver]
    ratio = signal_to_noise(channel, found.distance[index])
    if ears.chance[run, receiver, count] < loss_probability(channel, ratio):
        return False
    variance = range_variance(channel, ratio)
    measured = found.distance[index] + math.sqrt(variance) * ears.normal[run, receiver, count]
    inbox.message[run, receiver, count, RANGE] = max(measured, 0.0)
    inbox.message[run, receiver, count, VARIANCE] = variance
    return True


@kernel
def _listen(run: int, receiver: int, tick: int, on_air: OnAir, channel: Channel, hearing: Hearing) -> None:
    """Fill the inbox of one receiver with those of its arrivals that end after `tick` and not after the next."""
    number, found, ears = hearing
    inbox, now = ears.inbox, tick * channel.tick_ns
    for index in range(number):
        end, slot = found.begin[index] + channel.duration_ns, inbox.heard[run, receiver]
        if end <= now or end > now + channel.tick_ns or slot == inbox.sender.shape[2]:
            continue
        if _is_sending(run, receiver, found.begin[index], on_air, channel):
            continue
        if not found.clear[index] or not _understand(run, receiver, index, found, channel, ears):
            ears.garbled[run, receiver] += 1
            continue
        place = found.place[index]
        for column in range(MESSAGE_SIZE):
            inbox.message[run, receiver, slot, column] = on_air.said[place, run, found.sender[index], column]
        inbox.sender[run, receiver, slot] = found.sender[index]
        inbox.age[run, receiver, slot] = tick + 1 - on_air.tick[place]
        inbox.heard[run, receiver] = slot + 1


@allocating_kernel
def receive(tick: int, on_air: OnAir, channel: Channel, ears: Ears) -> None:
    """Fill the inboxes of `ears` with what ends after `tick` and not after the next."""
    most = on_air.said.shape[2] * channel.window
    found = Arrivals(
        np.empty(most, np.int64),
        np.empty(most, np.int64),
        np.empty(most, np.int64),
        np.empty(most, np.float64),
        np.empty(most, np.bool_),
    )
    for run in range(on_air.said.shape[1]):
        for receiver in range(on_air.said.shape[2]):
            ears.inbox.heard[run, receiver], ears.garbled[run, receiver] = 0, 0
            if ears.listens[receiver]:
                count = _find_arrivals(run, receiver, tick, on_air, channel, found)
                _mark_clear(found, np.argsort(found.begin[:count]), channel.duration_ns)
                _listen(run, receiver, tick, on_air, channel, Hearing(count, found, ears))


class SoundLink:
    """The sound in the water of some runs, and what fills an inbox with it."""

    def __init__(self, channel: Channel, listens: Flags, speaks: Flags, swarms: Swarms, inbox: Inbox) -> None:
        """`listens`, `speaks` (robots,): who hears and speaks by sound."""
        runs, robots, capacity = inbox.sender.shape
        window = channel.window
        self._channel, self._listens, self._inbox = channel, listens, inbox
        self._turn = np.where(speaks, np.cumsum(speaks) - 1, -1)  # (robots,) whose slot is the first, second, ...
        self._speakers = max(1, int(speaks.sum()))
        self._on_air = OnAir(
            np.full(window, LONG_AGO),
            np.zeros((window, runs, robots, MESSAGE_SIZE)),
            np.zeros((window, runs, robots, 3)),
        )
        self._last_sent = np.full((runs, robots), LONG_AGO)
        self._busy = -(-channel.duration_ns // channel.tick_ns)  # ticks that a message takes
        self._latest = LONG_AGO  # tick at which anybody sent
        self._chance = RandomBlocks(swarms.seed, "sound loss", swarms.robots, swarms.runs, capacity, uniform)
        self._normal = RandomBlocks(swarms.seed, "sound range", swarms.robots, swarms.runs, capacity, standard_normal)
        self.garbled: Integers = np.zeros((runs, robots), dtype=np.int64)

    def carry(self, tick: int, state: Floats, said: Floats) -> None:
        """Send what is `said` (runs, robots, MESSAGE_SIZE) at this tick; hear what arrives until the next."""
        sends = self._who_sends(tick, said[..., MESSAGE_LENGTH] > 0.0)
        if sends.any():
            place = tick % self._channel.window
            self._on_air.tick[place] = tick
            self._on_air.said[place] = said
            self._on_air.said[place, ..., MESSAGE_LENGTH] *= sends
            self._on_air.place[place] = state[..., X : Z + 1]
            self._latest = tick
        if tick - self._latest >= self._channel.window:
            self._inbox.heard[...], self.garbled[...] = 0, 0
            return
        ears = Ears(self._listens, self._chance.at(tick), self._normal.at(tick), self._inbox, self.garbled)
        receive(tick, self._on_air, self._channel, ears)

    def _who_sends(self, tick: int, wishes: Flags) -> Flags:
        """(runs, robots) who of those with `wishes` may send now, and is not busy with the last message."""
        slot = self._channel.slot_ticks
        may = self._turn >= 0
        if slot != NO_SLOTS:
            may &= (tick % slot == 0) & (self._turn == tick // slot % self._speakers)
        idle = tick - self._last_sent >= self._busy
        sends: Flags = wishes & may & idle
        self._last_sent[sends] = tick
        return sends
