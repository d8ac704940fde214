"""A map for a log that none is written for."""

from __future__ import annotations

import re
from pathlib import Path

from cocorosim_ros.diagnosis.guessing.guess import GuessedMap, guess_map
from cocorosim_ros.foundation.output_file import check_file, write_text
from cocorosim_ros.scenario.reading.arguments import Place, place_text


def guess(source: Place, out: Place, *, force: bool = False) -> GuessedMap:
    """Write the map that a log most probably needs, as `convert` reads it.

    source: a bag of ROS 1 or 2, a ULog, a CSV, Parquet, npz or MATLAB file, or a folder of such files. out: the map
    to write, a YAML file. Types, names, sizes and the motion itself decide; whatever nothing decides is in `doubts`,
    and in comments of the file.

    Returns the map with its streams and doubts. Raises CocorosimError if the log cannot be read or nothing in it is
    recognised, and if the file exists (without `force`) or cannot be written.

    Example: `guess("log.csv", "log.yaml").doubts`.
    """
    file, log = Path(place_text(out, "out")), Path(place_text(source, "source"))
    check_file(file, force=force, inputs=[log])
    found = guess_map(log, re.sub(r"\W+", "_", file.stem).strip("_") or "guessed")
    write_text(file, found.text)
    return found
