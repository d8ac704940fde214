"""Each effect of hull, water and weight against a closed form or a calculation by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z

Swim = Callable[..., Any]
OFF = (0.0, 0.0, 0.0)
FINE = {"tick": 0.5, "steps": 50}


def test_linear_drag_lets_a_robot_coast_down(swim: Swim, lily: SimpleNamespace) -> None:
    """Forwards, sideways, upwards and turning each decay as exp(-d t / m) with their own coefficient."""
    numbers = {"linear_drag.surge": 0.02, "linear_drag.heave": 0.05, "linear_drag.yaw": 3e-5}
    path = swim(numbers, {SURGE: 0.05, HEAVE: 0.01}, [OFF] * 40)
    turning = swim(numbers, {YAW_RATE: 0.5}, [OFF] * 40)
    time = 0.5 * np.arange(41)
    np.testing.assert_allclose(path[:, 0, SURGE], 0.05 * np.exp(-0.02 * time / lily.mass), rtol=1e-8)
    np.testing.assert_allclose(path[:, 0, HEAVE], 0.01 * np.exp(-0.05 * time / lily.mass), rtol=1e-8)
    np.testing.assert_allclose(turning[:, 0, YAW_RATE], 0.5 * np.exp(-3e-5 * time / lily.inertia), rtol=1e-8)
    aside = swim({"linear_drag.sway": 0.04}, {SWAY: 0.03}, [OFF] * 40)
    np.testing.assert_allclose(aside[:, 0, SWAY], 0.03 * np.exp(-0.04 * time / lily.mass), rtol=1e-8)


@pytest.mark.parametrize(("column", "name"), [(SWAY, "sway_ratio"), (HEAVE, "heave_ratio")])
def test_anisotropic_drag_of_pure_motion(swim: Swim, lily: SimpleNamespace, column: int, name: str) -> None:
    """Along its own axis a robot slows as v0 / (1 + a k v0 t / m), a being the ratio; forwards the ratio is nothing."""
    numbers = {"drag": lily.drag, f"anisotropic_drag.{name}": 3.0}
    time = 0.5 * np.arange(21)
    path = swim(numbers, {column: 0.04}, [OFF] * 20)
    np.testing.assert_allclose(path[:, 0, column], 0.04 / (1 + 3.0 * lily.drag * 0.04 * time / lily.mass), rtol=1e-7)
    ahead = swim(numbers, {SURGE: 0.04}, [OFF] * 20)
    np.testing.assert_allclose(ahead[:, 0, SURGE], 0.04 / (1 + lily.drag * 0.04 * time / lily.mass), rtol=1e-7)


def test_each_axis_by_its_own_speed(acceleration: Swim, lily: SimpleNamespace) -> None:
    """In mixed motion X = -k |u| u, Y = -k a |v| v, Z = -k b |w| w: no axis feels another one's speed."""
    numbers = {"drag": lily.drag, "anisotropic_drag.sway_ratio": 3.0, "anisotropic_drag.heave_ratio": 0.5}
    numbers["anisotropic_drag.form"] = 3.0
    rates = acceleration(numbers, {SURGE: -0.06, SWAY: 0.02, HEAVE: 0.01}) * lily.mass
    wanted = [lily.drag * 0.06**2, -3.0 * lily.drag * 0.02**2, -0.5 * lily.drag * 0.01**2]
    assert rates[:3] == pytest.approx(wanted, rel=1e-9)


