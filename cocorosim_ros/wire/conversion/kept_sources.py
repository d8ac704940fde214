"""What results of a conversion must leave as it is."""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros.wire.bags import bag_metadata


def kept_from(out: Path, source: Path) -> list[Path]:
    """What results at `out` must not replace of a source.

    A folder of tables may get a recording or a map beside them; nothing comes into a recording.
    """
    recorded = (source / bag_metadata.FILE_NAME).exists() or any(source.glob("*.mcap"))
    beside = out.is_dir() or out.suffix in ("", ".yaml", ".yml", ".json")
    within = source.is_dir() and not recorded and beside and source.resolve() in out.resolve().parents
    return [] if within else [source]
