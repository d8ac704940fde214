"""A diagnosis as JUnit's XML, which services that run tests show: one test of the model, one for each finding."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from xml.etree import ElementTree

from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate, Verdict
from cocorosim_ros.diagnosis.report.number_text import estimate_words

USUALLY_FAILING: frozenset[Verdict] = frozenset({"mismatch"})


def junit_xml(diagnosis: Diagnosis, platform: str, failing: Collection[Verdict]) -> str:
    """The text of the file.

    The test 'verdict' fails if the verdict is one of `failing`, and is skipped if the recording says too little. Each
    effect that was found fails a test of its own if 'mismatch' is failing, each moved number if 'recalibrate' is.
    """
    suite = ElementTree.Element("testsuite", {"name": f"cocorosim diagnose {platform}"})
    told = " ".join(dict.fromkeys((diagnosis.sentence, *diagnosis.reasons)))
    _case(suite, platform, "verdict", told, failed=diagnosis.verdict in failing)
    if diagnosis.verdict == "insufficient" and diagnosis.verdict not in failing:
        ElementTree.SubElement(suite[0], "skipped", {"message": told})
    for effect in diagnosis.effects:
        words = f"{effect.equation}; {effect.tier}; {_numbers(effect.parameters)}"
        _case(suite, platform, f"effect {effect.id}", words, failed="mismatch" in failing)
    for moved in diagnosis.recalibrated:
        words = f"platform {moved.nominal:g}, fitted {_numbers({moved.parameter: moved.estimate})}"
        _case(suite, platform, f"number {moved.parameter}", words, failed="recalibrate" in failing)
    failures = sum(case.find("failure") is not None for case in suite)
    skipped = sum(case.find("skipped") is not None for case in suite)
    suite.attrib |= {"tests": str(len(suite)), "failures": str(failures), "skipped": str(skipped), "errors": "0"}
    ElementTree.indent(suite)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ElementTree.tostring(suite, encoding="unicode")}\n'


def _case(suite: ElementTree.Element, platform: str, name: str, words: str, *, failed: bool) -> None:
    case = ElementTree.SubElement(suite, "testcase", {"classname": platform, "name": name})
    if failed:
        ElementTree.SubElement(case, "failure", {"message": words})
    else:
        ElementTree.SubElement(case, "system-out").text = words


def _numbers(estimates: Mapping[str, Estimate]) -> str:
    return ", ".join(f"{name} {' '.join(estimate_words(each))}" for name, each in estimates.items())
