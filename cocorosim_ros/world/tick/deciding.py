"""One control cycle of all robots of all runs."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.stretch import Stretch, ends_of
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.controllers.conduct import ask, carry_out, speak_by_code
from cocorosim_ros.world.controllers.crew import Crew
from cocorosim_ros.world.sensors.readings import FIELDS
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.tick.perception import Perception


def _observing_lines() -> list[str]:
    """The body of `observe`: what sensors show by the fields of Readings, and all else."""
    shown = {name: f"perception.readings.{name}[run, robot]" for name in FIELDS} | {
        "time": "time",
        "angular_rate": "angular_rate",
        "heard_count": "perception.radio.heard[run, robot]",
        "heard": "perception.radio.message[run, robot]",
        "light_count": "perception.light.heard[run, robot]",
        "light": "perception.light.message[run, robot]",
        "sound_count": "perception.sound.heard[run, robot]",
        "sound": "perception.sound.message[run, robot]",
        "neighbour_count": "perception.neighbourhood.found[run, robot]",
        "neighbour_offset": "perception.neighbourhood.offset[run, robot]",
        "neighbour_velocity": "perception.neighbourhood.velocity[run, robot]",
    }
    return [
        "for axis in range(3):",
        "    angular_rate[axis] = perception.readings.angular_rate[run, robot, axis]",
        f"return Observation({', '.join(shown[name] for name in Observation._fields)})",
    ]


observe = compile_lines(
    "observe", "time, perception, run, robot, angular_rate", _observing_lines(), {"Observation": Observation}
)
"""What one robot of one run knows at `time` [s]: an Observation; its arrays are not to be changed, but for the angular
rate. That is a copy in `angular_rate` (3,), because a robot without a gyro puts its own estimate there."""


observe_plainly = observe.py_func  # type: ignore[attr-defined]
"""The same outside of compiled functions."""


class Answers(NamedTuple):
    """What comes of controllers."""

    memory: Floats  # (runs, robots, MEMORY_SIZE), persists between ticks
    command: Floats  # (runs, robots, actuators)
    said: Floats  # (runs, robots, MESSAGE_SIZE) the messages


@kernel
def decide(time: float, perception: Perception, crew: Crew, answers: Answers, robots: Stretch | None) -> None:
    """Let the controllers of some robots run once at `time` [s]."""
    memory, command, said = answers
    angular_rate = stack_array(3)
    first, last = ends_of(robots, command.shape[1])
    for run in range(command.shape[0]):
        for robot in range(first, last):
            observation = observe(time, perception, run, robot, angular_rate)
            ask(crew, robot, observation, memory[run, robot], said[run, robot])
        for robot in range(first, last):
            observation = observe(time, perception, run, robot, angular_rate)
            carry_out(crew, robot, observation, memory[run, robot], command[run, robot])


@kernel
def speak(time: float, perception: Perception, crew: Crew, said: Floats) -> None:
    """Let every controller say at `time` [s] what it has to say, into `said` (runs, robots, MESSAGE_SIZE)."""
    angular_rate = stack_array(3)
    for run in range(said.shape[0]):
        for robot in range(said.shape[1]):
            settings = crew.settings[robot, : crew.settings_count[robot]]
            observation = observe(time, perception, run, robot, angular_rate)
            speak_by_code(crew.code[robot], observation, settings, said[run, robot])