def test_strips_of_a_hull_that_drifts_and_turns(acceleration: Swim, lily: SimpleNamespace) -> None:
    """Cross-flow of v + x r, summed over ten thousand strips, gives force and moment of the closed integral."""
    length, ratio, v, r = 0.2, 3.0, 0.02, 0.5
    numbers = {"drag": lily.drag, "anisotropic_drag.sway_ratio": ratio, "anisotropic_drag.length": length}
    numbers["anisotropic_drag.form"] = 4.0
    place = length * ((np.arange(10_000) + 0.5) / 10_000 - 0.5)
    aside, spin = v + place * r, place * r
    force = -ratio * lily.drag * np.mean(np.abs(aside) * aside)
    moment = -ratio * lily.drag * np.mean(place * (np.abs(aside) * aside - np.abs(spin) * spin))
    rates = acceleration(numbers, {SURGE: 0.06, SWAY: v, YAW_RATE: r})
    assert (rates[1] + 0.06 * r) * lily.mass == pytest.approx(force, rel=1e-6)
    assert rates[3] * lily.inertia == pytest.approx(moment, rel=1e-6)


def test_munk_moment(acceleration: Swim, lily: SimpleNamespace) -> None:
    """Drifting at u, v a body of added mass A feels N = -A u v, and turns by it over its whole inertia."""
    numbers = {"added_mass.sway_minus_surge": 0.044, "added_mass.yaw": 6e-5}
    rates = acceleration(numbers, {SURGE: 0.06, SWAY: 0.02})
    assert rates[3] == pytest.approx(-0.044 * 0.06 * 0.02 / (lily.inertia + 6e-5), rel=1e-12)


def test_added_mass_keeps_kirchhoffs_integrals(swim: Swim, lily: SimpleNamespace) -> None:
    """Without force the energy of hull and water, and their momentum in the world, stay as they are."""
    added, turning = 0.3, 2e-4
    numbers = {"added_mass.sway_minus_surge": added, "added_mass.yaw": turning}
    path = swim(numbers, {SURGE: 0.06, SWAY: 0.03, YAW_RATE: 0.7}, [OFF] * 60, **FINE)[:, 0]
    along, aside = lily.mass * path[:, SURGE], (lily.mass + added) * path[:, SWAY]
    energy = along * path[:, SURGE] + aside * path[:, SWAY] + (lily.inertia + turning) * path[:, YAW_RATE] ** 2
    east = along * np.cos(path[:, YAW]) - aside * np.sin(path[:, YAW])
    north = along * np.sin(path[:, YAW]) + aside * np.cos(path[:, YAW])
    for kept in (energy, east, north):
        np.testing.assert_allclose(kept, kept[0], rtol=1e-7, atol=1e-9)
    assert np.ptp(path[:, YAW_RATE]) > 0.1


def test_a_steady_current_carries_everything_along(swim: Swim, lily: SimpleNamespace) -> None:
    """Galilei: seen from the moving water a robot with drag and added mass moves as in still water."""
    numbers = {
        "drag": lily.drag,
        "yaw_drag": lily.yaw_drag,
        "linear_drag.sway": 0.02,
        "added_mass.sway_minus_surge": 0.1,
        "anisotropic_drag.sway_ratio": 2.0,
        "advance_loss.slope": 3.0,
    }
    commands = [(math.sin(tick), math.cos(2.0 * tick), 0.0) for tick in range(60)]
    still = swim(numbers, {SURGE: 0.02}, commands)[:, 0]
    moving = {**numbers, "steady_current.x": 0.01, "steady_current.y": -0.004}
    carried = swim(moving, {SURGE: 0.03, SWAY: -0.004}, commands)[:, 0]
    time = 0.5 * np.arange(61)
    # What the integrator leaves over at steps of 0.05 s is below 1e-8.
    np.testing.assert_allclose(carried[:, X], still[:, X] + 0.01 * time, rtol=0, atol=1e-8)
    np.testing.assert_allclose(carried[:, Y], still[:, Y] - 0.004 * time, rtol=0, atol=1e-8)
    np.testing.assert_allclose(carried[:, YAW], still[:, YAW], rtol=0, atol=1e-8)


