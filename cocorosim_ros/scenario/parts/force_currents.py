"""Currents as the paper has them: forces on patches of water, with every open choice of the paper by name.

Source: Read et al. 2013, sections 3.1 and 5.1; `released` names what the authors' later model does instead.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text, quantity_text, read_nanoseconds, read_quantity
from cocorosim_ros.scenario.reading.records import TIME_FORM, choice, nested, quantity, read_record, record_tree, stored

PAPER_OR_RELEASED = ("paper", "released")
Source = Literal["paper", "released"]


def _read_fraction(entry: Entry) -> float:
    value = read_quantity(entry, "pure number", "not negative")
    if value > 1.0:
        raise entry.problem(f"has {entry.found()}; it must lie between 0 and 1.")
    return value


FRACTION = stored(_read_fraction, lambda value: quantity_text(value, "pure number"), form="pure number from 0 to 1")


@dataclass(frozen=True)
class ColdSpots:
    """Low pressure patches that pull water towards them, for a while.

    force: greatest force on a neighbouring patch [N]; it rises and falls as a half sine over `lifetime`.
    probability: that a patch becomes a cold spot in one step. spawning: `paper` lets every patch draw for itself;
    `released` makes twice as many, the same number each step, and may choose a patch twice.
    neighbours: `surrounding_26`: all, straight towards the spot (the paper's words); `released_18`: without the
    corners, and with the full force along both axes on the vertical diagonals.
    """

    force: float = field(metadata=quantity("force", "not negative"))
    probability: float = field(default=0.0015, metadata=FRACTION)
    lifetime_ns: int = field(
        default=12_500_000_000, metadata=stored(read_nanoseconds, nanoseconds_text, key="lifetime", form=TIME_FORM)
    )
    spawning: Source = field(default="paper", metadata=choice(*PAPER_OR_RELEASED))
    neighbours: Literal["surrounding_26", "released_18"] = field(
        default="surrounding_26", metadata=choice("surrounding_26", "released_18")
    )


@dataclass(frozen=True)
class Wakes:
    """Currents made by thrusters.

    strength: force on the water per force of the thruster: 1 is the paper's, 50 the released model's, 0 none.
    outer_angle: where the outer quarter of the jet goes, counted from straight behind [rad]: 45 deg is the patch
    behind and to the side, the paper's; the released model has 30 deg.
    """

    strength: float = field(default=1.0, metadata=quantity("pure number", "not negative"))
    outer_angle: float = field(default=math.pi / 4, metadata=quantity("angle", "not negative"))


@dataclass(frozen=True)
class ForceCurrents:
    """Forces on patches of water, and how they spread, decay and act.

    patch [m] divides the tank; step: one update of the forces, a whole number of ticks (the paper's numbers belong
    to 0.5 s). diffusion: `paper_equation_5` or `released`. walls: at walls a patch has `fewer_neighbours`; or,
    besides, what flows into a wall is `redirected` along it. torque_lever [m] turns differences between the four
    neighbouring patches into a yaw moment.
    """

    cold_spots: ColdSpots | None = field(default=None, metadata=nested(ColdSpots))
    wakes: Wakes | None = field(default=None, metadata=nested(Wakes))
    patch: float = field(default=0.1, metadata=quantity("length", "positive"))
    step_ns: int = field(
        default=500_000_000, metadata=stored(read_nanoseconds, nanoseconds_text, key="step", form=TIME_FORM)
    )
    diffusion: Literal["paper_equation_5", "released"] = field(
        default="paper_equation_5", metadata=choice("paper_equation_5", "released")
    )
    diffusion_rate: float = field(default=0.6, metadata=FRACTION)
    decay_rate: float = field(default=0.65, metadata=FRACTION)
    walls: Literal["fewer_neighbours", "redirected"] = field(
        default="fewer_neighbours", metadata=choice("fewer_neighbours", "redirected")
    )
    torque_lever: float = field(default=0.1, metadata=quantity("length", "not negative"))

    @property
    def lifetime_steps(self) -> int:
        """How many steps a cold spot lives; 0 without cold spots."""
        return 0 if self.cold_spots is None else self.cold_spots.lifetime_ns // self.step_ns

    def growth(self) -> float:
        """Factor by which a uniform field is multiplied in one step: above 1 the forces grow without end.

        Every other pattern is multiplied by less, because no patch gives or takes a negative share.
        """
        kappa, gamma = self.diffusion_rate, self.decay_rate
        return 1.0 + gamma * (1.0 - 2.0 * kappa) if self.diffusion == "paper_equation_5" else gamma


def read_force_currents(entry: Entry) -> ForceCurrents:
    """The force currents that a mapping describes, which neither grow without end nor cut a cold spot's life."""
    forces = read_record(ForceCurrents, entry)
    if forces.growth() > 1.0 + 1e-12:
        raise entry.problem(
            f"multiplies every current by {forces.growth():.4g} in each step, so that the forces grow without end; "
            f"choose a 'diffusion_rate' of at least 0.5 (found {forces.diffusion_rate:g}), or 'diffusion: released'."
        )
    if forces.cold_spots is not None and (not forces.lifetime_steps or forces.cold_spots.lifetime_ns % forces.step_ns):
        lifetime, step = nanoseconds_text(forces.cold_spots.lifetime_ns), nanoseconds_text(forces.step_ns)
        raise entry.mapping()["cold_spots"].problem(
            f"has a lifetime of '{lifetime}', which is not a whole number of steps of '{step}'; choose a multiple."
        )
    return forces


FORCE_CURRENTS = stored(read_force_currents, record_tree, form="mapping") | {"inside": ForceCurrents}
