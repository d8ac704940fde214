"""model.yaml is a platform file that loads, with what was found where it was found."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis, Estimate, FoundEffect, HeldOut, Recalibrated
from cocorosim_ros.diagnosis.report.changed_vehicle import as_platform
from cocorosim_ros.diagnosis.report.model_file import Origin, model_yaml
from cocorosim_ros.scenario.parts.platform import DragForm, Platform, load_platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.reading.quantity import Quantity
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.laws.laws_of_platform import effects_of
from cocorosim_ros.world.terms.regressors import REGRESSORS

Example = Callable[[str], Diagnosis]
BAG = "/somewhere/tank_7"
CONFIG = Path(__file__).parents[3] / "config"


def origin(platform: Platform | None = None, robots: tuple[str, ...] = ("lily_01",)) -> Origin:
    """A diagnosis of one bag on Lily."""
    return Origin(platform or load_platform("lily"), (BAG,), robots, 600.0)


def written(tmp_path: Path, diagnosis: Diagnosis, source: Origin, name: str = "model.yaml") -> Platform:
    """The model, written and loaded again."""
    path = tmp_path / name
    path.write_text(model_yaml(diagnosis, source), "utf-8")
    return load_platform(path)


def asymmetry(value: float, *robots: str) -> FoundEffect:
    """Thrusters that differ, of some robots."""
    return FoundEffect(
        "thruster_asymmetry", "thrusters differ", "", robots, "confirmed",
        {"difference": Estimate(value, value - 0.01, value + 0.01, "1")}, 50.0,
    )  # fmt: skip


def test_parameters_and_effects_come_back(example: Example, tmp_path: Path) -> None:
    """Refitted drag and inertia (also the one whose interval holds the nominal value), added mass; the rest is Lily."""
    model, lily = written(tmp_path, example("mismatch"), origin()), load_platform("lily")
    assert (model.drag, model.yaw_inertia) == (1.853, 4.11e-4)
    assert model.effects == {"added_mass": {"sway_minus_surge": 0.0443, "yaw": 6.1e-5}}
    same = replace(
        model, drag=lily.drag, yaw_inertia=lily.yaw_inertia, effect_quantities={}, intervals={},
        description=lily.description,
    )  # fmt: skip
    assert same == lily


@pytest.mark.parametrize(
    ("chosen", "declared", "comes_back"),
    [("", None, "total_speed"), ("own_speed", None, "own_speed"), ("", "strips", "strips")],
)
def test_the_form_of_the_drag_comes_back(
    chosen: str, declared: DragForm | None, comes_back: str, example: Example, tmp_path: Path
) -> None:
    """Numbers hold in the form by which they were found, also where none was ahead of the usual one."""
    text = (CONFIG / "platforms" / "lily.yaml").read_text(encoding="utf-8")
    line = f"drag_form: {declared}" if declared else ""
    (tmp_path / "boat.yaml").write_text(re.sub(r"(?m)^drag_form:.*$", line, text), encoding="utf-8")
    source = origin(load_platform(tmp_path / "boat.yaml"))
    assert source.platform.drag_form == declared
    found = replace(example("consistent"), drag_form=chosen, step=0.1)
    assert written(tmp_path, found, source).drag_form == comes_back


def test_the_step_of_the_filter_comes_back(example: Example, tmp_path: Path) -> None:
    """Another step averages other readings, so the next diagnosis takes the same one; without a fit there is none."""
    found = replace(example("mismatch"), step=0.04)
    assert written(tmp_path, found, origin()).fitted_step == 0.04
    assert written(tmp_path, replace(found, step=None), origin()).fitted_step is None


def test_a_fitted_number_keeps_its_interval(example: Example, tmp_path: Path) -> None:
    """So the next diagnosis knows how sure the number is; one that was not told by any reading has none."""
    found = example("recalibrate")
    numbers = {each.parameter: each.estimate for each in found.all_recalibrated}
    model = written(tmp_path, found, origin())
    assert (model.intervals["drag"].low, model.intervals["drag"].high) == (numbers["drag"].low, numbers["drag"].high)
    blind = [replace(each, estimate=replace(each.estimate, low=-math.inf, high=math.inf)) for each in
             found.all_recalibrated]  # fmt: skip
    assert written(tmp_path, replace(found, all_recalibrated=tuple(blind), recalibrated=()), origin()).intervals == {}


def test_a_fitted_number_keeps_its_range(example: Example, tmp_path: Path) -> None:
    """What the file leaves open stays open in the model, of the vehicle and of its effects: the limits are the same."""
    (tmp_path / "vague.yaml").write_text(
        """based_on: lily
