"""Looks at a graph from outside, in plain rclpy.

onlooker.py names NAME...     ends with status 0 as soon as all these nodes are there
onlooker.py describe NODE     prints the node's parameters as JSON: name to value, type, description, range
onlooker.py do ACTION...      does one after the other, and prints what is answered as JSON: [success, words]; an action
                              is SERVICE (a Trigger), SERVICE=true or =false (a SetBool), NODE/NAME=NUMBER (a parameter)
onlooker.py description TOPIC prints the robot's description, which was published before this looked
onlooker.py qualities TOPIC... prints for each topic how reliable its subscriptions are, by the name of their node
"""

import json
import sys
import time

import rclpy
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

LIMIT = 120.0  # s
AGAIN = 10.0  # s until a question without an answer is asked again
NAMELESS = "_NODE_NAME_UNKNOWN_"
clients = {}


def ask(node, service, kind, request):
    """The answer of a service, asked through one client for each.

    An answer to a client that the server has not discovered yet is lost, however long it is waited for.
    """
    client = clients.get(service) or clients.setdefault(service, node.create_client(kind, service))
    if not client.wait_for_service(LIMIT):
        sys.exit(f"no service {service}")
    for _ in range(int(LIMIT / AGAIN)):
        future = client.call_async(request)
        rclpy.spin_until_future_complete(node, future, timeout_sec=AGAIN)
        if future.result() is not None:
            return future.result()
    return sys.exit(f"no answer from {service}")


def describe(node, name):
    """All parameters of a node."""
    names = list(ask(node, f"{name}/list_parameters", ListParameters, ListParameters.Request()).result.names)
    descriptors = ask(
        node, f"{name}/describe_parameters", DescribeParameters, DescribeParameters.Request(names=names)
    ).descriptors
    values = ask(node, f"{name}/get_parameters", GetParameters, GetParameters.Request(names=names)).values
    return {
        found.name: {
            "value": parameter_value_to_python(value),
            "type": found.type,
            "description": found.description,
            "read_only": found.read_only,
            "range": [[r.from_value, r.to_value] for r in (*found.floating_point_range, *found.integer_range)],
        }
        for found, value in zip(descriptors, values, strict=True)
    }


def act(node, action):
    """What is answered to an action."""
    place, _, value = action.partition("=")
    if value in ("true", "false"):
        answer = ask(node, place, SetBool, SetBool.Request(data=value == "true"))
        return answer.success, answer.message
    if not value:
        answer = ask(node, place, Trigger, Trigger.Request())
        return answer.success, answer.message
    owner, _, name = place.rpartition("/")
    parameter = Parameter(name, value=float(value)).to_parameter_msg()
    answer = ask(node, f"{owner}/set_parameters", SetParameters, SetParameters.Request(parameters=[parameter]))
    return answer.results[0].successful, answer.results[0].reason


def description(node, topic):
    """The text of a latched std_msgs/String."""
    heard = []
    profile = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(String, topic, heard.append, profile)
    deadline = time.monotonic() + LIMIT
    while not heard and time.monotonic() < deadline:
        rclpy.spin_once(node, timeout_sec=0.1)
    return heard[0].data


def qualities(node, topic):
    """How reliable the subscriptions of a topic are, by the name of their node.

    It is asked again until there is one and all have names: a subscription may be discovered before its node is.
    """
    deadline = time.monotonic() + LIMIT
    found = {}
    while (not found or NAMELESS in found) and time.monotonic() < deadline:
        rclpy.spin_once(node, timeout_sec=0.1)
        subscriptions = node.get_subscriptions_info_by_topic(topic)
        found = {each.node_name: each.qos_profile.reliability.name for each in subscriptions}
    return found


def sees(node, names):
    """Whether all these nodes come up."""
    deadline = time.monotonic() + LIMIT
    while time.monotonic() < deadline:
        rclpy.spin_once(node, timeout_sec=0.1)
        seen = {f"{space.rstrip('/')}/{name}" for name, space in node.get_node_names_and_namespaces()}
        if names <= seen:
            return True
    return False


def main():
    """Do what the command line says."""
    rclpy.init()
    node = Node("onlooker")
    if sys.argv[1] == "describe":
        print(json.dumps(describe(node, sys.argv[2])), flush=True)
        return 0
    if sys.argv[1] == "do":
        for action in sys.argv[2:]:
            print(json.dumps(act(node, action)), flush=True)
        return 0
    if sys.argv[1] == "description":
        print(description(node, sys.argv[2]), flush=True)
        return 0
    if sys.argv[1] == "qualities":
        print(json.dumps([qualities(node, topic) for topic in sys.argv[2:]]), flush=True)
        return 0
    return 0 if sees(node, set(sys.argv[2:])) else 1


if __name__ == "__main__":
    sys.exit(main())
