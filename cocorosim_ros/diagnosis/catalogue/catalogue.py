"""CATALOGUE: the effects that a diagnosis knows. Their physics are the simulator's, under the same names."""

from __future__ import annotations

import math
from collections.abc import Mapping

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.diagnosis.catalogue.phases import phased, phases
from cocorosim_ros.diagnosis.criteria.catalogue import CATALOGUE

LATE = (0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0)  # of what is large: delays of up to 0.6 s
TOPICS_THAT_LAG = ("pose", "compass", "pressure", "imu", "velocity")


def _within(size: float) -> tuple[float, float]:
    return (-size, size)


def _spread(low: float, high: float, count: int) -> list[float]:
    return [low + (high - low) * (index + 0.5) / count for index in range(count)]


def _times(scene: Scene) -> list[float]:
    return sorted({*_spread(0.03 * scene.duration, 0.97 * scene.duration, 24), *scene.changes})


def _depths(scene: Scene) -> list[float]:
    """Depths that were crossed: a layer that is never clearly above or below is as good as a part of the trim."""
    deepest, highest = scene.lower[2] + CATALOGUE.crossed, scene.upper[2] - CATALOGUE.crossed
    return [-value for value in _spread(deepest, highest, 12)] if deepest < highest else []


def _periods(scene: Scene) -> list[float]:
    return sorted({*scene.periods["world_x"], *scene.periods["world_y"]})


def _lengths(scene: Scene) -> list[float]:
    return [0.6 * scene.hull, scene.hull, 1.6 * scene.hull]


def _affine(values: Mapping[str, float]) -> list[tuple[dict[str, float], float]]:
    """-k (x - x0) is a sum of the pulls to three anchors."""
    x, y = values["tether.x"], values["tether.y"]
    anchors = (((0.0, 0.0), 1.0 - x - y), ((1.0, 0.0), x), ((0.0, 1.0), y))
    return [({**values, "tether.x": place[0], "tether.y": place[1]}, weight) for place, weight in anchors]


def _x(scene: Scene) -> list[float]:
    reach = scene.upper[0] - scene.lower[0]
    return _spread(scene.lower[0] - reach, scene.upper[0] + reach, 7)


def _y(scene: Scene) -> list[float]:
    reach = scene.upper[1] - scene.lower[1]
    return _spread(scene.lower[1] - reach, scene.upper[1] + reach, 7)


def _plain(
    effect: str, names: dict[str, tuple[str, float]], step: float = 0.05, least: float = -math.inf, neutral: float = 0.0
) -> tuple[Amplitude, ...]:
    return tuple(
        Amplitude(f"{effect}.{name}", name, unit, large, step, least, neutral=neutral)
        for name, (unit, large) in names.items()
    )


_WATER_AND_TETHER = "water that moves"
_LATE = "late"
_COURSE = "course beside heading"
_TURN = "turns by itself"
_TRIM = "weight"
_DRAG = "drag"

