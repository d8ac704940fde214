"""Fitted numbers with 95 % intervals, by the names of the contract."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import norm

from cocorosim_ros.diagnosis.catalogue.eddies import EDDY
from cocorosim_ros.diagnosis.catalogue.meaning import between
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.showing import ESTIMATES
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated, Rival, Tier
from cocorosim_ros.diagnosis.fitting.beside_noise import variances_beside_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, information
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Z95, Unknown
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.naming.single_thrusters import ONE_THRUSTER, alike_of, thruster_of
from cocorosim_ros.diagnosis.showing.form_width import variances_between_parts, variances_of_other_forms
from cocorosim_ros.diagnosis.showing.several_tests import holm
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL


@dataclass(frozen=True)
class Fitted:
    """One unknown with its fitted q and the standard deviation of q; felt: whether any reading depends on it."""

    unknown: Unknown
    q: float
    spread: float
    felt: bool = True

    @property
    def estimate(self) -> Estimate:
        """Value and 95 % interval, in the unit of the unknown.

        A difference that is added to a number is told as the number would be with it alone: a scale of 1.06, not 0.06.
        """
        return estimate(self.unknown, self.q, self.spread, self.unknown.owner.unit)

    @property
    def chance(self) -> float:
        """Probability of a q at least as far from 0 by chance: the p of a two-sided test.

        Both may err: the fit, and the number in the platform's file where that gives a 95 % interval.
        """
        return 2.0 * float(norm.sf(abs(self.q) / max(math.hypot(self.spread, self.unknown.stated), 1e-300)))


def fitted(fit: Fit) -> tuple[Fitted, ...]:
    """All unknowns of a fit but its noise, with standard deviations no less than ESTIMATES.numerical allows.

    Since a cause may follow another law, two variances are added (`form_width`): that between parts of the recordings,
    and that between laws of the kind.
    """
    values = np.array([unknown.value(float(q)) for unknown, q in zip(fit.unknowns, fit.q, strict=True)])
    slopes = np.array([unknown.slope(float(q)) for unknown, q in zip(fit.unknowns, fit.q, strict=True)])
    variance = variances_beside_noise(fit) + variances_between_parts(fit).between + variances_of_other_forms(fit)
    spread = np.hypot(np.sqrt(variance), ESTIMATES.numerical * np.abs(values / slopes))
    felt = np.any([np.any(slope, axis=0) for slope in information(fit).slopes], axis=0) | (
        np.abs(fit.q) > ESTIMATES.moved
    )
    return tuple(map(Fitted, fit.unknowns, fit.q.tolist(), spread.tolist(), felt.tolist()))


def estimate(unknown: Unknown, q: float, spread: float, unit: str) -> Estimate:
    """Value and 95 % interval of an unknown whose q has the standard deviation `spread`."""
    neutral = float(NEUTRAL[COLUMN[unknown.column]])
    value, *ends = (unknown.alone(place, neutral) for place in (q, q - Z95 * spread, q + Z95 * spread))
    bounds = [unknown.alone(place, neutral) for place in unknown.bounds]
    limits = _limits(unknown, min(bounds), max(bounds), neutral)
    return Estimate(
        value, min(ends), max(ends), unit, between(unknown.column), limits, at_limit=any(unknown.at_ends(q))
    )


def within_half_a_turn(angle: Estimate) -> Estimate:
    """Copy an angle [rad] that means the same a full turn further, with its value within half a turn of 0."""
    shift = math.remainder(angle.value, 2.0 * math.pi) - angle.value
    return replace(angle, value=angle.value + shift, low=angle.low + shift, high=angle.high + shift)


def _limits(unknown: Unknown, least: float, most: float, neutral: float) -> tuple[float, float]:
    """Limits of a number; of an effect's, no end at which the effect is absent: it is told as holding zero."""
    if unknown.owner.effect == PLATFORM:
        return least, most
    return -math.inf if least == neutral else least, math.inf if most == neutral else most


def recalibrated(numbers: Sequence[Fitted]) -> tuple[tuple[Recalibrated, ...], tuple[Recalibrated, ...]]:
    """All recalibrated numbers of the platforms among those of a fit, and those of them that have clearly moved.

    Clearly: by Holm's procedure over all of them.
    """
    own = [number for number in numbers if number.unknown.owner.effect == PLATFORM]
    every = tuple(
        Recalibrated(
            number.unknown.owner.parameter, number.unknown.value(0.0), number.estimate, number.unknown.owner.robots
        )
        for number in own
    )
    clear = holm([number.chance for number in own]) <= ESTIMATES.sure
    return every, tuple(each for each, moved in zip(every, clear, strict=True) if moved)


def found_effects(fit: Fit, named: Sequence[NamedEffect], numbers: Sequence[Fitted]) -> tuple[FoundEffect, ...]:
    """All named effects, the one with most evidence first; one for each robot where the numbers are the robot's own.

    numbers: those of the fit.
    """
    found = [
        _found(fit, effect, robots.names, [each for each in numbers if effect.candidate.owns(each.unknown)])
        for effect in named
        for robots in effect.candidate.sharers
    ]
    return tuple(sorted(found, key=lambda effect: -effect.nats))


def _found(fit: Fit, effect: NamedEffect, robots: tuple[str, ...], numbers: Sequence[Fitted]) -> FoundEffect:
    """One effect on robots that share its amplitudes; numbers: all unknowns of the effect, on other robots too.

    Numbers that no reading feels are left out, as the bias of an accelerometer that was not recorded.
    """
    entry = effect.candidate.entry
    mine = [each for each in numbers if each.felt and set(robots) <= set(each.unknown.owner.robots)]
    rivals = tuple(
        Rival(rival.candidate.entry.id, round(rival.behind, 2))
        for rival in effect.rivals
        if rival.candidate.entry.id != entry.id
    )
    if thruster := thruster_of(entry.id):
        rivals += tuple(Rival(f"{ONE_THRUSTER}:{name}", 0.0) for name in alike_of(fit.tracks)[thruster])
    sure = (
        effect.nats >= NAMING.threshold + ESTIMATES.beyond_threshold
        and effect.held_out.p < ESTIMATES.held_out_p
        and not rivals
    )
    name = entry.name_with({each.unknown.column: each.estimate.value for each in mine})
    if effect.candidate.known and not effect.candidate.over:
        name = f"{name}, other than in the platform's file"
    turning = {each.name for each in entry.shapes if each.periodic}
    every = {each.unknown.owner.parameter: each.estimate for each in mine}
    told = {name: within_half_a_turn(each) if name in turning else each for name, each in every.items()}
    tier: Tier = "confirmed" if sure else "suspected"
    return FoundEffect(
        entry.id, name, entry.shown_equation(told), robots, tier, told, effect.nats, rivals, entry.topic,
        held_out_nats=effect.held_out.total,
        settings=_settings(fit, effect),
        simulated_as=entry.law if entry.law and (entry.law == EDDY or effect.candidate.known) else "",
        law=entry.form,
    )  # fmt: skip


def _settings(fit: Fit, effect: NamedEffect) -> dict[str, float]:
    """Numbers of an effect that its entry fixes or that were chosen from a grid only, by the simulator's names."""
    entry = effect.candidate.entry
    columns = [*entry.fixed, *(shape.column for shape in entry.shapes if shape.fixed)]
    row = fit.rows[effect.candidate.everybody[0]]
    return {column.partition(".")[2]: float(row[COLUMN[column]]) for column in columns}
