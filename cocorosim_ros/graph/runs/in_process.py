"""A scenario without ROS: the same ticks, the same bytes, the same bag as the node graph gives."""

from __future__ import annotations

from collections.abc import Callable

from cocorosim_ros.graph.runs.body_side import BodySide
from cocorosim_ros.graph.runs.run_record import STATUS_TOPIC, RunRecord
from cocorosim_ros.graph.runs.under_way import longest_under_way
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage
from cocorosim_ros.wire.cdr.status import end_of_run
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.observations import AnswerEncoder
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.controllers.plain.faults import ControllerError
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.radio import read_payload
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation


def run_in_process(
    scenario: Scenario, record: RunRecord, progress: Callable[[int], bool] = lambda tick: True, run: int = 0
) -> int:
    """Run all ticks of a scenario and record them; return how many were run.

    `run` is the number of the run, which with the scenario's seed decides its random numbers.
    `progress(tick)` is called after every tick and ends the run by returning False. Does not close the
    record, unless a plain Python controller fails, which raises ControllerError.
    """
    bodies = [describe_body(robot) for robot in scenario.robots]
    encoders = [AnswerEncoder(body) for body in bodies]
    side = BodySide(bodies, longest_under_way(scenario))
    simulation = Simulation(build_world(scenario, first_run=run), start_poses(scenario, run)[None])
    going = True
    while going and simulation.tick < scenario.ticks:
        stamp = simulation.time_ns
        messages = dict(side.tick(simulation))
        try:
            simulation.decide()
        except ControllerError:
            _write_end(record, simulation)
            record.close()
            raise
        for robot, (body, encoder) in enumerate(zip(bodies, encoders, strict=True)):
            command, said = simulation.command[0, robot], simulation.said[0, robot]
            messages[robot_topic(body.name, "thruster_command")] = encoder.command(stamp, command)
            if body.speaks:
                messages[robot_topic(body.name, body.talk)] = encoder.said(stamp, said)
                side.say(robot, RadioMessage(stamp, body.frame, body.name, read_payload(said)))
        record.write_tick(stamp, messages)
        simulation.advance()
        going = progress(simulation.tick)
    _write_end(record, simulation)
    return simulation.tick


def _write_end(record: RunRecord, simulation: Simulation) -> None:
    """Record that the run has ended, at the last tick that is done."""
    last = max(0, simulation.time_ns - simulation.world.tick_ns)
    record.write(STATUS_TOPIC, last, end_of_run(last, simulation.tick, 0))
