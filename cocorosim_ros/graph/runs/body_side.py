"""Everything that the simulated bodies publish at one tick, as bytes, in the order of the topics."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import replace

from cocorosim_ros.wire.cdr.acoustic_messages import AcousticMessage, encode_sounds
from cocorosim_ros.wire.cdr.neighbours import encode_neighbours
from cocorosim_ros.wire.cdr.radio_messages import RadioEncoder, RadioMessage
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.swarm_messages import SwarmMessages
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.state.radio import PAYLOAD_LIMIT, Inbox, read_payload
from cocorosim_ros.world.state.sound import RANGE, VARIANCE
from cocorosim_ros.world.tick.simulation import Simulation


class BodySide:
    """Encodes one run of a simulation, tick by tick."""

    def __init__(self, bodies: Sequence[BodyDescription], longest_delay: int = 0) -> None:
        """`longest_delay`: ticks that a message can be under way beyond the one that it always takes."""
        self._bodies = tuple(bodies)
        self._messages = SwarmMessages(bodies)
        self._radio = RadioEncoder()
        self._said: list[RadioMessage | None] = [None] * len(bodies)
        self._history: deque[list[RadioMessage | None]] = deque(maxlen=1 + longest_delay)

    def say(self, robot: int, message: RadioMessage) -> None:
        """Note what a robot said at this tick. The sender is who it is."""
        body = self._bodies[robot]
        self._said[robot] = replace(message, sender=body.name, frame=body.frame)

    def tick(self, simulation: Simulation) -> Iterator[tuple[str, bytes]]:
        """Topic and bytes of everything at the present tick: poses and instruments first, `/clock` last.

        `/clock` last, because a controller that sees the new time can take the rest without waiting.
        """
        stamp = simulation.time_ns
        poses, transforms = self._messages.poses(stamp, simulation.state[0], simulation.attitude[0])
        columns = {"pose": poses, **self._messages.readings(stamp, simulation.sense())}
        self._history.appendleft(list(self._said))
        columns["radio_rx"] = self._inboxes(stamp, simulation, simulation.inbox)
        if any("blue_light_rx" in body.topics for body in self._bodies):
            columns["blue_light_rx"] = self._inboxes(stamp, simulation, simulation.light_inbox)
        if any("acoustic_rx" in body.topics for body in self._bodies):
            columns["acoustic_rx"] = self._sound_inboxes(stamp, simulation)
        if any("neighbours" in body.topics for body in self._bodies):
            columns["neighbours"] = self._surroundings(stamp, simulation)
        for robot, body in enumerate(self._bodies):
            for name in ("pose", *body.topics):
                yield robot_topic(body.name, name), columns[name][robot]
        yield "/tf", transforms
        yield "/clock", self._messages.clock(stamp)

    def _inboxes(self, stamp_ns: int, simulation: Simulation, inbox: Inbox) -> list[bytes]:
        encoded = []
        for robot, body in enumerate(self._bodies):
            count = int(inbox.heard[0, robot])
            if simulation.world.corruption or simulation.world.instant_radio:
                heard = [self._heard(simulation, inbox, robot, slot) for slot in range(count)]
            else:
                heard = [self._history[0][sender] for sender in inbox.sender[0, robot, :count].tolist()]
            encoded.append(self._radio.inbox(stamp_ns, body.frame, [part for part in heard if part is not None]))
        return encoded

    def _sound_inboxes(self, stamp_ns: int, simulation: Simulation) -> list[bytes]:
        inbox, garbled, encoded = simulation.sound_inbox, simulation.garbled, []
        for robot, body in enumerate(self._bodies):
            sounds = []
            for slot in range(int(inbox.heard[0, robot])):
                message, row = self._heard(simulation, inbox, robot, slot), inbox.message[0, robot, slot]
                if message is not None:
                    sounds.append(AcousticMessage(message, float(row[RANGE]), float(row[VARIANCE])))
            lost = 0 if garbled is None else int(garbled[0, robot])
            encoded.append(encode_sounds(stamp_ns, body.frame, lost, sounds))
        return encoded

    def _heard(self, simulation: Simulation, inbox: Inbox, robot: int, slot: int) -> RadioMessage | None:
        """What stands in one place of an inbox; as it was sent, unless the link has changed it."""
        sender, age = int(inbox.sender[0, robot, slot]), int(inbox.age[0, robot, slot])
        payload = read_payload(inbox.message[0, robot, slot])
        if age == 0:
            body = self._bodies[sender]
            return RadioMessage(simulation.time_ns, body.frame, body.name, payload)
        message = self._history[age - 1][sender]
        if message is not None and message.payload[:PAYLOAD_LIMIT] != payload:
            message = replace(message, payload=payload)
        return message

    def _surroundings(self, stamp_ns: int, simulation: Simulation) -> list[bytes]:
        around = simulation.neighbourhood
        encoded = []
        for robot, body in enumerate(self._bodies):
            count = int(around.found[0, robot])
            names = [self._bodies[who].name for who in around.who[0, robot, :count]]
            vectors = (around.offset[0, robot, :count], around.velocity[0, robot, :count])
            encoded.append(encode_neighbours(stamp_ns, body.frame, names, *vectors))
        return encoded
