"""What robots hear of each other in one run or many: all media, perfect or not."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.side_by_side import SideBySide
from cocorosim_ros.world.links.blue_light import deliver_light
from cocorosim_ros.world.links.imperfect_links import ImperfectLink, imperfect_links
from cocorosim_ros.world.links.radio import deliver
from cocorosim_ros.world.links.sound import SoundLink
from cocorosim_ros.world.seeding.corruption_at_work import Swarms
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_LENGTH, Inbox, empty_inbox
from cocorosim_ros.world.state.sound import SOUND_SIZE
from cocorosim_ros.world.surroundings.neighbours import Neighbours
from cocorosim_ros.world.tick.wants import nothing
from cocorosim_ros.world.tick.world import World


class Exchange:
    """The inboxes of all robots of `runs` runs, and what fills them."""

    def __init__(self, world: World, runs: range, side_by_side: SideBySide) -> None:
        """`runs` are the numbers of the runs, by which their random numbers differ."""
        self._world = world
        self._side_by_side = side_by_side
        self._wants = world.wants or nothing(world.robots)
        self.uses_light: bool = bool(self._wants.blue_light.any())
        """Whether anybody hears over blue light."""
        self.uses_sound: bool = bool(self._wants.sound.any())
        """Whether anybody hears by sound."""
        capacity = max(1, min(world.robots - 1, HEARING_LIMIT))
        self.radio: Inbox = empty_inbox(len(runs), world.robots, capacity)
        self.light: Inbox = empty_inbox(len(runs), world.robots, capacity if self.uses_light else 1)
        self.sound: Inbox = empty_inbox(len(runs), world.robots, capacity if self.uses_sound else 1, SOUND_SIZE)
        swarms = Swarms(world.seed, world.names, runs)
        self._sound_link = None
        if world.channel is not None and self.uses_sound:
            self._sound_link = SoundLink(world.channel, self._wants.sound, self._wants.speaks_sound, swarms, self.sound)
        speaks_radio = ~(self._wants.speaks_light | self._wants.speaks_sound)
        self._radio_medium = _Medium(speaks_radio, imperfect_links("radio", world.corruption, swarms))
        self._light_medium = _Medium(self._wants.speaks_light, imperfect_links("blue_light", world.corruption, swarms))

    @property
    def garbled(self) -> Integers | None:
        """(runs, robots) sounds of the last tick that could not be understood; None where nobody listens."""
        return None if self._sound_link is None else self._sound_link.garbled

    def carry_sound(self, tick: int, state: Floats, said: Floats) -> None:
        """Send by sound what was `said` (runs, robots, MESSAGE_SIZE) now; deliver what comes until the next tick."""
        if self._sound_link is not None:
            self._sound_link.carry(tick, state, said)

    def carry(self, tick: int, state: Floats, said: Floats, neighbours: Neighbours, nearest: Integers) -> None:
        """Deliver what was `said` (runs, robots, MESSAGE_SIZE) at this tick, with the state of this moment.

        `neighbours` are those in this state, `nearest` (runs, robots, sensors) who was seen in each cone.
        """
        by_radio = self._radio_medium.sent(tick, said)
        reach = self._world.radio_range
        self._side_by_side.do(lambda robots: deliver(state, by_radio, reach, neighbours, self.radio, robots))
        for link in self._radio_medium.links:
            link.spoil(tick, self.radio)
        if self.uses_light:
            by_light = self._light_medium.sent(tick, said)
            deliver_light(by_light, nearest, self._world.light_delivery, self.light)
            for link in self._light_medium.links:
                link.spoil(tick, self.light)


class _Medium:
    """The words of its speakers (robots,) that go out over one medium, as often as its links allow."""

    def __init__(self, speakers: Flags, links: list[ImperfectLink]) -> None:
        self.links = links
        self._silent = ~speakers
        self._as_said = bool(speakers.all()) and not links  # asked once, not at every tick

    def sent(self, tick: int, said: Floats) -> Floats:
        """What goes out of what was `said` (runs, robots, MESSAGE_SIZE): that itself where all of it does."""
        if self._as_said:
            return said
        sent = said.copy()
        sent[:, self._silent, MESSAGE_LENGTH] = 0.0
        for link in self.links:
            link.restrict(tick, sent)
        return sent
