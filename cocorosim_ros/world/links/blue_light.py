"""Blue light as a link: a message goes to the nearest robot in each cone.

TO_NEAREST is the paper's: a robot's message reaches, through each of its sensors, the nearest robot in that
sensor's cone. FROM_NEAREST is that of the authors' released model: a robot hears, through each of its sensors,
the nearest robot in that sensor's cone. The two differ where "nearest" is not mutual. As on the radio, what is
said at tick k is heard at tick k + 1.
Assumes: lossless, noiseless; the receiver's own cones do not matter to TO_NEAREST.
Source: Read et al. 2013, sections 2.1 ("direct message passing to the nearest AUV within a sensor's cone") and 5.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, Inbox

TO_NEAREST = 0
FROM_NEAREST = 1
DELIVERY_CODE = {"to_nearest": TO_NEAREST, "from_nearest": FROM_NEAREST}


@kernel
def _hear(said: Floats, run: int, sender: int, receiver: int, inbox: Inbox) -> None:
    """Put what `sender` says at the end of the inbox of `receiver`, unless it is silent, heard already, or no room."""
    count = inbox.heard[run, receiver]
    if said[run, sender, MESSAGE_LENGTH] == 0.0 or count == inbox.sender.shape[2]:
        return
    if count > 0 and inbox.sender[run, receiver, count - 1] == sender:
        return
    inbox.sender[run, receiver, count] = sender
    for column in range(MESSAGE_SIZE):
        inbox.message[run, receiver, count, column] = said[run, sender, column]
    inbox.age[run, receiver, count] = 1
    inbox.heard[run, receiver] = count + 1


@kernel
def _next_above(nearest: Integers, least: int) -> int:
    """The lowest of the robots in the cones of `nearest` (sensors,) that is at least `least`; -1 if there is none."""
    lowest = -1
    for sensor in range(nearest.shape[0]):
        robot = nearest[sensor]
        if robot >= least and (lowest < 0 or robot < lowest):
            lowest = robot
    return lowest


@kernel
def deliver_light(said: Floats, nearest: Integers, delivery: int, inbox: Inbox) -> None:
    """Fill `inbox` with what every robot hears of `said` (runs, robots, MESSAGE_SIZE) over blue light.

    `nearest` (runs, robots, sensors) is who was the nearest in each cone at the moment of sending, -1 for nobody;
    `delivery` one of DELIVERY_CODE. Messages stand in the order of the senders, each once.
    """
    for run in range(said.shape[0]):
        for receiver in range(said.shape[1]):
            inbox.heard[run, receiver] = 0
        # Lookers in ascending order, and who each of them sees: so every inbox is filled in the senders' order.
        for looker in range(said.shape[1]):
            seen = _next_above(nearest[run, looker], 0)
            while seen >= 0:
                sender, receiver = (looker, seen) if delivery == TO_NEAREST else (seen, looker)
                _hear(said, run, sender, receiver, inbox)
                seen = _next_above(nearest[run, looker], seen + 1)
