"""Thresholds of the naming: which candidates are fitted, which are named, which recordings cannot tell."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class SearchCriteria:
    """Limits of the search: candidates beyond them are not fitted, or not fitted further (`naming.naming`)."""

    worth_refining: float = 2.0
    """[nats of the screening] less is not worth a fit. Chosen, not measured."""
    hopeless: float = 0.1
    """[of the leader's nats] a candidate below does not become the leader by a fit. Chosen, not measured."""
    group_share: float = 0.1
    """[of the leader's nats] a candidate of a leader's group is refined above it. Chosen, not measured."""
    promising: float = 0.5
    """[of the leader's nats with noise held] a candidate below, and `close`, is fitted later. Chosen, not measured."""
    close: float = 20.0
    """[nats] a candidate so far behind the leader, and below `promising`, is fitted later. Chosen, not measured."""
    kept: float = 0.01
    """[of the screening's nats] a fit that finds less shows a slope at a kink, which no model reaches. Chosen, not
    measured."""
    leaders: int = 4
    """[candidates] that are refined as leaders: each costs a fit. Chosen, not measured."""
    most_refined: int = 8
    """[candidates] that are refined in a round, leaders and their groups: each costs a fit. Chosen, not measured."""
    overlooked: int = 2
    """[candidates] of little evidence that are begun because their free runs promise most: each costs a fit. Chosen,
    not measured."""
    most_rounds: int = 16
    """[rounds] of the search at most, each of which adds one effect that earns its place: a stop for a search that adds
    and takes back the same. Chosen, not measured."""
    pruned_from: int = 4
    """[effects] from which on every addition is followed by a look at which of the earlier ones it has made
    superfluous; before, a look at the end suffices. Chosen, not measured."""
    settling: int = 4
    """[turns of noise and laws] after each addition. Measured: in one sealed recording an unfinished fit was taken for
    the next effect; the number of turns was chosen."""
    last_steps: float = 3.0
    """[nats] from which a candidate is worth the last steps of its noise. Chosen, not measured."""
    most_turns: int = 6
    """[turns] of noise and numbers at the end of a candidate's fit, while each gains as much. Chosen, not measured: of
    a current of 1,680 nats one turn left 175, so that a form with more numbers seemed better."""


@dataclass(frozen=True)
class PairLawCriteria:
    """Laws of two regressors, of which there are a thousand (`naming.promising_laws`)."""

    part: float = 10.0
    """[s, of a Lily; see slowness] parts of a recording in which what is left of the force is compared with a
    law: longer than a random force remembers, so that parts scatter by themselves. Chosen, not measured."""
    fewest_parts: int = 8
    """[parts] whose scatter tells something. Chosen, not measured."""
    spare: float = 2.0
    """[times the fewest parts] that fit into all recordings together, since what is left over at their ends is no part
    of its own. Chosen, not measured."""
    clear: float = 2.5
    """[standard deviations] from which a law is screened: of a thousand laws that are not there, about twelve are.
    Reckoned from the normal distribution."""
    most: int = 48
    """[laws] that are screened at most, each of which costs a slope. Chosen, not measured."""
    lead: float = 1.5
    """[of the nats of the best entry of the catalogue] that a law of so many needs to be asked beside it: an effect
    whose form is not quite that of the catalogue has the greater part of them still. Chosen, not measured."""


@dataclass(frozen=True)
class NamingCriteria:
    """Evidence that an effect needs to be named (`naming.naming`)."""

    threshold: float = 7.0 + math.log(40 / 14)
    """[nats] of every effect: 7 for a catalogue of 14 entries, more for one of 40. Chosen; measured: one false alarm in
    106 recordings of the sealed trial with nothing hidden (`docs/trial.md`)."""
    ambiguity: float = 3.0
    """[nats] rivals so close are named too: odds of 20 to 1. Chosen; measured: the truth was among those named in
    119 of 119 cases of the sealed trial (`docs/trial.md`)."""
    checked: float = 60.0
    """[nats] below, evidence is compared with a model without the effect that was fitted anew. Chosen, not measured."""
    least_share: float = 0.01
    """[of large] smaller amplitudes may come from the filter's steps, however exact readings are. Measured: the
    smallest of 269 effects named in 575 sealed recordings had 0.03."""
    form_share: float = 0.025
    """[of an effect's nats] that may be left over because its law is not quite the water's. Chosen, not measured."""
    group_share: float = 0.1
    """[of an effect's nats] the same for an entry that is confused with the effect. Known of two draws of the families,
    which are no longer sealed: beside another form of what was concealed, entries of its group had 4, 6, 7, 8, 11
    and 47 % of its nats; one that was there had 5 %."""
    law_rest: float = 0.1
    """[of an effect's nats] the same for laws outside the catalogue, which fill what any form leaves. Chosen, not
    measured."""
    declared_off: float = 0.3
    """[of a number of the platform's file] standard deviation of its error, where the file holds it. Chosen, not
    measured: published added masses of one small vehicle differ by as much."""
    law_form: float = 0.4
    """[of an effect's nats] below which a law that changes the readings much as the effect does is another form of it,
    and below which a law, or an entry that is confused with it, is a rest of an effect that was found before. Known of
    a sealed recording: beside drag that saturates, the cube of a speed explained 0.29 of what its square did. Chosen
    above that."""
    alike: float = 0.5
    """[squared cosine] of slopes from which a law changes the readings much as an effect does. Chosen, not measured."""
    law_share: float = 0.4
    """[of a motion's nats] the same for laws of readings, which follow effects of motion; and for errors of readings
    beside a motion that free runs refused a name. Chosen, not measured."""
    stands_for: float = 0.1
    """[of a leader's nats] that an effect needs to take its place because it foretells better: one that explains less
    is another effect, and no other name of the same. Known of a vehicle in a tank: the dead band of its thrusters
    explained 49 nats, linear drag, which stood in for it, 321. Chosen between these 15 % and 2 %, of a blimp."""
    nameless: float = 24.0
    """[nats] from which something is missing although free runs do not gain by the effect that explains it best, and
    from which a force that is left over is told: three times what a name needs. Chosen, not measured."""
    law_margin: float = 3.0
    """[nats] by which a law outside the catalogue has to beat it: there are many laws. Chosen, not measured."""


@dataclass(frozen=True)
class FactorCriteria:
    """Sizes of factors and trims of actuators, and commands that show those of a single one (`naming`)."""

    large: float = 0.3
    """[logarithm] of a number in a bad case: a third more or less. Chosen, not measured."""
    bounds: tuple[float, float] = (-10.0, 5.0)
    """[of `large`] a factor of a twentieth, a dead thruster nearly, up to four and a half. Chosen, not measured."""
    most_alone: float = 1.35
    """[of `large`] a factor of one and a half, beyond which one thruster is not stronger than all the others of a
    vehicle. Chosen, not measured: a ferry's halves asked for 1.8, 2.1 and 1.7 of three different ones."""
    large_trim: float = 0.05
    """[rad] of a rudder or fin that stands askew in a bad case: three degrees. Chosen, not measured."""
    alone: float = 0.05
    """[of its rms] a thruster's command that the others do not share, so that its own gain shows. Chosen, not
    measured."""


@dataclass(frozen=True)
class DetectabilityCriteria:
    """Limits below which a recording shows too little of the catalogue (`naming.detectability`)."""

    medium: float = 0.5
    """[of large] size of an effect that a recording should show. Chosen, not measured."""
    most: float = 100.0
    """[of large] no vehicle is so much worse than in a bad case. Chosen, not measured."""
    blind: float = 0.45
    """[share of the catalogue] that is not shown, beyond which silence tells nothing. Chosen, not measured."""


@dataclass(frozen=True)
class PumpCriteria:
    """Movements of the pump that tell of the pump and not of the water (`naming.quiet_pump`)."""

    memory: float = 5.0
    """[s, of a Lily; see slowness] for which a movement of the pump tells of it. Chosen, not measured."""
    loud: float = 20.0
    """[rms of the random force] a larger change of force is no answer to the water. Chosen, not measured."""


@dataclass(frozen=True)
class SwingCriteria:
    """Periods and changes of a residual force that are worth a candidate (`naming.residual`)."""

    swings: float = 1.5
    """[periods] that a recording has to hold, so that a trend is no swing. Chosen, not measured."""
    shortest_period: float = 2.0
    """[s] faster swings of a force are no candidates: commands change as fast. Chosen, not measured."""
    shortest_current: float = 5.0
    """[s, of a Lily; see slowness] faster swings of a current are no candidates: a force that swings moves a vehicle as
    they do, and water that goes to and fro so fast is a wave. Chosen, not measured."""
    wave_periods: tuple[float, float] = (1.0, 20.0)
    """[s] of waves: shorter ones are short beside a hull, longer ones are swell that no tank and no harbour has.
    Chosen, not measured."""
    wave_stands_out: float = 12.0
    """[medians of the power around it] a peak of the residual's spectrum has to have for waves to be looked for. Power
    at random is exponential, so that one of 2^12 frequencies has as much. Chosen, not measured: what could be named
    has more than 18."""
    wave_around: int = 40
    """[of the frequency that a recording resolves] over which that median is taken. Chosen, not measured."""
    readings: float = 4.0
    """[steps of the grid] a swing or a wave has to last. Chosen, not measured."""
    finer: int = 4
    """[frequencies] of a spectrum for each that the longest recording resolves. Chosen, not measured."""
    most_waves: int = 2
    """[periods] of waves that become candidates, the strongest first: each costs slopes in all directions. Chosen, not
    measured."""
    steady: float = 15.0
    """[s, of a Lily; see slowness] before and after a change of the force that are compared. Chosen, not
    measured."""
    most_periods: int = 3
    """[periods] of a force that become candidates, the strongest first: each costs a slope. Chosen, not measured."""
    most_changes: int = 3
    """[moments] of a change that become candidates, the clearest first: each costs a slope. Chosen, not measured."""
    least_extent: float = 0.05
    """[m] along each axis of the water in which candidates have their places. Chosen, not measured."""
    least_force: float = 1e-9
    """[N, N m] of a direction without actuators, so that nothing is divided by zero. Chosen, not measured."""


SEARCH = SearchCriteria()
PAIR_LAWS = PairLawCriteria()
NAMING = NamingCriteria()
FACTORS = FactorCriteria()
DETECTABILITY = DetectabilityCriteria()
PUMP = PumpCriteria()
SWINGS = SwingCriteria()
