"""Radio: a message reaches every robot within range at the moment of sending.

What is said at tick k stands in the inbox at tick k + 1: a message takes one tick to be heard, in the node
graph as in the process, so that no robot's answer depends on who answered first.
Assumes: omnidirectional, lossless, noiseless. Source: Read et al. 2013, sections 2.1 and 5.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.stretch import Stretch, ends_of
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, Inbox
from cocorosim_ros.world.state.state import X, Y, Z
from cocorosim_ros.world.surroundings.neighbours import Neighbours


@kernel
def deliver(
    state: Floats, said: Floats, radio_range: Floats, neighbours: Neighbours, inbox: Inbox, receivers: Stretch | None
) -> None:
    """Fill `inbox` with what the receivers hear of `said` (runs, robots, MESSAGE_SIZE).

    `state` (runs, robots, columns) is the state at the moment of sending, `radio_range` (robots,) [m] the
    sender's reach, `neighbours` who may be within it. Messages stand in the order of the senders.
    """
    words = stack_array(MESSAGE_SIZE)
    first, last = ends_of(receivers, said.shape[1])
    for run in range(said.shape[0]):
        for receiver in range(first, last):
            count = 0
            here = state[run, receiver]
            for sender in neighbours.who[run, receiver, : neighbours.near[run, receiver]]:
                if said[run, sender, MESSAGE_LENGTH] == 0.0:
                    continue
                there = state[run, sender]
                squared = (there[X] - here[X]) ** 2 + (there[Y] - here[Y]) ** 2 + (there[Z] - here[Z]) ** 2
                if squared > radio_range[sender] ** 2 or count == inbox.sender.shape[2]:
                    continue
                inbox.sender[run, receiver, count] = sender
                # All are read before one is written: so the compiler may carry several at once.
                for column in range(MESSAGE_SIZE):
                    words[column] = said[run, sender, column]
                for column in range(MESSAGE_SIZE):
                    inbox.message[run, receiver, count, column] = words[column]
                inbox.age[run, receiver, count] = 1
                count += 1
            inbox.heard[run, receiver] = count
