"""Tables of docs/reference and config/README.md, made from the code's own; run this file to write them anew."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import click

from cocorosim_ros.commands.main import COMMANDS, cocorosim
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.wire.topics.service_quality import PROFILES
from cocorosim_ros.wire.topics.topics import GLOBAL_TOPICS, ROBOT_TOPICS, Topic
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.effect import Description, Number

ROOT = Path(__file__).parents[2]
REFERENCE = ROOT / "docs" / "reference"
CONFIG_README = ROOT / "config" / "README.md"


def table(heading: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A Markdown table."""
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in line)} |" for line in lines)


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


def effect_examples() -> str:
    """Every effect of the motion with every number, as it stands in a platform file."""
    return _examples(CATALOGUE_EFFECTS)


def error_examples() -> str:
    """Every error of sensors, cameras and clocks with every number, as it stands in a platform file."""
    return _examples(ERRORS)


TABLES = {
    "commands": command_table,
    "robot topics": robot_topic_table,
    "swarm topics": swarm_topic_table,
    "quality of service": quality_table,
    "metrics": paper_metric_table,
    "metric variants": variant_table,
    "scenarios": scenario_table,
    "effects": effect_examples,
    "errors": error_examples,
}
FILE_OF = {
    "commands": REFERENCE / "commands.md",
    "robot topics": REFERENCE / "topics.md",
    "swarm topics": REFERENCE / "topics.md",
    "quality of service": REFERENCE / "topics.md",
    "metrics": REFERENCE / "metrics.md",
    "metric variants": REFERENCE / "metrics.md",
    "scenarios": REFERENCE / "scenarios.md",
    "effects": CONFIG_README,
    "errors": CONFIG_README,
}


def with_tables(file: Path) -> str:
    """The text of a file with every table of its own between its two marks made anew."""
    text = file.read_text("utf-8")
    for name in (name for name in TABLES if FILE_OF[name] == file):
        begin, end = f"<!-- table: {name} -->", f"<!-- end of table: {name} -->"
        pattern = re.compile(f"{re.escape(begin)}.*?{re.escape(end)}", re.DOTALL)
        if len(pattern.findall(text)) != 1:
            raise ValueError(f"{file.name} does not have exactly one place for the table '{name}'.")
        before, after = text[: text.index(begin)], text[text.index(end) :]
        text = f"{before}{begin}\n\n{TABLES[name]()}\n\n{after}"
    return text


def _examples(described: Mapping[str, Description]) -> str:
    lines = []
    for name, effect in described.items():
        if effect.numbers:
            lines.append(f"{name}:  # {effect.summary}: {effect.equation}")
            lines += [_example(number) for number in effect.numbers]
    return "\n".join(["```yaml", *lines, "```"])


def _example(number: Number) -> str:
    """One number of an effect, with its meaning."""
    if number.example is None:
        raise ValueError(f"'{number.name}' has no example.")
    unit = '"1"' if number.unit == "1" else number.unit
    needed = "; must be given" if number.needed else ""
    value = re.sub(r"e([+-])0", r"e\1", f"{number.example.value:g}")
    stated = f"{{value: {value}, unit: {unit}, source: {number.example.source}}}"
    return f"  {number.name}: {stated}  # {number.meaning}{needed}"


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


if __name__ == "__main__":
    for file in sorted(set(FILE_OF.values())):
        file.write_text(with_tables(file), "utf-8")
