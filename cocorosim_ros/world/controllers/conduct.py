"""One control cycle of one robot: speak, avoid or decide, then steer and dive.

While an avoidance function of the operating system is active the behaviour is not run (subsumption); the
robot keeps talking all the same.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.controllers import CONTROLLER_CODE, CONTROLLERS
from cocorosim_ros.world.controllers.crew import Crew
from cocorosim_ros.world.controllers.operating_system import (
    GRAVITY,
    WALLS_SIZE,
    WATER_DENSITY,
    avoid_floor_and_surface,
    avoid_walls,
    dive,
    steer,
)
from cocorosim_ros.world.controllers.request import DIRECT, DIRECT_LIMIT, FRACTIONS, HEADING, REQUEST_SIZE
from cocorosim_ros.world.state.observation import Observation

LAST_TIME = REQUEST_SIZE  # s, NaN before the first cycle
LAST_PRESSURE = REQUEST_SIZE + 1  # Pa
LAST_COMPASS = REQUEST_SIZE + 2  # rad
LAST_WALLS = REQUEST_SIZE + 3  # WALLS_SIZE columns, for robots that avoid walls a cycle late
MEMORY_SIZE = LAST_WALLS + WALLS_SIZE

_DECIDE = "observation, sensor_axis, settings, request"
_SPEAK = "observation, settings, message"


def _choices(call: str) -> list[str]:
    """The lines that do `call` for the controller of `code` and ask no further: '{name}' in it becomes the name's."""
    return [
        f"{'el' if number > 0 else ''}if code == {CONTROLLER_CODE[name]}: {call.format(name=name)}"
        for number, name in enumerate(CONTROLLERS)
    ]


decide_by_code = compile_lines(
    "decide_by_code",
    f"code, {_DECIDE}",
    _choices(f"decide_{{name}}({_DECIDE})"),
    {f"decide_{name}": controller.decide for name, controller in CONTROLLERS.items()},
)
speak_by_code = compile_lines(
    "speak_by_code",
    f"code, {_SPEAK}",
    _choices(f"speak_{{name}}({_SPEAK})"),
    {f"speak_{name}": controller.speak for name, controller in CONTROLLERS.items()},
)


def blank_memory(runs: int, robots: int) -> Floats:
    """Memory (runs, robots, MEMORY_SIZE) of controllers that have not run yet."""
    memory = np.zeros((runs, robots, MEMORY_SIZE))
    memory[..., [HEADING, LAST_TIME, LAST_PRESSURE, LAST_COMPASS]] = np.nan
    return memory


@kernel
def climb_rate(observation: Observation, pressure_per_metre: float, memory: Floats) -> float:
    """Speed upwards [m/s]: the robot's own estimate, or the change of pressure where it has none."""
    if math.isfinite(observation.velocity[2]):
        climb: float = observation.velocity[2]
        return climb
    elapsed = observation.time - memory[LAST_TIME]
    risen = (memory[LAST_PRESSURE] - observation.pressure) / pressure_per_metre
    return risen / elapsed if elapsed > 0.0 and math.isfinite(risen) else 0.0


@kernel
def complete_yaw_rate(observation: Observation, memory: Floats) -> None:
    """Where the gyro gives nothing, put the change of the compass into the observation's yaw rate."""
    if math.isfinite(observation.angular_rate[2]):
        return
    elapsed = observation.time - memory[LAST_TIME]
    turned = wrap_angle(observation.compass - memory[LAST_COMPASS])
    observation.angular_rate[2] = turned / elapsed if elapsed > 0.0 and math.isfinite(turned) else 0.0


@kernel
def avoid(crew: Crew, robot: int, observation: Observation, memory: Floats) -> bool:
    """Put what obstacle avoidance asks for into the request in `memory`; True if something is too near.

    A robot whose behaviour commands the actuators directly is left alone.
    """
    sensor_axis = crew.sensor_axis[robot, : crew.sensor_count[robot]]
    request, last_walls = memory[:REQUEST_SIZE], memory[LAST_WALLS:MEMORY_SIZE]
    if request[DIRECT] != 0.0:
        return False
    avoids_wall: bool = avoid_walls(observation, sensor_axis, crew.system[robot], last_walls, request)
    avoids_depth: bool = avoid_floor_and_surface(observation, sensor_axis, crew.system[robot], request)
    return avoids_wall or avoids_depth


@kernel
def renew_request(crew: Crew, robot: int, observation: Observation, memory: Floats) -> None:
    """Let the behaviour change the request in `memory` or, where something is too near, obstacle avoidance.

    In the first cycle the behaviour runs in any case: nobody knows earlier whether it commands the actuators
    directly, and then avoidance must leave them alone. All behaviours are compiled into one place of this function,
    since a second one would take the compiler as long again.
    """
    settings = crew.settings[robot, : crew.settings_count[robot]]
    sensor_axis = crew.sensor_axis[robot, : crew.sensor_count[robot]]
    first = math.isnan(memory[LAST_TIME])
    if first or not avoid(crew, robot, observation, memory):
        decide_by_code(crew.code[robot], observation, sensor_axis, settings, memory[:REQUEST_SIZE])
    if first:
        avoid(crew, robot, observation, memory)


@kernel
def ask(crew: Crew, robot: int, observation: Observation, memory: Floats, message: Floats) -> None:
    """Let the behaviour of `robot` speak into `message` (MESSAGE_SIZE,) and renew its request in `memory`."""
    settings = crew.settings[robot, : crew.settings_count[robot]]
    complete_yaw_rate(observation, memory)
    if math.isnan(memory[HEADING]):
        memory[HEADING] = observation.compass
    speak_by_code(crew.code[robot], observation, settings, message)
    renew_request(crew, robot, observation, memory)


@kernel
def carry_out(crew: Crew, robot: int, observation: Observation, memory: Floats, command: Floats) -> None:
    """Turn the request of `robot` into its `command` (actuators,), and remember what the next cycle needs."""
    system, actuator, request = crew.system[robot], crew.actuator[robot], memory[:REQUEST_SIZE]
    complete_yaw_rate(observation, memory)
    command[:] = 0.0
    if request[DIRECT] == 1.0:
        for index in range(min(command.shape[0], DIRECT_LIMIT)):
            command[index] = request[FRACTIONS + index]
    else:
        climb = climb_rate(observation, system[WATER_DENSITY] * system[GRAVITY], memory)
        steer(observation, system, request, actuator, command)
        dive(observation, climb, system, request, actuator, command)
    memory[LAST_TIME] = observation.time
    memory[LAST_PRESSURE] = observation.pressure
    memory[LAST_COMPASS] = observation.compass


@kernel
def conduct_one(
    crew: Crew, robot: int, observation: Observation, memory: Floats, command: Floats, message: Floats
) -> None:
    """Run one control cycle of `robot`: write `command` (actuators,) and `message` (MESSAGE_SIZE,).

    `command` are fractions in -1..1, in the platform's order of actuators. `memory` (MEMORY_SIZE,) persists
    between cycles. A robot that does not know its heading or depth leaves the actuators concerned off.
    """
    ask(crew, robot, observation, memory, message)
    carry_out(crew, robot, observation, memory, command)
