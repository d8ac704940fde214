"""The effects of the interface's table that live in the water, the hull and the drives: how each is drawn and hidden.

Each function changes the scene and returns what the envelope says of it. `amount` is in the unit that prior.yaml
states for the effect. Sensors are in catalogue_sensors.py. Parameters that depend on where the robot went (of a law
whose form is not the table's) are filled in by truth_after.py once the trajectory is known.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from concealer import layout as at
from concealer.fluid import GUST
from concealer.scene import Scene, Secret, direction, signed

Hide = Callable[[np.random.Generator, float, Scene], Secret]


def linear_drag(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """-d v along each body axis, -d r; amount is the surge value."""
    sway, heave = amount * rng.uniform(0.8, 1.3, 2)
    yaw = amount * 1.5e-3 * rng.uniform(0.8, 1.25)
    scene.own[[at.LINEAR_SURGE, at.LINEAR_SWAY, at.LINEAR_HEAVE, at.LINEAR_YAW]] = amount, sway, heave, yaw
    return Secret("linear_drag", {"surge": amount, "sway": sway, "heave": heave, "yaw": yaw}, "linear")


def anisotropic_drag(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Strip theory across the hull; amount is sway_ratio - 1, heave gets as much or nothing."""
    heave = amount * rng.uniform(0.7, 1.3) if rng.random() < 0.5 else 0.0
    scene.own[[at.CROSS_SWAY, at.CROSS_HEAVE, at.STRIP_LENGTH]] = amount, heave, rng.uniform(0.04, 0.1)
    form = "cross-flow integral of |v + x r|(v + x r) over the hull; ratios are those of pure motion along an axis"
    return Secret("anisotropic_drag", {"sway_ratio": 1.0 + amount, "heave_ratio": 1.0 + heave}, form)


