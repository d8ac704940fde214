"""Runs that leave a recording, in this process and without ROS."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.results import recording_metadata
from cocorosim_ros.graph.runs.run_record import RunRecord, Selection
from cocorosim_ros.graph.runs.scenery import Scenery
from cocorosim_ros.library.recording import Recording, read_recording
from cocorosim_ros.library.scenario import scenario_to_run
from cocorosim_ros.scenario.reading.arguments import Place, Seed, Time, place_text, whole_number
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.controllers.plain.plain_controller import rehearse_plain


def record(
    scenario: Place | Scenario,
    out: Place,
    *,
    seed: Seed | None = None,
    duration: Time | None = None,
    run: int = 0,
    force: bool = False,
) -> Recording:
    """Run a scenario and record it into the folder `out`: the bag of `cocorosim run --in-process`, byte for byte.

    scenario, seed, duration, run: as for `simulate`. out: a new folder; force: replace a recording that is there.

    Returns the recording. Raises CocorosimError for whatever is wrong with the scenario, if a controller is left to
    somebody else or cannot be made, if the folder exists (without `force`) or cannot be written, and if a motion runs
    away; then what was recorded until then stays.

    Example: `record("five_lilys", "bag", duration="60 s").tracks["lily_01"].yaw`.
    """
    number, folder = whole_number(run, "run", 0), Path(place_text(out, "out"))
    loaded = scenario_to_run(scenario, seed, duration)
    rehearse_plain(loaded.robots, loaded.seed, number)
    kept = new_record(loaded, folder, selection=loaded.recording.topics, force=force)
    with kept.writer:
        run_in_process(loaded, kept, run=number)
    return read_recording(folder)


def new_record(
    scenario: Scenario,
    folder: Path,
    *,
    made_by: Mapping[str, str] | None = None,
    selection: Selection = "all",
    force: bool = False,
) -> RunRecord:
    """A bag that says what makes it, for a run of this scenario to be written into.

    made_by: what its metadata say beside scenario, seed and versions. selection: which topics are recorded. Raises
    CocorosimError if the folder exists (without `force`) or cannot be written.
    """
    bodies = [describe_body(robot) for robot in scenario.robots]
    metadata = {**recording_metadata(scenario), **(made_by or {})}
    scenery = Scenery.of(scenario)
    return RunRecord(folder, bodies, metadata, selection=selection, scenery=scenery, force=force)
