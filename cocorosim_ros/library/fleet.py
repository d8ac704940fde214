"""Hundreds of recordings of a fleet, each diagnosed, resumable, and what they show together."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from cocorosim_ros.diagnosis.fleet.recordings import find_recordings
from cocorosim_ros.foundation.input_place import refuse_inputs
from cocorosim_ros.foundation.processors import processors
from cocorosim_ros.library.design import Watch
from cocorosim_ros.library.diagnose import inputs_of, model_of
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.arguments import Place, one_of, place_text, whole_number

if TYPE_CHECKING:
    from cocorosim_ros.diagnosis.fleet.outcome import Outcome
    from cocorosim_ros.diagnosis.fleet.work import Job
    from cocorosim_ros.library.fleet_result import FleetResult

_UNWATCHED = Watch()
_MOST_NAMES = 5
Calculate = Callable[[Sequence["Job"], Watch], Generator["Outcome", None, None]]


def diagnose_fleet(
    fleet: Place,
    platform: Place | Platform,
    out: Place,
    *,
    known: Place | Platform | None = None,
    workers: int | str | None = None,
    force: bool = False,
    watch: Watch = _UNWATCHED,
) -> FleetResult:
    """Diagnose every recording below a folder that is not in the folder `out` yet, and say what they show together.

    fleet: folder with recordings of robots of one platform, which is found below it at any depth; a robot's name is its
    namespace. platform, known: as for `diagnose`. out: folder of outcomes, `fleet.parquet` and `fleet.html`. workers:
    how many processes of this machine, one per processor if left out (a script has to call this below
    `if __name__ == "__main__":`), or the address of a Dask scheduler whose workers do it; they have to see the
    recordings at the same paths. force: start again instead of going on. watch: told how far it is, asked whether to go
    on; what is finished by then is kept.

    Returns table, drifts, groups and what is common. A recording that cannot be used is a row with a sentence, and so
    is one over which two processes have died. Raises CocorosimError if the folders cannot be used, if `out` holds
    outcomes of another fleet, platform or version (without `force`), and if workers keep dying.

    Example: `diagnose_fleet("bags/2026", "lily", "found/2026").to_frame().groupby("robot")["thrust_gain"].median()`.
    """
    one_of(watch, "watch", Watch)
    if workers is not None and not isinstance(workers, str):
        workers = whole_number(workers, "workers")
    model = model_of(platform, known)
    place, folder = Path(place_text(fleet, "fleet")), Path(place_text(out, "out"))
    refuse_inputs(folder, inputs_of((), platform, known))
    recordings = find_recordings(place.absolute())  # a worker elsewhere has another working folder
    # Loaded here: a path that is wrong is said before the weight comes.
    from cocorosim_ros.diagnosis.fleet.findings import fleet_findings
    from cocorosim_ros.diagnosis.fleet.rows import rows_of
    from cocorosim_ros.diagnosis.fleet.store import FleetStore, Order
    from cocorosim_ros.diagnosis.fleet.work import VERSION, Job
    from cocorosim_ros.library.fleet_result import FleetResult

    with _calculator(workers) as calculate:  # before the folder is made: a scheduler may not answer
        store = FleetStore(folder, Order(place, model, VERSION), force=force)
        there = store.found(recordings)
        outcomes = dict(there.outcomes)
        jobs = [Job(recording, model) for recording in recordings if recording.name not in outcomes]
        watch.progress(len(outcomes), len(recordings))
        with closing(calculate(jobs, watch)) as finished:
            for outcome in finished:
                store.add(outcome)
                outcomes[outcome.recording] = outcome
                watch.progress(len(outcomes), len(recordings))
    remarks = (*_resumed(there.changed, there.again, store.left_over(recordings)), *_deaths(outcomes.values()))
    found = fleet_findings(rows_of(outcomes.values()), len(recordings) - len(outcomes))
    result = FleetResult(model, place, folder, found, remarks)
    result.save()
    return result


def _resumed(changed: Sequence[str], again: Sequence[str], left_over: int) -> Iterator[str]:
    """Sentences on outcomes that were there and did not serve."""
    from cocorosim_ros.diagnosis.fleet.sentence import few

    if changed:
        yield f"{_many(len(changed))} changed since the last time, and diagnosed again: {few(changed, _MOST_NAMES)}."
    if again:
        yield f"{_many(len(again))} without a usable outcome the last time, and tried again: {few(again, _MOST_NAMES)}."
    if left_over:
        yield f"{left_over} outcomes are of recordings that are no longer there, and are left out."


def _deaths(outcomes: Iterable[Outcome]) -> Iterator[str]:
    """Sentences on recordings whose process died and that were diagnosed by another one."""
    for each in sorted(outcomes, key=lambda outcome: outcome.recording):
        if each.attempts > 1 and not each.again:
            yield f"The process that diagnosed {each.recording} {each.ended}; a second one has done it."


def _many(count: int) -> str:
    return "1 recording was" if count == 1 else f"{count} recordings were"


@contextmanager
def _calculator(workers: int | str | None) -> Iterator[Calculate]:
    """What diagnoses recordings, in processes of this machine or on a cluster."""
    if isinstance(workers, str):
        from cocorosim_ros.diagnosis.fleet.work import diagnose_recording, given_up
        from cocorosim_ros.study.experiments.on_dask import connected, work_on_dask

        instead = partial(given_up, why="the workers of the Dask cluster that had it died, perhaps for lack of memory")
        with connected(workers) as client:

            def far(jobs: Sequence[Job], watch: Watch) -> Generator[Outcome, None, None]:
                for _, outcome in work_on_dask(diagnose_recording, jobs, client, watch.going, instead):
                    yield outcome

            yield far
    else:
        yield lambda jobs, watch: _here(jobs, workers or processors(), watch)


def _here(jobs: Sequence[Job], workers: int, watch: Watch) -> Generator[Outcome, None, None]:
    from cocorosim_ros.diagnosis.fleet.processes import in_processes
    from cocorosim_ros.diagnosis.fleet.work import diagnose_recording, given_up

    with closing(in_processes(diagnose_recording, jobs, min(workers, len(jobs)), watch.going)) as finished:
        for done in finished:
            if done.result is None:
                told = f"each of the {done.attempts} processes that had it died (the last one {done.ended})"
                yield replace(given_up(done.job, told), attempts=done.attempts, ended=done.ended)
            else:
                yield replace(done.result, attempts=done.attempts, ended=done.ended)
