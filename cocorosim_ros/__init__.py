"""Swarms of underwater robots on ROS 2.

What `run --in-process`, `metrics`, `convert`, `diagnose` and `experiment` do, the names below do, without ROS:

    import cocorosim_ros as cocorosim

    run = cocorosim.simulate("five_lilys", duration="60 s")     # arrays: run.position (ticks, robots, 3) [m; world]
    run.measure().values["polarisation"]                        # shoaling statistics
    cocorosim.read_recording("runs/demo").tracks["lily_01"]     # what a recording holds
    cocorosim.diagnose("tank_bag", "lily").to_frame()           # where recording and model disagree

Errors are sentences in a `CocorosimError`. Results are frozen records that show themselves in a notebook.

The wings are the flow of the data, and each may import those above it only:

    foundation    what all else stands on: errors as sentences, units, how hot loops are compiled
    scenario      what is asked: arena, swarm, water, rates, seed
    world         the model: how robots move, sense, talk and decide, and in what water
    wire          messages as bytes, topics, recordings, other people's logs; without ROS
    study         shoaling statistics, many runs at once, calibration, the claims of the paper
    graph         the ROS nodes (the only ones that import rclpy), and the same run in one process
    diagnosis     where a recording and the model differ, and what physics is missing
    library       the names below: the work of these commands as functions, the results as records
    commands      the command `cocorosim`
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cocorosim_ros.foundation.errors import CocorosimError
    from cocorosim_ros.library.check import CheckedRecording, check
    from cocorosim_ros.library.convert import Conversion, ConvertedRecording, convert
    from cocorosim_ros.library.design import DesignResults, Watch, run_design
    from cocorosim_ros.library.diagnose import diagnose
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult
    from cocorosim_ros.library.explain import explain
    from cocorosim_ros.library.explaining.explanation import Explanation
    from cocorosim_ros.library.fleet import diagnose_fleet
    from cocorosim_ros.library.fleet_result import FleetResult
    from cocorosim_ros.library.measure import measure
    from cocorosim_ros.library.record import record
    from cocorosim_ros.library.recording import Recording, read_recording
    from cocorosim_ros.library.scenario import load_scenario
    from cocorosim_ros.library.shoal_statistics import ShoalStatistics
    from cocorosim_ros.library.simulate import simulate, simulate_runs
    from cocorosim_ros.library.simulated_run import SimulatedRun
    from cocorosim_ros.scenario.parts.platform import Platform, load_platform
    from cocorosim_ros.scenario.scenario import Scenario
    from cocorosim_ros.study.experiments.design import Design, load_design
    from cocorosim_ros.wire.bags.readings import TopicReadings
    from cocorosim_ros.wire.bags.tracks import RecordedTrack
    from cocorosim_ros.world.state.pose_track import PoseTrack

__version__ = "0.2.0"

# Where each name is defined; it is loaded when it is first used, so that the version alone costs nothing.
_HOMES = {
    "CheckedRecording": "library.check",
    "CocorosimError": "foundation.errors",
    "Conversion": "library.convert",
    "ConvertedRecording": "library.convert",
    "Design": "study.experiments.design",
    "DesignResults": "library.design",
    "DiagnosisResult": "library.diagnosis_result",
    "Explanation": "library.explaining.explanation",
    "FleetResult": "library.fleet_result",
    "Platform": "scenario.parts.platform",
    "PoseTrack": "world.state.pose_track",
    "RecordedTrack": "wire.bags.tracks",
    "Recording": "library.recording",
    "Scenario": "scenario.scenario",
    "ShoalStatistics": "library.shoal_statistics",
    "SimulatedRun": "library.simulated_run",
    "TopicReadings": "wire.bags.readings",
    "Watch": "library.design",
    "check": "library.check",
    "convert": "library.convert",
    "diagnose": "library.diagnose",
    "diagnose_fleet": "library.fleet",
    "explain": "library.explain",
    "load_design": "study.experiments.design",
    "load_platform": "scenario.parts.platform",
    "load_scenario": "library.scenario",
    "measure": "library.measure",
    "read_recording": "library.recording",
    "record": "library.record",
    "run_design": "library.design",
    "simulate": "library.simulate",
    "simulate_runs": "library.simulate",
}
__all__ = [
    "CheckedRecording",
    "CocorosimError",
    "Conversion",
    "ConvertedRecording",
    "Design",
    "DesignResults",
    "DiagnosisResult",
    "Explanation",
    "FleetResult",
    "Platform",
    "PoseTrack",
    "RecordedTrack",
    "Recording",
    "Scenario",
    "ShoalStatistics",
    "SimulatedRun",
    "TopicReadings",
    "Watch",
    "check",
    "convert",
    "diagnose",
    "diagnose_fleet",
    "explain",
    "load_design",
    "load_platform",
    "load_scenario",
    "measure",
    "read_recording",
    "record",
    "run_design",
    "simulate",
    "simulate_runs",
]


if not TYPE_CHECKING:  # so that type checkers find a name that does not exist

    def __getattr__(name: str) -> Any:
        """The public name, loaded when it is first used (PEP 562)."""
        if name not in _HOMES:
            raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
        value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    """The public names too, before they are loaded."""
    return sorted({*globals(), *__all__})