drag: {value: 1.9, unit: kg/m, range: [1, 4], source: guess, confidence: estimate}
yaw_drag: {value: 1e-4, unit: N m s^2, range: [1e-5, 1e-3], source: guess, confidence: estimate}
effects:
  linear_drag: {surge: {value: 0.01, unit: N s/m, range: [0.001, 0.03], source: guess, confidence: estimate}}
""",
        "utf-8",
    )
    vague = load_platform(tmp_path / "vague.yaml")
    fitted = Recalibrated("linear_drag.surge", 0.01, Estimate(0.02, 0.018, 0.022, "N s/m"), ("lily_01",))
    found = replace(example("recalibrate"), all_recalibrated=(*example("recalibrate").all_recalibrated, fitted))
    model = written(tmp_path, found, origin(vague))
    assert model.effects["linear_drag"]["surge"] == 0.02
    assert model.drag != vague.drag
    assert model.ranges == vague.ranges


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: f"{entry.id}-{entry.topic}")
def test_every_entry_of_the_catalogue_can_be_loaded_again(entry: Entry, example: Example, tmp_path: Path) -> None:
    """Whatever is found stands in the model as a number of the simulator, whose own checks it passes."""
    numbers = {part.name: _around(part.neutral + 0.5 * part.large, part.unit) for part in entry.amplitudes}
    numbers |= {part.name: _around(1.0, part.unit) for part in entry.shapes}
    found = FoundEffect(entry.id, entry.name, entry.whole_equation, (), "confirmed", numbers, 50.0, topic=entry.topic)
    model = written(tmp_path, replace(example("mismatch"), effects=(found,), recalibrated=()), origin())
    assert sorted(value for effect in model.effects.values() for value in effect.values() if value != 600.0) == sorted(
        each.value for each in numbers.values()
    )


def test_the_offset_with_which_a_drift_begins_is_an_offset(example: Example, tmp_path: Path) -> None:
    """The simulator has offset and drift of a pressure sensor apart."""
    numbers = {"rate": _around(0.3, "Pa/s"), "offset": _around(15.0, "Pa")}
    drift = FoundEffect("pressure_drift", "drift", "", ("lily_01",), "confirmed", numbers, 50.0, topic="pressure")
    model = written(tmp_path, replace(example("mismatch"), effects=(drift,), recalibrated=()), origin())
    assert model.effects == {"pressure_drift": {"rate": 0.3}, "pressure_offset": {"offset": 15.0}}


def _around(value: float, unit: str) -> Estimate:
    return Estimate(value, 0.9 * value, 1.1 * value, unit)


def test_every_found_number_says_where_it_is_from(example: Example, tmp_path: Path) -> None:
    """Unit, source with the bag's name, confidence and interval stand beside the number."""
    entry = parse_yaml(model_yaml(example("mismatch"), origin()), "model")
    drag = dict(entry.mapping()["drag"].mapping())
    assert [part.value for part in drag.pop("ci95").items()] == [1.831, 1.875]
    assert {name: part.value for name, part in drag.items()} == {
        "value": 1.853,
        "unit": "kg/m",
        "source": "diagnosis of tank_7",
        "confidence": "fitted",
        "note": "95 % interval 1.831 to 1.875 kg/m",
    }


def test_a_shipped_platform_is_named_and_a_file_is_written_out(example: Example, tmp_path: Path) -> None:
    """A model on Lily says so; a model on a model needs no other file than itself."""
    first = written(tmp_path, example("recalibrate"), origin(), "first.yaml")
    assert "based_on: lily\n" in (tmp_path / "first.yaml").read_text("utf-8")
    found = replace(example("mismatch"), all_recalibrated=(), recalibrated=())
    (tmp_path / "other").mkdir()
    second = written(tmp_path, found, origin(first), "other/second.yaml")
    (tmp_path / "first.yaml").unlink()
    assert load_platform(tmp_path / "other" / "second.yaml") == second
    assert (second.drag, second.yaw_inertia) == (1.853, 4.11e-4)
    assert second.effects["added_mass"]["sway_minus_surge"] == 0.0443


