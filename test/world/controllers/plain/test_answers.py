"""What a plain Python controller may answer, what becomes of it, and one sentence for everything else."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.controllers.plain.faults import ControllerError
from cocorosim_ros.world.controllers.request import (
    DIRECT,
    DIVE,
    DIVE_AT_SPEED,
    DIVE_MODE,
    DIVE_TO_DEPTH,
    FRACTIONS,
    HEADING,
    SPEED,
    TURN_GAIN,
)
from cocorosim_ros.world.seeding.seeding import generator
from cocorosim_ros.world.state.observation import blank_observation

Make = Callable[..., Any]
USES = "from cocorosim_ros.world.controllers.plain import Command, Course\n"


def answering(expression: str, constructor: str = "self") -> str:
    """The source of a class whose `__call__`, in line 6, answers with the value of an expression."""
    return f"""{USES}
class Mine:
    def __init__({constructor}):
        self.ticks = 0
    def __call__(self, sensed):
        self.ticks += 1
        return {expression}
"""


def test_fractions_by_name(robot_with: Make, asked: Make) -> None:
    """A mapping commands the actuators directly; what it does not name is off, and nothing is said."""
    request, said = asked(robot_with(answering("{'right': 0.25, 'left': -1}")))
    assert request[DIRECT] == 1.0
    assert request[FRACTIONS : FRACTIONS + 3].tolist() == [-1.0, 0.25, 0.0]
    assert said.tolist() == [0.0] * 9


STEERED = """\
based_on: lily
name: steered
description: Lily by sticks
mixing:
  form: table
  rows:
    - {actuator: left, weights: {value: [1, 0, 0, 0, 0, -1], unit: "1", source: made}}
    - {actuator: right, weights: {value: [1, 0, 0, 0, 0, 1], unit: "1", source: made}}