def added_mass(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A body of revolution: sway and heave alike; surge half as much to as much as the difference."""
    surge = amount * rng.uniform(0.5, 1.0)
    yaw = amount * 1.4e-3 * rng.uniform(0.6, 1.4)
    places = [at.ADDED_SURGE, at.ADDED_SWAY, at.ADDED_HEAVE, at.ADDED_YAW]
    scene.own[places] = surge, surge + amount, surge + amount, yaw
    return Secret("added_mass", {"sway_minus_surge": amount, "yaw": yaw}, "Fossen, heave added mass as sway")


def steady_current(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Velocity of the water, the same everywhere."""
    x, y = direction(rng, amount)
    scene.everywhere(current_x=x, current_y=y)
    return Secret("steady_current", {"x": x, "y": y}, "relative velocity", shared=True)


def sheared_current(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A tanh profile across x, y or z; the gradient is the straight line's along the way the robots went."""
    name = str(rng.choice(["shear_xy", "shear_yx", "shear_xz", "shear_yz"]))
    x, y = direction(rng, amount * rng.uniform(0.0, 1.0))
    gradient = {name: signed(rng, amount)}
    if rng.random() < 0.3:
        gradient = {"shear_xy": signed(rng, amount), "shear_yx": signed(rng, 0.7 * amount)}
    scene.everywhere(current_x=x, current_y=y, shear_width=rng.uniform(2.5, 5.0), shear_depth=rng.uniform(2.0, 5.0))
    scene.everywhere(**gradient)
    form = "tanh profile; least-squares plane of the water's velocity at the places visited"
    return Secret("sheared_current", {"x": x, "y": y}, form, shared=True)


def tidal_current(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Velocity of the water that swings."""
    x, y = direction(rng, amount)
    period, phase = float(np.exp(rng.uniform(np.log(60.0), np.log(400.0)))), rng.uniform(-np.pi, np.pi)
    scene.everywhere(tide_x=x, tide_y=y, tide_period=period, tide_phase=phase)
    return Secret("tidal_current", {"x": x, "y": y, "period": period, "phase": phase}, "relative velocity", shared=True)


def surface_waves(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Waves that travel over water with a floor, their crests a little sharper than their troughs."""
    period, way, phase = rng.uniform(3.0, 8.0), rng.uniform(-np.pi, np.pi), rng.uniform(-np.pi, np.pi)
    scene.everywhere(swell=amount, swell_omega=2.0 * np.pi / period, swell_direction=way, swell_phase=phase)
    numbers = {"speed": amount, "period": period, "direction": way, "phase": phase}
    return Secret("surface_waves", numbers, "Stokes waves of second order over a floor", shared=True)


def tether(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A spring that softens when long; the stiffness is the straight line's along the way the robot went."""
    x, y = rng.uniform(-1.0, 1.0, 2)
    scene.own[[at.TETHER, at.TETHER_X, at.TETHER_Y, at.TETHER_SOFT]] = amount, x, y, rng.uniform(3.0, 8.0)
    form = "k d / sqrt(1 + (d/D)^2); least-squares stiffness and place along the track"
    return Secret("tether", {"stiffness": amount, "x": x, "y": y}, form)


def wall_effect(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A power law of the distance to the nearest of walls, floor, surface; range is where 1/e is left."""
    power, reach = rng.uniform(2.0, 4.0), rng.uniform(0.1, 0.3)
    scale = reach / (np.exp(1.0 / power) - 1.0)
    scene.everywhere(wall_gain=amount, wall_scale=scale, wall_power=power)
    form = "gain (1 + h/a)^-n, on all drag; range: the distance at which 1/e of it is left"
    return Secret("wall_effect", {"gain": amount, "range": reach}, form, shared=True)


def neighbour_wake(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Jets that fall with 1/d along and as a Gaussian across."""
    scene.everywhere(wake=amount)
    form = "1/d along the jet, Gaussian of width 0.05 m + 0.2 d across it"
    return Secret("neighbour_wake", {"gain": amount}, form, shared=True)


def thruster_lag(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Two stages in series; the time constant is their sum, the mean delay of both laws."""
    share = rng.uniform(0.05, 0.3)
    scene.own[[at.LAG_SLOW, at.LAG_FAST]] = (1.0 - share) * amount, share * amount
    return Secret("thruster_lag", {"time_constant": amount}, "second order; time constant: sum of both")


def thruster_deadband(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """No thrust below the width; behind it a ramp from zero or a jump."""
    continuous = rng.random() < 0.5
    scene.own[at.DEAD_CONTINUOUS if continuous else at.DEAD_JUMP] = amount
    form = "dead zone, c - width behind it" if continuous else "jump to c behind it"
    return Secret("thruster_deadband", {"width": amount}, form)


def thrust_curve(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Thrust that is a square law in part, or bent the other way; the exponent is that of the power nearest to it."""
    scene.own[at.THRUST_BEND] = signed(rng, amount)
    form = "|c| (1 + b (|c| - 1)); least-squares exponent of |c|^n at the commands of the run"
    return Secret("thrust_curve", {"exponent": 1.0 + float(scene.own[at.THRUST_BEND])}, form)


def thruster_asymmetry(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """(right - left) / mean."""
    scene.own[at.ASYMMETRY] = signed(rng, amount)
    return Secret("thruster_asymmetry", {"difference": float(scene.own[at.ASYMMETRY])}, "gain")


def torque_bias(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A constant yaw torque."""
    scene.own[at.TORQUE_BIAS] = signed(rng, amount)
    return Secret("torque_bias", {"torque": float(scene.own[at.TORQUE_BIAS])}, "constant")


def reverse_loss(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Each thruster weaker backwards."""
    scene.own[at.REVERSE_LOSS] = amount
    return Secret("reverse_loss", {"loss": amount}, "gain per thruster")


def advance_loss(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A thrust curve over the advance that bends; the slope is the straight line's at the speeds of the run."""
    bend = rng.uniform(-3.0, 3.0)
    scene.own[[at.ADVANCE, at.ADVANCE_CURVE]] = amount / (1.0 + 0.05 * bend), bend
    form = "1 - s a (1 + b |a|), a: speed along the thrust; least-squares slope weighted by thrust"
    return Secret("advance_loss", {"slope": amount}, form)


def crashback_loss(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A ring vortex takes thrust from what stops the robot, most at one speed; the slope is the straight line's."""
    scene.own[[at.CRASHBACK, at.CRASHBACK_PEAK]] = amount, rng.uniform(0.08, 0.2)
    form = "s a / (1 + (a/peak)^2), a: speed against the thrust; least-squares slope weighted by thrust"
    return Secret("crashback_loss", {"slope": amount}, form)


def battery_sag(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A discharge curve over the charge used, not a straight line over time."""
    scene.own[at.BATTERY] = amount
    return Secret("battery_sag", {"fraction_lost": amount}, "discharge curve; what is lost at the end")


def thruster_misalignment(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Both thrusters turned about the vertical where they stand, counter-clockwise positive."""
    scene.own[at.MISALIGNMENT] = signed(rng, amount)
    form = "both turned where they are mounted, so with the torque of the side force"
    return Secret("thruster_misalignment", {"angle": float(scene.own[at.MISALIGNMENT])}, form)


def buoyancy_trim(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A net weight."""
    scene.own[at.TRIM] = signed(rng, amount)
    return Secret("buoyancy_trim", {"force": float(scene.own[at.TRIM])}, "constant")


def pump_lag(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A lag, a play, or a play followed by a lag; the backlash is the full width of the play."""
    kind = rng.integers(3)
    lag = 0.0 if kind == 1 else amount
    play = 0.0 if kind == 0 else 0.06 * amount
    scene.own[[at.PUMP_LAG, at.PUMP_PLAY]] = lag, play
    return Secret("pump_lag", {"time_constant": lag, "backlash": play}, "play operator, then first order")


def hull_compressibility(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A gas volume by Boyle's law; the gradient is the straight line's through the surface at the depths visited."""
    scene.own[[at.SHRINK, at.SHRINK_SCALE]] = amount, at.SURFACE_PRESSURE / (at.RHO * at.GRAVITY)
    return Secret("hull_compressibility", {"gradient": amount}, "Boyle; least-squares line through the surface")


def density_gradient(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Water that grows denser ever more slowly; the gradient is the straight line's through the surface."""
    scene.everywhere(denser=amount, denser_scale=rng.uniform(2.0, 6.0))
    form = "exponential approach; least-squares line through the surface"
    return Secret("density_gradient", {"gradient": amount}, form, shared=True)


def surface_loss(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Thrust that comes back with depth as a tanh."""
    scale = rng.uniform(0.1, 0.2)
    scene.own[[at.BUBBLES, at.BUBBLES_REACH]] = amount, scale
    return Secret("surface_loss", {"loss": amount}, "1 - loss (1 - tanh(depth / scale))")


def stratification(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A density layer with a soft edge."""
    depth, force = rng.uniform(0.7, 1.3), amount
    scene.everywhere(layer_depth=depth, layer_force=force, layer_width=rng.uniform(0.02, 0.06))
    return Secret("stratification", {"depth": depth, "force": force}, "tanh step", shared=True)


def offset_centre(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Mass that lies ahead or astern, little aside, and moves with the water in the pump by up to a millimetre."""
    ahead, left = signed(rng, amount), amount * rng.uniform(-0.3, 0.3)
    scene.own[[at.CENTRE_AHEAD, at.CENTRE_LEFT, at.CENTRE_SHIFT]] = ahead, left, rng.uniform(-1e-3, 1e-3)
    form = "moves with the pump; where it is while that is neutral"
    return Secret("offset_centre", {"ahead": ahead, "left": left}, form)


def payload_shift(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Trim that changes within a second."""
    duration = scene.own[at.DURATION]
    rise, middle = rng.uniform(0.2, 2.0), duration * rng.uniform(0.2, 0.8)
    force = signed(rng, amount)
    scene.own[[at.PAYLOAD_TIME, at.PAYLOAD_RISE, at.PAYLOAD_FORCE]] = middle - 0.5 * rise, rise, force
    return Secret("payload_shift", {"time": middle, "force": force}, "ramp; time: its middle")


def wind(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Gusts of whole periods; the numbers are those of the steady wind that pushes as much in the mean."""
    x, y = direction(rng, amount)
    omega = 2.0 * np.pi * rng.integers(5, 30) / scene.own[at.DURATION]
    scene.everywhere(wind=amount, wind_direction=np.arctan2(y, x), gust_omega=omega)
    scene.everywhere(gust_phase=rng.uniform(-np.pi, np.pi), wind_turn=rng.uniform(-0.01, 0.01))
    steady = float(np.sqrt(1.0 + 0.5 * GUST**2))
    form = "gusts; yaw by the sine of twice the angle; numbers: root mean square of the wind"
    return Secret("wind", {"x": steady * x, "y": steady * y}, form, shared=True)


def hull_emergence(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A spheroid that comes out of the water; the share is that of straight walls at the depths visited."""
    scene.own[at.EMERGE] = amount
    form = "spheroid s^2 (3 - 2 s), s = 1/2 + z / height; least-squares share of straight walls"
    return Secret("hull_emergence", {"share": amount}, form)


BODY: dict[str, Hide] = {
    hide.__name__: hide
    for hide in (
        linear_drag, anisotropic_drag, added_mass, steady_current, sheared_current, tidal_current, tether, wall_effect,
        neighbour_wake, thruster_lag, thruster_deadband, thruster_asymmetry, torque_bias, reverse_loss, advance_loss,
        battery_sag, thruster_misalignment, buoyancy_trim, pump_lag, hull_compressibility, stratification,
        payload_shift, density_gradient, surface_loss, surface_waves, wind, hull_emergence, crashback_loss,
        offset_centre, thrust_curve,
    )
}  # fmt: skip
