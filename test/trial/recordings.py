"""Real recordings: logs of others converted to the contract, in groups that are diagnosed together."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path

from trial.examiner import COMMAND

_CLOCK = "%Y/%m/%d %H:%M:%S"  # of the ferry's logs
# Trials of the ferry, an hour apart and with another allocation of thrust each: where the parts of one begin, how long
# they are and how many. In the first it goes from place to place, in the other its thrusters push against each other;
# after two minutes that one only keeps its place (1 to 3 cm/s) and is left out.
NLP1 = ("nlp1", "2025/04/11 11:15:46", 123, 4)
MANEUVERING1 = ("maneuvering1", "2025/04/11 12:08:17", 60, 2)


@dataclass(frozen=True)
class Group:
    """Recordings of one vehicle that are diagnosed together."""

    name: str
    platform: str
    bags: tuple[Path, ...]


def converted(vehicle: str, source: Path, out: Path) -> list[Path]:
    """Recordings made of a folder of logs by `cocorosim convert`, sorted; made once."""
    if not out.exists():
        out.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(
            [str(COMMAND), "convert", vehicle, str(source), "--out", str(out)], check=True, stdout=subprocess.DEVNULL
        )
    return sorted(path for path in out.iterdir() if path.is_dir())


def chunks(bags: list[Path], size: int) -> Iterator[tuple[Path, ...]]:
    """So many at a time; what does not fill the last group is left out."""
    for first in range(0, len(bags) - size + 1, size):
        yield tuple(bags[first : first + size])


def hovercraft(data: Path, out: Path) -> list[Path]:
    """All runs of the hovercraft."""
    return converted("hovercraft_epfl", data / "hovercraft_epfl", out / "hovercraft_epfl")


def dives(data: Path, out: Path, kind: str) -> list[Path]:
    """Dives of the four-propeller vehicle: `reference` as it was built, or `runs_under_test`."""
    return converted("haizhe_auv", data / "haizhe_auv" / kind, out / f"haizhe_{kind}")


def minutes_in_the_pool(data: Path, out: Path) -> list[Path]:
    """The minutes of the AUV with eight thrusters."""
    return converted("tauv_pool", data / "tauv_pool", out / "tauv_pool")


def flights(data: Path, out: Path) -> list[Path]:
    """The flights of the blimp."""
    return converted("rgblimp", data / "rgblimp", out / "rgblimp")


def parts_of_a_mission(data: Path, out: Path) -> list[Path]:
    """The two parts of the glider's mission."""
    return converted("slocum_glider", data / "slocum_glider", out / "slocum_glider")


def zigzags(data: Path, out: Path) -> list[Path]:
    """Zigzags of the large tanker's model."""
    return converted("kvlcc2_hsva", data / "kvlcc2_hsva", out / "kvlcc2_hsva")


def pond(data: Path, out: Path, kind: str) -> list[Path]:
    """Drives of the small tanker's model on a pond: `zigzag`, `turning` or `random`."""
    return converted("esso_osaka", data / "esso_osaka" / kind, out / f"esso_osaka_{kind}")


def crossings(data: Path, out: Path, trial: str, first: str, seconds: int, count: int) -> list[Path]:
    """Parts of a trial of the ferry, so many seconds each, one after the other from `first` on its clock."""
    logs = out / f"milliampere_{trial}_logs"
    if not logs.exists():
        unfinished = logs.with_name(f"{logs.name}_unfinished")  # an interrupted cut is not taken for a whole one
        shutil.rmtree(unfinished, ignore_errors=True)
        start, length = datetime.strptime(first, _CLOCK), timedelta(seconds=seconds)
        for part in range(count):
            begin, end = ((start + k * length).strftime(_CLOCK) for k in (part, part + 1))
            folder = unfinished / f"{trial}_{part}"
            folder.mkdir(parents=True)
            for log in sorted((data / "milliampere_ferry" / trial).glob("*.csv")):
                lines = log.read_text("utf-8").splitlines(keepends=True)  # none, if nothing was logged
                mine = [row for row in lines[1:] if begin <= row[: len(begin)] < end]  # such dates are sorted as text
                (folder / log.name).write_text("".join([*lines[:1], *mine]), "utf-8")
        unfinished.rename(logs)
    return converted("milliampere_ferry", logs, out / f"milliampere_{trial}")
