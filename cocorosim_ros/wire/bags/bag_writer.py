"""Writes a rosbag2 folder: one MCAP file, and metadata.yaml as the very last step.

The MCAP file holds a metadata record `cocorosim_begun` at its beginning (what the recording was made from) and
`cocorosim` at its end (the same and the digest), of two names because viewers warn of one that comes twice. A folder
without metadata.yaml is a recording that was not closed.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType

from cocorosim_ros import __version__
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags import bag_metadata
from cocorosim_ros.wire.bags.bag_folder import PROVISIONAL_NAME, make_room
from cocorosim_ros.wire.bags.bag_summary import METADATA_AT_BEGIN, METADATA_NAME
from cocorosim_ros.wire.bags.digest import Digest, TopicDigest
from cocorosim_ros.wire.bags.mcap_writer import CHUNK_BYTES, McapWriter
from cocorosim_ros.wire.cdr.type_store import schema_text, type_hash
from cocorosim_ros.wire.topics.service_quality import STREAM, ServiceQuality


@dataclass(frozen=True)
class Channel:
    """A topic to be recorded; schema and hash are needed only for types that the type store does not know."""

    topic: str
    type_name: str
    quality: ServiceQuality = STREAM
    schema: str | None = None
    type_hash: str | None = None


class BagWriter:
    """A recording in the making; not for use by several threads at once.

    As a context manager it closes the recording, or leaves it unclosed but readable when an exception passes.

    Args:
        folder: the rosbag2 folder to make; its parents are made too.
        channels: the topics to be recorded; `add_channel` adds more.
        metadata: texts such as scenario, seed and versions, kept in the recording.
        force: replace a recording that is there already; other people's files are never removed.

    Raises:
        CocorosimError: the folder exists, or cannot be written.
    """

    def __init__(
        self,
        folder: Path | str,
        channels: Iterable[Channel] = (),
        *,
        metadata: Mapping[str, str] | None = None,
        force: bool = False,
        chunk_bytes: int = CHUNK_BYTES,
    ) -> None:
        self.folder = Path(folder).resolve()
        self.file = self.folder / f"{self.folder.name}_0.mcap"
        self.digest = Digest()
        self._metadata = dict(metadata or {})
        self._channels: dict[str, Channel] = {}
        self._routes: dict[str, tuple[int, TopicDigest]] = {}
        self._schemas: dict[str, int] = {}
        self._open = False
        self._ended = "it was closed before"
        make_room(self.folder, force=force)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self._mcap = McapWriter(self.file, "ros2", f"cocorosim_ros {__version__}", chunk_bytes=chunk_bytes)
            self._mcap.add_metadata(METADATA_AT_BEGIN, self._metadata)
        except OSError as error:
            raise CocorosimError(
                f"The recording {self.folder} cannot be written: {error.strerror}; choose a folder on a "
                f"disk that has "
                "room and that you may write to."
            ) from error
        self._open = True
        for channel in channels:
            self.add_channel(channel)

    @property
    def message_count(self) -> int:
        """How many messages were given to the recording so far."""
        return sum(digest.count for digest in self.digest.topics.values())

    def add_channel(self, channel: Channel) -> None:
        """Record this topic too. Raises CocorosimError if it is there already, or its type is unknown."""
        if channel.topic in self._channels:
            raise CocorosimError(
                f"The topic {channel.topic} is given twice to the recording {self.folder}; give it once."
            )
        schema = schema_text(channel.type_name) if channel.schema is None else channel.schema
        hash_text = type_hash(channel.type_name) if channel.type_hash is None else channel.type_hash
        if channel.type_name not in self._schemas:
            self._schemas[channel.type_name] = self._mcap.add_schema(channel.type_name, "ros2msg", schema)
        quality = bag_metadata.yaml_text([channel.quality.as_rosbag2()]).strip()
        metadata = {"offered_qos_profiles": quality, "topic_type_hash": hash_text}
        number = self._mcap.add_channel(channel.topic, self._schemas[channel.type_name], metadata)
        self._channels[channel.topic] = Channel(
            channel.topic, channel.type_name, channel.quality, channel.schema, hash_text
        )
        self._routes[channel.topic] = number, self.digest.topic(channel.topic, channel.type_name, schema)

    def write(self, topic: str, log_time_ns: int, publish_time_ns: int, data: bytes) -> None:
        """Record one message: when it was received, when it was published, its CDR bytes.

        Raises CocorosimError if the topic is none of the channels, or the disk takes no more.
        """
        try:
            number, digest = self._routes[topic]
            self._mcap.add_message(number, log_time_ns, publish_time_ns, data)
        except KeyError:
            raise self._refusal(topic) from None
        except struct.error:
            raise CocorosimError(
                f"A message of {topic} cannot be recorded at log time {log_time_ns} ns and publish time "
                f"{publish_time_ns} ns; times are from 0 to 2^64 - 1 ns."
            ) from None
        except OSError as error:
            raise self._failure(error) from error
        digest.add(log_time_ns, data)

    def flush(self) -> None:
        """Hand everything so far to the operating system, so that not even killing this process loses it."""
        if not self._open:
            raise self._refusal("")
        try:
            self._mcap.flush()
        except OSError as error:
            raise self._failure(error) from error

    def close(self, metadata: Mapping[str, str] | None = None) -> str:
        """The digest of the recording, which is complete from now on; a second call changes nothing.

        Args:
            metadata: texts that are known only now, kept beside the digest.
        """
        digest = self.digest.hexdigest()
        if self._open:
            try:
                self._finish({**self._metadata, **(metadata or {}), "digest": digest})
            except OSError as error:
                raise self._failure(error) from error
            self._stop()
        return digest

    def abort(self) -> None:
        """Stop without completing the recording: it stays readable, and reads as not closed."""
        if self._open:
            with suppress(OSError):
                self._mcap.flush()
            self._stop()

    def discard(self) -> None:
        """Stop and remove what was written."""
        self._stop()
        self.file.unlink(missing_ok=True)
        with suppress(OSError):
            self.folder.rmdir()

    def __enter__(self) -> BagWriter:
        """The writer itself."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close the recording, or abort it when an exception passes."""
        if kind is None:
            self.close()
        else:
            self.abort()

    def _finish(self, metadata: Mapping[str, str]) -> None:
        self._mcap.add_metadata(METADATA_NAME, metadata)
        content = bag_metadata.information(self.file.name, self._topic_entries(), *self._span(), metadata)
        self._mcap.add_metadata("rosbag2", {"serialized_metadata": bag_metadata.yaml_text(content)})
        self._mcap.finish()
        provisional = self.folder / PROVISIONAL_NAME
        try:
            provisional.write_text(bag_metadata.file_text(content), "utf-8")
            os.replace(provisional, self.folder / bag_metadata.FILE_NAME)
        except OSError:
            provisional.unlink(missing_ok=True)
            raise

    def _topic_entries(self) -> list[bag_metadata.TopicEntry]:
        return [
            bag_metadata.TopicEntry(
                channel.topic,
                channel.type_name,
                channel.type_hash or "",
                channel.quality,
                self._mcap.counts[self._routes[channel.topic][0]],
            )
            for channel in self._channels.values()
        ]

    def _span(self) -> tuple[int, int]:
        """First and last log time [ns]; zeros for an empty recording."""
        return (self._mcap.start_ns, self._mcap.end_ns) if self._mcap.message_count else (0, 0)

    def _stop(self) -> None:
        self._open = False
        self._routes.clear()
        self._mcap.close()

    def _failure(self, error: OSError) -> CocorosimError:
        """What to tell the user when the disk takes no more; the recording ends here."""
        kept = self._mcap.message_count
        until = f", until t = {self._mcap.end_ns / 1e9:.3f} s," if kept else ""
        self._ended = f"{error.strerror}; its first {kept} messages{until} are kept and readable"
        self._stop()
        return self._refusal("")

    def _refusal(self, topic: str) -> CocorosimError:
        """Why nothing more is recorded, or not this topic."""
        if self._open:
            return CocorosimError(f"The topic {topic} is not recorded in {self.folder}; give it as a channel first.")
        return CocorosimError(
            f"The recording {self.folder} cannot go on: {self._ended}; make room or choose another folder, "
            "and record again."
        )
