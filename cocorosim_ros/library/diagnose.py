"""Where recordings and the model of a platform disagree, why, and a model that does not."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.foundation.input_place import refuse_inputs
from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.known_effects import knowing
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.reading.arguments import Place, function, place_text
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.bags.bag_reader import check_there, recording_at

if TYPE_CHECKING:
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult
    from cocorosim_ros.library.recording import Recording

    Source = Place | Recording
Progress = Callable[[str, float], None]


def diagnose(
    bags: Source | Sequence[Source],
    platform: Place | Platform,
    *,
    known: Place | Platform | None = None,
    against: Source | Sequence[Source] | None = None,
    out: Place | None = None,
    force: bool = False,
    progress: Progress = lambda words, share: None,
) -> DiagnosisResult:
    """Compare recordings of robots of one platform with what the simulator makes of the commands.

    bags: one recording or several, as paths or as records of `read_recording`. platform: a name in config/platforms, a
    file (a model.yaml too), or a record of `load_platform`. known: a platform whose effects, axes and units are taken
    as given. against: recordings of the same vehicle when it was well; only what differs from these is named. out:
    folder for the files, written as `save` does; whether it may be written is asked first.
    progress(words, share): told what is being done, and the share (0..1) that is done.

    Returns verdict, effects with intervals, moved numbers, and the texts of all files. Raises CocorosimError if the
    folder holds a diagnosis already (without `force`), or a recording or platform cannot be used; one that merely says
    too little gets the verdict 'insufficient'. Takes from seconds to minutes, the first time a minute more.

    Example: `diagnose("tank_bag", "lily").to_frame()`.
    """
    from cocorosim_ros.diagnosis.report.output_folder import check_folder

    function(progress, "progress")
    if out is not None:
        check_folder(Path(place_text(out, "out")), force=force)
    model = model_of(platform, known)
    judged, well = _paths(bags, "bags"), [] if against is None else _paths(against, "against")
    if out is not None:
        refuse_inputs(Path(place_text(out, "out")), inputs_of((*judged, *well), platform, known))
    # Loaded here: a path that is wrong is said before the weight comes.
    from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult

    progress("reading", 0.0)
    whole = gather_evidence([*judged, *well], model)
    evidence = replace(whole, recordings=whole.recordings[: len(judged)])
    # Loaded here: recordings that cannot be used are refused before the filter is.
    if well:
        from cocorosim_ros.diagnosis.diagnose_against import diagnose_against

        found = diagnose_against(evidence, replace(whole, recordings=whole.recordings[len(judged) :]), progress)
    else:
        from cocorosim_ros.diagnosis.diagnose import diagnose as diagnose_evidence

        found = diagnose_evidence(evidence, progress)
    result = DiagnosisResult(found, evidence)
    if out is not None:
        progress("writing", 1.0)
        result.save(out, force=force)
    return result


def inputs_of(bags: Sequence[Path], platform: Place | Platform, known: Place | Platform | None) -> list[Path]:
    """The files and folders that a diagnosis reads, which its results must not replace."""
    files = [each for each in (platform, known) if each is not None and not isinstance(each, Platform)]
    return [*map(recording_at, bags), *(find_config("platforms", place_text(file, "platform")) for file in files)]


def model_of(platform: Place | Platform, known: Place | Platform | None) -> Platform:
    """The platform that recordings are compared with, in four degrees of freedom, with what is taken as known.

    Raises CocorosimError.
    """
    model = in_four_degrees(_platform(platform, "platform"))
    return model if known is None else knowing(model, _platform(known, "known"))


def _platform(platform: Place | Platform, name: str) -> Platform:
    return platform if isinstance(platform, Platform) else load_platform(place_text(platform, name))


def _paths(bags: Source | Sequence[Source], name: str) -> list[Path]:
    several = list(bags) if isinstance(bags, Sequence) and not isinstance(bags, str) else [bags]
    if not several:
        raise ArgumentError(f"The argument '{name}' has no recording; give one at least.", name)
    return [_path(bag, name) for bag in several]


def _path(bag: object, name: str) -> Path:
    if isinstance(bag, str | PathLike):
        return check_there(place_text(bag, name))
    from cocorosim_ros.library.recording import Recording

    return bag.path if isinstance(bag, Recording) else Path(place_text(bag, name))
