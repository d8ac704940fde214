"""The model that a diagnosis arrives at, as a platform file: refitted parameters and the effects that were missing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.report.effect_keys import (
    fixed_numbers,
    parameters_beside,
    platform_effect,
    platform_parameters,
    section_of,
    unit_in_file,
)
from cocorosim_ros.diagnosis.report.effects_in_words import effects_in_words
from cocorosim_ros.diagnosis.report.platform_file import tree_of_file, tree_to_change
from cocorosim_ros.diagnosis.report.words import parameter_unit
from cocorosim_ros.scenario.parts.effect_quantities import Effects
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.law_text import LawText
from cocorosim_ros.scenario.reading.ranges import Range
from cocorosim_ros.scenario.reading.sourced_platform import fitted_number
from cocorosim_ros.scenario.reading.yaml_file import yaml_text
from cocorosim_ros.world.effects.anisotropic_drag import REPLACING
from cocorosim_ros.world.vehicle_model.platform_effects import turning_gain

Tree = dict[str, Any]
ACTUATORS = "actuators"
TURNING_GAIN = "yaw_torque_gain"
PLATFORM_KEYS = {"inertia": "yaw_inertia"}
"""Keys of the platform file that are called otherwise than the parameters of a diagnosis."""


@dataclass(frozen=True)
class Origin:
    """Origin of a model: the diagnosed platform, the recordings, the robots in them.

    duration: of the longest recording [s].
    """

    platform: Platform
    recordings: tuple[str, ...]
    robots: tuple[str, ...]
    duration: float

    @property
    def source(self) -> str:
        """The source that the file gives for the numbers that were found."""
        return f"diagnosis of {', '.join(Path(recording).name for recording in self.recordings)}"


def model_yaml(diagnosis: Diagnosis, origin: Origin) -> str:
    """The text of the platform file, which `load_platform` reads."""
    return yaml_text(model_tree(diagnosis, origin))


def model_tree(diagnosis: Diagnosis, origin: Origin) -> Tree:
    """The platform file as nested plain values.

    Numbers of every robot of the recordings stand at the top; numbers of some robots alone stand below `robots`, by
    name. Where each robot has a number of its own, the top holds the mean.
    """
    platform = origin.platform
    tree = tree_to_change(platform)
    tree |= {"name": platform.name, "description": f"{platform.description}; {origin.source}"}
    robots: dict[str, Tree] = {name: dict(part) for name, part in tree.pop("robots", {}).items()}
    for name, own in platform.robots.items():
        if own.effect_quantities != platform.effect_quantities:
            written = robots.get(name, {}).get("effects", {})
            robots.setdefault(name, {})["effects"] = _known_effects(own.effect_quantities, written)
        if own.frame_corrections != platform.frame_corrections:
            robots.setdefault(name, {})["frame_corrections"] = dict(own.frame_corrections)
    tree["effects"] = _known_effects(platform.effect_quantities, tree_of_file(platform).get("effects", {}))
    if platform.frame_corrections:
        tree["frame_corrections"] = dict(platform.frame_corrections)
    if not _is_untold(diagnosis):
        tree |= _chosen(diagnosis, origin)
    numbers = _written(diagnosis)
    _put_parameters([each for each in numbers if "." not in each.parameter], origin, tree, robots)
    _put_declared([each for each in numbers if "." in each.parameter], origin, tree, robots)
    _put_effects(diagnosis.effects, origin, tree, robots)
    for part in (tree, *robots.values()):
        if "effects" in part:
            part["effects"] = effects_in_words(part["effects"])
    return tree | {"robots": robots} if robots else tree


def _written(diagnosis: Diagnosis) -> Sequence[Recalibrated]:
    """Choose the fitted numbers that a model is given; none of recordings that cannot tell, without sound ones.

    Sound: one has clearly moved, and the fit has not collapsed. Others foretell by chance: of half of a ferry's trial
    they made headings three times worse.
    """
    return () if _is_untold(diagnosis) else diagnosis.all_recalibrated or diagnosis.recalibrated


def _is_untold(diagnosis: Diagnosis) -> bool:
    """Tell whether recordings say nothing that a model could be given, so that the file is the platform as given."""
    is_sound = bool(diagnosis.recalibrated) and not collapsed_channels(diagnosis.fit)
    blind = diagnosis.verdict == "insufficient" and diagnosis.against is None
    return blind and not (diagnosis.effects or is_sound)


def _chosen(diagnosis: Diagnosis, origin: Origin) -> Tree:
    """Keys for what the diagnosis has chosen: form of the drag, step by which numbers were found, those not fitted."""
    if diagnosis.step is None:
        return {}
    chosen = _drag_form(diagnosis, origin.platform) | {"fitted_step": _derived(diagnosis.step, "s", origin)}
    kept = dict.fromkeys((*(origin.platform.kept_as_given or ()), *map(_key_of, diagnosis.held)))
    return chosen | {"kept_as_given": list(kept)} if kept else chosen


def _key_of(parameter: str) -> str:
    """The key of the platform's file of a number, by the name that a diagnosis gives it."""
    is_of_effect = "." in parameter and not parameter.startswith(f"{ACTUATORS}.")
    return f"effects.{parameter}" if is_of_effect else PLATFORM_KEYS.get(parameter, parameter)


