"""Effects, errors of sensors, metrics, topics and controllers, from the tables that the model is compiled from."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.against.numbers import SURGE_DRAG
from cocorosim_ros.diagnosis.naming.single_thrusters import ONE_THRUSTER
from cocorosim_ros.diagnosis.naming.steering_trims import STEERING_TRIM
from cocorosim_ros.foundation.compiling.sources import PACKAGE
from cocorosim_ros.library.explaining.explanation import CATALOGUE, PLACE, Explanation
from cocorosim_ros.library.explaining.shipped import trees, values
from cocorosim_ros.scenario.parts.controller_file import load_controller
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.wire.topics.topics import TOPICS
from cocorosim_ros.world.controllers import CONTROLLERS
from cocorosim_ros.world.effects import BASIC_EFFECTS, CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.effect import Description, Number


def table_entries() -> Iterator[Explanation]:
    """Everything that a table of the code defines."""
    for name, effect in (*BASIC_EFFECTS.items(), *CATALOGUE_EFFECTS.items()):
        place = f"{CATALOGUE}.{name}" if name in CATALOGUE_EFFECTS else ""
        yield from _described("effect", name, effect, "world/effects", place)
    for name, error in ERRORS.items():
        place = f"{CATALOGUE}.{name}" if error.parameters else ""
        yield from _described("error of a sensor", name, error, "world/sensors/errors", place)
    yield from _single_actuators()
    yield _drag_ahead()
    yield from _metrics()
    yield from _topics()
    yield from _controllers()


def _described(kind: str, name: str, what: Description, folder: str, place: str) -> Iterator[Explanation]:
    numbers = ", ".join(f"{part.name} [{part.unit}]" for part in what.parameters)
    facts = {"equation": what.whole_equation, "numbers": numbers, "check": what.check}
    if what.search is not None:
        facts["found by"] = f"cocorosim diagnose, in {what.search.channel}; best shown by {what.search.manoeuvre}"
    facts |= {PLACE: place, "defined in": _file(folder, name)}
    users = tuple(values("platforms").get(f"effects.{name}", {}))
    yield Explanation(name, kind, what.summary, _known(facts), tuple(f"platform {user}" for user in users))
    for part in what.parameters:
        yield _number(f"number of the {kind} {name}", f"{name}.{part.name}", part)


def _single_actuators() -> Iterator[Explanation]:
    """Numbers of one actuator that a diagnosis looks for, by the name before the actuator's."""
    yield Explanation(
        ONE_THRUSTER,
        "effect",
        "thrust of one thruster unlike that of the others, as one that is fouled or has lost a blade",
        {
            "equation": "T = factor * T_model",
            "numbers": "a factor [1] by the name of the thruster",
            "found by": "cocorosim diagnose, of vehicles with more than two thrusters",
            PLACE: "'gain' of that thruster",
        },
    )
    yield Explanation(
        STEERING_TRIM,
        "effect",
        "angle at which a rudder or a fin stands at command zero, as one whose linkage has slipped",
        {
            "equation": "angle = command + trim",
            "numbers": "an angle [rad] by the name of the rudder or fin",
            "found by": "cocorosim diagnose, where the file does not give it",
            PLACE: "'trim' of that rudder or fin",
        },
    )


def _drag_ahead() -> Explanation:
    return Explanation(
        SURGE_DRAG,
        "effect",
        "drag ahead that is another than when the vehicle was well, as that of a bracket or a fouled bow",
        {
            "equation": "X = -factor k U u, with sway and heave as before",
            "numbers": "a factor [1]",
            "found by": "cocorosim diagnose --against",
            PLACE: "'drag' times the factor, 'anisotropic_drag' over it",
        },
    )


def _number(kind: str, name: str, part: Parameter) -> Explanation:
    limit = {"any": "", "not negative": ", not negative", "positive": ", greater than zero"}[part.sign]
    unit = "that of its law" if part.unit == "*" else part.unit
    facts = {"unit": f"{unit}{limit}", "default": "none: it must be given" if part.needed else f"{part.neutral:g}"}
    if isinstance(part, Number) and part.example is not None:
        facts["example"] = f"{part.example.value:g} {part.unit} ({part.example.source})"
    there = values("platforms").get(f"effects.{name}", {})
    users = tuple(f"platform {user}: {'; '.join(words)}" for user, words in there.items())
    return Explanation(name, kind, part.meaning, facts, users)


def _file(folder: str, name: str) -> str:
    file = PACKAGE / folder / f"{name}.py"
    return file.relative_to(PACKAGE.parent).as_posix() if file.is_file() else ""


def _known(facts: dict[str, str]) -> dict[str, str]:
    return {name: words for name, words in facts.items() if words}


def _metrics() -> Iterator[Explanation]:
    for name, metric in METRICS.items():
        facts = {"unit": metric.unit, "value of a run": f"{metric.summary} over time", "source": metric.source}
        if metric.paper:
            facts["paper"] = "one of the six of Read et al., in the reading that is the default here"
        users = [design for design, tree in trees("designs").items() if name in tree.get("metrics", ())]
        yield Explanation(name, "metric", metric.formula, facts, tuple(f"design {user}" for user in users))


def _topics() -> Iterator[Explanation]:
    for name, topic in TOPICS.items():
        quality = topic.quality
        facts = {
            "type": topic.type_name,
            "place": "in the namespace of each robot" if topic.per_robot else "of the whole swarm",
            "published by": topic.publisher,
            "quality of service": f"{quality.reliability}, {quality.durability}, keep last {quality.depth}",
            "always there": "no" if topic.optional else "yes",
        }
        users = [f"controller {each}" for each, controller in CONTROLLERS.items() if name in controller.needs]
        yield Explanation(name, "topic", topic.meaning, facts, tuple(users))


def _controllers() -> Iterator[Explanation]:
    asked = [(name, group.get("controller")) for name, tree in trees("scenarios").items() for group in tree["swarm"]]
    for name in config_names("controllers"):
        controller = load_controller(name)
        facts = {"behaviour": controller.behaviour, "parameters": ", ".join(controller.parameters)}
        users = dict.fromkeys(f"scenario {scenario}" for scenario, chosen in asked if chosen == name)
        yield Explanation(name, "controller", controller.description, _known(facts), tuple(users))
        for key, number in controller.parameters.items():
            unit = "" if number.unit in ("", "1") else f" {number.unit}"
            facts = {
                "default": f"{number.value}{unit}",
                "allowed": f"{number.minimum:g} to {number.maximum:g}{unit}" if number.unit else "true or false",
                "source": number.source,
            }
            yield Explanation(f"{name}.{key}", f"parameter of the controller {name}", number.description, facts)
