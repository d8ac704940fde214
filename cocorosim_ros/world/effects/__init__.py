"""EFFECTS: the list of our physics beside inertia and actuators. The order is the order of summation.

BASIC_EFFECTS are what every simulation of a robot has; their texts are compiled for four robots at once too, and keep
to what `compiling.four` allows. CATALOGUE_EFFECTS, each off unless a platform asks for it, are what real robots
have beyond that, and a defect of the released CoCoRoSim. An effect's own file says all that is known of it: equation,
numbers, how a diagnosis looks for it, what to check on the robot, an example; everything else is made from this table.
The eddy is reported as a law outside the catalogue; LAWS are places for laws that no catalogue has. OF_ACTUATORS act
for the rudders and fins among a platform's actuators, and no platform names them as effects.
"""

from __future__ import annotations

from cocorosim_ros.world.effects.added_mass import ADDED_MASS
from cocorosim_ros.world.effects.advance_loss import ADVANCE_LOSS
from cocorosim_ros.world.effects.anisotropic_drag import ANISOTROPIC_DRAG
from cocorosim_ros.world.effects.battery_sag import BATTERY_SAG
from cocorosim_ros.world.effects.buoyancy_trim import BUOYANCY_TRIM
from cocorosim_ros.world.effects.crashback_loss import CRASHBACK_LOSS
from cocorosim_ros.world.effects.density_gradient import DENSITY_GRADIENT
from cocorosim_ros.world.effects.eddy import EDDY
from cocorosim_ros.world.effects.fin import FIN
from cocorosim_ros.world.effects.hull_compressibility import HULL_COMPRESSIBILITY
from cocorosim_ros.world.effects.hull_emergence import HULL_EMERGENCE
from cocorosim_ros.world.effects.hull_lift import HULL_LIFT
from cocorosim_ros.world.effects.law import LAW
from cocorosim_ros.world.effects.linear_drag import LINEAR_DRAG
from cocorosim_ros.world.effects.misplaced_root_drag import MISPLACED_ROOT_DRAG
from cocorosim_ros.world.effects.neighbour_wake import NEIGHBOUR_WAKE
from cocorosim_ros.world.effects.net_buoyancy import NET_BUOYANCY
from cocorosim_ros.world.effects.offset_centre import OFFSET_CENTRE
from cocorosim_ros.world.effects.patch_force import PATCH_FORCE
from cocorosim_ros.world.effects.payload_shift import PAYLOAD_SHIFT
from cocorosim_ros.world.effects.pump_lag import PUMP_LAG
from cocorosim_ros.world.effects.quadratic_drag import QUADRATIC_DRAG
from cocorosim_ros.world.effects.reverse_loss import REVERSE_LOSS
from cocorosim_ros.world.effects.rudder import RUDDER
from cocorosim_ros.world.effects.sheared_current import SHEARED_CURRENT
from cocorosim_ros.world.effects.side_thrust_lever import SIDE_THRUST_LEVER
from cocorosim_ros.world.effects.steady_current import STEADY_CURRENT
from cocorosim_ros.world.effects.stratification import STRATIFICATION
from cocorosim_ros.world.effects.surface_loss import SURFACE_LOSS
from cocorosim_ros.world.effects.surface_waves import SURFACE_WAVES
from cocorosim_ros.world.effects.tether import TETHER
from cocorosim_ros.world.effects.tether_drag import TETHER_DRAG
from cocorosim_ros.world.effects.thrust_curve import THRUST_CURVE
from cocorosim_ros.world.effects.thruster_asymmetry import THRUSTER_ASYMMETRY
from cocorosim_ros.world.effects.thruster_deadband import THRUSTER_DEADBAND
from cocorosim_ros.world.effects.thruster_lag import THRUSTER_LAG
from cocorosim_ros.world.effects.thruster_misalignment import THRUSTER_MISALIGNMENT
from cocorosim_ros.world.effects.tidal_current import TIDAL_CURRENT
from cocorosim_ros.world.effects.torque_bias import TORQUE_BIAS
from cocorosim_ros.world.effects.wall_effect import WALL_EFFECT
from cocorosim_ros.world.effects.wash_loss import WASH_LOSS
from cocorosim_ros.world.effects.wind import WIND
from cocorosim_ros.world.terms.effect import Effect

BASIC_EFFECTS: dict[str, Effect] = {
    "quadratic_drag": QUADRATIC_DRAG,
    "net_buoyancy": NET_BUOYANCY,
    "patch_force": PATCH_FORCE,
}
LAWS: dict[str, Effect] = {"law_1": LAW, "law_2": LAW, "law_3": LAW}
CATALOGUE_EFFECTS: dict[str, Effect] = {
    "linear_drag": LINEAR_DRAG,
    "anisotropic_drag": ANISOTROPIC_DRAG,
    "added_mass": ADDED_MASS,
    "steady_current": STEADY_CURRENT,
    "sheared_current": SHEARED_CURRENT,
    "tidal_current": TIDAL_CURRENT,
    "tether": TETHER,
    "wall_effect": WALL_EFFECT,
    "neighbour_wake": NEIGHBOUR_WAKE,
    "thruster_lag": THRUSTER_LAG,
    "thruster_deadband": THRUSTER_DEADBAND,
    "thrust_curve": THRUST_CURVE,
    "thruster_asymmetry": THRUSTER_ASYMMETRY,
    "torque_bias": TORQUE_BIAS,
    "reverse_loss": REVERSE_LOSS,
    "advance_loss": ADVANCE_LOSS,
    "battery_sag": BATTERY_SAG,
    "thruster_misalignment": THRUSTER_MISALIGNMENT,
    "buoyancy_trim": BUOYANCY_TRIM,
    "pump_lag": PUMP_LAG,
    "hull_compressibility": HULL_COMPRESSIBILITY,
    "stratification": STRATIFICATION,
    "payload_shift": PAYLOAD_SHIFT,
    "eddy": EDDY,
    "misplaced_root_drag": MISPLACED_ROOT_DRAG,
    "hull_lift": HULL_LIFT,
    "wind": WIND,
    "density_gradient": DENSITY_GRADIENT,
    "hull_emergence": HULL_EMERGENCE,
    "side_thrust_lever": SIDE_THRUST_LEVER,
    "surface_loss": SURFACE_LOSS,
    "surface_waves": SURFACE_WAVES,
    "tether_drag": TETHER_DRAG,
    "crashback_loss": CRASHBACK_LOSS,
    "wash_loss": WASH_LOSS,
    "offset_centre": OFFSET_CENTRE,
    **LAWS,
}
RUDDERS: dict[str, Effect] = {"rudder_1": RUDDER, "rudder_2": RUDDER}
FINS: dict[str, Effect] = {"fin_1": FIN, "fin_2": FIN, "fin_3": FIN, "fin_4": FIN}
OF_ACTUATORS: dict[str, Effect] = {**RUDDERS, **FINS}
EFFECTS: dict[str, Effect] = {**BASIC_EFFECTS, **CATALOGUE_EFFECTS, **OF_ACTUATORS}