"""


def test_sticks_by_name(robot_with: Make, asked: Make, tmp_path: Path) -> None:
    """Surge and yaw of a platform that mixes them, its pump beside; a stick and what it drives are a contradiction."""
    (tmp_path / "steered.yaml").write_text(STEERED)
    steered = str(tmp_path / "steered.yaml")
    answer = answering("{'yaw': 0.25, 'surge': 0.5, 'buoyancy': -1}")
    request, _ = asked(robot_with(answer, platform=steered))
    assert request[DIRECT] == 1.0
    assert request[FRACTIONS : FRACTIONS + 3].tolist() == [0.25, 0.75, -1.0]
    with pytest.raises(ControllerError, match="the stick 'surge' beside 'left', which it drives"):
        asked(robot_with(answering("{'surge': 0.5, 'left': 1}"), platform=steered))
    with pytest.raises(ControllerError, match="the command of 'surge' 2; allowed is a number from -1 to 1"):
        asked(robot_with(answering("{'surge': 2}"), platform=steered))


def test_a_command_that_speaks(robot_with: Make, asked: Make) -> None:
    """The message has the length that was said, then its numbers."""
    request, said = asked(robot_with(answering("Command({'left': 0.5}, say=[1.5, -2])")))
    assert request[FRACTIONS : FRACTIONS + 3].tolist() == [0.5, 0.0, 0.0]
    assert said.tolist() == [2.0, 1.5, -2.0] + [0.0] * 6


def test_a_course(robot_with: Make, asked: Make) -> None:
    """Heading, speed and depth go to the operating system; 3 pi / 2 is -pi / 2. Without a depth it climbs."""
    request, _ = asked(robot_with(answering("Course(heading=4.71238898038469, speed=0.5, depth=1.2)")))
    assert request[DIRECT] == 0.0
    assert request[HEADING] == pytest.approx(-math.pi / 2)
    assert (request[SPEED], request[DIVE_MODE], request[DIVE], request[TURN_GAIN]) == (0.5, DIVE_TO_DEPTH, 1.2, 3.0)
    request, _ = asked(robot_with(answering("Course(climb=0.02)")))
    assert math.isnan(request[HEADING]), "no heading keeps the one that was there"
    assert (request[DIVE_MODE], request[DIVE]) == (DIVE_AT_SPEED, 0.02)


def test_an_object_of_its_own_for_each_robot(robot_with: Make, asked: Make) -> None:
    """What an object counts, it counts alone, from 1 in its first tick."""
    robot = robot_with(answering("{'left': 0.1 * self.ticks}"))
    three = (blank_observation(5, 4),) * 3
    assert asked(robot, three)[0][FRACTIONS] == asked(robot, three)[0][FRACTIONS] == 0.1 * 3


def test_arguments_and_random_numbers(robot_with: Make, asked: Make) -> None:
    """Parameters are arguments; `random` is a generator of this seed, robot and run."""
    source = answering("{'left': self.gain, 'right': self.draw}", "self, gain, random")
    source = source.replace("self.ticks = 0", "self.ticks, self.gain, self.draw = 0, gain, random.uniform()")
    robot = robot_with(source, {"gain": 0.75})
    request, _ = asked(robot, seed=5, run=2)
    assert request[FRACTIONS] == 0.75
    assert request[FRACTIONS + 1] == generator(5, "controller", "lily_01", 2).uniform()
    assert request[FRACTIONS + 1] != asked(robot, seed=5, run=3)[0][FRACTIONS + 1]


@pytest.mark.parametrize(
    ("expression", "told"),
    [
        ("{'left': 1.5}", "the command of 'left' 1.5; allowed is a number from -1 to 1."),
        ("{'left': float('nan')}", "the command of 'left' nan; allowed is a number from -1 to 1."),
        ("{'left': 'full'}", "the command of 'left' 'full'; allowed is a number from -1 to 1."),
        (
            "{'rudder': 0.1}",
            "a command for 'rudder', an actuator that the robot does not have; it has left, right, buo",
        ),
        ("None", "nothing, which is no command; return {actuator: fraction}, Command(...) or Course(...)."),
        ("[0.1, 0.2, 0.0]", "an object of type 'list', which is no command"),
        ("Command([0.1, 0.2])", "actuators of type 'list'"),
        ("Course(heading=float('nan'))", "the heading nan; allowed is a finite number."),
        ("Course(speed=2)", "the speed 2; allowed is a number from -1 to 1."),
        ("Course(turn_gain=-1)", "the turn_gain -1; allowed is a number from 0 on."),
        ("Course(depth=float('inf'))", "the depth inf; allowed is a finite number."),
        ("Command({}, say=range(9))", "9 numbers to say; a message has 8 at most."),
        ("Command({}, say=[float('nan')])", "a number to say nan; allowed is a finite number."),
        ("Command({}, say=5)", "'say' of type 'int'; give a list of numbers."),
    ],
)
def test_an_answer_that_cannot_be_carried_out(robot_with: Make, asked: Make, expression: str, told: str) -> None:
    """File and line, class, robot, tick and time, what was found and what is allowed."""
    with pytest.raises(ControllerError) as caught:
        asked(robot_with(answering(expression)))
    sentence = str(caught.value)
    assert sentence.startswith("mine.py:6: 'Mine' of lily_01 answered at tick 0 (0 s) with ")
    assert told in sentence and "\n" not in sentence and sentence.endswith(".")


def test_what_the_platform_cannot_do(robot_with: Make, asked: Make) -> None:
    """The floater has neither an operating system nor a radio."""
    with pytest.raises(ControllerError, match="the platform 'floater' has no operating system that could keep it"):
        asked(robot_with(answering("Course()"), platform="floater"))
    with pytest.raises(ControllerError, match="something to say, but the platform 'floater' has no radio"):
        asked(robot_with(answering("Command({}, say=[1])"), platform="floater"))


def test_an_exception_in_the_users_class(robot_with: Make, asked: Make) -> None:
    """The line in the user's file that led to it, also where a library raised it, and the tick."""
    source = "import math\nclass Mine:\n    def __call__(self, sensed):\n        return self.turn(sensed)\n"
    source += "    def turn(self, sensed):\n        return math.sqrt(0.5 - sensed.time)\n"
    moments = tuple(blank_observation(5, 4)._replace(time=time) for time in (1.0, 1.5))
    source = source.replace("return math", "return {'left': 0.0} if sensed.time < 1.2 else math")
    with pytest.raises(ControllerError) as caught:
        asked(robot_with(source), moments)
    assert str(caught.value).startswith("mine.py:6: ValueError: ")
    assert str(caught.value).endswith("; this ended 'Mine' of lily_01 at tick 1 (1.5 s).")


def test_an_exception_in_the_constructor(robot_with: Make, asked: Make) -> None:
    """The same, and that nothing was made; the number of a run is told where there are several."""
    source = (
        "class Mine:\n    def __init__(self):\n        {}['gain']\n    def __call__(self, sensed):\n        return {}\n"
    )
    with pytest.raises(ControllerError) as caught:
        asked(robot_with(source), run=3)
    assert str(caught.value) == "mine.py:3: KeyError: 'gain'; 'Mine' of lily_01 in run 3 could not be made."


