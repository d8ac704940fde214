"""What the physics node is told of a run beside its scenario."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from cocorosim_ros.graph.nodes.complaints import tell_on_terminal


@dataclass(frozen=True)
class Terms:
    """What a run is told beside its scenario."""

    recorded: bool  # a recorder belongs to the run
    wait: float = 60.0  # s of wall clock that controllers and recorder get to appear
    dead: Callable[[], list[int]] = list  # robots whose controller is known to have died
    tell: Callable[[str], None] = tell_on_terminal  # says what goes wrong to whoever runs the node
    steps: int = 1  # of a tick by the wall clock that `/clock` and `/tf` show
