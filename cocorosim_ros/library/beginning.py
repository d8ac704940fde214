"""Files to begin with: a commented scenario, platform, map or controller that passes the checks as it is."""

from __future__ import annotations

import re
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.foundation.output_file import check_file, write_text
from cocorosim_ros.scenario.reading.arguments import Place, place_text
from cocorosim_ros.scenario.reading.config_files import shipped_file
from cocorosim_ros.scenario.reading.entry import nearest

KINDS = {"platform": ".yaml", "controller": ".py", "scenario": ".yaml", "map": ".yaml"}
"""What can be begun, with the ending of its file."""
_NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")


def begin_file(
    kind: str, name: str, out: Place | None = None, *, recording: Place | None = None, force: bool = False
) -> Path:
    """Write a commented file to begin with, which passes the checks as it is.

    kind: one of KINDS. name: in small letters, digits and single underscores. out: the file; NAME with the kind's
    ending in the working folder if left out. recording: for a platform, a recording of the robot, whose commands tell
    the names of its actuators and whose readings its sensors. Returns the path of the file. Raises CocorosimError for a
    kind that there is not, for another kind of name, for a recording that tells no actuators, and if the file exists
    (without `force`) or cannot be written.
    """
    if kind not in KINDS:
        raise ArgumentError(f"'{kind}' is nothing that can be begun{nearest(kind, KINDS)}.", "kind")
    if not _NAME.fullmatch(name):
        raise ArgumentError(
            f"'{name}' is no name of a {kind}; write small letters, digits and single underscores, beginning with a "
            "letter.",
            "name",
        )
    file = Path(f"{name}{KINDS[kind]}" if out is None else place_text(out, "out"))
    check_file(file, force=force, inputs=_read(recording))
    text = shipped_file(f"templates/{kind}{KINDS[kind]}").read_text("utf-8")
    if recording is not None:
        from cocorosim_ros.library.platform_for import with_the_parts_of

        if kind != "platform":
            raise ArgumentError(f"A {kind} does not follow from a recording; leave it out, or begin a platform.", "for")
        text = with_the_parts_of(text, recording)
    text = text.replace("NAME", name).replace("CLASS", class_name(name))
    write_text(file, text)
    return file


def _read(recording: Place | None) -> list[Path]:
    """What must not be replaced: the recording, where one is read."""
    from cocorosim_ros.wire.bags.bag_reader import recording_at

    return [] if recording is None else [recording_at(place_text(recording, "for"))]


def class_name(name: str) -> str:
    """What the class of a controller of that name is called."""
    return "".join(part.capitalize() for part in name.split("_"))
