"""What a robot decides from what it senses. CONTROLLERS lists the behaviours that exist."""

from __future__ import annotations

from cocorosim_ros.world.controllers.beeclust import BEECLUST
from cocorosim_ros.world.controllers.boids_blc import BOIDS_BLC
from cocorosim_ros.world.controllers.boids_blt import BOIDS_BLT
from cocorosim_ros.world.controllers.boids_na import BOIDS_NA
from cocorosim_ros.world.controllers.boids_released import (
    BOIDS_BLC_RELEASED,
    BOIDS_BLT_RELEASED,
    BOIDS_NA_RELEASED,
    BOIDS_VANILLA_RELEASED,
)
from cocorosim_ros.world.controllers.boids_vanilla import BOIDS_VANILLA
from cocorosim_ros.world.controllers.calibration_programme import CALIBRATION_PROGRAMME
from cocorosim_ros.world.controllers.constant import CONSTANT
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.depth_agreement import DEPTH_AGREEMENT
from cocorosim_ros.world.controllers.heading_hold import HEADING_HOLD
from cocorosim_ros.world.controllers.idle import IDLE
from cocorosim_ros.world.controllers.minimal_flocking import MINIMAL_FLOCKING
from cocorosim_ros.world.controllers.plume_tracking import PLUME_TRACKING
from cocorosim_ros.world.controllers.programme import PROGRAMME

CONTROLLERS: dict[str, Controller] = {
    "idle": IDLE,
    "constant": CONSTANT,
    "heading_hold": HEADING_HOLD,
    "boids_blt": BOIDS_BLT,
    "boids_vanilla": BOIDS_VANILLA,
    "boids_blc": BOIDS_BLC,
    "boids_na": BOIDS_NA,
    "minimal_flocking": MINIMAL_FLOCKING,
    "beeclust": BEECLUST,
    "calibration_programme": CALIBRATION_PROGRAMME,
    "plume_tracking": PLUME_TRACKING,
    "programme": PROGRAMME,
    "boids_blt_released": BOIDS_BLT_RELEASED,
    "boids_vanilla_released": BOIDS_VANILLA_RELEASED,
    "boids_blc_released": BOIDS_BLC_RELEASED,
    "boids_na_released": BOIDS_NA_RELEASED,
    "depth_agreement": DEPTH_AGREEMENT,
}
CONTROLLER_CODE: dict[str, int] = {name: code for code, name in enumerate(CONTROLLERS)}