def test_effects_of_the_base_stay_and_are_refitted(example: Example, tmp_path: Path) -> None:
    """A known effect is kept; found again it has the new number."""
    found = replace(example("mismatch"), effects=(asymmetry(0.05),))
    first = written(tmp_path, found, origin(), "first.yaml")
    second = written(tmp_path, example("mismatch"), origin(first), "second.yaml")
    assert second.effects["thruster_asymmetry"] == {"difference": 0.05}
    assert set(second.effects) == {"thruster_asymmetry", "added_mass"}
    third = written(tmp_path, replace(found, effects=(asymmetry(0.07),)), origin(second), "third.yaml")
    assert third.effects["thruster_asymmetry"] == {"difference": 0.07}


def test_what_one_robot_has_stands_below_its_name(example: Example, tmp_path: Path) -> None:
    """Two robots: common effects for both, an own one for the second, each its own drag, their mean for others."""
    drags = (
        Recalibrated("drag", 1.7778, Estimate(1.9, 1.8, 2.0, "kg/m"), ("lily_01",)),
        Recalibrated("drag", 1.7778, Estimate(1.6, 1.4, 1.8, "kg/m"), ("lily_02",)),
    )
    both = replace(example("mismatch").effects[0], robots=("lily_01", "lily_02"))
    found = replace(example("mismatch"), effects=(both, asymmetry(0.05, "lily_02")), all_recalibrated=drags)
    model = written(tmp_path, found, origin(robots=("lily_01", "lily_02")))
    assert [model.of_robot(name).drag for name in ("lily_01", "lily_02")] == [1.9, 1.6]
    # Weights go with 1/width^2: 1/0.04 against 1/0.16.
    assert model.of_robot("lily_03").drag == pytest.approx((1.9 * 25 + 1.6 * 6.25) / 31.25)
    assert set(model.effects) == set(model.of_robot("lily_01").effects) == {"added_mass"}
    assert set(model.of_robot("lily_02").effects) == {"added_mass", "thruster_asymmetry"}


@pytest.mark.parametrize("robots", [("lily_01", "lily_02"), ("lily_02",)])
def test_thrust_that_is_fitted_alone_leaves_the_turning_as_it_was(
    robots: tuple[str, ...], example: Example, tmp_path: Path
) -> None:
    """A file without `yaw_torque_gain` takes the gain of pushing for it; a held number must not move with another."""
    gain = Recalibrated("thrust_gain", 1.0, Estimate(0.88, 0.8, 0.97, "1"), robots)
    found = replace(example("recalibrate"), recalibrated=(gain,), all_recalibrated=(gain,))
    source = origin(replace(load_platform("lily"), yaw_torque_gain=1.2), ("lily_01", "lily_02"))
    for platform, turning in ((origin(robots=source.robots).platform, 1.0), (source.platform, 1.2)):
        of_robot = written(tmp_path, found, replace(source, platform=platform)).of_robot("lily_02")
        assert (of_robot.thrust_gain, of_robot.yaw_torque_gain) == (0.88, turning)


def test_an_effect_with_numbers_of_each_robot_is_at_the_top_their_mean(example: Example, tmp_path: Path) -> None:
    """Robots keep their own number; a law keeps its place."""
    effects = (
        asymmetry(0.05, "lily_01"),
        asymmetry(0.03, "lily_02"),
        replace(law("unknown:surge~x"), robots=("lily_01",)),
        replace(law("unknown:surge~x"), robots=("lily_02",)),
    )
    found = replace(example("mismatch"), effects=effects)
    model = written(tmp_path, found, origin(robots=("lily_01", "lily_02")))
    for name, difference in (("lily_01", 0.05), ("lily_02", 0.03), ("lily_03", 0.04)):
        assert model.of_robot(name).effects["thruster_asymmetry"]["difference"] == pytest.approx(difference)
        assert set(model.of_robot(name).effects) == {"thruster_asymmetry", "law_1"}


def test_a_second_common_effect_reaches_robots_with_their_own(example: Example, tmp_path: Path) -> None:
    """What all share later is added to those who had effects of their own before."""
    robots = ("lily_01", "lily_02")
    found = replace(example("mismatch"), effects=(asymmetry(0.05, "lily_02"),))
    first = written(tmp_path, found, origin(robots=robots), "first.yaml")
    common = replace(example("mismatch").effects[0], robots=robots)
    second = written(tmp_path, replace(found, effects=(common,)), origin(first, robots), "second.yaml")
    assert set(second.of_robot("lily_02").effects) == {"added_mass", "thruster_asymmetry"}
    assert set(second.of_robot("lily_01").effects) == {"added_mass"}


