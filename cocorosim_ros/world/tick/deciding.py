"""One control cycle of all robots of all runs."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel, stack_array
from cocorosim_ros.world.controllers.conduct import conduct_one, speak_by_code
from cocorosim_ros.world.controllers.crew import Crew
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.perception import Perception


def observe_plainly(time: float, perception: Perception, run: int, robot: int, angular_rate: Floats) -> Observation:
    """What one robot of one run knows at `time` [s]; its arrays are not to be changed, but for the angular rate.

    That is a copy in `angular_rate` (3,), because a robot without a gyro puts its own estimate there.
    """
    readings, neighbourhood = perception.readings, perception.neighbourhood
    for axis in range(3):
        angular_rate[axis] = readings.angular_rate[run, robot, axis]
    return Observation(
        time,
        readings.compass[run, robot],
        readings.pressure[run, robot],
        angular_rate,
        readings.specific_force[run, robot],
        readings.velocity[run, robot],
        readings.neighbour_range[run, robot],
        readings.obstacle_range[run, robot],
        perception.radio.heard[run, robot],
        perception.radio.message[run, robot],
        perception.light.heard[run, robot],
        perception.light.message[run, robot],
        neighbourhood.found[run, robot],
        neighbourhood.offset[run, robot],
        neighbourhood.velocity[run, robot],
        readings.illuminance[run, robot],
        readings.concentration[run, robot],
    )


observe = kernel(observe_plainly)


@kernel
def decide(time: float, perception: Perception, crew: Crew, memory: Floats, answer: tuple[Floats, Floats]) -> None:
    """Let every controller run once at `time` [s].

    `answer` receives the commands (runs, robots, actuators) and the messages (runs, robots, MESSAGE_SIZE);
    `memory` (runs, robots, MEMORY_SIZE) persists between ticks.
    """
    command, said = answer
    angular_rate = stack_array(3)
    for run in range(command.shape[0]):
        for robot in range(command.shape[1]):
            observation = observe(time, perception, run, robot, angular_rate)
            conduct_one(crew, robot, observation, memory[run, robot], command[run, robot], said[run, robot])


@kernel
def speak(time: float, perception: Perception, crew: Crew, said: Floats) -> None:
    """Let every controller say at `time` [s] what it has to say, into `said` (runs, robots, MESSAGE_SIZE)."""
    angular_rate = stack_array(3)
    for run in range(said.shape[0]):
        for robot in range(said.shape[1]):
            settings = crew.settings[robot, : crew.settings_count[robot]]
            observation = observe(time, perception, run, robot, angular_rate)
            speak_by_code(crew.code[robot], observation, settings, said[run, robot])
