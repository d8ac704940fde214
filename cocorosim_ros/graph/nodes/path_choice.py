"""Which way of getting messages through rclpy the user asks for. Known before rclpy is started."""

from __future__ import annotations

import os

from cocorosim_ros.foundation.errors import CocorosimError

PATH_VARIABLE = "COCOROSIM_ROS_PATH"
PLAIN = "plain"


def plain_path_asked() -> bool:
    """Whether the environment asks for the path on rclpy's public interface alone, although another may be faster.

    Raises CocorosimError if it asks for a path that does not exist.
    """
    asked = os.environ.get(PATH_VARIABLE, "")
    if asked not in ("", PLAIN):
        raise CocorosimError(f"{PATH_VARIABLE} is '{asked}'; set it to '{PLAIN}', or unset it for the fastest path.")
    return asked == PLAIN