def test_effects_of_the_recording_chain_stand_by_topic(example: Example, tmp_path: Path) -> None:
    """Two late streams are two numbers of one effect; a mix-up stays in words."""
    late = [
        FoundEffect("sensor_latency", "late", "", ("lily_01",), "confirmed",
                    {"latency": Estimate(value, value, math.nan, "s")}, 9.0, topic=topic)
        for topic, value in (("compass", 0.1), ("imu", 0.2))
    ]  # fmt: skip
    mixed = FoundEffect(
        "frame_mixup", "mixed up", "", ("lily_01",), "confirmed", {}, 9.0, topic="pose",
        correction="the position is in millimetres",
    )  # fmt: skip
    model = written(tmp_path, replace(example("mismatch"), effects=(*late, mixed)), origin())
    assert model.effects == {"sensor_latency": {"compass": 0.1, "imu": 0.2}}
    assert model.frame_corrections == {"pose": "the position is in millimetres"}


@pytest.mark.parametrize("verdict", ["consistent", "insufficient"])
def test_nothing_found_is_the_platform_again(example: Example, tmp_path: Path, verdict: str) -> None:
    """Without findings the model differs from Lily in its description alone."""
    found = replace(example(verdict), all_recalibrated=())
    lily = load_platform("lily")
    assert replace(written(tmp_path, found, origin()), description=lily.description) == lily


def test_numbers_that_have_not_moved_are_not_written_where_nothing_could_be_told(
    example: Example, tmp_path: Path
) -> None:
    """Of recordings that cannot tell; with one that has clearly moved all are written, unless the fit has collapsed."""
    lily = load_platform("lily")
    drag = Recalibrated("drag", lily.drag, Estimate(1.5, 1.0, 2.0, "kg/m"), ("lily_01",))
    telling = replace(example("recalibrate"), verdict="insufficient", all_recalibrated=(drag,), effects=())
    worse = {"heading": HeldOut(0.1, 0.3, 0.3, 0.05, "rad")}
    for name, moved, fit, value in (
        ("none", (), {}, lily.drag), ("one", (drag,), {}, 1.5), ("collapsed", (drag,), worse, lily.drag),
    ):  # fmt: skip
        found = written(tmp_path, replace(telling, recalibrated=moved, fit=fit), origin(), f"{name}.yaml")
        assert found.drag == value


@pytest.mark.parametrize("effects", ["", "effects: {}\n"])
def test_recordings_that_cannot_tell_give_the_platform_whole(effects: str, example: Example, tmp_path: Path) -> None:
    """No form of drag, no step, and what the file leaves open stays open, also in a file on which it is based."""
    (tmp_path / "open.yaml").write_text(
        "based_on: lily\neffects:\n  linear_drag:\n"
        "    surge: {value: 0.01, unit: N s/m, range: [0.001, 0.03], source: guess, confidence: estimate}\n",
        "utf-8",
    )
    (tmp_path / "here.yaml").write_text(f"based_on: open.yaml\n{effects}", "utf-8")
    platform = load_platform(tmp_path / "here.yaml")
    found = replace(example("insufficient"), recalibrated=(), effects=(), drag_form="own_speed", step=0.1)
    model = written(tmp_path, found, origin(platform))
    assert replace(model, description=platform.description) == platform


def test_numbers_of_effects_that_were_not_fitted_keep_their_ranges(example: Example, tmp_path: Path) -> None:
    """Those that ship have numbers with ranges, which the next diagnosis may fit."""
    ferry = load_platform("milliampere_ferry")
    found = replace(example("recalibrate"), all_recalibrated=(), recalibrated=())
    assert written(tmp_path, found, origin(ferry)).ranges == ferry.ranges


def test_numbers_that_were_kept_are_kept_by_the_next_diagnosis(example: Example, tmp_path: Path) -> None:
    """Under the keys of the file, beside those that the file kept already."""
    ferry = replace(load_platform("milliampere_ferry"), kept_as_given=("drag",))
    found = replace(example("mismatch"), step=0.1, held=("yaw_drag", "linear_drag.yaw", "drag"), all_recalibrated=())
    model = written(tmp_path, replace(found, recalibrated=(), effects=()), origin(ferry))
    assert model.kept_as_given == ("drag", "yaw_drag", "effects.linear_drag.yaw")
    of_lily = replace(found, held=("inertia",), recalibrated=(), effects=())
    tree = parse_yaml(model_yaml(of_lily, origin()), "written").mapping()
    assert [part.text() for part in tree["kept_as_given"].items()] == ["yaw_inertia"]


