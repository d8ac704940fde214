"""Every command and every snippet of the documents runs, or is at least taken apart as its program would."""

from __future__ import annotations

import ast
import contextlib
import io
import re
import subprocess
import sys
import webbrowser
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import click
import pytest

from cocorosim_ros.commands.main import cocorosim
from cocorosim_ros.foundation.installation import DISTRIBUTION
from cocorosim_ros.graph.nodes import controller_node, metrics_node, physics_node
from cocorosim_ros.scenario.parts.controller_file import load_controller

from .documents import ROOT, Block, blocks, commands, documents

pytestmark = pytest.mark.timeout(1800)  # s; the first diagnosis of the reader compiles
RUN_AND_LOOK = "docs/tutorials/run_and_look.md"
FOLLOWED = ("tutorials", "how_to", "explanation")  # folders of docs/ whose pages a reader goes through with a shell
DOCUMENTS = {str(path.relative_to(ROOT)): path.read_text("utf-8") for path in documents()}
ALL = [pytest.param(words, id=" ".join(words)) for text in DOCUMENTS.values() for words in commands(text)]
BIN = Path(sys.prefix, "bin")
NODES = {"physics_node": physics_node, "controller_node": controller_node, "metrics_node": metrics_node}
# Programs of a ROS installation, of the shell and of the Python world, which are not looked into.
TRUSTED = {"export", "cd", "echo", "python3", "pip", "python", "rosdep", "rviz2", "."}


def check_cocorosim(words: list[str]) -> None:
    """The sub-command exists, and click takes the arguments."""
    command = cocorosim.get_command(click.Context(cocorosim), words[0])
    assert command is not None, words
    command.make_context(words[0], list(words[1:]))


def check_node(name: str, words: list[str]) -> None:
    """Every -p sets a parameter that the node declares, or one of a shipped controller's."""
    known = {part.name for part in NODES[name].PARAMETERS}
    known |= {f"setting.{setting}" for setting in load_controller("boids_blt").parameters}
    given = {words[index + 1].split(":=")[0] for index, word in enumerate(words) if word == "-p"}
    assert given <= known


def check_make(words: list[str]) -> None:
    """The targets exist, and so does every variable that is set."""
    makefile = (ROOT / "Makefile").read_text("utf-8")
    targets = re.findall(r"^([\w-]+):", makefile, re.MULTILINE)
    settings = {word.partition("=")[0] for word in words if "=" in word}
    assert {word for word in words if "=" not in word} <= set(targets)
    assert all(f"$({name})" in makefile for name in settings)


def check_ros2(words: list[str]) -> None:
    """`run` names a node, `launch` a launch file and its arguments; `bag` is rosbag2's."""
    if words[0] == "run":
        assert words[1] == "cocorosim_ros" and words[2] in NODES
    elif words[0] == "launch":
        source = (ROOT / "cocorosim_ros/graph/launch" / words[2]).read_text("utf-8")
        (table,) = (
            node for node in ast.parse(source).body if isinstance(node, ast.Assign) and _name(node) == "ARGUMENTS"
        )
        assert {word.split(":=")[0] for word in words[3:]} <= ast.literal_eval(table.value).keys()
    else:
        assert words[0] == "bag"


def _name(node: ast.Assign) -> str:
    target = node.targets[0]
    return target.id if isinstance(target, ast.Name) else ""


def check_uvx(words: list[str]) -> None:
    """It takes the distribution by the name that setup.py gives it, and runs a command of it."""
    assert words[:2] == ["--from", DISTRIBUTION] and words[2] == "--find-links"
    assert words[4] == "cocorosim"
    check_cocorosim(words[5:])


CHECKS: dict[str, Callable[[list[str]], None]] = {
    "cocorosim": check_cocorosim,
    "make": check_make,
    "ros2": check_ros2,
    "uvx": check_uvx,
}


@pytest.mark.parametrize("words", ALL)
def test_command_is_understood(words: list[str]) -> None:
    """The program exists and takes these options; files of this tree that it is given exist."""
    program = Path(words[0]).name
    if words[0].startswith(".venv/"):
        assert (BIN / program).exists()
    if program in NODES:
        check_node(program, words[1:])
    elif program in CHECKS:
        CHECKS[program](words[1:])
    else:
        assert words[0] in TRUSTED or words[0].startswith(".venv/"), words
    for word in words[1:]:
        if re.match(r"(test|cocorosim_ros|config)/[\w./]+$", word):
            assert (ROOT / word).exists(), word


