"""`warmed_up.py SCENARIO`: prints which functions the nodes of a scenario still load or compile after their warm-up."""

import gc
import sys

import numpy as np
from numba.core.dispatcher import Dispatcher

from cocorosim_ros.graph.runs.body_side import BodySide
from cocorosim_ros.graph.runs.warm_up import compile_everything
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor
from cocorosim_ros.wire.bags.tracks import decode_poses
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.observations import AnswerEncoder, ObservationDecoder, read_payload
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.controllers.conduct import blank_memory, conduct_one
from cocorosim_ros.world.controllers.crew_assembly import build_crew
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_SIZE
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

TICKS = 6


def loaded() -> set[tuple[str, str]]:
    """Every function that is machine code in this process, with the types that it takes."""
    dispatchers = [each for each in gc.get_objects() if isinstance(each, Dispatcher)]
    return {(each.py_func.__qualname__, str(types)) for each in dispatchers for types in each.signatures}


class Controller:
    """What a controller node calls at every tick."""

    def __init__(self, robot: RobotDescription) -> None:
        self.body = describe_body(robot)
        self.crew, self.memory = build_crew([robot]), blank_memory(1, 1)[0, 0]
        self.command, self.said = np.zeros(len(self.body.actuators)), np.zeros(MESSAGE_SIZE)
        self.decoder, self.encoder = ObservationDecoder(self.body, HEARING_LIMIT), AnswerEncoder(self.body)

    def answer(self, stamp: int, messages: dict[str, bytes]) -> None:
        """One answer to the messages of a tick."""
        latest = {name: messages[robot_topic(self.body.name, name)] for name in self.body.topics}
        observation = self.decoder.observation(stamp * 1e-9, latest)
        conduct_one(self.crew, 0, observation, self.memory, self.command, self.said)
        self.encoder.command(stamp, self.command)
        self.encoder.said(stamp, self.said)


def main() -> None:
    """Warm up, then do what the nodes do."""
    scenario = load_scenario(sys.argv[1])
    compile_everything(scenario)
    before = loaded()
    bodies = [describe_body(robot) for robot in scenario.robots]
    simulation, side = Simulation(build_world(scenario), start_poses(scenario)[None]), BodySide(bodies)
    controllers, monitor = [Controller(robot) for robot in scenario.robots], ShoalMonitor(len(bodies))
    for _ in range(TICKS):
        stamp = simulation.time_ns
        messages = dict(side.tick(simulation))
        monitor.update(stamp, *decode_poses([messages[robot_topic(body.name, "pose")] for body in bodies]))
        for number, controller in enumerate(controllers):
            controller.answer(stamp, messages)
            simulation.command[0, number, : len(controller.command)] = controller.command
            simulation.said[0, number] = controller.said
            frame, name = controller.body.frame, controller.body.name
            side.say(number, RadioMessage(stamp, frame, name, read_payload(controller.said)))
        simulation.advance()
    for name, types in sorted(loaded() - before):
        print(name, types)


if __name__ == "__main__":
    main()