def test_a_change_is_added_to_what_the_vehicle_had(example: Example, tmp_path: Path) -> None:
    """To the learned number of an effect that the file leaves open, and to the file's own of one that it does not."""
    (tmp_path / "slender.yaml").write_text(
        """based_on: lily
effects:
  added_mass: {sway_minus_surge: {value: 0.1, unit: kg, range: [0, 1], source: guess, confidence: estimate}}
  linear_drag: {surge: {value: 0.03, unit: N s/m, source: a scale, confidence: measured}}
""",
        "utf-8",
    )
    slender = load_platform(tmp_path / "slender.yaml")
    learned = Recalibrated("added_mass.sway_minus_surge", 0.1, Estimate(0.3, 0.28, 0.32, "kg"), ("lily_01",))
    changes = tuple(
        FoundEffect(name, name, "", ("lily_01",), "confirmed", {part: Estimate(value, value, value, unit)}, 50.0)
        for name, part, value, unit in (
            ("added_mass", "sway_minus_surge", 0.12, "kg"), ("linear_drag", "surge", -0.02, "N s/m"),
            ("torque_bias", "torque", 1e-5, "N m"),
        )
    )  # fmt: skip
    found = replace(
        example("mismatch"), effects=changes, recalibrated=(), all_recalibrated=(),
        against=Comparison(("good",), (), (), before=(learned,)),
    )  # fmt: skip
    model = written(tmp_path, as_platform(found, slender), origin(slender))
    assert model.effects["added_mass"]["sway_minus_surge"] == pytest.approx(0.42)
    assert model.effects["linear_drag"]["surge"] == pytest.approx(0.01)
    assert model.effects["torque_bias"]["torque"] == 1e-5


@pytest.mark.parametrize(("learned", "gain"), [((), 0.8), ((0.9,), 0.72)])
def test_a_weak_thruster_is_written_as_the_gain_of_its_actuator(
    example: Example, tmp_path: Path, learned: tuple[float, ...], gain: float
) -> None:
    """On top of the file's own gain, 1 where it says none, or of the one that was learned."""
    lily = load_platform("lily")
    name = next(each.name for each in lily.actuators if isinstance(each, Thruster))
    factor = Estimate(0.8, 0.78, 0.82, "1")
    weak = FoundEffect("thruster_gain", "", "", ("lily_01",), "confirmed", {name: factor}, 50.0)
    before = tuple(
        Recalibrated(f"actuators.{name}.gain", 1.0, Estimate(each, each, each, "1"), ("lily_01",)) for each in learned
    )
    found = replace(
        example("mismatch"), effects=(weak,), recalibrated=(), all_recalibrated=(),
        against=Comparison(("good",), (), (), before=before),
    )  # fmt: skip
    plain = replace(found, against=None, all_recalibrated=before)
    for told in (found, plain):
        model = written(tmp_path, as_platform(told, lily), origin(lily))
        assert {each.name: each.gain for each in model.actuators if isinstance(each, Thruster)}[name] == pytest.approx(
            gain
        )


@pytest.mark.parametrize(("delay", "written_as"), [(0.2, {"command_delay": {"delay": 0.2}}), (-0.2, {})])
def test_no_vehicle_acts_before_it_is_told(
    example: Example, tmp_path: Path, delay: float, written_as: dict[str, dict[str, float]]
) -> None:
    """Late commands are an effect of the model; early ones, a difference of clocks, are left out."""
    lily = load_platform("lily")
    late = {"delay": Estimate(delay, delay - 0.01, delay + 0.01, "s")}
    effect = FoundEffect("command_delay", "", "", ("lily_01",), "confirmed", late, 50.0)
    against = Comparison(("good",), (), ())
    found = replace(example("mismatch"), effects=(effect,), recalibrated=(), all_recalibrated=(), against=against)
    assert written(tmp_path, as_platform(found, lily), origin(lily)).effects == written_as


