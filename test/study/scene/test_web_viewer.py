"""Rerun's web viewer, opened on a scene by a browser without a window: what must be there is in the picture."""

from __future__ import annotations

import base64
import io
import itertools
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote
from urllib.request import urlopen

import numpy as np
import pytest
from matplotlib.colors import rgb_to_hsv
from matplotlib.image import imread
from websockets.sync.client import connect

from cocorosim_ros.commands.rerun_viewer import HERE, write_scenes
from cocorosim_ros.library.recording import read_recording

pytest.importorskip("rerun", reason="rerun-sdk is not installed, and it is optional")
if np.__version__.startswith("1."):
    pytest.skip("rerun-sdk asks for NumPy 2", allow_module_level=True)
BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SHIPPED = Path(__file__).parents[3] / "bags" / "five_lilys"
Picture = np.ndarray[tuple[int, ...], np.dtype[np.float64]]  # (rows, columns, 3): hue, saturation, value
LIMIT = 300.0  # s; only a hang takes so long
BLUE, YELLOW = (0.53, 0.65), (0.09, 0.16)  # hues of the first shoal's bodies and of curves; of cones and their edges
VIVID = 0.6  # of the saturation; that of water and walls is below
ENOUGH = 50  # pixels; a body in the tank, the smallest of all, has some 30, and there are five


@contextmanager
def running(*command: str) -> Iterator[subprocess.Popen[str]]:
    """A program whose words come line by line on its errors; it ends with the block, and what it has started too."""
    pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, **pipes, text=True, start_new_session=True) as process:
        try:
            yield process
        finally:
            os.killpg(process.pid, signal.SIGKILL)


def told(process: subprocess.Popen[str], pattern: str) -> re.Match[str]:
    """The first match in what a program says on its errors."""
    assert process.stderr is not None
    return next(found for line in process.stderr if (found := re.search(pattern, line)))


def free_ports(count: int) -> list[str]:
    """Ports that nobody listens at."""
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind((HERE, 0))
    ports = [str(each.getsockname()[1]) for each in sockets]
    for each in sockets:
        each.close()
    return ports


@contextmanager
def pictures(address: str, profile: Path) -> Iterator[Callable[[], Picture]]:
    """A function that takes a picture of a page."""
    options = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    options += [f"--user-data-dir={profile}", "--window-size=1400,900", "--remote-debugging-port=0", address]
    with running(str(BROWSER), *options) as browser:
        port = told(browser, r"ws://[^:]+:(\d+)/")[1]
        pages = json.load(urlopen(f"http://{HERE}:{port}/json", timeout=LIMIT))
        page = next(each["webSocketDebuggerUrl"] for each in pages if each["type"] == "page")
        with connect(page, max_size=None) as tab:
            numbers = itertools.count(1)

            def take() -> Picture:
                number = next(numbers)
                tab.send(json.dumps({"id": number, "method": "Page.captureScreenshot"}))
                while (answer := json.loads(tab.recv(LIMIT))).get("id") != number:
                    pass
                png = io.BytesIO(base64.b64decode(answer["result"]["data"]))
                return rgb_to_hsv(imread(png, format="png")[..., :3])

            yield take


def vivid(picture: Picture, hues: tuple[float, float]) -> int:
    """How many pixels of these hues are no mere tint."""
    hue, saturation, _ = np.moveaxis(picture, -1, 0)
    return int(np.count_nonzero((hue > hues[0]) & (hue < hues[1]) & (saturation > VIVID)))


def shown(picture: Picture) -> Iterator[int]:
    """Pixels of bodies in the tank, of bodies and cones in the view beside it, and of curves in three columns below."""
    rows, columns = picture.shape[:2]
    above, below = picture[: rows // 2], picture[rows * 3 // 5 :]
    tank, beside = above[:, : columns * 2 // 3], above[:, columns * 5 // 7 :]
    yield vivid(tank, BLUE)
    yield from (vivid(beside, BLUE), vivid(beside, YELLOW))
    yield from (vivid(plots, BLUE) for plots in np.array_split(below, 3, axis=1))


@pytest.mark.skipif(BROWSER is None, reason="no Chromium is installed, so the viewer cannot be opened")
def test_bodies_cones_and_curves_are_in_the_picture(tmp_path: Path) -> None:
    """Bodies in the tank and beside it, cones of what a robot sees, and six curves below, as the layout has them."""
    write_scenes([read_recording(SHIPPED)], tmp_path / "scene.rrd")
    port, page = free_ports(2)
    server = [sys.executable, "-m", "rerun", "--serve-web", "--bind", HERE, "--port", port, "--web-viewer-port", page]
    scene = quote(f"rerun+http://{HERE}:{port}/proxy", safe="")
    with running(*server, str(tmp_path / "scene.rrd")) as viewer:
        told(viewer, "Hosting a web-viewer")
        with pictures(f"http://{HERE}:{page}?url={scene}", tmp_path / "profile") as take:
            deadline = time.monotonic() + LIMIT
            while min(found := list(shown(take()))) < ENOUGH:
                assert time.monotonic() < deadline, f"bodies in the tank, bodies and cones beside it, curves: {found}"