ENTRIES: tuple[Entry, ...] = (
    Entry(
        "linear_drag",
        "linear drag",
        "X = -d_u u, Y = -d_v v, Z = -d_w w, N = -d_r r",
        "surge",
        _plain(
            "linear_drag",
            {"surge": ("N s/m", 0.02), "sway": ("N s/m", 0.02), "heave": ("N s/m", 0.02), "yaw": ("N m s", 3e-5)},
            least=0.0,
        ),
        group=_DRAG,
        manoeuvre="coast_down",
    ),
    Entry(
        "anisotropic_drag",
        "drag that differs between axes",
        "Y = -k_v U v, Z = -k_w U w with k_v, k_w unlike k_u",
        "sway",
        _plain("anisotropic_drag", {"sway_ratio": ("1", 2.0), "heave_ratio": ("1", 2.0)}, least=-0.45, neutral=1.0),
        (
            Shape("anisotropic_drag.form", "form", "1", lambda scene: [0.0, 1.0, 2.0], fixed=True),
            Shape("anisotropic_drag.length", "length", "m", _lengths, logarithmic=True),
        ),
        group=_DRAG,
        manoeuvre="zig_zag",
    ),
    Entry(
        "added_mass",
        "added mass",
        "N = -(A_v - A_u) u v, and inertia against sway and yaw",
        "yaw",
        _plain(
            "added_mass",
            {"sway_minus_surge": ("kg", 0.044), "yaw": ("kg m^2", 6e-5), "heave_minus_surge": ("kg", 0.044)},
        ),
        manoeuvre="zig_zag",
    ),
    Entry(
        "steady_current",
        "steady current",
        "u, v through the water: V - V_c",
        "surge",
        _plain("steady_current", {"x": ("m/s", 0.005), "y": ("m/s", 0.005)}),
        water=True,
        group=_WATER_AND_TETHER,
        manoeuvre="four_headings",
    ),
    Entry(
        "sheared_current",
        "current that changes with place",
        "V_c = V_0 + gradient * place",
        "surge",
        _plain(
            "sheared_current",
            {
                "x": ("m/s", 0.005),
                "y": ("m/s", 0.005),
                "dx_dy": ("1/s", 0.005),
                "dx_dz": ("1/s", 0.005),
                "dy_dx": ("1/s", 0.005),
                "dy_dz": ("1/s", 0.005),
            },
        ),
        water=True,
        group=_WATER_AND_TETHER,
        manoeuvre="four_headings",
    ),
    Entry(
        "tidal_current",
        "current that swings",
        "V_c = (x, y) sin(2 pi t / period + phase)",
        "surge",
        _plain("tidal_current", {"x": ("m/s", 0.007), "y": ("m/s", 0.007)}),
        (
            Shape("tidal_current.period", "period", "s", _periods, logarithmic=True),
            Shape("tidal_current.phase", "phase", "rad", phases, periodic=True),
        ),
        water=True,
        group=_WATER_AND_TETHER,
        manoeuvre="four_headings",
        basis=phased("tidal_current.phase"),
    ),
    Entry(
        "tether",
        "pull of a tether",
        "F = -k (place - anchor)",
        "surge",
        _plain("tether", {"stiffness": ("N/m", 8e-4)}, least=0.0),
        (Shape("tether.x", "x", "m", _x), Shape("tether.y", "y", "m", _y)),
        group=_WATER_AND_TETHER,
        manoeuvre="four_headings",
        basis=_affine,
    ),
    Entry(
        "wall_effect",
        "drag that grows near walls",
        "drag * (1 + gain * exp(-distance / range))",
        "surge",
        _plain("wall_effect", {"gain": ("1", 2.0)}, least=0.0),
        (Shape("wall_effect.range", "range", "m", lambda scene: [0.05, 0.1, 0.2, 0.4], logarithmic=True),),
        group=_DRAG,
        manoeuvre="along_wall",
    ),
    Entry(
        "neighbour_wake",
        "push by a neighbour's jet",
        "thrust of the neighbour * gain * 0.1 m / distance behind it",
        "surge",
        _plain("neighbour_wake", {"gain": ("1", 0.6)}),
        manoeuvre="follow_neighbour",
        needs_neighbours=True,
    ),
    Entry(
        "thruster_lag",
        "thrust that lags behind its command",
        "tau dT/dt = T_command - T",
        "surge",
        (
            Amplitude(
                "thruster_lag.time_constant",
                "time_constant",
                "s",
                0.3,
                0.05,
                0.0,
                negligible=_within(CATALOGUE.thrust_tick),
                searched=LATE,
            ),
        ),
        group=_LATE,
        manoeuvre="steps",
    ),
    Entry(
        "thruster_deadband",
        "dead band of the thrusters",
        "T = 0 for |command| < width",
        "surge",
        _plain("thruster_deadband", {"width": ("1", 0.1)}, step=0.5, least=0.0),
        shapes=(Shape("thruster_deadband.ramp", "ramp", "1", lambda scene: [0.0, 1.0], fixed=True),),
        manoeuvre="ramps_through_zero",
    ),
    Entry(
        "thruster_asymmetry",
        "left and right thrusters that differ",
        "T_right / T_left = (1 + d/2) / (1 - d/2)",
        "yaw",
        _plain("thruster_asymmetry", {"difference": ("1", 0.06)}),
        group=_TURN,
        manoeuvre="thrust_staircase",
    ),
    Entry(
        "torque_bias",
        "constant yaw torque",
        "N = const",
        "yaw",
        _plain("torque_bias", {"torque": ("N m", 1e-5)}),
        group=_TURN,
        manoeuvre="thrust_staircase",
    ),
    Entry(
        "reverse_loss",
        "thrust that is weaker backwards",
        "T (1 - loss) for command < 0",
        "surge",
        _plain("reverse_loss", {"loss": ("1", 0.2)}),
        manoeuvre="reverse_steps",
    ),
    Entry(
        "advance_loss",
        "thrust that falls with speed",
        "T (1 - slope u)",
        "surge",
        _plain("advance_loss", {"slope": ("s/m", 3.0)}),
        group=_DRAG,
        manoeuvre="coast_down",
    ),
    Entry(
        "battery_sag",
        "thrust that falls during the recording",
        "T (1 - fraction_lost t / duration)",
        "surge",
        _plain("battery_sag", {"fraction_lost": ("1", 0.2)}),
        fixed={"battery_sag.duration": lambda scene: scene.duration},
        manoeuvre="repeat_at_end",
    ),
    Entry(
        "thruster_misalignment",
        "thrust beside the hull's axis",
        "thrust turned by an angle",
        "sway",
        _plain("thruster_misalignment", {"angle": ("rad", 0.08)}),
        shapes=(Shape("thruster_misalignment.arm", "arm", "m", lambda scene: [0.0, scene.arm], fixed=True),),
        group=_COURSE,
        manoeuvre="reverse_steps",
    ),
    Entry(
        "buoyancy_trim",
        "net weight or buoyancy",
        "Z = const",
        "heave",
        _plain("buoyancy_trim", {"force": ("N", 1e-3)}),
        group=_TRIM,
        manoeuvre="depth_staircase",
    ),
    Entry(
        "pump_lag",
        "slow buoyancy pump",
        "tau dZ/dt = Z_command - Z, with backlash",
        "heave",
        (
            Amplitude(
                "pump_lag.time_constant", "time_constant", "s", 1.0, 0.1, 0.0, negligible=_within(CATALOGUE.pump_tick)
            ),
            Amplitude("pump_lag.backlash", "backlash", "1", 0.06, 0.1, 0.0, negligible=_within(CATALOGUE.play)),
        ),
        group="late pump",
        of_pump=True,
        manoeuvre="pump_triangle",
    ),
    Entry(
        "hull_compressibility",
        "hull that shrinks with depth",
        "Z = -gradient * depth",
        "heave",
        _plain("hull_compressibility", {"gradient": ("N/m", 2e-3)}),
        shapes=(Shape("hull_compressibility.gas", "gas", "1", lambda scene: [0.0, 1.0], fixed=True),),
        group=_TRIM,
        manoeuvre="depth_staircase",
    ),
    Entry(
        "stratification",
        "density layer",
        "Z steps by force below depth",
        "heave",
        _plain("stratification", {"force": ("N", 2e-3)}),
        (Shape("stratification.depth", "depth", "m", _depths),),
        water=True,
        group=_TRIM,
        manoeuvre="depth_staircase",
    ),
    Entry(
        "payload_shift",
        "trim that jumps",
        "Z steps by force at a moment",
        "heave",
        _plain("payload_shift", {"force": ("N", 1e-3)}),
        (Shape("payload_shift.time", "time", "s", _times, once=True),),
        group=_TRIM,
        manoeuvre="depth_staircase",
    ),
    Entry(
        "compass_distortion",
        "distorted compass",
        "reading = yaw + offset + sin * sin(yaw) + cos * cos(yaw)",
        "compass",
        _plain("compass_distortion", {"offset": ("rad", 0.085), "sin": ("rad", 0.085), "cos": ("rad", 0.085)}),
        group=_COURSE,
        topic="compass",
        manoeuvre="slow_turns",
    ),
    Entry(
        "pressure_offset",
        "pressure reading that is shifted",
        "reading = pressure + offset",
        "pressure",
        _plain("pressure_offset", {"offset": ("Pa", 500.0)}),
        group="pressure",
        topic="pressure",
        manoeuvre="surface_touch",
    ),
    Entry(
        "pressure_drift",
        "pressure reading that drifts",
        "reading = pressure + rate t",
        "pressure",
        (*_plain("pressure_drift", {"rate": ("Pa/s", 0.7)}), *_plain("pressure_offset", {"offset": ("Pa", 500.0)})),
        group="pressure",
        topic="pressure",
        manoeuvre="surface_touch",
    ),
    Entry(
        "imu_bias",
        "IMU that is off",
        "reading = rate or acceleration + bias",
        "imu",
        _plain(
            "imu_bias",
            {
                "gyro_z": ("rad/s", 0.02),
                "accel_x": ("m/s^2", 0.05),
                "accel_y": ("m/s^2", 0.05),
                "accel_z": ("m/s^2", 0.05),
            },
        ),
        topic="imu",
        manoeuvre="rest",
    ),
    Entry(
        "camera_scale",
        "camera lengths that are wrong by a factor",
        "reading = scale * place",
        "pose",
        _plain("camera_scale", {"scale": ("1", 0.05)}, neutral=1.0),
        topic="pose",
        manoeuvre="ruler",
    ),
    *(
        Entry(
            "sensor_latency",
            f"{topic} that comes late",
            "reading(t) = what was at t - latency",
            topic,
            (
                Amplitude(
                    f"sensor_latency.{topic}",
                    "latency",
                    "s",
                    0.15,
                    0.05,
                    0.0,
                    negligible=_within(CATALOGUE.clock_tick),
                    searched=LATE,
                ),
            ),
            group=_LATE,
            topic=topic,
            manoeuvre="steps",
            of_pump=topic == "pressure",
        )
        for topic in TOPICS_THAT_LAG
    ),
    *(
        Entry(
            "clock_skew",
            f"clock of {topic} that runs wrong",
            "stamp = t0 + (1 + skew) (t - t0)",
            "clock",
            (Amplitude(f"clock_skew.{topic}", "skew", "s/s", 5e-4, 0.05, adds_up=2.0 * CATALOGUE.clock_tick),),
            group=_LATE,
            topic=topic,
            manoeuvre="repeat_at_end",
            of_pump=topic == "pressure",
        )
        for topic in TOPICS_THAT_LAG
    ),
)

IDS: tuple[str, ...] = tuple(dict.fromkeys(entry.id for entry in ENTRIES))