def law(identifier: str, unit: str = "N/m", **numbers: float) -> FoundEffect:
    """A law outside the catalogue."""
    numbers = {"coefficient": -3e-4, **numbers}
    estimates = {name: Estimate(value, 0.9 * value, 1.1 * value, unit) for name, value in numbers.items()}
    return FoundEffect(identifier, "a law", "", ("lily_01",), "confirmed", estimates, 40.0, law=Law.parse(identifier))


def test_laws_outside_the_catalogue_take_free_places(example: Example, tmp_path: Path) -> None:
    """Two laws, two places, in words; they load as the codes of the simulator's tables."""
    found = replace(example("mismatch"), effects=(law("unknown:world_x~x"), law("unknown:yaw~sin_t", "N m", omega=0.2)))
    model = written(tmp_path, found, origin())
    assert model.laws["law_1"]["world_x"].text == "-0.0003 * x"
    assert model.laws["law_2"]["yaw"].text == "-0.0003 * sin_t"
    effects = effects_of(model)
    codes = {regressor.name: code for code, regressor in enumerate(REGRESSORS)}
    assert effects["law_1"] == {
        "coefficient": -3e-4, "equation": 4.0,
        "regressor_1": codes["x"], "power_1": 1.0, "signed_1": 1.0,
        "regressor_2": codes["1"], "power_2": 1.0, "signed_2": 1.0,
    }  # fmt: skip
    assert effects["law_2"]["equation"] == 3.0
    assert effects["law_2"]["regressor_1"] == codes["sin_t"]
    assert effects["law_2"]["omega"] == 0.2
    more = written(tmp_path, replace(found, effects=(law("unknown:surge~t"),)), origin(model), "more.yaml")
    assert set(more.effects) == {"law_1", "law_2", "law_3"}


def test_a_law_that_the_platform_had_gets_another_coefficient(example: Example, tmp_path: Path) -> None:
    """In its place, with its codes: it is not there a second time."""
    known = written(tmp_path, replace(example("mismatch"), effects=(law("unknown:world_x~x"),)), origin())
    again = replace(law("unknown:world_x~x"), simulated_as="law_1")
    stronger = replace(again, parameters={"coefficient": replace(again.parameters["coefficient"], value=-5e-4)})
    model = written(tmp_path, replace(example("mismatch"), effects=(stronger,)), origin(known), "more.yaml")
    assert effects_of(model) == {"law_1": effects_of(known)["law_1"] | {"coefficient": -5e-4}}
    assert list(model.effect_quantities["law_1"]) == ["world_x"]


@pytest.mark.parametrize(
    "declared",
    [
        """{surge: {value: "-0.5 * u * v", range: [-1, 0.25], source: guess}}""",
        """{coefficient: {value: -500, unit: g, range: [-1000, 250], source: guess},
     equation: {value: 0, unit: "1", source: a},
     regressor_1: {value: U, unit: "1", source: a}, regressor_2: {value: V, unit: "1", source: a}}""",
    ],
    ids=["in words", "as codes"],
)
def test_a_law_with_a_range_is_in_words_too(declared: str, example: Example, tmp_path: Path) -> None:
    """The platform's own law, refitted: words, the range in SI units and the interval come back; no code is left."""
    codes = {regressor.name: str(code) for code, regressor in enumerate(REGRESSORS)}
    for letter, name in (("U", "u"), ("V", "v")):
        declared = declared.replace(f"value: {letter},", f"value: {codes[name]},")
    (tmp_path / "boat.yaml").write_text(f"name: boat\nbased_on: lily\neffects:\n  law_1: {declared}\n", "utf-8")
    boat = load_platform(tmp_path / "boat.yaml")
    between = boat.ranges["effects.law_1.coefficient"]
    assert (between.low, between.high, effects_of(boat)["law_1"]["coefficient"]) == (-1.0, 0.25, -0.5)
    fitted = Recalibrated("law_1.coefficient", -0.5, Estimate(-0.7, -0.8, -0.6, "kg"), ("lily_01",))
    found = replace(example("recalibrate"), all_recalibrated=(fitted,), recalibrated=())
    model = written(tmp_path, found, origin(boat))
    refitted = effects_of(boat)["law_1"] | {"coefficient": -0.7}
    assert {name: effects_of(model)["law_1"][name] for name in refitted} == refitted
    again = model.ranges["effects.law_1.coefficient"]
    assert (again.low, again.high) == (-1.0, 0.25)
    interval = model.intervals["effects.law_1.coefficient"]
    assert (interval.low, interval.high) == (-0.8, -0.6)
    text = (tmp_path / "model.yaml").read_text("utf-8")
    assert "-0.7 * u * v" in text and "regressor" not in text and "coefficient" not in text


