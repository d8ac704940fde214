"""The same swarm in MuJoCo: its own ellipsoid fluid, a k-d tree for neighbours, a rough boids rule in NumPy.

MuJoCo is no dependency; without it this row is left out. What is compared is the pace of physics and neighbours:
the controller is simpler than ours, there are no cones, no radio and no avoidance, all of which favours MuJoCo.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from scipy.spatial import cKDTree
from swarms import Pace

BODY = """<body pos="{x} {y} {z}"><freejoint/>
<geom type="ellipsoid" size="0.065 0.05 0.035" mass="0.44" contype="0" conaffinity="0"
 fluidshape="ellipsoid" fluidcoef="0.5 0.25 1.5 1 1"/></body>"""
MODEL = """<mujoco><option timestep="0.25" density="1000" viscosity="0.001" gravity="0 0 0" integrator="implicitfast"/>
<worldbody>{bodies}</worldbody></mujoco>"""


def mujoco_pace(robots: int, ticks: int) -> Pace | None:
    """The pace on one core, two steps of 0.25 s to a tick; None without MuJoCo."""
    try:
        import mujoco
    except ImportError:
        return None
    draw = np.random.default_rng(0)
    side = 0.9 if robots == 11 else (robots / 11) ** 0.5 * 6.0
    places = draw.uniform([-side / 2, -side / 2, -1.9], [side / 2, side / 2, -0.6], (robots, 3))
    bodies = "".join(BODY.format(x=x, y=y, z=z) for x, y, z in places)
    model = mujoco.MjModel.from_xml_string(MODEL.format(bodies=bodies))
    data = mujoco.MjData(model)
    began, processor = time.perf_counter(), time.thread_time()
    for _ in range(ticks):
        data.xfrc_applied[1:, :3] = _forces(data.xpos[1:], data.qvel.reshape(-1, 6)[:, :3])
        mujoco.mj_step(model, data, 2)
    return Pace(robots * ticks, time.perf_counter() - began, time.thread_time() - processor)


def _forces(position: Any, velocity: Any) -> Any:
    """Cohesion and alignment with everybody within 0.5 m, at a tenth of Lily's thrust."""
    pairs = cKDTree(position).query_pairs(0.5, output_type="ndarray")
    wish, count = np.zeros_like(position), np.ones(len(position))
    for one, other in ((pairs[:, 0], pairs[:, 1]), (pairs[:, 1], pairs[:, 0])):
        np.add.at(wish, one, position[other] - position[one] + 10.0 * velocity[other])
        np.add.at(count, one, 1.0)
    wish /= count[:, None]
    length = np.linalg.norm(wish, axis=1, keepdims=True)
    return 0.001 * wish / np.maximum(length, 1e-9)
