"""One plain Python controller at work: one robot's, in one run."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.plain.answer_check import AnswerCheck
from cocorosim_ros.world.controllers.plain.faults import ControllerError, raised_in
from cocorosim_ros.world.controllers.plain.sensed import Senses
from cocorosim_ros.world.controllers.plain.user_class import RANDOM, forget, load_class
from cocorosim_ros.world.controllers.request import DIRECT_LIMIT
from cocorosim_ros.world.controllers.traits import needs_sound, traits_of
from cocorosim_ros.world.seeding.seeding import generator
from cocorosim_ros.world.state.observation import Observation

PURPOSE = "controller"  # of its random numbers


def plain_of(robot: RobotDescription) -> PythonController | None:
    """The robot's controller if it is one in plain Python."""
    return robot.controller if isinstance(robot.controller, PythonController) else None


def check_plain(robots: Iterable[RobotDescription]) -> None:
    """Nothing, if the plain Python controllers of these robots can be made; raises CocorosimError before a run begins.

    Their files are imported for that; nothing is made and nothing called.
    """
    for robot in robots:
        if (named := plain_of(robot)) is None:
            continue
        user_class = load_class(named)
        user_class.check()
        if needs_sound(traits_of(named)) and not robot.acoustic:
            raise CocorosimError(
                f"{user_class.place}: '{named.name}' speaks or hears by sound, but the scenario has no 'acoustic'; add "
                "'acoustic: {range: ...}' to the scenario."
            )
        if len(robot.platform.actuators) > DIRECT_LIMIT:
            raise CocorosimError(
                f"{user_class.place}: the platform '{robot.platform.name}' has {len(robot.platform.actuators)} "
                f"actuators; a controller can command {DIRECT_LIMIT} at most."
            )


def rehearse_plain(robots: Iterable[RobotDescription], seed: int, run: int = 0) -> None:
    """Make the plain Python controllers of these robots as a run would, and throw them away again.

    Constructors that fail are so found before anything is written. The users' files are executed anew afterwards, so
    that nothing which a constructor leaves in its class or file reaches the run. Raises CocorosimError.
    """
    made = [(robot, named) for robot in robots if not robot.external and (named := plain_of(robot)) is not None]
    try:
        for robot, named in made:
            PlainController(robot, named, seed, run)
    except ControllerError as error:  # no run has begun, so that this is unusable input
        raise CocorosimError(str(error)) from error
    finally:
        for _, named in made:
            forget(named)


class PlainController:
    """A user's controller of one robot in one run, with its own object of the user's class."""

    def __init__(self, robot: RobotDescription, named: PythonController, seed: int, run: int = 0) -> None:
        """`seed` and `run` decide its random numbers, if it asks for any. Raises CocorosimError, ControllerError."""
        check_plain([robot])
        self._named = named
        self._user_class = load_class(named)
        self._owner = f"'{named.name}' of {robot.name}" + (f" in run {run}" if run else "")
        self._senses = Senses(robot)
        self._check = AnswerCheck(robot, self._user_class.medium())
        self._tick = 0
        arguments = named.values
        if self._user_class.wants_random:
            arguments[RANDOM] = generator(seed, PURPOSE, robot.name, run)
        self._controller = self._make(arguments)

    def ask(self, observation: Observation, request: Floats, said: Floats) -> None:
        """Call the user's controller once: its wishes into `request` (controllers.request), its words into `said`.

        `said` (MESSAGE_SIZE,), see state.radio. Raises ControllerError for an exception in the user's class and for an
        answer that cannot be carried out.
        """
        sensed = self._senses.see(observation)
        try:
            answer = self._controller(sensed)
        except (Exception, SystemExit) as error:
            raise ControllerError(
                f"{raised_in(self._named, error)}; this ended {self._owner} at {self._moment(sensed.time)}."
            ) from error
        try:
            self._check.carry_out(answer, request, said)
        except ValueError as error:
            raise ControllerError(
                f"{self._user_class.place}: {self._owner} answered at {self._moment(sensed.time)} with {error}."
            ) from error
        self._tick += 1

    def _moment(self, time: float) -> str:
        return f"tick {self._tick} ({time:g} s)"

    def _make(self, arguments: dict[str, Any]) -> Any:
        try:
            return self._user_class.kind(**arguments)
        except (Exception, SystemExit) as error:
            raise ControllerError(f"{raised_in(self._named, error)}; {self._owner} could not be made.") from error
