"""A ROS domain of one's own: two swarms on one machine do not hear each other, nothing leaves the machine."""

from __future__ import annotations

import fcntl
import os
import random
import socket
import tempfile
from pathlib import Path
from typing import IO

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.config_files import shipped_file

DOMAINS = range(1, 101)  # ports of these lie below the ephemeral ones
GREATEST_DOMAIN = 232  # whose ports exist
PORTS_PER_DOMAIN, FIRST_PORT = 250, 7400  # DDSI-RTPS 9.6.1.1
SHARED_MEMORY = Path("/dev/shm")
PROFILE_VARIABLES = ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE")


def domain_of_user() -> int | None:
    """The domain that ROS_DOMAIN_ID asks for, if it is set. Raises CocorosimError if it is no domain."""
    given = os.environ.get("ROS_DOMAIN_ID", "").strip()
    if not given:
        return None
    if not given.isdecimal() or int(given) > GREATEST_DOMAIN:
        raise CocorosimError(
            f"ROS_DOMAIN_ID is '{given}'; set it to a number from 0 to {GREATEST_DOMAIN}, or unset it for a free one."
        )
    return int(given)


class OwnDomain:
    """A domain id that no other swarm on this machine uses while this object lives, or the user's own choice."""

    def __init__(self) -> None:
        """Raises CocorosimError if ROS_DOMAIN_ID is set to something else than a domain id, or if none is free."""
        self._lock: IO[str] | None = None
        given = domain_of_user()
        self.number = self._claim() if given is None else given

    def release(self) -> None:
        """Let others have the domain."""
        if self._lock is not None:
            self._lock.close()
            self._lock = None

    def _claim(self) -> int:
        numbers, littered = list(DOMAINS), domains_with_remains()
        random.SystemRandom().shuffle(numbers)
        for number in sorted(numbers, key=lambda number: number in littered):
            self._lock = _locked(number)
            if self._lock is not None and _is_quiet(number):
                return number
            self.release()
        raise CocorosimError("No ROS domain from 1 to 100 is free on this machine; set ROS_DOMAIN_ID yourself.")


def domains_with_remains(folder: Path = SHARED_MEMORY) -> set[int]:
    """The domains of whose shared-memory ports Fast DDS has files: in use, or left behind by a process that was killed.

    Half a port that was left behind makes every participant wait that opens it, such as a controller of the user's
    own, which has shared memory unlike the nodes of a run.
    """
    ports = [path.name.removeprefix("fastrtps_port") for path in folder.glob("fastrtps_port*")]
    return {(int(port) - FIRST_PORT) // PORTS_PER_DOMAIN for port in ports if port.isdecimal()}


def keep_on_this_machine(*, network: bool) -> None:
    """Limit discovery to this machine, or open it to the network; for processes that start rclpy later.

    Fast DDS gets a profile with the loopback interface alone. Another middleware, and a profile of the user's own,
    get ROS's own limitation instead (which would add a shared-memory transport to the profile's).
    """
    os.environ.pop("ROS_LOCALHOST_ONLY", None)
    if network:
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "SUBNET"
        return
    os.environ.pop("ROS_STATIC_PEERS", None)
    fast_dds = os.environ.get("RMW_IMPLEMENTATION", "rmw_fastrtps_cpp").startswith("rmw_fastrtps")
    profile = str(shipped_file("middleware/fastdds_local.xml"))
    own = [os.environ[name] for name in PROFILE_VARIABLES if os.environ.get(name)]
    if fast_dds and set(own) <= {profile}:
        os.environ[PROFILE_VARIABLES[0]] = profile
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "SYSTEM_DEFAULT"
    else:
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"


def _locked(number: int) -> IO[str] | None:
    path = Path(tempfile.gettempdir()) / f"cocorosim_domain_{number}.lock"
    try:
        file = path.open("w")
    except OSError:
        return None
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        file.close()
        return None
    return file


def _is_quiet(number: int) -> bool:
    """Whether no participant of somebody else sits on the domain's first unicast port."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("", FIRST_PORT + 10 + PORTS_PER_DOMAIN * number))
        except OSError:
            return False
    return True