def test_an_eddy_by_hand(acceleration: Swim, lily: SimpleNamespace) -> None:
    """0.6 m north of an axis the water flows west, circulation / (2 pi d) (1 - exp(-d^2 / core^2)) fast."""
    numbers = {"linear_drag.surge": 1.0, "linear_drag.sway": 1.0, "eddy.x": 2.0, "eddy.y": 2.4}
    numbers |= {"eddy.circulation": 0.03, "eddy.core": 0.5}
    rates = acceleration(numbers, {X: 2.0, Y: 3.0, Z: -1.5, YAW: 0.0})
    west = 0.03 / (2.0 * math.pi * 0.6) * (1.0 - math.exp(-((0.6 / 0.5) ** 2)))
    assert rates[0] < 0.0
    assert rates[1] * lily.mass == pytest.approx(0.0, abs=1e-15)
    quadratic = acceleration({"steady_current.x": -west, "linear_drag.surge": 1.0}, {Z: -1.5, YAW: 0.0})
    assert rates[0] == pytest.approx(quadratic[0], rel=1e-9)


def test_currents_by_hand(acceleration: Swim, lily: SimpleNamespace) -> None:
    """At rest a linear drag of 1 N s/m shows the water's velocity, of all three currents at once, as a force."""
    numbers = {
        "linear_drag.surge": 1.0, "linear_drag.sway": 1.0, "steady_current.x": 0.001,
        "sheared_current.x": 0.01, "sheared_current.y": -0.02, "sheared_current.dx_dy": 0.003,
        "sheared_current.dx_dz": 0.005, "sheared_current.dy_dx": -0.007, "sheared_current.dy_dz": 0.011,
        "tidal_current.x": 0.1, "tidal_current.y": 0.2, "tidal_current.period": 40.0, "tidal_current.phase": 0.25,
    }  # fmt: skip
    rates = acceleration(numbers, {X: 2.0, Y: 3.0, Z: -1.5, YAW: math.pi / 2}, time=7.0)
    swing = math.sin(2 * math.pi * 7.0 / 40.0 + 0.25)
    east = 0.001 + 0.01 + 0.003 * 3.0 - 0.005 * 1.5 + 0.1 * swing
    north = -0.02 - 0.007 * 2.0 - 0.011 * 1.5 + 0.2 * swing
    assert rates[:2] * lily.mass == pytest.approx([north, -east], rel=1e-9)


def test_a_tether_swings(swim: Swim, lily: SimpleNamespace) -> None:
    """Without drag a robot on a spring swings about its end with sqrt(k / m), whichever way it points."""
    path = swim({"tether.stiffness": 0.05, "tether.x": 1.0, "tether.y": -0.5}, {X: 1.2, YAW: 0.7}, [OFF] * 60, **FINE)
    swing = np.cos(math.sqrt(0.05 / lily.mass) * 0.5 * np.arange(61))
    np.testing.assert_allclose(path[:, 0, X], 1.0 + 0.2 * swing, rtol=0, atol=1e-7)
    np.testing.assert_allclose(path[:, 0, Y], -0.5 + 0.5 * swing, rtol=0, atol=1e-7)


@pytest.mark.parametrize(
    ("place", "distance"),
    [((0.0, 0.0, -1.0), 1.0), ((2.9, 0.0, -1.0), 0.1), ((0.0, -2.7, -1.0), 0.3), ((0.0, 0.0, -1.8), 0.2),
     ((1.0, 1.0, -0.05), 0.05)],
)  # fmt: skip
def test_walls_make_drag_grow(acceleration: Swim, place: tuple[float, ...], distance: float) -> None:
    """Near any of walls, floor and surface all quadratic drag is 1 + gain exp(-h / range) times what it is."""
    state = {X: place[0], Y: place[1], Z: place[2], SURGE: 0.03, SWAY: -0.02, HEAVE: 0.01, YAW_RATE: 0.4}
    turn = {SURGE: state[SWAY] * state[YAW_RATE], SWAY: -state[SURGE] * state[YAW_RATE]}
    drag, bounds = {"drag": 1.7778, "yaw_drag": 1.14e-4}, ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
    plain = acceleration(drag, state, bounds=bounds)
    near = acceleration({**drag, "wall_effect.gain": 0.8, "wall_effect.range": 0.15}, state, bounds=bounds)
    for rates in (plain, near):
        rates[0] -= turn[SURGE]
        rates[1] -= turn[SWAY]
    np.testing.assert_allclose(near / plain, 1.0 + 0.8 * math.exp(-distance / 0.15), rtol=1e-9)


