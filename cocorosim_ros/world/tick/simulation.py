"""The swarm without ROS: sense, decide, advance, tick by tick, for one run or thousands at once."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.stretch import Stretch
from cocorosim_ros.foundation.side_by_side import SideBySide
from cocorosim_ros.world.controllers.conduct import blank_memory
from cocorosim_ros.world.motion.late_commands import LateCommands
from cocorosim_ros.world.motion.motion import apply_commands, move
from cocorosim_ros.world.motion.surroundings import LOOKING
from cocorosim_ros.world.seeding.corruption_at_work import Swarms
from cocorosim_ros.world.sensors.cones import cones_of
from cocorosim_ros.world.sensors.corruption import corrupted_channels
from cocorosim_ros.world.sensors.exact_neighbours import EXACT_RANGE, exact_neighbours
from cocorosim_ros.world.sensors.faults import add_errors
from cocorosim_ros.world.sensors.latency import late_readings
from cocorosim_ros.world.sensors.readings import Readings, blank_readings
from cocorosim_ros.world.state.neighbourhood import Neighbourhood, empty_neighbourhood
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_SIZE, Inbox
from cocorosim_ros.world.state.state import YAW, X, row_size
from cocorosim_ros.world.surroundings.neighbours import Neighbours, NeighbourSearch
from cocorosim_ros.world.terms.motors import Motors
from cocorosim_ros.world.tick.deciding import Answers, decide, speak
from cocorosim_ros.world.tick.divergence import check_motion
from cocorosim_ros.world.tick.exchange import Exchange
from cocorosim_ros.world.tick.perception import Perception
from cocorosim_ros.world.tick.plain_deciding import PlainCrew
from cocorosim_ros.world.tick.rolling import Rolling, level_attitudes, level_velocities
from cocorosim_ros.world.tick.sensing import Afloat, Shown, sense
from cocorosim_ros.world.tick.wants import nothing
from cocorosim_ros.world.tick.water import MovingWater
from cocorosim_ros.world.tick.world import World
from cocorosim_ros.world.vehicle_model.vehicles import Vehicles

ROBOTS_FOR_THREADS = 3000  # of one run; with fewer, to wake a thread costs more than it does
ROBOTS_OF_A_PART = 1200  # a multiple of those that move in one group


class Simulation:
    """The state of `runs` runs of one world and what happens to it in a tick.

    At tick k: `sense()` gives the readings, `inbox` what was heard; controllers answer with commands and
    messages (`decide()` runs them all here; in the node graph they are nodes of their own); `advance()`
    delivers the messages, moves everybody and counts the tick. With instant radio the robots have spoken, and
    heard each other, when `sense()` returns.
    """

    def __init__(self, world: World, start: Floats) -> None:
        """`start` (runs, robots, 4): x, y, z [m; world] and yaw [rad] of every robot, at rest."""
        runs, robots = start.shape[0], world.robots
        numbers = range(world.first_run, world.first_run + runs)
        self.world = world
        self.tick = 0
        self.actuators = world.vehicles.actuator_limit.shape[2]
        self.state: Floats = np.zeros((runs, robots, row_size(self.actuators)))
        self.state[..., X : YAW + 1] = start
        self.readings: Readings = blank_readings(runs, robots, world.instruments.axis.shape[1])
        self.water = MovingWater(world.water, world.vehicles)
        self.water.begin(self.state)
        school = world.school
        self._rolling = None if school is None else Rolling(school, self.state, world.water.flow, world.tank)
        self.nearest = np.full((runs, robots, world.instruments.axis.shape[1]), -1, dtype=np.int64)
        self._wants = world.wants or nothing(robots)
        at_a_time = ROBOTS_OF_A_PART if runs == 1 and robots >= ROBOTS_FOR_THREADS else robots
        self._side_by_side = SideBySide(robots, at_a_time)
        self._exchange = Exchange(world, numbers, self._side_by_side)
        self._knows_exactly = bool(self._wants.neighbours.any())
        capacity = max(1, min(robots - 1, HEARING_LIMIT)) if self._knows_exactly else 1
        self.neighbourhood: Neighbourhood = empty_neighbourhood(runs, robots, capacity)
        self.perception = Perception(self.readings, self.inbox, self.light_inbox, self.sound_inbox, self.neighbourhood)
        self._corruption = corrupted_channels(world.corruption, Swarms(world.seed, world.names, numbers))
        tick = world.tick_ns * 1e-9
        self._late = [] if world.faults is None else late_readings(world.faults.latency, tick)
        self._late_commands = LateCommands(world.command_delay, tick)
        self.memory = blank_memory(runs, robots)
        self._plain = PlainCrew(world.plain, world.seed, numbers) if world.plain else None
        self._search = NeighbourSearch(runs, robots, world.tank, world.reach, self._side_by_side)
        self._cones = cones_of(world.instruments)
        self._neighbours: Neighbours | None = None  # of the present state, once somebody has looked
        self.command: Floats = np.zeros((runs, robots, self.actuators))
        self._acting = self.command
        self.said: Floats = np.zeros((runs, robots, MESSAGE_SIZE))

    @property
    def attitude(self) -> Floats:
        """(runs, robots, 4) unit quaternions x y z w, from the body's axes to the world's; a copy."""
        attitude = level_attitudes(self.state)
        if self._rolling is not None:
            self._rolling.put_attitudes(attitude)
        return attitude

    @property
    def velocity(self) -> Floats:
        """(runs, robots, 3) u, v, w over ground [m/s; body]; a copy."""
        velocity = level_velocities(self.state)
        if self._rolling is not None:
            self._rolling.put_velocities(velocity)
        return velocity

    @property
    def inbox(self) -> Inbox:
        """What was heard on the radio."""
        return self._exchange.radio

    @property
    def light_inbox(self) -> Inbox:
        """What was heard over blue light."""
        return self._exchange.light

    @property
    def sound_inbox(self) -> Inbox:
        """What was heard by sound; its messages have SOUND_SIZE columns (state.sound)."""
        return self._exchange.sound

    @property
    def garbled(self) -> Integers | None:
        """(runs, robots) sounds of the last tick that could not be understood; None where nobody listens."""
        return self._exchange.garbled

    @property
    def time_ns(self) -> int:
        """Simulated time since the start [ns], exact."""
        return self.tick * self.world.tick_ns

    def sense(self) -> Readings:
        """Measure with all instruments; the arrays are those of the next call too."""
        world = self.world
        self._neighbours = self._search.find(self.state)
        flow, lamps, smell = world.water.flow, world.lamps, self.water.concentration
        afloat = Afloat(self.water.vehicles, world.tank, flow, self._neighbours, self._cones, lamps, smell)
        shown, time = Shown(self.readings, self.nearest), self.time_ns * 1e-9
        self._side_by_side.do(lambda robots: sense(self.state, time, afloat, world.instruments, shown, robots))
        if self._rolling is not None:
            self._rolling.feel(time, self.readings)
        if world.water.waves:
            weight = world.instruments.water_density * world.instruments.gravity
            self.water.press(self.state, self.time_ns * 1e-9, weight, self.readings.pressure)
        if self._knows_exactly:
            wanted = self._wants.neighbours
            exact_neighbours(self.state, wanted, EXACT_RANGE, self._neighbours, self.neighbourhood)
        if world.faults is not None:
            vehicles = self.water.vehicles
            motors = Motors(vehicles.is_pump, vehicles.actuator_curve, vehicles.actuator_limit)
            add_errors(time, world.faults.error, self.state, motors, self.readings)
            for late in self._late:
                late.apply(self.readings)
        for channel in self._corruption:
            channel.apply(self.tick, self.readings)
        if world.instant_radio:
            speak(self.time_ns * 1e-9, self.perception, world.crew, self.said)
            self._exchange.carry(self.tick, self.state, self.said, self._neighbours, self.nearest)
            self.inbox.age[...] = 0
            self.light_inbox.age[...] = 0
        return self.readings

    def decide(self) -> None:
        """Run every controller on the present readings: sets `command` and `said`.

        Raises ControllerError if one in plain Python fails.
        """
        if self._plain is not None:
            self._plain.ask(self.time_ns * 1e-9, self.perception, self.memory, self.said)
        time, answers = self.time_ns * 1e-9, Answers(self.memory, self.command, self.said)
        self._side_by_side.do(lambda robots: decide(time, self.perception, self.world.crew, answers, robots))

    def advance(self) -> None:
        """Deliver what was said, move everybody under `command`, then the water, count the tick.

        Raises RanAwayError if the motion of a robot has run away.
        """
        if not self.world.instant_radio:
            neighbours = self._neighbours if self._neighbours is not None else self._search.find(self.state)
            self._exchange.carry(self.tick, self.state, self.said, neighbours, self.nearest)
        self._exchange.carry_sound(self.tick, self.state, self.said)
        self._neighbours = None
        world = self.world
        self._acting = self._late_commands.acting(self.command)
        self._move()
        if self._rolling is not None:
            self._rolling.move(self._acting, self.time_ns * 1e-9, world.stepping, self.state)
        self.water.advance(self.tick, self.state, world.tank, world.tick_ns)
        self.tick += 1
        check_motion(self.state, world, self.tick)

    def _move(self) -> None:
        """Move everybody under `command` by one tick."""
        if self._side_by_side.threaded and not (self.water.vehicles.active & LOOKING).any():
            self._side_by_side.do(self._move_some)
        else:
            self._move_some(None)

    def _move_some(self, robots: Stretch | None) -> None:
        """Move some robots, who do not look at the others; of the only run, whose arrays they then take a part of."""
        world, state, command = self.world, self.state, self._acting
        fixed, present = world.vehicles, self.water.vehicles
        if robots is not None:
            own = np.s_[:, robots.first : robots.last]
            state, command = state[own], command[own]
            fixed, present = (Vehicles._make(array[own] for array in each) for each in (fixed, present))
        apply_commands(state, command, fixed)
        move(state, present, world.tank, world.stepping, world.water.flow, self.time_ns * 1e-9)
