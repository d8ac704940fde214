"""By default nothing leaves the machine, and swarms on one machine do not hear each other."""

from __future__ import annotations

import array
import fcntl
import socket
import struct
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.nodes import domain as domain_module
from cocorosim_ros.graph.nodes.domain import OwnDomain, domains_with_remains, keep_on_this_machine

Starter = Callable[..., Any]
RTPS_GROUP = "239.255.0.1"
IP_MULTICAST_ALL = 49  # of Linux: 0 limits a socket to the groups that it joined itself
SIOCGIFCONF = 0x8912


def addresses() -> list[str]:
    """The IPv4 addresses of this machine's interfaces but loopback (netdevice(7))."""
    room = array.array("B", bytes(40 * 64))
    request = struct.pack("iL", len(room), room.buffer_info()[0])
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        size = struct.unpack("iL", fcntl.ioctl(probe.fileno(), SIOCGIFCONF, request))[0]
    found = [socket.inet_ntoa(room.tobytes()[at + 20 : at + 24]) for at in range(0, size, 40)]
    return [address for address in found if not address.startswith("127.")]


def listen(port: int) -> socket.socket:
    """A socket that hears what is sent to the group of DDS by way of a real interface, from this machine too."""
    ear = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    ear.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    ear.setsockopt(socket.IPPROTO_IP, IP_MULTICAST_ALL, 0)
    ear.bind((RTPS_GROUP, port))
    for address in addresses():
        group = socket.inet_aton(RTPS_GROUP) + socket.inet_aton(address)
        ear.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, group)
    ear.setblocking(False)
    return ear


def has_heard(ear: socket.socket) -> bool:
    """Whether something has come in."""
    try:
        return bool(ear.recv(65536))
    except BlockingIOError:
        return False


@pytest.mark.skipif(not addresses(), reason="this machine has no interface but loopback")
@pytest.mark.parametrize(("options", "leaves"), [((), False), (("--network",), True)])
def test_only_network_leaves_the_machine(
    start: Starter,
    scenario: Callable[..., Path],
    tmp_path: Path,
    free_domain: str,
    options: tuple[str, ...],
    leaves: bool,
) -> None:
    """What DDS announces goes out of a real interface with --network, and does not without."""
    with listen(7400 + 250 * int(free_domain)) as ear:
        arguments = ("run", scenario(1, 2), "--composed", "--out", tmp_path / "run", *options)
        run = start("cocorosim", *arguments, env={"ROS_DOMAIN_ID": free_domain})
        assert run.finish() == 0, run.output
        assert has_heard(ear) == leaves


def test_two_swarms_at_once_do_not_hear_each_other(
    start: Starter, scenario: Callable[..., Path], tmp_path: Path, counts: Callable[[Path], dict[str, int]]
) -> None:
    """The same robots in two graphs: each has one controller per robot and every message once."""
    path = scenario(2, 40)
    runs = [start("cocorosim", "run", path, "--out", tmp_path / name, "--rate", 10) for name in ("one", "two")]
    domains = {run.wait_for(r"ROS domain (\d+)")[1] for run in runs}
    assert len(domains) == 2
    for run, name in zip(runs, ("one", "two"), strict=True):
        assert run.finish() == 0, run.output
        assert "more than one controller" not in run.output
        assert counts(tmp_path / name / "bag")["/lily_01/pose"] == 40


def test_a_claimed_domain_is_nobody_elses(monkeypatch: pytest.MonkeyPatch) -> None:
    """While it lives, others get other numbers; the user's own choice is kept, nonsense is refused."""
    monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)
    several = [OwnDomain() for _ in range(10)]
    assert len({domain.number for domain in several}) == 10
    for domain in several:
        domain.release()
    monkeypatch.setenv("ROS_DOMAIN_ID", "7")
    assert OwnDomain().number == 7
    for nonsense in ("seven", "-1", "233"):
        monkeypatch.setenv("ROS_DOMAIN_ID", nonsense)
        with pytest.raises(CocorosimError, match="ROS_DOMAIN_ID is"):
            OwnDomain()


def test_remains_of_killed_processes_name_their_domain(tmp_path: Path) -> None:
    """Unicast port of participant p in domain d: 7410 + 250 d + 2 p (DDSI-RTPS 9.6.1.1); other files say nothing."""
    for name in ("fastrtps_port8660", "fastrtps_port17411_el", "fastrtps_port17413", "sem.fastrtps_port9910_mutex"):
        (tmp_path / name).touch()
    assert domains_with_remains(tmp_path) == {5, 40}


def test_a_domain_with_remains_is_the_last_choice(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Where only three domains have none, three swarms get those, and a fourth one still gets a domain."""
    monkeypatch.delenv("ROS_DOMAIN_ID", raising=False)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))  # the locks of other swarms are elsewhere
    monkeypatch.setattr(domain_module, "_is_quiet", lambda number: True)
    monkeypatch.setattr(domain_module, "DOMAINS", range(1, 21))
    monkeypatch.setattr(domain_module, "domains_with_remains", lambda: set(range(4, 21)))
    several = [OwnDomain() for _ in range(4)]
    try:
        assert {domain.number for domain in several[:3]} == {1, 2, 3}
        assert several[3].number > 3
    finally:
        for domain in several:
            domain.release()


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({}, "SYSTEM_DEFAULT"),
        ({"RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp"}, "LOCALHOST"),
        ({"FASTRTPS_DEFAULT_PROFILES_FILE": "/etc/my_profile.xml"}, "LOCALHOST"),
    ],
)
def test_every_middleware_is_limited(monkeypatch: pytest.MonkeyPatch, given: dict[str, str], expected: str) -> None:
    """Only where our own profile names the loopback interface, ROS need not limit discovery itself."""
    for name in ("RMW_IMPLEMENTATION", "FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"):
        monkeypatch.setenv(name, given.get(name, ""))
        if name not in given:
            monkeypatch.delenv(name)
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET")
    monkeypatch.setenv("ROS_STATIC_PEERS", "192.0.2.1")
    monkeypatch.setenv("ROS_LOCALHOST_ONLY", "0")
    keep_on_this_machine(network=False)
    import os

    assert os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] == expected
    assert "ROS_STATIC_PEERS" not in os.environ
    if expected == "SYSTEM_DEFAULT":
        assert "127.0.0.1" in Path(os.environ["FASTRTPS_DEFAULT_PROFILES_FILE"]).read_text()
    keep_on_this_machine(network=True)
    assert os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "SUBNET"
