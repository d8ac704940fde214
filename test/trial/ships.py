"""Arm three, two model ships: how far a fitted tanker foretells other zigzags, and whether a hidden wind is found."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from trial.recordings import Group
from trial.ways import answer, effects

Tree = dict[str, Any]
TANKER, WINDY, WINDY_DAY = "kvlcc2_hsva", "esso_osaka_july", "31-Jul-2020"
FITTED_ZIGZAGS = ("Z_10_05", "Z_20_05", "Z_20_10_P", "Z_30_05")
WINDOW, AROUND, STEP = 40.0, 0.5, 0.05  # s: of a free run, of readings that give its start, of the simulation
BAR = (0.97, 0.98, 0.98)  # R2 of u, v, r that has to be reached
WIND_BAR = 30.0  # deg


def ship_figures(pairs: Sequence[tuple[Group, Group]], data: Path, out: Path) -> Tree:
    """What was measured of both ships by name, as far as they were diagnosed."""
    found: Tree = {}
    for some, others in pairs:
        folder = out / "diagnoses" / some.name
        if some.name == TANKER and (folder / "model.yaml").is_file():
            shares = dict(zip("uvr", explained(folder / "model.yaml", others.bags), strict=True))
            found[TANKER] = {"fitted": list(FITTED_ZIGZAGS), "others": len(others.bags), "explained": shares}
        if some.name == WINDY and answer(folder) is not None:
            kinds = [bag.name.partition("_")[0] for bag in some.bags]  # zigzag, random: folders as well
            logs = [data / "esso_osaka" / kind / f"{bag.name}.csv" for kind, bag in zip(kinds, some.bags, strict=True)]
            found[WINDY] = wind(answer(folder), logs)
    return found


def ship_lines(found: Tree) -> list[str]:
    """The lines of the page about both ships."""
    lines = {TANKER: _tanker_line, WINDY: _wind_line}
    return [line(found[name]) for name, line in lines.items() if name in found]


def _tanker_line(found: Tree) -> str:
    told = ", ".join(f"{name} {share:.4f}" for name, share in found["explained"].items())
    bar = ", ".join(f"{each:g}" for each in BAR)
    return (
        f"- {TANKER}: fitted to {', '.join(found['fitted'])}; free runs of {WINDOW:g} s on the other {found['others']} "
        f"zigzags explain (R2, bar {bar}): {told}."
    )


def explained(model: Path, bags: Sequence[Path]) -> tuple[float, ...]:
    """Shares R2 of u, v and r that free runs of a model explain, each begun at the readings and driven by commands."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    pairs = [pair for bag in bags for pair in free_runs(load_platform(model), bag)]
    return shares_of([seen for seen, _ in pairs], [run for _, run in pairs])


def shares_of(seen: Sequence[Any], runs: Sequence[Any]) -> tuple[float, ...]:
    """1 - sum of squared errors over sum of squares about the mean, by column, over all windows together."""
    told, foretold = np.concatenate(seen), np.concatenate(runs)
    rest, spread = ((told - foretold) ** 2).sum(axis=0), ((told - told.mean(axis=0)) ** 2).sum(axis=0)
    return tuple((1.0 - rest / spread).tolist())


def free_runs(platform: Any, bag: Path) -> Iterator[tuple[Any, Any]]:
    """u, v, r as recorded and as simulated, at the recorded moments of every whole window of a recording."""
    from cocorosim_ros.diagnosis.evidence.gather import gather_recording

    (log,) = gather_recording(bag, platform).robots
    time, speed, turn = log.streams["velocity"].time, log.streams["velocity"].value, log.streams["imu"]
    value = np.column_stack([speed[:, 0], speed[:, 1], np.interp(time, turn.time, turn.value[:, 0])])
    for begin in np.arange(time[0], time[-1] - WINDOW, WINDOW):
        inside = (time >= begin) & (time < begin + WINDOW)
        near = np.abs(time - begin) <= AROUND
        start = [np.polyval(np.polyfit(time[near] - begin, column, 1), 0.0) for column in value[near].T]
        yield value[inside], simulated(platform, start, time[inside], log)


def simulated(platform: Any, start: Sequence[float], moments: Any, log: Any) -> Any:
    """u, v, r (moments, 3) of the simulator from `start` at the first of the moments, under the commands of a log."""
    from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
    from cocorosim_ros.world.state.state import SURGE, SWAY, YAW_RATE, row_size
    from cocorosim_ros.world.surroundings.tank import Tank
    from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

    vehicles = build_vehicles([platform])
    tank = Tank(np.full(3, -1e9), np.full(3, 1e9), np.zeros((0, 4)), np.zeros((0, 6)))
    state, moving, path = np.zeros((1, 1, row_size(len(platform.actuators)))), [SURGE, SWAY, YAW_RATE], []
    state[0, 0, moving] = start
    for now, then in zip(moments, [*moments[1:], moments[-1]], strict=True):
        path.append(state[0, 0, moving].copy())
        held = max(int(np.searchsorted(log.command_time, now + 1e-6, side="right")) - 1, 0)
        apply_commands(state, np.ascontiguousarray(log.command[None, None, held]), vehicles)
        steps = max(1, math.ceil((then - now) / STEP - 1e-6))
        move(state, vehicles, tank, Stepping(0, steps, max(then - now, 1e-9) / steps, 1), np.zeros(0), float(now))
    return np.array(path)


def wind(said: Any, logs: Sequence[Path]) -> Tree:
    """Speeds [m/s] of the hidden wind by the anemometer, which no map has, and as named, and the angle between [deg].

    Where no wind is named, what else is.
    """
    truth = anemometer(logs)
    named = next((effect["parameters"] for effect in effects(said) if effect["id"] == "wind"), None)
    if named is None:
        return {"anemometer": abs(truth), "others": [effect["id"] for effect in effects(said)]}
    found = complex(named["x"]["value"], named["y"]["value"])
    off = abs(math.degrees(np.angle(found / truth)))
    return {"anemometer": abs(truth), "named": abs(found), "beside": off}


def _wind_line(found: Tree) -> str:
    told = f"{WINDY}: with the wind hidden, the anemometer had {found['anemometer']:.2f} m/s"
    if "named" not in found:
        others = ", ".join(f"`{name}`" for name in found["others"]) or "nothing"
        return f"- {told}; no wind is named, but {others}."
    return (
        f"- {told}; wind is named with {found['named']:.2f} m/s, {found['beside']:.0f} deg beside it "
        f"(bar {WIND_BAR:g} deg)."
    )


def anemometer(logs: Sequence[Path]) -> complex:
    """Mean velocity of the air, east + i north [m/s]; the files have where it comes from, from north to east."""
    seen = np.concatenate([np.genfromtxt(path, delimiter=",", skip_header=1, usecols=(11, 12)) for path in logs])
    speed, origin = seen[np.isfinite(seen).all(axis=1)].T
    return complex(np.mean(-speed * np.sin(origin)), np.mean(-speed * np.cos(origin)))