def _drag_form(diagnosis: Diagnosis, platform: Platform) -> Tree:
    """Key for the form of drag by which the numbers were found, where the platform's file does not say one.

    The numbers hold in that form alone; a diagnosis with this file that chose another would move them all.
    """
    everybody = (platform, *platform.robots.values())
    replaced = any(each.effects.get("anisotropic_drag", {}).get("form") in REPLACING for each in everybody)
    if replaced or any(each.drag_form is not None for each in everybody):
        return {}
    return {"drag_form": diagnosis.drag_form or "total_speed"}


def _derived(value: float, unit: str, origin: Origin) -> Tree:
    return {"value": value, "unit": unit, "source": origin.source, "confidence": "derived"}


def _put_parameters(found: Sequence[Recalibrated], origin: Origin, tree: Tree, robots: dict[str, Tree]) -> None:
    for parameter in dict.fromkeys(each.parameter for each in found):
        key = PLATFORM_KEYS.get(parameter, parameter)
        values = [each for each in found if each.parameter == parameter]
        for each in values:
            number = _ranged(_number(each.estimate, origin.source), origin.platform.ranges.get(key))
            everywhere = [tree, *(part for part in robots.values() if key in part)]
            for target in everywhere if _of_all(each.robots, origin) else _own(each.robots, robots):
                target[key] = number
        covered = {robot for each in values for robot in each.robots}
        if len(values) > 1 and covered >= set(origin.robots):
            mean = _mean([each.estimate for each in values])
            number = _number(mean, f"{origin.source}, mean of {len(values)} robots")
            tree[key] = _ranged(number, origin.platform.ranges.get(key))
    if not any(each.parameter == TURNING_GAIN for each in found):
        _keep_turning_gain(origin.platform, tree, robots)


def _keep_turning_gain(platform: Platform, tree: Tree, robots: dict[str, Tree]) -> None:
    """Write the gain of turning thrusters as it was, for which a file without it takes that of pushing ones."""
    for name, part in (("", tree), *robots.items()):
        if "thrust_gain" in part and TURNING_GAIN not in part:
            kept = turning_gain(platform.robots.get(name, platform))
            part[TURNING_GAIN] = {"value": kept, "unit": "1", "source": "taken as known", "confidence": "derived"}


def _put_declared(found: Sequence[Recalibrated], origin: Origin, tree: Tree, robots: dict[str, Tree]) -> None:
    """Write numbers of effects that the platform's file gives with a range, and which were fitted within it."""
    of_actuators = [each for each in found if each.parameter.startswith(f"{ACTUATORS}.")]
    _put_of_actuators(of_actuators, origin, tree, robots)
    for each in found:
        if each in of_actuators:
            continue
        effect, _, name = each.parameter.partition(".")
        everywhere = [tree, *(part for part in robots.values() if "effects" in part)]
        for target in everywhere if _of_all(each.robots, origin) else _own(each.robots, robots):
            known: Tree = target["effects"] if "effects" in target else tree["effects"]
            number = _ranged(
                _number(each.estimate, origin.source), origin.platform.ranges.get(f"effects.{each.parameter}")
            )
            numbers = known.get(effect, {}) | {name: number}
            target["effects"] = known | {effect: numbers}


def _put_of_actuators(found: Sequence[Recalibrated], origin: Origin, tree: Tree, robots: dict[str, Tree]) -> None:
    """Write numbers of single actuators into the list of all of them, which replaces the one of a file that ships."""
    if not found:
        return
    whole = tree_of_file(origin.platform)
    for each in found:
        _, actuator, name = each.parameter.split(".", 2)
        number = _ranged(_number(each.estimate, origin.source), origin.platform.ranges.get(each.parameter))
        everywhere = [tree, *(part for part in robots.values() if ACTUATORS in part)]
        for target in everywhere if _of_all(each.robots, origin) else _own(each.robots, robots):
            known: list[Tree] = target.get(ACTUATORS) or tree.get(ACTUATORS) or whole[ACTUATORS]
            target[ACTUATORS] = [part | {name: number} if part["name"] == actuator else part for part in known]