@dataclass
class Reader:
    """A reader with a folder, who types what pages say, each command once."""

    folder: Path
    outputs: dict[tuple[str, ...], str] = field(default_factory=dict)

    def follow(self, page: str) -> None:
        """Write the files of a page, run its commands and snippets, and compare output that it shows."""
        shown = ""
        with contextlib.chdir(self.folder):
            for block in blocks(DOCUMENTS[page]):
                if block.file:
                    Path(block.file).write_text(block.code, "utf-8")
                elif block.language == "python":
                    exec(compile(block.code, page, "exec"), {})
                elif block.language == "text":
                    assert_shown(block, shown)
                elif block.language == "shell":
                    shown += "".join(self.type(words) for words in block.commands)

    def type(self, words: list[str]) -> str:
        """What a command prints; "" of one that this reader leaves to other tests."""
        if words[0] != "cocorosim" or "--external" in words:
            return ""
        if tuple(words) not in self.outputs:
            shortened = ["5 s" if word == "60 s" else word for word in words[1:]]
            needs_ros = words[1] == "replay" or (words[1] == "run" and "--in-process" not in words)
            self.outputs[tuple(words)] = (in_a_process if needs_ros else in_this_process)(shortened)
        return self.outputs[tuple(words)]


STAGE = re.compile(r"after \d+\.\d min, \d+%: .+")
"""A line that long work says of itself on standard error each half minute where no terminal is."""


def in_this_process(words: list[str]) -> str:
    """Standard output of `cocorosim` as a function call."""
    out, complaints = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(complaints):
        status = cocorosim.main(words, standalone_mode=False)
    assert not status, (words, out.getvalue())
    said = [line for line in complaints.getvalue().splitlines() if not STAGE.fullmatch(line)]
    assert not said or "-" in words, (words, said)  # "-": the table goes there
    return out.getvalue()


def in_a_process(words: list[str]) -> str:
    """Standard output of `cocorosim` where it starts nodes."""
    command = [str(BIN / "cocorosim"), *words]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert (done.returncode, done.stderr) == (0, ""), (words, done.stdout, done.stderr)
    return done.stdout


def assert_shown(block: Block, output: str) -> None:
    """Each line of a block of output was printed, one below the other; spaces may be unbreakable there."""
    printed = "\n".join(line.rstrip() for line in output.replace("\u00a0", " ").splitlines())
    assert block.code.rstrip() in printed, f"The page shows\n{block.code}\nand the commands before it print\n{printed}"


def followed_pages() -> list[str]:
    """README.md, and the pages to be followed, in the order of the site."""
    index = re.findall(r"^(\w+)/(\w+)$", DOCUMENTS["docs/index.md"], re.MULTILINE)
    return ["README.md", *(f"docs/{folder}/{page}.md" for folder, page in index if folder in FOLLOWED)]


@pytest.fixture(scope="module")
def reader(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Reader]:
    """One who has what `make demo` leaves, from a shorter run, and has tried what README.md says."""
    one = Reader(tmp_path_factory.mktemp("reader"))
    (one.folder / "config").symlink_to(ROOT / "config")
    with pytest.MonkeyPatch.context() as patch, contextlib.chdir(one.folder):
        patch.setattr(webbrowser, "open", lambda *_: True)
        patch.setenv("COLUMNS", "200")
        patch.setenv("TMPDIR", str(one.folder))
        in_this_process(["run", "eleven_lilys", "--in-process", "--duration", "20 s", "--out", "runs/demo"])
        one.follow("README.md")
        yield one


@pytest.mark.parametrize("page", followed_pages())
def test_a_page_can_be_followed(reader: Reader, page: str) -> None:
    """Each command ends with status 0 and without complaint, each snippet without an error; output is as shown."""
    reader.follow(page)


def test_every_page_has_its_place_on_the_site() -> None:
    """A page that is to be followed stands in the index of the site."""
    pages = {
        f"docs/{path.parent.name}/{path.name}" for name in FOLLOWED for path in (ROOT / "docs" / name).glob("*.md")
    }
    assert pages == set(followed_pages()) - {"README.md"}


def test_what_a_page_says_lies_in_the_folder(reader: Reader) -> None:
    """A run of the graph leaves exactly the files of the table."""
    rows = re.search(r"which holds:\n\n(.*?)\n\n", DOCUMENTS[RUN_AND_LOOK], re.DOTALL)
    assert rows is not None
    said = {name.rstrip("/") for name in re.findall(r"^\| `([\w./]+)`", rows[1], re.MULTILINE)}
    reader.follow(RUN_AND_LOOK)
    assert {path.name for path in (reader.folder / "runs/one").iterdir()} == said
