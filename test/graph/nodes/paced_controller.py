"""A controller for one robot that does what it is told on standard input, tick by tick; plain rclpy, none of ours.

    paced_controller.py ROBOT [late SECONDS]

Each input line is one answer: how the tick that is waiting, or comes next, is answered. `all`: from now on every tick
is answered properly. It prints `ready` when it is connected, and `tick SECONDS` and `answered KIND SECONDS`.
"""

import math
import queue
import sys
import threading
import time

import rclpy
from builtin_interfaces.msg import Time
from cocorosim_msgs.msg import Compass, ThrusterCommand
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

NAMES = ["left", "right", "buoyancy"]
AHEAD = (NAMES, [0.5, 0.5, 0.0])
ANSWERS = {  # kind: what is sent, with an offset to the stamp [s]; None: no stamp
    "good": [(*AHEAD, 0)],
    "nan": [(NAMES, [math.nan, 0.5, 0.0], 0)],
    "beyond": [(NAMES, [1.7, 0.5, 0.0], 0)],
    "unknown": [([*NAMES, "warp"], [0.5, 0.5, 0.0, 1.0], 0)],
    "partial": [(["right"], [0.5], 0)],
    "uneven": [(NAMES, [0.5], 0)],
    "past": [(*AHEAD, -0.2), (*AHEAD, 0)],
    "future": [(*AHEAD, 3600), (*AHEAD, 0)],
    "shortly": [(*AHEAD, 0.05)],
    "unstamped": [(*AHEAD, None), (*AHEAD, None)],
    "twice": [(*AHEAD, 0), (*AHEAD, 0)],
    "skip": [],
}


class Paced(Node):
    """Answers one tick per word from standard input."""

    def __init__(self, robot, delay):
        super().__init__("paced_controller", namespace=robot)
        self.delay = delay
        self.orders = queue.Queue()
        self.always = False
        self.publisher = self.create_publisher(ThrusterCommand, "thruster_command", 10)
        self.ticks = queue.Queue()
        self.create_subscription(Compass, "compass", self._note, 10)
        threading.Thread(target=self._read, daemon=True).start()

    def _note(self, message):
        stamp = message.header.stamp
        print(f"tick {stamp.sec + stamp.nanosec * 1e-9:g}", flush=True)
        self.ticks.put(message)

    def _read(self):
        for line in sys.stdin:
            self.orders.put(line.strip())

    def answer_if_asked(self):
        """Answer one waiting tick, if there is an order for it."""
        if self.ticks.empty() or (self.orders.empty() and not self.always):
            return
        order = "good" if self.orders.empty() else self.orders.get()
        if order == "all":
            self.always, order = True, "good"
        stamp = self.ticks.get().header.stamp
        time.sleep(self.delay)
        for names, values, offset in ANSWERS[order]:
            message = ThrusterCommand(name=names, command=values)
            moment = 0 if offset is None else stamp.sec * 10**9 + stamp.nanosec + int(offset * 1e9)
            message.header.stamp = Time(sec=moment // 10**9, nanosec=moment % 10**9)
            self.publisher.publish(message)
        print(f"answered {order} {stamp.sec + stamp.nanosec * 1e-9:g}", flush=True)


def main():
    """Do as the input says until the readings stop for good."""
    rclpy.init()
    node = Paced(sys.argv[1], float(sys.argv[3]) if sys.argv[2:3] == ["late"] else 0.0)
    said = False
    try:
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0.02)
            if not said and node.publisher.get_subscription_count() > 0 and node.count_publishers("compass") > 0:
                said = True
                print("ready", flush=True)
            node.answer_if_asked()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
