#!/usr/bin/python3
"""Adds up the results of test runs and says whether all is well.

Reads, for every build folder, the JUnit files below test_results, and ctest's own account of what
should have run (ctest.json) and how it ended (ctest.xml). A program that crashed, ran out of time or
left no results counts as one failed test, and so does a folder in which nothing ran.

Prints the failures, the skipped tests with their reasons, and last "N passed, N failed". Exits with
1 if anything failed.
"""

import argparse
import collections
import dataclasses
import json
import os
import pathlib
import sys
import xml.etree.ElementTree

MESSAGE_LENGTH = 300
# What a test that skips for lack of recorded data names in its message.
SHARED_DATA_VARIABLE = "SEMANTIC_SLAM_SHARED"
# What catkin leaves for a program without results. ctest's account, read here, says the same.
PLACEHOLDER_PREFIX = "MISSING-"
ROSTEST_PREFIX = "rostest-"
CTEST_JUNIT = "ctest.xml"
CTEST_LIST = "ctest.json"


@dataclasses.dataclass(frozen=True)
class Case:
    """One test: where it ran, its name, how it ended (passed, failed or skipped), and why."""

    program: str
    name: str
    outcome: str
    message: str = ""


def one_line(text):
    words = " ".join(text.split())
    return words if len(words) <= MESSAGE_LENGTH else words[:MESSAGE_LENGTH] + "..."


def message_of(element):
    return element.get("message") or element.text or "no message"


def skip_reason(element):
    """The last line: Google Test puts the place before it, which differs from test to test."""
    return one_line(message_of(element).strip().splitlines()[-1])


def read_case(program, element):
    name = ".".join(part for part in (element.get("classname"), element.get("name")) if part)
    for tag in ("failure", "error"):
        problem = element.find(tag)
        if problem is not None:
            return Case(program, name, "failed", one_line(message_of(problem)))
    skipped = element.find("skipped")
    if skipped is not None:
        return Case(program, name, "skipped", skip_reason(skipped))
    if element.get("status") == "notrun":  # Google Test's word for DISABLED_ tests
        return Case(program, name, "skipped", "disabled")
    return Case(program, name, "passed")


def read_junit(path):
    """The cases in a result file; one failed case if it cannot be read or holds none."""
    program = path.stem
    try:
        root = xml.etree.ElementTree.parse(path).getroot()
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        return [Case(program, program, "failed", f"left no readable results: {error}")]
    cases = [read_case(program, element) for element in root.iter("testcase")]
    return cases or [Case(program, program, "failed", "left results without a test in them")]


def read_rostest(path):
    """The cases in a rostest's file and in those of the programs that it ran.

    rostest's own cases say whether a program ran at all, so they count only where it did not.
    """
    cases = []
    for case in read_junit(path):
        program = case.name.rpartition(".")[2].removeprefix("test")
        inner = path.with_name(f"rosunit-{program}.xml")
        if case.outcome != "passed" or not inner.exists():
            cases.append(case)
        if inner.exists():
            cases += read_junit(inner)
    return cases


def result_file(command):
    """The result file that a program of ctest's list is to write; None if its command names none."""
    for argument in command:
        if argument.endswith(".xml"):
            return pathlib.Path(argument.rpartition("xml:")[2])
    return None


def ctest_programs(results):
    """Yields (name, result file, whether it ended well) of each program on ctest's list."""
    listed = json.loads((results / CTEST_LIST).read_text())["tests"]
    junit = xml.etree.ElementTree.parse(results / CTEST_JUNIT).getroot()
    ended = {case.get("name"): case.get("status") for case in junit.iter("testcase")}
    for test in listed:
        yield test["name"], result_file(test["command"]), ended.get(test["name"]) == "run"


def read_program(name, path, ended_well):
    if path is None:
        return [Case(name, name, "passed" if ended_well else "failed", "see its output above")]
    read = read_rostest if path.name.startswith(ROSTEST_PREFIX) else read_junit
    cases = read(path)
    if not ended_well and all(case.outcome != "failed" for case in cases):
        cases.append(Case(path.stem, name, "failed", "crashed, ran out of time or exited with an error"))
    return cases


def read_folder(folder):
    """The cases of everything that ran in a build folder, each under the folder's name."""
    results = folder / "test_results"
    try:
        programs = list(ctest_programs(results))
    except (OSError, ValueError, xml.etree.ElementTree.ParseError):
        return [Case(folder.name, folder.name, "failed", "no tests ran: was it built?")]
    if not programs:
        return [Case(folder.name, folder.name, "failed", "there is no test in it")]
    cases = []
    for program in programs:
        cases += read_program(*program)
    return [dataclasses.replace(case, program=f"{folder.name}/{case.program}") for case in cases]


def shared_data_folder():
    """Where the tests look for recorded data; None if there is no such folder."""
    beside = pathlib.Path(__file__).resolve().parents[2] / "shared"
    folder = pathlib.Path(os.environ.get(SHARED_DATA_VARIABLE, beside))
    return folder if folder.is_dir() else None


def needless_skips_as_failures(cases, shared):
    """Recorded data that is at hand must be used: no test may skip for lack of it in every run."""
    if shared is None:
        return cases
    ran = {case.name for case in cases if case.outcome != "skipped"}
    return [
        dataclasses.replace(case, outcome="failed", message=f"skipped, but there is {shared}: {case.message}")
        if case.outcome == "skipped" and SHARED_DATA_VARIABLE in case.message and case.name not in ran
        else case
        for case in cases
    ]


def print_summary(cases, out):
    """Prints the account of `cases` and returns the number of failures."""
    by_outcome = collections.defaultdict(list)
    for case in cases:
        by_outcome[case.outcome].append(case)
    for case in by_outcome["failed"]:
        print(f"FAILED  {case.program}: {case.name}\n        {case.message}", file=out)
    if by_outcome["skipped"]:
        reasons = collections.Counter(case.message for case in by_outcome["skipped"])
        listed = "; ".join(f"{count} x {reason}" for reason, count in reasons.most_common())
        print(f"skipped: {len(by_outcome['skipped'])} ({listed})", file=out)
    failed = len(by_outcome["failed"])
    print(f"{len(by_outcome['passed'])} passed, {failed} failed", file=out)
    return failed


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path, metavar="FOLDER", help="a build folder")
    parser.add_argument("--expect", action="append", default=[], type=pathlib.Path, metavar="FILE.xml",
                        help="results that something else than ctest was to leave")
    arguments = parser.parse_args()
    cases = []
    for folder in arguments.folders:
        cases += read_folder(folder)
    for path in arguments.expect:
        cases += read_junit(path)
    return 1 if print_summary(needless_skips_as_failures(cases, shared_data_folder()), sys.stdout) else 0


if __name__ == "__main__":
    sys.exit(main())