def test_a_form_is_a_word(example: Example, tmp_path: Path) -> None:
    """Of drag, and of a dead band: words in the file, the same numbers in the model, with where they are from."""
    drag = FoundEffect(
        "anisotropic_drag", "drag", "", ("lily_01",), "confirmed", {"sway_ratio": _around(2.0, "1")}, 50.0,
        settings={"form": 2.0},
    )  # fmt: skip
    band = FoundEffect(
        "thruster_deadband", "band", "", ("lily_01",), "confirmed", {"width": _around(0.1, "1")}, 50.0,
        settings={"ramp": 1.0},
    )  # fmt: skip
    model = written(tmp_path, replace(example("mismatch"), effects=(drag, band)), origin())
    assert model.effects["anisotropic_drag"] == {"sway_ratio": 2.0, "form": 2.0}
    assert model.effects["thruster_deadband"] == {"width": 0.1, "ramp": 1.0}
    effects = parse_yaml((tmp_path / "model.yaml").read_text("utf-8"), "model").mapping()["effects"].mapping()
    form = {name: part.value for name, part in effects["anisotropic_drag"].mapping()["form"].mapping().items()}
    assert form == {"value": "added_strips", "source": "diagnosis of tank_7", "confidence": "derived"}
    again = written(tmp_path, replace(example("consistent"), all_recalibrated=()), origin(model), "again.yaml")
    assert again.effects == model.effects


def test_laws_of_readings_have_places_of_their_own(example: Example, tmp_path: Path) -> None:
    """A compass in error with the thrusters' amounts; its codes are those that its fit had."""
    settings = {"reading": 4.0, "regressor_1": 10.0, "power_1": 1.0, "signed_1": 0.0}
    settings |= {"regressor_2": 0.0, "power_2": 1.0, "signed_2": 1.0}
    compass = replace(law("unknown:compass~|thrust|", "rad/N"), topic="compass", settings=settings)
    model = written(tmp_path, replace(example("mismatch"), effects=(compass,)), origin())
    assert effects_of(model) == {"sensor_law_1": {"coefficient": -3e-4, **settings}}
    assert model.laws["sensor_law_1"]["compass"].text == "-0.0003 * |thrust|"


def test_an_eddy_is_an_effect_of_its_own(example: Example, tmp_path: Path) -> None:
    """It is reported as a law outside the catalogue and simulated as what it is; its coefficient is the circulation."""
    eddy = replace(law("unknown:world_x~y", "m^2/s", x=0.4, y=-0.3, core=0.6), simulated_as="eddy")
    model = written(tmp_path, replace(example("mismatch"), effects=(eddy,)), origin())
    assert model.effects == {"eddy": {"circulation": -3e-4, "x": 0.4, "y": -0.3, "core": 0.6}}


def test_what_refers_to_the_recording_knows_its_length(example: Example, tmp_path: Path) -> None:
    """A battery that sags until the end of 600 s sags in the same time in a simulation."""
    sag = FoundEffect(
        "battery_sag", "battery", "", ("lily_01",), "confirmed", {"fraction_lost": Estimate(0.1, 0.09, 0.11, "1")}, 30.0
    )
    model = written(tmp_path, replace(example("mismatch"), effects=(sag,)), origin())
    assert model.effects["battery_sag"] == {"fraction_lost": 0.1, "duration": 600.0}


def test_what_was_known_of_one_robot_stays_with_it(example: Example, tmp_path: Path) -> None:
    """Also where another platform's file said so, and not the one that was diagnosed."""
    own = replace(load_platform("lily"), effect_quantities={"buoyancy_trim": {"force": Quantity(2e-3, "N", "force")}})
    platform = replace(load_platform("lily"), robots={"lily_02": own}, frame_corrections={"pose": "y mirrored"})
    found = replace(example("mismatch"), effects=(asymmetry(0.05, "lily_01"),), recalibrated=(), all_recalibrated=())
    model = written(tmp_path, found, origin(platform, ("lily_01", "lily_02")))
    assert model.of_robot("lily_02").effects == {"buoyancy_trim": {"force": 2e-3}}
    assert model.of_robot("lily_01").effects == {"thruster_asymmetry": {"difference": 0.05}}
    assert (model.effects, model.frame_corrections) == ({}, {"pose": "y mirrored"})
