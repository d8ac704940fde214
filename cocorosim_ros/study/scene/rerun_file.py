"""A Rerun recording (.rrd) of one scene, or of two side by side."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

import rerun as rr

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.pictures.colours import robot_colours
from cocorosim_ros.study.scene.rerun_layout import layout
from cocorosim_ros.study.scene.rerun_robots import Canvas, Colour, draw_robots
from cocorosim_ros.study.scene.rerun_surroundings import draw_surroundings
from cocorosim_ros.study.scene.scene import Scene

ROOTS = ("run", "against")
"""Paths of the scenes' entities."""
_CURVES = (Colour(70, 160, 230), Colour(240, 140, 60))


def write_rerun(scenes: Sequence[Scene], file: Path) -> None:
    """Write the scenes into one file, each on a time line that counts from its own first pose.

    scenes: one or two. Nothing is left behind half written. Raises CocorosimError if the file cannot be written.
    """
    roots = ROOTS[: len(scenes)]
    provisional = file.with_name(file.name + ".part")
    try:
        stream = rr.RecordingStream("cocorosim")
        stream.save(provisional, layout(roots, scenes))
        for root, scene, curve in zip(roots, scenes, _CURVES, strict=False):
            canvas = Canvas(stream, root, scene.start_ns)
            canvas.always("", rr.ViewCoordinates.RIGHT_HAND_Z_UP)
            colours = robot_colours([robot.name for robot in scene.robots])
            draw_robots(canvas, scene, [in_bytes(*each) for each in colours.values()])
            draw_surroundings(canvas, scene, curve)
        stream.flush()
        stream.disconnect()
        provisional.replace(file)
    except (OSError, RuntimeError) as error:
        raise CocorosimError(f"{file} cannot be written: {error}; give a file in a folder with room.") from error
    finally:
        with suppress(OSError):
            provisional.unlink(missing_ok=True)


def in_bytes(red: float, green: float, blue: float, _: float) -> Colour:
    """A colour of Matplotlib as Rerun has it."""
    return Colour(round(255 * red), round(255 * green), round(255 * blue))
