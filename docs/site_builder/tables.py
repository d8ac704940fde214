"""Tables of the reference, made from the code's own when the site is built."""

from __future__ import annotations

from collections.abc import Iterable

import click

from cocorosim_ros.commands.main import COMMANDS, cocorosim
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.wire.topics.service_quality import PROFILES
from cocorosim_ros.wire.topics.topics import GLOBAL_TOPICS, ROBOT_TOPICS, Topic
from cocorosim_ros.world.checks.loading import load_scenario
from site_builder.markdown import table


def command_table() -> str:
    """The sub-commands with what each of their options does."""
    rows = []
    for name, words in COMMANDS.items():
        command = cocorosim.get_command(click.Context(cocorosim), name)
        parameters = [] if command is None else command.params
        arguments = " ".join(part.human_readable_name for part in parameters if isinstance(part, click.Argument))
        options = [f"`{part.opts[-1]}`" for part in parameters if isinstance(part, click.Option)]
        rows.append([f"`cocorosim {name} {arguments}`".replace(" `", "`"), words, " ".join(options)])
    return table(("command", "does", "options"), rows)


def robot_topic_table() -> str:
    """The topics under each robot's namespace."""
    return _topic_table(ROBOT_TOPICS.values())


def swarm_topic_table() -> str:
    """The topics of the whole swarm."""
    return _topic_table(GLOBAL_TOPICS.values())


def quality_table() -> str:
    """The profiles of quality of service."""
    rows = [
        [f"`{part.name}`", f"{part.reliability}, {part.durability}, keep last {part.depth}", part.why]
        for part in PROFILES.values()
    ]
    return table(("profile", "quality of service", "why"), rows)


def paper_metric_table() -> str:
    """The six metrics of the paper."""
    return _metric_table(PAPER_METRICS)


def variant_table() -> str:
    """All other metrics."""
    return _metric_table(name for name in METRICS if name not in PAPER_METRICS)


def scenario_table() -> str:
    """The scenarios that ship."""
    rows = []
    for name in config_names("scenarios"):
        scenario = load_scenario(name)
        robots = str(len(scenario.robots))
        rows.append([f"`{name}`", scenario.description, robots, f"{scenario.tick:g} s", f"{scenario.duration:g} s"])
    return table(("scenario", "what it is", "robots", "tick", "length"), rows)


def _topic_table(topics: Iterable[Topic]) -> str:
    rows = [
        [
            f"`{part.name}`",
            f"`{part.type_name}`",
            part.publisher,
            _optional(part),
            f"`{part.quality.name}`",
            part.meaning,
        ]
        for part in topics
    ]
    return table(("topic", "type", "who publishes", "needed", "QoS", "meaning"), rows)


def _optional(topic: Topic) -> str:
    return "optional" if topic.optional else "yes"


def _metric_table(names: Iterable[str]) -> str:
    rows = [
        [
            f"`{name}`",
            METRICS[name].unit,
            METRICS[name].formula,
            METRICS[name].summary,
            METRICS[name].source.split(",")[0],
        ]
        for name in names
    ]
    return table(("metric", "unit", "value at one moment", "of a run", "source"), rows)
