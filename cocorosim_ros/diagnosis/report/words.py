"""Words of the report: verdicts, and checks on the robot for each effect of the catalogue."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.world.effects import EFFECTS

VERDICTS = {
    "consistent": (
        "Nothing is missing",
        "The recording is what the model of this platform expects, within its noise: no number of the platform has "
        "moved, and no effect of the catalogue explains anything.",
    ),
    "recalibrate": (
        "Recalibrate",
        "The physics is complete, but numbers of the platform differ from its file. With the fitted numbers of "
        "model.yaml the simulation follows the recording.",
    ),
    "mismatch": (
        "Physics is missing",
        "No choice of the platform's own numbers explains the recording; the effects below do.",
    ),
    "insufficient": (
        "This recording cannot tell",
        "The file can be read, but it does not hold the information that a diagnosis needs; nothing is said for or "
        "against the model.",
    ),
}
TIERS = {
    "confirmed": "confirmed: it also improves data that its fit did not see",
    "suspected": "suspected: the evidence is there, but data that its fit did not see are not improved beyond doubt",
}
CHANNELS = {"position": "position, horizontal"}

READING_WORDS = {
    "yaw": "the heading", "t": "time", "x": "place", "u": "speed ahead", "w": "speed of rising", "r": "rate of turning",
}  # fmt: skip

NOISES = {
    "random.force": "random force, horizontal",
    "random.heave_force": "random force, vertical",
    "random.moment": "random yaw moment",
    "random.correlation": "memory of the random forces",
    "random.smoothness": "smoothness of the random forces (0 rough, 1 smooth)",
    "reading.pose_xy": "a reading of pose, x and y",
    "reading.pose_z": "a reading of pose, z",
    "reading.pose_yaw": "a reading of pose, yaw",
    "reading.compass": "a reading of the compass",
    "reading.pressure": "a reading of the pressure",
    "reading.gyro_z": "a reading of the gyroscope",
    "reading.accel": "a reading of the accelerometer",
    "reading.velocity": "a reading of the velocity",
}

CHECKS = {
    "linear_drag": "Drag at low speed: fouling, fins, a tether in the water, a smoother or rougher hull than assumed.",
    "anisotropic_drag": "A hull whose side or top resists more than its bow: compare pushes sideways and ahead.",
    "added_mass": "Compare with the added mass of an ellipsoid of the hull's size; a model of any hull needs it.",
    "steady_current": "Filter pumps, inflows, convection: let a float drift, and see whether all robots drift alike.",
    "sheared_current": "An inflow or a wall near by: let floats drift at several places and depths.",
    "tidal_current": "A pump that cycles, a tide, a seiche of the tank: compare the period with what runs near by.",
    "tether": "A cable or line: see what it hangs on, and whether it lies at the place that is named.",
    "wall_effect": "Turns and speeds near the walls, the floor and the surface.",
    "neighbour_wake": "Robots that swim into each other's jets: keep them further apart and compare.",
    "thruster_lag": "Time from command to full thrust: motor controller, filters of the command, propeller inertia.",
    "thruster_deadband": "Raise each thruster's command slowly from zero, and note when the propeller starts.",
    "thruster_asymmetry": "Weigh the thrust of both thrusters at the same command; look for a damaged propeller.",
    "torque_bias": "A bent fin, a thruster mounted askew, or a keel: let the robot coast straight on.",
    "reverse_loss": "Propellers push less backwards: weigh the thrust in both directions.",
    "advance_loss": "Thrust at speed against thrust at rest: tow the robot, or compare coasting with driving.",
    "battery_sag": "Log the battery's voltage; repeat the first manoeuvre at the end.",
    "thruster_misalignment": "The axis of the thrusters against the axis of the hull, and of the camera's marker.",
    "buoyancy_trim": "Weigh the robot in the water: add or take away ballast.",
    "pump_lag": "Time from command to volume of the pump, and play when it changes direction.",
    "hull_compressibility": "A hull that gives way, or trapped air: weigh the robot in the water at two depths.",
    "stratification": "Warm water above cold, or fresh above salt: measure the temperature over depth.",
    "compass_distortion": "Iron or currents near the compass: turn the robot slowly through full circles, both ways.",
    "pressure_offset": "Read the sensor at the surface.",
    "pressure_drift": "Read the sensor at the surface before and after; note the air pressure.",
    "sensor_latency": "Filters and buffers between this sensor and its stamp; flash a light on command.",
    "clock_skew": "Synchronise the clocks, or note one event in both recordings at the start and at the end.",
    "camera_scale": "Measure a known length in the camera's picture, at the depth where the robots swim.",
    "frame_mixup": "Axes, signs and units of the driver of this stream; correct them there or in `cocorosim convert`.",
    "imu_bias": "Let the robot lie still, level and turned over, and read the sensor.",
    "payload_shift": "What came loose, leaked or was added at that moment.",
}
_UNITS = {  # of parameters that are no physics of the body
    "compass_distortion": {"offset": "rad", "sin": "rad", "cos": "rad"},
    "pressure_offset": {"offset": "Pa"},
    "pressure_drift": {"rate": "Pa/s"},
    "sensor_latency": {"latency": "s"},
    "clock_skew": {"skew": "s/s"},
    "camera_scale": {"scale": "1"},
    "imu_bias": {"gyro_z": "rad/s", "accel_x": "m/s^2", "accel_y": "m/s^2", "accel_z": "m/s^2"},
}


def effect_words(identifier: str) -> str:
    """An identifier of the catalogue, or of a law outside it, as words."""
    if identifier.startswith("unknown:"):
        equation, _, regressor = identifier.removeprefix("unknown:").partition("~")
        return f"unknown law of {equation.replace('_', ' ')} in proportion to {regressor.replace('*', chr(0xB7))}"
    return identifier.replace("_", " ")


def check_words(identifier: str) -> str:
    """A check on the robot or in the tank for an effect."""
    if identifier.startswith("unknown:"):
        return (
            "No entry of the catalogue has this law: look for what could act like it, and record again to see it twice."
        )
    return CHECKS.get(identifier, "")


def parameter_unit(effect: str, parameter: str) -> str:
    """The SI unit of a parameter of the catalogue, '1' if the catalogue does not know it."""
    if effect in EFFECTS:
        known = {each.name: each.unit for each in EFFECTS[effect].parameters}
        return known.get(parameter, "1")
    return _UNITS.get(effect, {}).get(parameter, "1")


def odds_words(nats: float) -> str:
    """Words for the odds of a rival that is `nats` behind."""
    if not math.isfinite(nats):
        return "\u2013"
    factor = math.exp(min(nats, 20.0))
    return f"{factor:.2g} times less likely" if factor < 100 else "much less likely"


def nothing_missing_words(diagnosis: Diagnosis) -> str:
    """The reason, as a sentence, for a diagnosis without effects."""
    if diagnosis.verdict == "insufficient":
        return "Nothing could be tested, because the recording holds too little information."
    return "No effect of the catalogue, and no law outside it, explains what the fitted model leaves over."
