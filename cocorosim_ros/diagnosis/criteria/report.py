"""Thresholds of the report: what a sentence, a table or a picture leaves out."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ReportCriteria:
    """Limits from which a number is worth a bar, an interval, a mark or a clause (`report`)."""

    least_nats: float = 0.1
    """[nats] of an effect alone; less gets no bar. Chosen, not measured."""
    most_laws: int = 3
    """[laws] outside the catalogue with bars beside those that were found: many explain alike. Chosen, not measured."""
    fewest_visits: int = 3
    """[visits] of a class of a picture, below which its mean has no interval. Chosen, not measured."""
    clear_gain: float = 0.95
    """[of the error without the effects] an error below is a gain worth a clause. Chosen, not measured."""
    clearly_best: float = 0.9
    """[of the next smallest error] an error below is set in bold. Chosen, not measured."""
    along_axis: float = 0.3
    """[of a thruster's force] a share along an axis, from which a manoeuvre uses it there. Chosen, not measured."""
    fewest_samples: int = 8
    """[samples] of a cell of the map of places; cells with fewer stay empty. Chosen, not measured."""
    most_sets: int = 4
    """[sets of suspects] whose probability is told in a sentence. Chosen, not measured: ten sets, as a hovercraft had,
    are a paragraph."""
    most_robots: int = 3
    """[robots] with pictures of their own. Chosen, not measured."""
    most_located: int = 3
    """[findings] of a robot with a picture of the residual against the regressor. Chosen, not measured."""
    most_free_runs: int = 3
    """[stretches] that are drawn. Chosen, not measured."""
    most_readings: int = 4
    """[streams] that are drawn. Chosen, not measured."""
    most_dots: int = 600
    """[dots] of a cloud, about: more make the page slow and no clearer. Chosen, not measured."""
    most_points: int = 400
    """[points] of a line, for the same reason. Chosen, not measured."""
    most_places: int = 1500
    """[places] of a path seen from above, about, for the same reason. Chosen, not measured."""
    most_numbers: int = 4
    """[numbers] of an effect or of a platform that a sentence can carry. Chosen, not measured."""
    most_words: int = 25
    """[words] of the headline: more are not read at a glance. Chosen, not measured."""
    three_digits: float = 10.0
    """[nats] from which evidence is written with three digits, and to which the axis reaches. Chosen, not measured."""
    told_odds: float = 100.0
    """[1] odds above are told in words. Chosen, not measured."""
    most_told_nats: float = 20.0
    """[nats] more make no other words, and numbers that overflow. Chosen, not measured."""
    digits_of_sums: int = 12
    """[digits] of a sum in a file, beyond which it shows how computers add. Chosen, not measured."""
    least_extent: float = 1e-3
    """[m] of a map of places, so that a robot at rest has one. Chosen, not measured."""


@dataclass(frozen=True)
class ManoeuvreCriteria:
    """Lengths and sizes of the manoeuvres that are advised (`report.manoeuvre_scenario`)."""

    least_duration: float = 600.0
    """[s] ten minutes are good for a diagnosis. Chosen, not measured."""
    least_rise: float = 0.1
    """[of a thruster's push] upwards; less does not carry a vehicle to another depth. Chosen, not measured."""
    least_arm: float = 0.005
    """[of the hull's length] lever of a thruster that turns a vehicle. Chosen, not measured."""
    under_way: float = 0.5
    """[of full thrust] ahead with which a vehicle turns that turns under way alone. Chosen, not measured."""
    long: float = 1800.0
    """[s] of a manoeuvre that shows what changes slowly. Chosen, not measured."""
    depth: float = 4.0
    """[m] of water. Chosen, not measured."""
    side: float = 100.0
    """[s at full speed, of a Lily; see slowness] side of the tank. Chosen, not measured."""
    least_side: float = 6.0
    """[m] side of the tank of the slowest robots. Chosen, not measured."""


@dataclass(frozen=True)
class BelievableCriteria:
    """Sizes beyond which no number of a vehicle, its water or its instruments can be (`report.believable`).

    An end of an interval, or a smallest visible size, that lies further out tells nothing.
    """

    spread: float = 1000.0
    """[of the value] an end of an interval that stands to it as its exponential does. Chosen, not measured."""
    ratio: float = 1000.0
    """[1] gains and ratios. Chosen, not measured."""
    length: float = 1.2e4
    """[m] the deepest trench has 11 km. Chosen, not measured."""
    time: float = 1e6
    """[s] twelve days. Chosen, not measured."""
    angle: float = 6.283185307179586
    """[rad] a full turn. Chosen, not measured."""
    mass: float = 1e9
    """[kg] a hundred ships weigh as much. Chosen, not measured."""
    speed: float = 100.0
    """[m/s] a hurricane's. Chosen, not measured."""
    acceleration: float = 1000.0
    """[m/s^2] a hundred times that of the earth. Chosen, not measured."""
    yaw_rate: float = 100.0
    """[rad/s] three times what gyroscopes show. Chosen, not measured."""
    shear: float = 10.0
    """[m/s per m] a jet's edge has less. Chosen, not measured."""
    slowness: float = 100.0
    """[s/m] thrust that is gone at 1 cm/s. Chosen, not measured."""
    clock_rate: float = 1.0
    """[s/s] a clock that stands still. Chosen, not measured."""
    pressure: float = 1.2e8
    """[Pa] of the deepest trench. Chosen, not measured."""
    pressure_rate: float = 1e6
    """[Pa/s] a dive at 100 m/s. Chosen, not measured."""
    force: float = 1e8
    """[N] twenty of the largest ship's propellers. Chosen, not measured."""
    linear_drag: float = 1e7
    """[N s/m] ten times the largest ship's. Chosen, not measured."""
    stiffness: float = 1e8
    """[N/m] a steel cable of a metre. Chosen, not measured."""


REPORT = ReportCriteria()
BELIEVABLE = BelievableCriteria()
MANOEUVRE = ManoeuvreCriteria()


@dataclass(frozen=True)
class OverlayCriteria:
    """Layout of what is laid over a recording in a viewer (`report.overlay`)."""

    interval: float = 0.1
    """[s] between two messages of a topic at least: more is not seen. Chosen, not measured."""
    rounding: float = 1e-6
    """[share of an interval] by which steps of a grid may miss it. Chosen, not measured."""
    hulls: float = 2.0
    """[hulls] length of an arrow of a strong force. Chosen, not measured."""
    strong: float = 0.99
    """[share of the moments] whose forces are smaller than the strong one: a single one is not the rule. Chosen, not
    measured."""
    shaft: float = 0.01
    """[m] width of an arrow. Chosen, not measured."""
    lifetime: int = 1
    """[s] that an arrow is seen. Chosen, not measured."""


OVERLAY = OverlayCriteria()
