"""Who hears whom, from what the inboxes of a recording hold."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.scene.scene import Hearing
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.cdr.acoustic_messages import read_sounds
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage, read_inbox
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic
from cocorosim_ros.world.state.pose_track import PoseTrack


def _sounds(data: bytes) -> list[RadioMessage]:
    """What came by sound, without its ranges."""
    return [sound.message for sound in read_sounds(data)[1]]


_INBOXES = {"radio_rx": read_inbox, "blue_light_rx": read_inbox, "acoustic_rx": _sounds}

Point = tuple[float, float, float]


def read_hearing(bag: Bag, tracks: Mapping[str, PoseTrack]) -> Hearing:
    """Every delivery between two robots whose places are known; inboxes that cannot be read are left out."""
    wanted = [each.topic for each in bag.summary.topics if _is_inbox(each.topic, each.type_name)]
    links: dict[int, list[tuple[Point, Point]]] = {}
    for message in bag.messages(wanted):
        listener, name = split_topic(message.topic)
        try:
            stamp, heard = stamp_ns(message.type_name, message.data), _INBOXES[name](message.data)
        except CocorosimError:
            continue
        if stamp is None:
            continue
        here = links.setdefault(stamp, [])
        ends = ((_place(tracks, sent.sender, stamp), _place(tracks, listener, stamp)) for sent in heard)
        here += [(sender, ear) for sender, ear in ends if sender is not None and ear is not None]
    stamps = sorted(links)
    return Hearing(
        np.array(stamps, np.int64),
        np.array([len(links[stamp]) for stamp in stamps], np.int64),
        np.array([link for stamp in stamps for link in links[stamp]], np.float64).reshape(-1, 2, 3),
    )


def _is_inbox(topic: str, type_name: str) -> bool:
    name = split_topic(topic)[1]
    return name in _INBOXES and type_name == ROBOT_TOPICS[name].type_name


def _place(tracks: Mapping[str, PoseTrack], robot: str, stamp: int) -> Point | None:
    """Where a robot was last seen at that stamp [ns]."""
    track = tracks.get(robot)
    last = -1 if track is None else int(np.searchsorted(track.stamp_ns, stamp, "right")) - 1
    if track is None or last < 0:
        return None
    x, y, z = (float(part) for part in track.position[last])
    return x, y, z