@pytest.mark.parametrize(
    ("source", "told"),
    [
        ("class Mine:\n    def __call__(self, sensed)\n", "mine.py:2: SyntaxError: "),
        ("import nothing_of_that_name\n", "mine.py:1: ModuleNotFoundError: No module named 'nothing_of_that_name'; "),
        ("\n\nraise SystemExit(3)\n", "mine.py:3: SystemExit: 3; this file cannot be imported"),
        (
            "class Other:\n    def __call__(self, sensed):\n        return {}\n",
            "mine.py has no class 'Mine'; it has Other.",
        ),
        ("Mine = 3\n", "mine.py: 'Mine' is no class but of type 'int'"),
        ("class Mine:\n    pass\n", "mine.py:1: objects of the class 'Mine' cannot be called"),
        (answering("{}", "self, gain"), "mine.py:6: the constructor of 'Mine' needs 'gain'; give it in a test below"),
        (answering("{}").replace("class Mine:", "class Mine:\n    needs = ['sonar']"), "'needs' of 'Mine' has 'sonar'"),
        (answering("{}").replace("class Mine:", "class Mine:\n    needs = 3"), "'needs' of 'Mine' has 3"),
        (answering("{}").replace("class Mine:", "class Mine:\n    medium = 'sound'"), "'medium' of 'Mine' has 'sound'"),
    ],
)
def test_a_file_that_has_no_such_controller(robot_with: Make, source: str, told: str) -> None:
    """One sentence before anything runs, and it is unusable input, not a run that failed."""
    from cocorosim_ros.world.controllers.plain.plain_controller import check_plain

    robot = robot_with(source)
    with pytest.raises(CocorosimError) as caught:
        check_plain([robot])
    assert told in str(caught.value) and "\n" not in str(caught.value)
    assert not isinstance(caught.value, ControllerError)


def test_a_parameter_that_the_constructor_does_not_take(robot_with: Make) -> None:
    """The nearest of those that it takes is named."""
    from cocorosim_ros.world.controllers.plain.plain_controller import check_plain

    robot = robot_with(answering("{}", "self, gain=1.0"), {"gian": 2.0})
    with pytest.raises(CocorosimError, match=r"takes no 'gian', which a test gives .* did you mean 'gain'\?"):
        check_plain([robot])


def test_a_file_that_has_changed_since(robot_with: Make) -> None:
    """A scenario that was read before the edit runs with the file as it was, or not at all."""
    from cocorosim_ros.world.controllers.plain.user_class import load_class

    before = robot_with(answering("{'left': 0.1}")).controller
    robot_with(answering("{'left': 0.2}"))
    with pytest.raises(CocorosimError, match=r"mine\.py has changed since a test was made with its class 'Mine'"):
        load_class(before)


def test_modules_beside_the_file_can_be_imported(robot_with: Make, asked: Make, tmp_path: Any) -> None:
    """As they can when the file is run by itself."""
    (tmp_path / "gains_beside_mine.py").write_text("LEFT = 0.125\n", "utf-8")
    request, _ = asked(robot_with("from gains_beside_mine import LEFT\n" + answering("{'left': LEFT}")))
    assert request[FRACTIONS] == 0.125


def test_what_a_class_asks_for(robot_with: Make) -> None:
    """`needs` and `medium` are the topics of its robot; every plain controller may speak at every tick."""
    from cocorosim_ros.wire.topics.body import describe_body

    source = answering("{}").replace(
        "class Mine:", "class Mine:\n    needs = ['illuminance']\n    medium = 'blue_light'"
    )
    body = describe_body(robot_with(source))
    assert body.topics[-1] == "illuminance"
    assert body.answers == ("thruster_command", "blue_light_tx")


def test_a_rehearsal_leaves_nothing_behind(robot_with: Make) -> None:
    """Objects are made as a run makes them; what they leave in their class is gone when the run makes its own."""
    from cocorosim_ros.world.controllers.plain.plain_controller import rehearse_plain
    from cocorosim_ros.world.controllers.plain.user_class import load_class

    source = "class Mine:\n    made = []\n    def __init__(self, random):\n        self.made.append(random.random())\n"
    source += "        with open('made.txt', 'a') as file:\n            file.write(f'{self.made}\\n')\n"
    source += "    def __call__(self, sensed):\n        return {}\n"
    robot = robot_with(source)
    rehearse_plain([robot, robot], seed=3, run=2)
    rehearse_plain([robot], seed=3, run=2)
    before, both, after = Path("made.txt").read_text("utf-8").splitlines()
    assert before == after != both
    assert load_class(robot.controller).kind.made == []


def test_a_rehearsal_leaves_the_controllers_of_others_alone(robot_with: Make) -> None:
    """The constructor of a robot that is left to others is not called; that of one that fails is unusable input."""
    from cocorosim_ros.world.controllers.plain.plain_controller import rehearse_plain

    failing = "class Mine:\n    def __init__(self):\n        raise OSError('no port')\n"
    robot = robot_with(failing + "    def __call__(self, sensed):\n        return {}\n")
    rehearse_plain([replace(robot, external=True)], seed=1)
    with pytest.raises(
        CocorosimError, match=r"^mine\.py:3: OSError: no port; 'Mine' of lily_01 could not be made\.$"
    ) as end:
        rehearse_plain([robot], seed=1)
    assert not isinstance(end.value, ControllerError)
