"""Linear drag sideways or upwards, and none ahead: drag that differs between axes by another law looks the same."""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of

_ACROSS = ("sway", "heave")


def drag_but_ahead(case: Case) -> Iterator[Objection]:
    """Object to a linear drag that may be nothing ahead, and clearly is more than that sideways or upwards.

    Water that brakes in proportion to speed does so along all axes. A quadratic drag that is larger across the hull and
    grows more slowly at speed, as one of a hull that sheds its wake, resembles it across and lacks it ahead.
    """
    for found, _ in effects_of(case):
        ahead = found.parameters.get("surge") if found.id == "linear_drag" else None
        if ahead is not None and ahead.holds(0.0):
            across = [found.parameters[name] for name in _ACROSS if name in found.parameters]
            if any(each.low > ahead.high for each in across):
                yield Objection(
                    "It brakes across the hull and, as far as can be told, not ahead: drag that differs between axes, "
                    "by another law of the speed than the catalogue's, looks the same.",
                    effect=found,
                )
