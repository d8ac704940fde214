"""What a message that came by sound holds beyond that of the radio: how far away it was sent."""

from __future__ import annotations

from cocorosim_ros.world.state.radio import MESSAGE_SIZE

RANGE = MESSAGE_SIZE  # column: from where the sender was to where the receiver was at the moment of sending [m]
VARIANCE = MESSAGE_SIZE + 1  # column: of the range [m^2]
SOUND_SIZE = MESSAGE_SIZE + 2