@pytest.mark.parametrize(
    ("ahead", "thrust", "felt"),
    [(-0.1, 0.01, -2e-3), (-0.2, 0.01, -1e-3), (-0.4, 0.01, -0.5e-3), (-0.05, 0.01, -2e-3), (0.2, 0.01, 0.0),
     (0.2, -0.01, 1e-3), (-0.2, 0.0, 0.0)],
)  # fmt: skip
def test_a_neighbours_jet_on_its_axis(
    acceleration: Swim, lily: SimpleNamespace, ahead: float, thrust: float, felt: float
) -> None:
    """A fifth of a neighbour's 10 mN is felt 0.1 m behind it, half of that at 0.2 m, and nothing in front of it."""
    yaw = 0.6
    east, north = math.cos(yaw), math.sin(yaw)
    own = [ahead * east, ahead * north, -1.0, 5.0, 5.0]
    other = [0.0, 0.0, -1.0, thrust * east, thrust * north]
    state = {X: own[0], Y: own[1], YAW: yaw}
    rates = acceleration({"neighbour_wake.gain": 0.2}, state, neighbours=[own, other], own=0)
    np.testing.assert_allclose(rates[:3] * lily.mass, [felt, 0.0, 0.0], rtol=1e-9, atol=1e-15)


def test_a_jet_is_narrow(acceleration: Swim) -> None:
    """0.0607 m beside the axis, 0.1 m behind, 1/e of the push is left; three times as far 1/e^9."""
    other = [0.0, 0.0, -1.0, 0.01, 0.0]
    pushes = [
        acceleration({"neighbour_wake.gain": 0.2}, {X: -0.1, Y: aside}, neighbours=[other])[0]
        for aside in (0.0, 0.0607, 3 * 0.0607)
    ]
    np.testing.assert_allclose(np.array(pushes) / pushes[0], [1.0, math.exp(-1), math.exp(-9)], rtol=1e-9)


def test_who_follows_another_is_blown_back(swim: Swim, lily: SimpleNamespace) -> None:
    """In the simulator's loop a passive robot 0.2 m behind a thrusting one gets -gain F / 2 in the first tick."""
    command = [(1.0, 1.0, 0.0), OFF]
    path = swim({"neighbour_wake.gain": 0.2}, [{X: 0.2}, {X: 0.0}], [command], tick=0.01, steps=1)
    assert path[1, 1, SURGE] == pytest.approx(-0.2 * 0.01 * 0.5 * 0.01 / lily.mass, rel=1e-5)
    assert path[1, 0, SURGE] == pytest.approx(0.01 * 0.01 / lily.mass, rel=1e-9)  # itself it does not feel


def test_a_torque_bias_turns(swim: Swim, lily: SimpleNamespace) -> None:
    """A constant torque comes to the rate sqrt(N / Cr)."""
    path = swim({"yaw_drag": lily.yaw_drag, "torque_bias.torque": -1e-5}, {}, [OFF] * 200)
    assert path[-1, 0, YAW_RATE] == pytest.approx(-math.sqrt(1e-5 / lily.yaw_drag), rel=1e-6)


def test_a_buoyancy_trim_lifts(swim: Swim, lily: SimpleNamespace) -> None:
    """A net force comes to the speed sqrt(F / k): 0.98 mN lift a Lily at 23 mm/s."""
    path = swim({"drag": lily.drag, "buoyancy_trim.force": 9.8e-4}, {Z: -40.0}, [OFF] * 400)
    assert path[-1, 0, HEAVE] == pytest.approx(math.sqrt(9.8e-4 / lily.drag), rel=1e-6)


