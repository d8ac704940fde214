"""Controllers that die, hang, are late, come late or never in lock-step: no dead-lock, and never in silence."""

from __future__ import annotations

import os
import re
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

Starter = Callable[..., Any]
Counts = Callable[[Path], dict[str, int]]
Diagnostics = Callable[[Path], list[tuple[str, str]]]
Statuses = Callable[[Path], list[tuple[float, str, str]]]
TICKS = 12


def kill_the_second(run: Any, pacer: Any) -> None:
    """End lily_02's controller in the fourth tick, then let the pacer go on."""
    pacer.say("good", "good", "good")
    pacer.wait_for(r"tick 1\.5\n")
    os.kill(run.find_nodes()["controller_lily_02"], signal.SIGKILL)
    run.wait_for("controller_lily_02 was ended by signal SIGKILL")
    pacer.say("all")


def test_the_run_goes_on_without_a_controller_that_is_killed(
    begin: Starter,
    paced: Starter,
    counts: Counts,
    diagnostics: Diagnostics,
) -> None:
    """thrusters_off: the others are not held up, all ticks are recorded, the death is on terminal and /diagnostics."""
    run, bag = begin(3, TICKS, "lily_03")
    kill_the_second(run, paced(run, "lily_03"))
    assert run.finish() == 0, run.output
    found = counts(bag)
    answered = found["/lily_02/thruster_command"]
    assert answered in (3, 4)
    assert found["/lily_02/pose"] == found["/lily_01/thruster_command"] == found["/shoal_statistics"] == TICKS
    words = f"no answer at tick {answered}, its controller has died: its thrusters are off until it is heard again"
    assert ("cocorosim: lily_02", words) in diagnostics(bag)
    assert f"lily_02: {words}" in run.output
    assert f"{TICKS - answered} of {TICKS} answers came late or not at all" in run.output


def test_controllers_that_share_a_process_die_together(
    begin: Starter,
    paced: Starter,
    diagnostics: Diagnostics,
) -> None:
    """Each robot's death is on /diagnostics, and the run goes on with the rest."""
    run, bag = begin(4, TICKS, "lily_04", options=("--processes", 2))
    pacer = paced(run, "lily_04")
    pacer.say("good", "good", "good")
    pacer.wait_for(r"tick 1\.5\n")
    os.kill(run.find_nodes()["controller_lily_02_and_1_more"], signal.SIGKILL)
    run.wait_for("controller_lily_02_and_1_more was ended by signal SIGKILL")
    pacer.say("all")
    assert run.finish() == 0, run.output
    dead = {subject for subject, words in diagnostics(bag) if "its controller has died" in words}
    assert dead == {"cocorosim: lily_02", "cocorosim: lily_03"}


def test_the_run_ends_with_a_controller_that_is_killed_if_the_scenario_says_so(
    begin: Starter,
    paced: Starter,
    counts: Counts,
    all_ended: Callable[[Any], None],
) -> None:
    """stop: status 1 with the sentence, a bag that is whole until then, and no process left."""
    run, bag = begin(3, TICKS, "lily_03", silent="stop")
    kill_the_second(run, paced(run, "lily_03"))
    assert run.finish() == 1, run.output
    ended = re.search(r"The run ends: lily_02: no answer at tick (\d), its controller has died", run.output)
    assert ended is not None, run.output
    assert "'lockstep.silent_controller' is 'stop'" in run.output
    found = counts(bag)
    assert found["/shoal_statistics"] == int(ended[1])
    assert found["/diagnostics"] >= 1
    all_ended(run)


def test_a_controller_that_hangs_is_left_out_and_taken_up_again(
    begin: Starter,
    paced: Starter,
    counts: Counts,
    statuses: Statuses,
) -> None:
    """Stopped, it costs its patience once; when it goes on, it is waited for again."""
    ticks = 60
    run, bag = begin(3, ticks, "lily_03", patience=8)
    pacer = paced(run, "lily_03", "late", 0.1)  # so slow that the other one can wake up before the end
    pacer.say("good", "good")
    pacer.wait_for("answered good 0.5")
    hung = run.find_nodes()["controller_lily_02"]
    os.kill(hung, signal.SIGSTOP)
    pacer.say("all")
    run.wait_for(r"lily_02: no answer at tick \d+, nothing was heard for 8 s: its thrusters are off")
    os.kill(hung, signal.SIGCONT)
    assert run.finish() == 0, run.output
    found = counts(bag)
    assert found["/lily_01/thruster_command"] == found["/lily_02/pose"] == found["/shoal_statistics"] == ticks
    missing = [2 * stamp for stamp, name, _ in statuses(bag) if name == "cocorosim: answers"]
    assert missing == list(range(int(missing[0]), int(missing[0]) + len(missing)))
    assert 0 < missing[0] <= missing[-1] < ticks - 1
    assert run.output.count("lily_02: no answer at tick") == 1
    left_out = re.search(rf"lily_02: (\d+) of {ticks} answers came late or not at all", run.output)
    assert left_out is not None, run.output
    assert 1 <= int(left_out[1]) < ticks - 4


def test_a_controller_that_is_always_late_does_not_hold_the_run_up(
    begin: Starter, paced: Starter, counts: Counts
) -> None:
    """Each of its answers comes a second after its tick; patience is half a second, and in the end there is none."""
    run, bag = begin(2, TICKS, "lily_02", patience=0.5)
    paced(run, "lily_02", "late", 1.0).say("all")
    assert run.finish() == 0, run.output
    assert re.search(r"lily_02: no answer at tick 0, nothing was heard for 0.5 s: its thrusters are off", run.output)
    assert re.search(r"lily_02: \d+ of 12 answers came late or not at all", run.output)
    assert counts(bag)["/lily_02/pose"] == TICKS


def test_one_that_joins_late_is_obeyed_from_then_on(
    begin: Starter,
    paced: Starter,
    counts: Counts,
    statuses: Statuses,
) -> None:
    """The run starts without it after --wait and says so; once it answers, it is waited for like everybody."""
    run, bag = begin(3, 400, "lily_02", "lily_03", options=("--wait", 2))
    pacer = paced(run, "lily_03")
    run.wait_for("lily_02: no answer at tick 0, it was not there within 2 s: its thrusters are off")
    pacer.say("good", "good")
    pacer.wait_for("answered good 0.5")
    joiner = paced(run, "lily_02")
    joiner.wait_for("ready")
    joiner.say("all")
    while "answered" not in joiner.output:
        pacer.say("good")
        pacer.wait_for("answered", times=pacer.output.count("answered") + 1)
    # Everybody halts at the tick after the pacer's last one, which the joiner hears of however late it is.
    stand = pacer.output.count("answered")
    joiner.wait_for(rf"answered good {stand / 2:g}\n")
    pacer.say("all")
    assert run.finish() == 0, run.output
    first = int(float(re.search(r"answered good ([\d.]+)", joiner.output)[1]) * 2)  # type: ignore[index]
    found = counts(bag)
    missing = [stamp for stamp, name, _ in statuses(bag) if name == "cocorosim: answers"]
    # DDS may bring the joiner to the physics node before the recorder; what is not recorded is then said.
    recorded = found["/lily_02/thruster_command"]
    said = re.search(r"lily_02: (\d+) of the commands that it obeyed are not in the recording", run.output)
    assert 400 - len(missing) <= recorded + (0 if said is None else int(said[1])) <= 400 - first, run.output
    assert missing == [tick / 2 for tick in range(len(missing))]
    assert first <= len(missing) <= stand + 1
    assert f"lily_02: {len(missing)} of 400 answers came late or not at all" in run.output
