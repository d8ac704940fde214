"""The command `cocorosim` as it would run with an rclpy that lacks what the fast path needs.

Only `rclpy_internals` uses such parts (see test_plain_path), so that it is enough to hide them from there.
"""

from __future__ import annotations

from cocorosim_ros.commands.main import main
from cocorosim_ros.graph.nodes import rclpy_internals

rclpy_internals.MODULE = "rclpy.impl.moved_elsewhere"

if __name__ == "__main__":
    main()