def test_a_compressible_hull_sinks_ever_faster(swim: Swim, lily: SimpleNamespace) -> None:
    """Without drag it leaves its depth as cosh(sqrt(gradient / m) t), counted from the surface."""
    path = swim({"hull_compressibility.gradient": 2e-3}, {Z: -0.5}, [OFF] * 60, **FINE)
    depth = 0.5 * np.cosh(math.sqrt(2e-3 / lily.mass) * 0.5 * np.arange(61))
    np.testing.assert_allclose(-path[:, 0, Z], depth, rtol=1e-8)


def test_the_pump_holds_a_compressible_hull(acceleration: Swim) -> None:
    """Where gradient times depth is what the pump lifts, no force is left."""
    assert acceleration({"hull_compressibility.gradient": 2e-3}, {Z: -0.75}, (0.0, 0.0, 1.5e-3))[2] == pytest.approx(
        0.0, abs=1e-15
    )


@pytest.mark.parametrize(("gradient", "share"), [(2e-3, 10.33 / 12.33), (-2e-3, 1.0)])
def test_only_a_hull_that_shrinks_is_a_gas(
    acceleration: Swim, lily: SimpleNamespace, gradient: float, share: float
) -> None:
    """At 2 m, under 12.33 m of water and air, gas has given way by 10.33/12.33 of what it would at its first rate."""
    rates = acceleration({"hull_compressibility.gradient": gradient, "hull_compressibility.gas": 1.0}, {Z: -2.0})
    assert rates[2] * lily.mass == pytest.approx(-gradient * 2.0 * share, rel=1e-9)


@pytest.mark.parametrize(
    ("depth", "share"), [(0.5, 0.0), (0.98, 0.0), (1.0, 0.5), (1.01, 0.84375), (1.02, 1.0), (2, 1)]
)
def test_a_layer_of_density(acceleration: Swim, lily: SimpleNamespace, depth: float, share: float) -> None:
    """Above it nothing, below it the whole force, within 2 cm a cubic: 27/32 half-way into its lower half."""
    rates = acceleration({"stratification.depth": 1.0, "stratification.force": 2e-3}, {Z: -depth})
    assert rates[2] * lily.mass == pytest.approx(2e-3 * share, abs=1e-12)


def test_a_payload_that_shifts(swim: Swim, lily: SimpleNamespace) -> None:
    """Before its time nothing, after it a constant force: v = F (t - t0) / m."""
    path = swim({"payload_shift.time": 2.0, "payload_shift.force": -1e-3}, {}, [OFF] * 8)
    speeds = -1e-3 / lily.mass * np.maximum(0.5 * np.arange(9) - 2.0, 0.0)
    # The last stage of the step that ends at its time feels it already: a sixth of a step of 0.05 s.
    np.testing.assert_allclose(path[:, 0, HEAVE], speeds, rtol=0, atol=1e-3 / lily.mass * 0.05 / 6 * 1.001)


def test_thrust_falls_with_speed(swim: Swim, lily: SimpleNamespace) -> None:
    """At full thrust the terminal speed solves k u^2 = F (1 - s u); backwards the same."""
    numbers, slope = {"drag": lily.drag, "yaw_drag": lily.yaw_drag, "advance_loss.slope": 3.0}, 3.0
    force = 2 * lily.thrust
    speed = (-slope * force + math.sqrt((slope * force) ** 2 + 4 * lily.drag * force)) / (2 * lily.drag)
    assert swim(numbers, {}, [(1, 1, 0)] * 80)[-1, 0, SURGE] == pytest.approx(speed, rel=1e-6)
    assert swim(numbers, {}, [(-1, -1, 0)] * 80)[-1, 0, SURGE] == pytest.approx(-speed, rel=1e-6)


