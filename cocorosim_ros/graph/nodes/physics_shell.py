"""The physics node's doings: publish a tick, gather the answers, advance the world."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence

from rclpy.node import Node

from cocorosim_ros.foundation.compiling.once import somebody_compiles
from cocorosim_ros.graph.nodes.answers import Answers
from cocorosim_ros.graph.nodes.between_ticks import BetweenTicks
from cocorosim_ros.graph.nodes.complaints import Complaints
from cocorosim_ros.graph.nodes.recorder_link import RECORDED_AHEAD, RecorderEar
from cocorosim_ros.graph.nodes.start_line import StartLine
from cocorosim_ros.graph.nodes.terms import Terms
from cocorosim_ros.graph.nodes.wiring import Listener, Speaker
from cocorosim_ros.graph.runs.body_side import BodySide
from cocorosim_ros.graph.runs.latency import check_latency
from cocorosim_ros.graph.runs.run_error import RunError
from cocorosim_ros.graph.runs.run_record import ANSWERS, STATISTICS_TOPIC, STATUS_TOPIC, run_topics
from cocorosim_ros.graph.runs.scenery import scenery_topics, standing_messages
from cocorosim_ros.graph.runs.under_way import longest_under_way
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.cdr.status import ANSWERS_MISSING, WARN, end_of_run, status_bytes
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.swarm_messages import SwarmMessages
from cocorosim_ros.wire.topics.topics import TOPICS
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.radio import write_payload
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.dead_mans_switch import DeadMansSwitch
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.tick.step_barrier import COMMAND, RADIO_MESSAGE, StepBarrier

LAST_ANSWERS = 1.0  # s, wall clock, that a tick gets to be completed when the run is to stop
LAST_WORDS = 5.0  # s, wall clock
RECORDER_PATIENCE = 20.0  # s, wall clock
LOOK_AT_COMPILERS = 0.5  # s, wall clock
Idle = Callable[[Sequence[Listener], float], None]


class PhysicsShell:
    """One run of a scenario on topics.

    `idle(listeners, seconds)` is called when there is nothing to do until one of the listeners has a message.
    """

    def __init__(self, node: Node, scenario: Scenario, idle: Idle, terms: Terms) -> None:
        """Raises CocorosimError for a scenario that nodes cannot keep."""
        check_latency(scenario)
        self.scenario = scenario
        self.bodies = [describe_body(robot) for robot in scenario.robots]
        self.stop = False
        self._idle = idle
        self._terms = terms
        self._recorder = RecorderEar(node) if terms.recorded else None
        self._speakers = {
            topic: Speaker(node, TOPICS[row].type_name, topic, TOPICS[row].quality)
            for topic, row in run_topics(self.bodies).items()
            if row not in ANSWERS and topic != STATISTICS_TOPIC
        }
        self._scenery = self._set_scenery(node)
        self._complaints = Complaints(self._speakers[STATUS_TOPIC], terms.tell)
        self._answers = [Answers(node, body, self.complain) for body in self.bodies]
        self._start_line = StartLine(node, scenario, self.bodies, self._speakers, self._answers, self._recorder)
        clock, transforms = self._speakers["/clock"], self._speakers["/tf"]
        messages = SwarmMessages(self.bodies)
        self._between = BetweenTicks(messages, clock, transforms, scenario.tick_ns, terms.steps)
        self._mourned: set[int] = set()
        self.begin_anew()

    @property
    def missing_answers(self) -> int:
        """How many answers of controllers were late or missing so far."""
        return sum(self._missing)

    @property
    def patience(self) -> float:
        """How long a missing answer is waited for [s, wall clock]."""
        return self.scenario.lockstep.patience

    def begin_anew(self) -> None:
        """Put everything where it is before the first tick."""
        scenario, count = self.scenario, len(self.bodies)
        self.simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
        self.barrier = StepBarrier(count, [i for i, body in enumerate(self.bodies) if body.speaks])
        self._side = BodySide(self.bodies, longest_under_way(scenario))
        self._missing = [0] * count
        self._switch = DeadMansSwitch(count, self.patience)

    def request_stop(self) -> None:
        """Let the run end after the present tick."""
        self.stop = True

    def complain(self, robot: str, words: str) -> None:
        """Say on `/diagnostics` and on the terminal what is wrong with a robot, each sentence once."""
        self._complaints.about(robot, words, self.simulation.time_ns)

    def wait_until_connected(self) -> None:
        """Return when everybody who belongs to the run is there; robots that are missing are dealt with.

        The time in which a node on this machine still compiles does not count.

        Raises RunError if the recorder is missing, a robot has two controllers, or a controller is missing and the
        scenario says to stop then.
        """
        now = looked = time.monotonic()
        deadline = now + self._terms.wait
        while not self.stop and not self._start_line.everybody_is_there(self._terms.dead()):
            now = time.monotonic()
            if now - looked > LOOK_AT_COMPILERS or now > deadline:
                looked = now
                deadline = now + self._terms.wait if somebody_compiles() else deadline
            if now > deadline:
                self._give_up_waiting()
                return
            self._idle([], 0.01)

    def publish_tick(self) -> None:
        """Publish everything of the present tick."""
        for topic, data in self._side.tick(self.simulation):
            self._speakers[topic].publish(data)
        self.simulation.said[0, :, 0] = 0.0
        self.barrier.begin_tick()

    def gather(self) -> None:
        """Wait for the answers to the present tick; raises RunError if one is missing and that means stop."""
        start = time.monotonic()
        deadline = start + self.patience
        while not (self.stop and time.monotonic() > start + LAST_ANSWERS):
            self.take_answers(held=False)
            waiting = self.barrier.waiting_for()
            if not waiting:
                break
            died = [robot for robot in self._terms.dead() if robot in waiting and robot not in self._mourned]
            if died:
                self._mourned.update(died)
                self._no_answer(died, "its controller has died")
            elif time.monotonic() > deadline:
                self._no_answer(waiting, f"nothing was heard for {self.patience:g} s")
            else:
                self._idle(self._answers[waiting[0]].listeners(), deadline - time.monotonic())
        self._note_missing()

    def gather_until(self, moment: float, held: float = 0.0) -> None:
        """Take answers until `moment` [s, monotonic clock]; the last command of each robot holds for the patience.

        Until all have answered is enough where the way to the next tick is shown, which has to be known for that.
        `held` [s]: how long the tick was held up, which is no silence of a controller.

        Raises RunError if a controller has died or is silent for longer, and that means stop.
        """
        self._switch.excuse(held)
        self._switch.begin_tick(time.monotonic())
        self._between.begin_tick(self.simulation.time_ns, moment)
        everybody = [listener for answers in self._answers for listener in answers.listeners()]
        while not self.stop and (now := time.monotonic()) < moment:
            self.take_answers(held=True)
            if self._between.wanted and not self.barrier.waiting_for():
                break
            self._idle(everybody, max(0.0, self._between.tell(now) - now))
        self.take_answers(held=True)
        self._switch_off()
        for robot in () if self.stop else self.barrier.unanswered():
            self._missing[robot] += 1
        for body, answers in zip(self.bodies, self._answers, strict=True):
            if answers.commands.publishers > 1:
                self.complain(body.name, "it has more than one controller and obeys whichever spoke last")

    def take_answers(self, *, held: bool) -> None:
        """Take what has come in. In lock-step only answers to the present tick count; `held`: late ones too."""
        for robot, answers in enumerate(self._answers):
            while (command := answers.take_command()) is not None:
                stamp, fractions = command
                if self._is_answer(robot, stamp, COMMAND, held=held):
                    self.simulation.command[0, robot, : len(fractions)] = fractions
                    if self._switch.heard(robot) and held:
                        self.complain(self.bodies[robot].name, "it is heard again: its commands count again")
            while (said := answers.take_radio()) is not None:
                owed = self.barrier.owes(robot, RADIO_MESSAGE)
                if not owed or self._is_answer(robot, said.stamp_ns, RADIO_MESSAGE, held=held):
                    write_payload(self.simulation.said[0, robot], said.payload)
                    self._side.say(robot, said)

    def advance(self) -> None:
        """Move the world on by one tick; wait first if the recorder is too far behind."""
        self.simulation.advance()
        deadline = time.monotonic() + RECORDER_PATIENCE
        while self._recorder is not None and not self.stop:
            if self.simulation.tick - self._recorder.recorded() < RECORDED_AHEAD:
                return
            if time.monotonic() > deadline:
                raise RunError(
                    f"The recorder has written nothing for {RECORDER_PATIENCE:g} s, so the run ends at tick "
                    f"{self.simulation.tick}; look at the metrics node."
                )
            self._idle([self._recorder.listener], 0.05)

    def advance_until_due(self) -> None:
        """Move the world on by one tick of the wall clock, and show the way there until the next is due."""
        before = self.simulation.state[0].copy()
        self.simulation.advance()
        self._between.follow(before, self.simulation.state[0], lambda: self.stop)

    def end(self) -> None:
        """Say that the run has ended, and whose answers were missing."""
        for body, missing in zip(self.bodies, self._missing, strict=True):
            if missing:
                self.complain(body.name, f"{missing} of {self.simulation.tick} answers came late or not at all")
        last = max(0, self.simulation.time_ns - self.scenario.tick_ns)
        self._speakers[STATUS_TOPIC].publish(end_of_run(last, self.simulation.tick, self.missing_answers))

    def linger(self) -> None:
        """Stay until the recorder has everything (without one: until everybody has), but not for long."""
        deadline = time.monotonic() + LAST_WORDS
        while time.monotonic() < deadline:
            recorded = self._recorder is not None and self._recorder.recorded() >= self.simulation.tick
            speakers = [self._speakers[STATUS_TOPIC]] if recorded else self._speakers.values()
            if all(speaker.all_received() for speaker in speakers):
                return

    def _set_scenery(self, node: Node) -> list[Speaker]:
        """Say once, for all who come later, what robots and tank look like; what said it must stay."""
        rows, speakers = scenery_topics([body.name for body in self.bodies]), []
        for topic, data in standing_messages(self.scenario.robots, self.scenario.tank, self.scenario.light).items():
            speakers.append(Speaker(node, TOPICS[rows[topic]].type_name, topic, TOPICS[rows[topic]].quality))
            speakers[-1].publish(data)
        return speakers

    def _switch_off(self) -> None:
        """Take the actuators from controllers of a free run that have died or are silent for too long."""
        if self.stop:
            return
        if died := self._switch.newly_dead(self._terms.dead()):
            self._no_answer(died, "its controller has died")
        if silent := self._switch.newly_silent(time.monotonic()):
            self._no_answer(silent, f"nothing was heard for {self.patience:g} s")

    def _is_answer(self, robot: int, stamp: int, part: str, *, held: bool) -> bool:
        """Whether what came is to be used; raises RunError if a robot turns out to have two controllers."""
        now = self.simulation.time_ns
        if stamp == 0 and self.scenario.robots[robot].external:  # without a stamp, as `ros2 topic pub` sends it
            return self.barrier.answered(robot, part) or held
        if stamp == now or (held and now < stamp <= self._between.newest_ns):
            if self.barrier.answered(robot, part) or held:
                return True
            raise RunError(
                f"{self.bodies[robot].name} has given two answers to the tick at {now / 1e9:g} s, so the run ends: two "
                "controllers command it, or one answers twice; see to it that there is one answer, and run again."
            )
        if held and stamp < now:
            return True
        if not held:
            self._start_line.refuse_second_controllers()
        when = "the past" if stamp < now else "the future"
        self.complain(
            self.bodies[robot].name,
            f"a {part} from {when} is not used; stamp it with the time of the readings it answers",
        )
        self.barrier.heard(robot, in_time=now - self.scenario.tick_ns <= stamp < now)
        return False

    def _no_answer(self, waiting: Sequence[int], reason: str) -> None:
        """Do as the scenario says with robots that give no answer."""
        names = ", ".join(self.bodies[robot].name for robot in waiting)
        late = f"no answer at tick {self.simulation.tick}, {reason}"
        if self.scenario.lockstep.silent_controller == "stop":
            raise RunError(f"The run ends: {names}: {late} (the scenario's 'lockstep.silent_controller' is 'stop').")
        for robot in waiting:
            self.simulation.command[0, robot] = 0.0
            self.barrier.declare_silent(robot)
            self._switch.off(robot)
            self.complain(self.bodies[robot].name, f"{late}: its thrusters are off until it is heard again")

    def _note_missing(self) -> None:
        """Tell the recorder whose answers it need not wait for at this tick, and leave their actuators off."""
        missing = self.barrier.unanswered()
        for robot in missing:
            self._missing[robot] += not self.stop
            self.simulation.command[0, robot] = 0.0
        if missing:
            names = " ".join(self.bodies[robot].name for robot in missing)
            words = "answers are missing at this tick"
            self._speakers[STATUS_TOPIC].publish(
                status_bytes(self.simulation.time_ns, WARN, ANSWERS_MISSING, words, {"missing": names})
            )

    def _give_up_waiting(self) -> None:
        if self._recorder is not None and not self._recorder.is_ready():
            raise RunError(
                f"The recorder was not there within {self._terms.wait:g} s, so the run does not start; look at the "
                "metrics node."
            )
        if absent := self._start_line.absent():
            self.barrier.begin_tick()
            self._no_answer(absent, f"it was not there within {self._terms.wait:g} s")
