"""Numbers that turn evidence into probabilities (`showing.probability`). They decide nothing else.

Those that say so were fitted by `prove.py weights` (test/trial/weights.py), which begins at what the counts of
docs/trial.json and the shares of the registered prior, test/concealer/prior.yaml, say. 66 recordings moved them little
(`prove.py sealed --warm --count 110 --parts main --seed-word probabilities-fitted`, the first 66). By cross-validation
they are worth little more than where it began: mean logarithm of the probability of what came true -0.571 for -0.577.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ProbabilityCriteria:
    """Weights of what a diagnosis may be wrong about; the weight of what it names is 1 (`showing.probability`)."""

    temper: float = 0.409
    """[1] share of the nats that counts. Evidence is too sure of itself, since no model is exactly the water's.
    Measured: fitted, from 0.5, a guess."""
    unnamed: float = 0.00979
    """[odds] that something without a name here explains what an effect was named for. Measured: fitted, from 0.01:
    one of 172 first names."""
    chance: float = 0.00983
    """[odds] that there is nothing where the first effect was named, however many nats it has. Measured: fitted, from
    0.01: one of 172 first names."""
    rest: float = 0.139
    """[odds] that there is nothing where a further effect was named: perhaps what the form of the first leaves over.
    Measured: fitted, from 0.15: seven of 46 further names."""
    law: float = 0.0496
    """[odds] that there is nothing where a law outside the catalogue was named first. Measured: fitted, from 0.05: one
    of 19."""
    rest_by_law: float = 0.6
    """[odds] that there is nothing where a law outside the catalogue was named beside a stronger effect. Measured:
    each was a rest; at its bound, so that what is confirmed stays more probable than not."""
    missing: float = 1.9
    """[odds] that the model lacks anything, before the recordings are looked at. Measured: fitted, from 0.65 to 0.35 of
    the registered prior."""
    further: float = 0.427
    """[odds] that the model lacks anything more, where something was named. Measured: fitted, from 0.15 to 0.35 of the
    registered prior."""
    outside: float = 0.0198
    """[odds] of a law outside the catalogue that no recording shows, against nothing, where nothing was named.
    Measured: fitted, from 0.02, a guess."""
    smallest: float = 0.05
    """[of a bad case] the smallest effects that are counted as such. Known of the registered prior."""
    stopped: float = 0.5
    """[probability] at most of a name that a hard stop or the control speaks against: even odds. Measured: of 24
    altered logs of real vehicles 12 were named rightly (docs/tampered.md)."""
    stopped_difference: float = 0.92
    """[probability] at most of a difference from recordings of --against that a hard stop or the control speaks
    against: what was altered in a vehicle's logs is told far better than what a platform's file lacks. Measured: 58 of
    62 such names of an earlier draw were what had been altered, with its number, one more of each added; of the last
    draw 26 of 26 (docs/against.json)."""
    least_told: float = 0.005
    """[probability] of a set of suspects that is told: what would be no percent is not. Chosen, not measured."""
    most_told: int = 6
    """[sets] of suspects that are told. Chosen, not measured."""
    most_sets: int = 512
    """[sets] that are kept while many effects are put together. Chosen, not measured."""


PROBABILITY = ProbabilityCriteria()
