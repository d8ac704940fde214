"""One recording of a fleet diagnosed: the work of a process, here or on a cluster."""

from __future__ import annotations

import hashlib
import time
import traceback
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from cocorosim_ros import __version__
from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.diagnosis.fleet.dating import dated
from cocorosim_ros.diagnosis.fleet.outcome import Outcome
from cocorosim_ros.diagnosis.fleet.recordings import FleetRecording
from cocorosim_ros.diagnosis.report.json_file import diagnosis_tree
from cocorosim_ros.foundation.compiling.cache import TOOLS
from cocorosim_ros.foundation.compiling.sources import PACKAGE, digest_of, sources_of
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.wire.bags.bag_reader import read_bag

# Taken when the code is loaded: a source that is edited while a fleet is diagnosed changes nothing of what runs.
VERSION = f"{__version__}+{digest_of(sources_of(Path(__file__), PACKAGE), *TOOLS)}"
"""Version of the package, and digest of the sources that decide a diagnosis."""


@dataclass(frozen=True)
class Job:
    """A recording, and the platform of its robots."""

    recording: FleetRecording
    platform: Platform


def diagnose_recording(job: Job) -> Outcome:
    """Diagnose a recording; whatever is wrong with it becomes a sentence, so that the others go on."""
    begun, worked = time.perf_counter(), time.process_time()
    outcome = Outcome(job.recording.name, job.recording.files, version=VERSION)
    path = job.recording.path
    try:
        outcome = replace(outcome, found=found_in(job))
    except CocorosimError as error:
        # What the system refused, such as a file that may not be read, may go well the next time, with the same file.
        outcome = replace(outcome, problem=str(error), again=isinstance(error.__cause__, OSError))
    except MemoryError:
        told = f"{path} needs more memory than there is; give fewer processes with --workers, and the same again."
        outcome = replace(outcome, problem=told, again=True)
    except OSError as error:
        told = f"{path} cannot be read: {error.strerror}; make it readable, or remove it."
        outcome = replace(outcome, problem=told, again=True)
    except Exception as error:  # of this program itself: one recording must not end the work on all others
        outcome = replace(outcome, problem=_own_error(path, error), trace=traceback.format_exc())
    clock, processor = time.perf_counter() - begun, time.process_time() - worked
    return replace(outcome, seconds=round(clock, 3), processor_seconds=round(processor, 3))


def found_in(job: Job) -> dict[str, Any]:
    """Diagnose a recording, and give what is to be kept of it, as plain values.

    `diagnosis`: the content of diagnosis.json. `numbers`: all fitted numbers of the platform, also those that have not
    moved. `start_ns` and `dated_by`: when it was made. `sha256`: of its files. Raises CocorosimError if the recording
    cannot be used.
    """
    path = job.recording.path
    if path.exists() and not (path.is_file() or path.is_dir()):  # reading it would wait for ever
        raise CocorosimError(f"{path} is a pipe or a device and no file; take it out of the fleet.")
    evidence = gather_evidence([path], job.platform)
    (log,) = evidence.recordings
    found = diagnose(evidence, lambda words, share: None)
    when = dated(log.robots[0].clock.start_ns, read_bag(path).summary.start_ns, job.recording.name)
    return {
        "robots": [robot.name for robot in log.robots],
        "start_ns": when.start_ns,
        "dated_by": when.by,
        "duration": log.duration,
        "sha256": _digest(job.recording),
        "sentence": found.sentence,
        "diagnosis": diagnosis_tree(found),
        "numbers": diagnosis_tree(replace(found, recalibrated=found.all_recalibrated))["recalibrated"],
        "remarks": [*found.reasons, *found.remarks],
    }


def given_up(job: Job, why: str) -> Outcome:
    """Say of a recording that no process has lived to diagnose it; the same command tries it again."""
    told = (
        f"{job.recording.path} was given up: {why}; give workers more memory, or fewer of them with --workers, and the "
        "same command again."
    )
    return Outcome(job.recording.name, job.recording.files, told, again=True, version=VERSION)


def _digest(recording: FleetRecording) -> str:
    """SHA-256 of the recording's data files, by which a copy under another name is known."""
    digest = hashlib.sha256()
    base = recording.path.parents[len(Path(recording.name).parts) - 1]
    data = [file.name for file in recording.files if not file.name.endswith(".yaml")]  # metadata has file names in it
    for name in data:
        with (base / name).open("rb") as stream:
            digest.update(hashlib.file_digest(stream, "sha256").digest())
    return digest.hexdigest()


def _own_error(path: Path, error: Exception) -> str:
    words = " ".join(f"{type(error).__name__}: {error}".split())
    return (
        f"{path} met an error of the program itself ({words}); its trace lies in the recording's outcome: report it, "
        "and take the recording out of the fleet meanwhile."
    )
