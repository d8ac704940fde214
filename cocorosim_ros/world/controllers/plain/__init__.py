"""Controllers in plain Python: a class in a file of the user's own, called once a tick with what its robot senses.

    from cocorosim_ros.world.controllers.plain import Command, Course, Sensed

`Sensed` is what the class is called with; it returns a `Command`, a `Course`, or a mapping of actuators to fractions.
"""

from __future__ import annotations

from cocorosim_ros.world.controllers.plain.answers import Command, Course
from cocorosim_ros.world.controllers.plain.sensed import Sensed

__all__ = ["Command", "Course", "Sensed"]
