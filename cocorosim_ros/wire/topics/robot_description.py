"""A robot as URDF, made from the numbers of its platform, and its fixed frames.

Links carry the robot's name (lily_01/base_link), so that RViz and Foxglove show many robots without a prefix to be set.
Hull, mass, yaw inertia, and where thrusters and sensors are and point, are the platform's. The model has no roll and no
pitch, so inertia about these axes is that of a homogeneous box. How thick a thruster is drawn says nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Hull, Vector3
from cocorosim_ros.wire.cdr.type_store import build, serialize
from cocorosim_ros.wire.topics.colours import Rgb
from cocorosim_ros.wire.topics.robot_parts import BODY, RobotPart, sensor_parts, thruster_parts

QUARTER_TURN = 1.5707963267948966  # rad; a URDF cylinder stands along z
_THRUSTER_LENGTH, _THRUSTER_RADIUS = 0.2, 0.15  # of the hull's length and height
_BOW_RADIUS, _SENSOR_RADIUS = 0.2, 0.08  # of the hull's height
_DARK, _SIGHT = Rgb(0.25, 0.25, 0.28), Rgb(0.35, 0.6, 1.0)


def urdf(name: str, platform: Platform, colour: Rgb) -> str:
    """The description of the robot of that name; colour: of its hull."""
    robot = Element("robot", name=name)
    for material, parts in (("hull", colour), ("thruster", _DARK), ("sensor", _SIGHT)):
        rgba = _numbers((*parts, 1.0))
        SubElement(SubElement(robot, "material", name=material), "color", rgba=rgba)
    _add_body(robot, f"{name}/{BODY}", platform)
    hull = platform.hull
    for part in thruster_parts(platform):
        link = _add_part(robot, name, part)
        size = {"radius": hull.height * _THRUSTER_RADIUS, "length": hull.length * _THRUSTER_LENGTH}
        _add_visual(link, "cylinder", size, "thruster", rpy=(0.0, QUARTER_TURN, 0.0))
    for part in sensor_parts(platform):
        link = _add_part(robot, name, part)
        window = (_distance_to_hull(hull, part.direction), 0.0, 0.0)
        _add_visual(link, "sphere", {"radius": hull.height * _SENSOR_RADIUS}, "sensor", place=window)
    ElementTree.indent(robot)
    return '<?xml version="1.0"?>\n' + ElementTree.tostring(robot, encoding="unicode") + "\n"


def description_message(name: str, platform: Platform, colour: Rgb) -> bytes:
    """The bytes of `robot_description`."""
    return serialize(build("std_msgs/msg/String", {"data": urdf(name, platform, colour)}))


def static_frames(platforms: Mapping[str, Platform]) -> bytes:
    """The bytes of `/tf_static`: base_link of each robot to its parts; platforms: by the name of the robot."""
    transforms = [
        {
            "header": {"frame_id": f"{name}/{BODY}"},
            "child_frame_id": f"{name}/{part.name}",
            "transform": {
                "translation": dict(zip("xyz", part.position, strict=True)),
                "rotation": dict(zip("xyzw", part.quaternion(), strict=True)),
            },
        }
        for name, platform in platforms.items()
        for part in (*thruster_parts(platform), *sensor_parts(platform))
    ]
    return serialize(build("tf2_msgs/msg/TFMessage", {"transforms": transforms}))


def _add_body(robot: Element, link_name: str, platform: Platform) -> None:
    link, hull, mass = SubElement(robot, "link", name=link_name), platform.hull, platform.mass
    inertial = SubElement(link, "inertial")
    SubElement(inertial, "mass", value=repr(mass))
    roll = mass / 12.0 * (hull.width**2 + hull.height**2)
    pitch = mass / 12.0 * (hull.length**2 + hull.height**2)
    moments = {"ixx": roll, "ixy": 0.0, "ixz": 0.0, "iyy": pitch, "iyz": 0.0, "izz": platform.yaw_inertia}
    SubElement(inertial, "inertia", {key: repr(value) for key, value in moments.items()})
    size = (hull.length, hull.width, hull.height)
    _add_visual(link, "box", {"size": size}, "hull")
    bow = {"radius": hull.height * _BOW_RADIUS}
    _add_visual(link, "sphere", bow, "hull", place=(0.5 * hull.length, 0.0, 0.0))
    SubElement(SubElement(SubElement(link, "collision"), "geometry"), "box", size=_numbers(size))


def _add_part(robot: Element, name: str, part: RobotPart) -> Element:
    """The link of a part, fixed to the body."""
    link = SubElement(robot, "link", name=f"{name}/{part.name}")
    joint = SubElement(robot, "joint", name=f"{name}/{part.name}_fixed", type="fixed")
    SubElement(joint, "parent", link=f"{name}/{BODY}")
    SubElement(joint, "child", link=f"{name}/{part.name}")
    SubElement(joint, "origin", xyz=_numbers(part.position), rpy=_numbers((0.0, part.pitch, part.yaw)))
    return link


def _add_visual(
    link: Element,
    shape: str,
    size: Mapping[str, float | Sequence[float]],
    material: str,
    *,
    place: Sequence[float] = (0.0, 0.0, 0.0),
    rpy: Sequence[float] = (0.0, 0.0, 0.0),
) -> None:
    visual = SubElement(link, "visual")
    SubElement(visual, "origin", xyz=_numbers(place), rpy=_numbers(rpy))
    words = {key: repr(value) if isinstance(value, float) else _numbers(value) for key, value in size.items()}
    SubElement(SubElement(visual, "geometry"), shape, words)
    SubElement(visual, "material", name=material)


def _distance_to_hull(hull: Hull, direction: Vector3) -> float:
    """From the centre to the hull's outside along a direction [m]."""
    halves = (0.5 * hull.length, 0.5 * hull.width, 0.5 * hull.height)
    return min(half / abs(along) for half, along in zip(halves, direction, strict=True) if along)


def _numbers(values: Sequence[float]) -> str:
    return " ".join(repr(float(value)) for value in values)
