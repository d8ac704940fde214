"""Pause, single steps, reset and rate of a run, asked for from outside and obeyed between two ticks.

Services and parameters are served by the node's background thread; what they ask for is a few values that the run looks
at before each tick. No service waits for the run: that thread may be the one which hears the controllers that the run
waits for. Simulated time stands still meanwhile, so that a run in lock-step that was paused gives the same recording.
"""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from std_srvs.srv import SetBool, Trigger

LOOK = 0.05  # s of wall clock between looks at what is asked for while paused
ON_ITS_WAY = 0.5  # s of wall clock that an answer gets to arrive before the node may end


class RunControl:
    """What is asked of one run."""

    def __init__(self, node: Node, rate: float, *, recorded: bool) -> None:
        """`rate`: seconds of simulation per second, 0 in lock-step; `recorded`: a recorder belongs to the run."""
        self.rate = rate
        self._recorded = recorded
        self._log = node.get_logger()
        self._paused = False
        self._steps = 0
        self._stepped = False
        self._reset = False
        self._seconds = 0.0
        self._answered_at = -math.inf
        self._changed = threading.Condition()
        node.create_service(SetBool, "~/pause", self._on_pause)
        node.create_service(Trigger, "~/step", self._on_step)
        node.create_service(Trigger, "~/reset", self._on_reset)
        node.add_on_set_parameters_callback(self._on_parameters)

    def hold(self, seconds: float, stopped: Callable[[], bool], reset: Callable[[], None]) -> float:
        """Return when the next tick may begin, and how long that took [s, wall clock].

        seconds: simulated time now; stopped(): whether the run is to end; reset(): begins it anew.
        """
        begin = time.monotonic()
        with self._changed:
            self._seconds = seconds
            if self._stepped:
                self._stepped = False
                self._log.info(f"a step is done: at {seconds:g} s now")
            while not stopped():
                if self._reset:
                    self._reset = False
                    reset()
                    self._seconds = 0.0
                if self._steps:
                    self._steps, self._stepped = self._steps - 1, True
                    break
                if not self._paused:
                    break
                self._changed.wait(LOOK)
        return time.monotonic() - begin

    def let_answers_arrive(self) -> None:
        """Return when the last answer has had its time.

        A short run may be over before the answer that frees the run has arrived, and a node that ends takes with it
        what others have not yet received.
        """
        time.sleep(max(0.0, self._answered_at + ON_ITS_WAY - time.monotonic()))

    def _on_pause(self, request: SetBool.Request, response: Any) -> Any:
        with self._changed:
            self._paused = bool(request.data)
            self._changed.notify_all()
            words = "paused" if self._paused else "going on"
            return self._answered(response, True, f"{words} at {self._seconds:g} s")

    def _on_step(self, request: Trigger.Request, response: Any) -> Any:
        with self._changed:
            if not self._paused:
                return self._answered(response, False, "the run is not paused; call ~/pause with 'data: true' first")
            self._steps += 1
            self._changed.notify_all()
            return self._answered(response, True, f"a step follows, {self._steps} in all, from {self._seconds:g} s on")

    def _on_reset(self, request: Trigger.Request, response: Any) -> Any:
        if self._recorded:
            words = "the run is recorded, and the time of a recording cannot go backwards; end it and start another"
            return self._answered(response, False, words)
        with self._changed:
            self._reset = True
            self._changed.notify_all()
            return self._answered(response, True, "the run begins anew after the present tick")

    def _on_parameters(self, parameters: list[Any]) -> SetParametersResult:
        """Take another rate; what else is not read-only, others take."""
        for each in parameters:
            if each.name == "rate" and (each.value > 0.0) != (self.rate > 0.0):
                words = "lock-step (rate 0.0) and the wall clock cannot be exchanged while running; start the run anew"
                return SetParametersResult(successful=False, reason=f"parameter 'rate' stays {self.rate:g}: {words}")
        for each in parameters:
            if each.name == "rate":
                self.rate = float(each.value)
                self._log.info(f"{self.rate:g} x real time from now on")
        return SetParametersResult(successful=True)

    def _answered(self, response: Any, success: bool, words: str) -> Any:
        self._log.info(words)
        self._answered_at = time.monotonic()
        response.success, response.message = success, words
        return response