def _put_effects(found: Sequence[FoundEffect], origin: Origin, tree: Tree, robots: dict[str, Tree]) -> None:
    shared = [each for each in found if _of_all(each.robots, origin)]
    for each in shared:
        key = section_of(each)
        # A robot's own section replaces the common one, so it must hold the common effects too.
        for part in [tree, *(part for part in robots.values() if key in part)]:
            part[key] = _with_effect(part.get(key, {}), each, origin)
    own = [each for each in found if each not in shared]
    for each in own:
        key = section_of(each)
        for part in _own(each.robots, robots):
            known = part[key] if key in part else tree.get(key, {})
            part[key] = _with_effect(known, each, origin)
    # Last, so that no robot with numbers of its own takes over the mean.
    for identity in dict.fromkeys((each.id, each.topic) for each in own):
        alike = [each for each in own if (each.id, each.topic) == identity and each.correction is None]
        if alike and {robot for each in alike for robot in each.robots} >= set(origin.robots):
            mean = replace(alike[0], parameters=_mean_parameters(alike))
            tree["effects"] = _with_effect(tree["effects"], mean, origin)


def _mean_parameters(alike: Sequence[FoundEffect]) -> dict[str, Estimate]:
    return {name: _mean([each.parameters[name] for each in alike]) for name in alike[0].parameters}


def _with_effect(known: Tree, found: FoundEffect, origin: Origin) -> Tree:
    """A copy of the section of a platform file that an effect belongs to, with the effect."""
    if found.correction is not None:
        topic = found.topic or "pose"
        before = [words for words in known.get(topic, "").split("; ") if words and words != found.correction]
        return known | {topic: "; ".join([*before, found.correction])}
    name = platform_effect(found, known)
    numbers = {key: _number(estimate, origin.source) for key, estimate in platform_parameters(found).items()}
    for key, value in fixed_numbers(found, origin.duration).items():
        numbers[key] = _derived(value, unit_in_file(parameter_unit(name, key)), origin)
    found_beside = {
        effect: known.get(effect, {}) | {key: _number(each, origin.source) for key, each in parameters.items()}
        for effect, parameters in parameters_beside(found).items()
    }
    return known | found_beside | {name: known.get(name, {}) | numbers}


def _known_effects(effects: Effects, written: Tree) -> Tree:
    """The effects that the diagnosis took as known, with the source from their file where the file gives one."""
    known: Tree = {}
    for effect, parameters in effects.items():
        known[effect] = {}
        for name, part in parameters.items():
            own = written.get(effect, {}).get(name)
            stated: Tree = {"source": "taken as known"}
            if isinstance(part, LawText):
                stated |= {"value": part.text}
            else:
                stated |= {"value": part.value, "unit": part.unit}
            known[effect][name] = own if own is not None else stated
    return known


def _of_all(robots: tuple[str, ...], origin: Origin) -> bool:
    return set(robots or origin.robots) >= set(origin.robots)


def _own(names: Sequence[str], robots: dict[str, Tree]) -> list[Tree]:
    return [robots.setdefault(name, {}) for name in names]


def _number(estimate: Estimate, source: str) -> Tree:
    return fitted_number(estimate.value, unit_in_file(estimate.unit), (estimate.low, estimate.high), source)


def _ranged(number: Tree, given: Range | None) -> Tree:
    """The number with the range of the platform's file, so that the next diagnosis with the model keeps to it too."""
    if given is None:
        return number
    value = number["value"]
    return number | {"range": [min(given.low, value), max(given.high, value)]}


def _mean(estimates: Sequence[Estimate]) -> Estimate:
    """The mean weighted by precision; every estimate counts alike if one has no width."""
    widths = [each.high - each.low for each in estimates]
    certain = all(math.isfinite(width) and width > 0 for width in widths)
    weights = [width**-2 if certain else 1.0 for width in widths]
    total = sum(weights)
    value = sum(weight * each.value for weight, each in zip(weights, estimates, strict=True)) / total
    half = total**-0.5 / 2 if certain else math.nan
    return Estimate(value, value - half, value + half, estimates[0].unit)
