"""Effects that the interface's table does not have, with the names that a right answer may give them.

Patterns are those of fnmatch. `tolerated` are entries of the table that describe the same thing nearly as well, so
that naming them is neither right nor wrong.
"""

from __future__ import annotations

import numpy as np

from concealer import layout as at
from concealer.catalogue import Hide
from concealer.scene import Scene, Secret, signed


def _sealed(kind: str, coefficient: float, names: str, tolerated: tuple[str, ...] = ()) -> Secret:
    patterns = tuple(f"unknown:{name}" for name in names.split())
    return Secret(patterns[0], {"coefficient": coefficient}, kind, acceptable=patterns, tolerated=tolerated)


def _swing(rng: np.random.Generator, amount: float, scene: Scene, place: int) -> float:
    """Period log-uniform in 15 to 90 s; the coefficient is the amplitude."""
    period = float(np.exp(rng.uniform(np.log(15.0), np.log(90.0))))
    scene.own[[place, at.OSC_OMEGA, at.OSC_PHASE]] = amount, 2.0 * np.pi / period, rng.uniform(-np.pi, np.pi)
    return period


def oscillating_x(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A force along world x that swings."""
    period = _swing(rng, amount, scene, at.OSC_X)
    return _sealed(f"A sin(2 pi t / {period:.1f} s + phase)", amount, "world_x~sin_t world_x~cos_t")


def oscillating_y(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A force along world y that swings."""
    period = _swing(rng, amount, scene, at.OSC_Y)
    return _sealed(f"A sin(2 pi t / {period:.1f} s + phase)", amount, "world_y~sin_t world_y~cos_t")


def oscillating_z(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A force along the vertical that swings."""
    period = _swing(rng, amount, scene, at.OSC_Z)
    names = "heave~sin_t world_z~sin_t heave~cos_t world_z~cos_t"
    return _sealed(f"A sin(2 pi t / {period:.1f} s + phase)", amount, names)


def oscillating_yaw(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A torque that swings."""
    period = _swing(rng, amount, scene, at.OSC_YAW)
    return _sealed(f"A sin(2 pi t / {period:.1f} s + phase)", amount, "yaw~sin_t yaw~cos_t")


def torque_of_place(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A torque proportional to x or to y."""
    along_x = bool(rng.random() < 0.5)
    value = signed(rng, amount)
    scene.own[at.TORQUE_AT_X if along_x else at.TORQUE_AT_Y] = value
    return _sealed("N = c x" if along_x else "N = c y", value, "yaw~x" if along_x else "yaw~y")


def vortex_patch(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """One Lamb-Oseen vortex; the coefficient is its circulation."""
    x, y = rng.uniform(-0.8, 0.8, 2)
    value = signed(rng, amount)
    scene.everywhere(vortex=value, vortex_x=x, vortex_y=y, vortex_core=rng.uniform(0.4, 0.8))
    names = "world_x~y world_y~x world_x~*y* world_y~*x*"
    secret = _sealed("Lamb-Oseen vortex", value, names, ("sheared_current",))
    secret.shared = True
    return secret


def dry_friction(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """Friction of a turning cable: N = -c sign(r), smooth within 0.02 rad/s."""
    scene.own[[at.FRICTION_YAW, at.FRICTION_RATE]] = amount, 0.02
    names = "yaw~|r|^-1*r yaw~|r|^-0.5*r yaw~|r|^0*r yaw~sign_r yaw~sign(r)"
    return _sealed("N = -c tanh(r / 0.02)", -amount, names)


def drag_of_power_three_halves(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A drag of a power between laminar and turbulent."""
    scene.own[at.POWER_THREE_HALVES] = amount
    names = "surge~|u|^0.5*u surge~u^1.5 surge~|u|^1.5 surge~speed^0.5*u surge~|speed|^0.5*u"
    return _sealed("X = -c |u|^0.5 u", -amount, names)


def cubic_drag(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A drag that grows faster than the square."""
    scene.own[at.CUBIC] = amount
    names = "surge~u^3 surge~u*u*u surge~|u|^2*u surge~u^2*u surge~speed^2*u surge~|u|*u^2"
    return _sealed("X = -c u^3", -amount, names)


def pump_jet(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """The pump's jet pushes forward or turns the robot; the rate is measured over 0.5 s."""
    turns = bool(rng.random() < 0.5)
    value = signed(rng, amount * (0.02 if turns else 1.0))
    scene.own[at.RATE_YAW if turns else at.RATE_SURGE] = value
    return _sealed("c d(pump)/dt", value, "yaw~pump_rate" if turns else "surge~pump_rate")


def pump_kick(_rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """The pump's jet pushes upward while it fills: ahead of the buoyancy, where a lag would be behind."""
    scene.own[at.RATE_HEAVE] = amount
    return _sealed("Z = c d(pump)/dt", amount, "heave~pump_rate world_z~pump_rate")


def trim_fin(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A bent fin: a torque with the square of the speed."""
    scene.own[at.FIN] = signed(rng, amount)
    names = "yaw~|u|*u yaw~u^2 yaw~u*speed yaw~speed*u yaw~speed^2 yaw~u*|u| yaw~u*u"
    return _sealed("N = c |u| u", float(scene.own[at.FIN]), names)


def lift(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A hull that climbs when it is fast."""
    scene.own[at.LIFT] = signed(rng, amount)
    names = "heave~u^2 heave~u*u heave~|u|*u heave~speed^2 world_z~u^2 heave~u*speed heave~speed*speed"
    return _sealed("Z = c u^2", float(scene.own[at.LIFT]), names)


def weather_vane(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A torque with the sine of the heading."""
    scene.own[at.VANE] = signed(rng, amount)
    return _sealed("N = c sin(yaw)", float(scene.own[at.VANE]), "yaw~sin_yaw")


def pump_torque(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A torque with the pump's position."""
    scene.own[at.PUMP_YAW] = signed(rng, amount)
    return _sealed("N = c pump", float(scene.own[at.PUMP_YAW]), "yaw~pump")


def roll_coupling(rng: np.random.Generator, amount: float, scene: Scene) -> Secret:
    """A hull that leans when it turns pushes sideways."""
    scene.own[at.ROLL_SWAY] = signed(rng, amount)
    return _sealed("Y = c |r| r", float(scene.own[at.ROLL_SWAY]), "sway~|r|*r sway~r*|r| sway~r sway~|r|^*r")


OUTSIDE: dict[str, Hide] = {
    hide.__name__: hide
    for hide in (
        oscillating_x, oscillating_y, oscillating_z, oscillating_yaw, torque_of_place, vortex_patch, dry_friction,
        drag_of_power_three_halves, cubic_drag, pump_jet, pump_kick, trim_fin, lift, weather_vane, pump_torque,
        roll_coupling,
    )
}  # fmt: skip
