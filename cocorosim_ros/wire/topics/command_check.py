"""What a controller may ask for, and what is done with what it may not."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.packed import PackedMessage


def read_command(decoder: PackedMessage, actuators: tuple[str, ...], data: bytes) -> tuple[Floats, str]:
    """Fractions in -1..1 per actuator from the bytes of a ThrusterCommand, and a complaint ('' for none).

    Not a number or not named: that actuator is off. Beyond 1: cut to 1. Unreadable, or an actuator that the
    robot does not have: all actuators are off.
    """
    try:
        wanted = decoder.decode(data)
    except CocorosimError as error:
        return np.zeros(len(actuators)), f"its command is not used, all actuators are off: {error}"
    complaints = []
    for index, name in enumerate(actuators):
        value = float(wanted[index])
        if math.isnan(value):
            complaints.append(f"'{name}' is not a number or not given, so it is off")
            wanted[index] = 0.0
        elif abs(value) > 1.0:
            complaints.append(f"'{name}' is {value:g}, beyond -1..1, and is cut")
            wanted[index] = math.copysign(1.0, value)
    return wanted, "; ".join(complaints)