def test_advance_loss_of_each_thruster_by_itself(acceleration: Swim, lily: SimpleNamespace) -> None:
    """One forwards, one backwards at speed u: each loses s F u against its push, so the robot is braked by 2 s F u."""
    rates = acceleration({"advance_loss.slope": 3.0}, {SURGE: 0.05}, (0.004, -0.004, 0.0))
    assert rates[0] * lily.mass == pytest.approx(-2 * 3.0 * 0.004 * 0.05, rel=1e-12)
    assert rates[3] * lily.inertia == pytest.approx(-2 * 0.004 * lily.lever, rel=1e-12)


def test_a_crash_stop_takes_as_long_as_the_lost_thrust_makes_it(swim: Swim, lily: SimpleNamespace) -> None:
    """Astern from u0 without drag m u' = -F (1 - s u) until it stands, after that m u' = -F: both are solved by hand.

    1 - s u grows as exp(s F t / m), so it stands when that has grown from 1 - s u0 to 1.
    """
    slope, begin, force = 5.0, 0.1, 2 * lily.thrust
    path = swim({"crashback_loss.slope": slope}, {SURGE: begin}, [(-1, -1, 0)] * 15, steps=50)[:, 0, SURGE]
    time = 0.5 * np.arange(16)
    stands = -math.log(1.0 - slope * begin) * lily.mass / (slope * force)
    braking = (1.0 - (1.0 - slope * begin) * np.exp(slope * force * time / lily.mass)) / slope
    astern = -force * (time - stands) / lily.mass
    assert time[0] < stands < time[-1]
    # One step holds the kink at rest: its thrust errs by s F times the step's change of speed.
    np.testing.assert_allclose(path, np.where(time < stands, braking, astern), rtol=0, atol=2e-6)


@pytest.mark.parametrize(
    ("speed", "forces", "left"),
    [
        (0.05, (0.004, 0.004), (1.0, 1.0)),
        (0.0, (0.004, -0.004), (1.0, 1.0)),
        (0.05, (-0.004, -0.004), (0.8, 0.8)),
        (-0.05, (0.004, 0.004), (0.8, 0.8)),
        (0.05, (0.004, -0.004), (1.0, 0.8)),
        (0.4, (-0.004, 0.0), (0.0, 1.0)),
    ],
)
def test_thrust_against_the_motion_alone_is_lost(
    acceleration: Swim, lily: SimpleNamespace, speed: float, forces: tuple[float, float], left: tuple[float, float]
) -> None:
    """Along the push and at rest nothing, against it s u of the thrust, at most all, of each thruster by itself."""
    rates = acceleration({"crashback_loss.slope": 4.0}, {SURGE: speed}, (*forces, 0.0))
    given = [force * share for force, share in zip(forces, left, strict=True)]
    assert rates[0] * lily.mass == pytest.approx(sum(given), rel=1e-12, abs=1e-18)
    assert rates[3] * lily.inertia == pytest.approx((given[1] - given[0]) * lily.lever, rel=1e-12, abs=1e-18)


def test_thrusters_off_their_axis(acceleration: Swim, lily: SimpleNamespace) -> None:
    """The force of both is turned by the angle; the arm makes a moment of its sideways part."""
    numbers = {"thruster_misalignment.angle": 0.1, "thruster_misalignment.arm": -0.05}
    rates = acceleration(numbers, {}, (0.004, 0.003, 0.002))
    expected = [0.007 * math.cos(0.1), 0.007 * math.sin(0.1), 0.002]
    np.testing.assert_allclose(rates[:3] * lily.mass, expected, rtol=1e-12)
    turning = -0.001 * lily.lever - 0.05 * 0.007 * math.sin(0.1)
    assert rates[3] * lily.inertia == pytest.approx(turning, rel=1e-12)
