"""Water out of an ocean model, as a scenario asks for it."""

from __future__ import annotations

import datetime
from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.parts.stated_file import StatedFile, read_stated_file, stated_file_text
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.records import FLAG, choice, quantity, stored


def _read_moment(entry: Entry) -> str:
    text = str(entry.value) if isinstance(entry.value, datetime.date) else entry.text()
    try:
        moment = datetime.datetime.fromisoformat(text)
    except ValueError as error:
        raise entry.problem(f"has {entry.found()}, which is no moment; write it as '2024-05-01T12:00:00'.") from error
    if moment.tzinfo is not None:
        moment = moment.astimezone(datetime.UTC).replace(tzinfo=None)
    return moment.isoformat()


@dataclass(frozen=True)
class OceanCurrent:
    """Velocity, and by temperature and salinity density, from a netCDF file of CMEMS, HYCOM or ROMS.

    latitude, longitude: of the world's origin [rad]. start: when the run begins, in UTC; None: at the first moment of
    the file. buoyancy: whether the density of the water acts on robots. reference_density: of the water in which robots
    are ballasted [kg/m^3]; None: that of their platform.
    """

    file: StatedFile = field(metadata=stored(read_stated_file, stated_file_text, form="path of a netCDF file"))
    latitude: float = field(metadata=quantity("angle"))
    longitude: float = field(metadata=quantity("angle"))
    start: str | None = field(
        default=None, metadata=stored(_read_moment, str, form="moment in UTC, such as '2024-05-01T12:00:00'")
    )
    buoyancy: bool = field(default=True, metadata=FLAG)
    reference_density: float | None = field(default=None, metadata=quantity("density", "positive"))
    kind: Literal["ocean"] = field(default="ocean", metadata=choice("ocean"))
