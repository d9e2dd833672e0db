"""scripts/summarise_tests.py: what it counts, and when it is not content."""

import io
import json

import pytest

import summarise_tests
from summarise_tests import Case

GTEST = """<testsuites><testsuite name="Queue">
  <testcase name="Pops" status="run" result="completed" classname="Queue"/>
  {case}
</testsuite></testsuites>"""


def case(outcome, message="", name="Queue.Waits"):
    return Case("build/queue_test", name, outcome, message)


@pytest.fixture(name="folder")
def fixture_folder(tmp_path):
    (tmp_path / "build/test_results").mkdir(parents=True)
    return tmp_path / "build"


def write_account(folder, file, status):
    """ctest's account of one program, queue, that was to write `file`."""
    results = folder / "test_results"
    command = ["env_cached.sh", "run_tests.py", str(results / file), f"queue --gtest_output=xml:{file}"]
    (results / "ctest.json").write_text(json.dumps({"tests": [{"name": "queue", "command": command}]}))
    (results / "ctest.xml").write_text(
        f'<testsuite><testcase name="queue" classname="queue" status="{status}"/></testsuite>')


def outcomes(folder):
    return [(c.program, c.name, c.outcome) for c in summarise_tests.read_folder(folder)]


def summary(cases):
    out = io.StringIO()
    failed = summarise_tests.print_summary(cases, out)
    return failed, out.getvalue().splitlines()


@pytest.mark.parametrize("element, outcome, message", [
    ('<testcase name="Waits" classname="Queue" status="run" result="completed"/>', "passed", ""),
    ('<testcase name="Waits" classname="Queue"><failure message="a.cpp:3&#x0A;1 != 2"/></testcase>',
     "failed", "a.cpp:3 1 != 2"),
    ('<testcase name="Waits" classname="Queue"><error>no master</error></testcase>',
     "failed", "no master"),
    ('<testcase name="Waits" classname="Queue"><skipped message="a.cpp:3&#x0A;no data&#x0A;"/></testcase>',
     "skipped", "no data"),
    ('<testcase name="Waits" classname="Queue" status="notrun"/>', "skipped", "disabled"),
])
def test_reads_a_case(tmp_path, element, outcome, message):
    path = tmp_path / "queue_test.xml"
    path.write_text(GTEST.format(case=element))
    assert summarise_tests.read_junit(path) == [
        Case("queue_test", "Queue.Pops", "passed"), Case("queue_test", "Queue.Waits", outcome, message)]


@pytest.mark.parametrize("text", ["", "<testsuites>", "<testsuites/>"])
def test_results_without_a_test_are_a_failure(tmp_path, text):
    path = tmp_path / "queue_test.xml"
    path.write_text(text)
    assert [c.outcome for c in summarise_tests.read_junit(path)] == ["failed"]


def test_counts_a_program_that_ended_well(folder):
    write_account(folder, "queue.xml", "run")
    (folder / "test_results/queue.xml").write_text(GTEST.format(case=""))
    assert outcomes(folder) == [("build/queue", "Queue.Pops", "passed")]


def test_a_program_that_failed_after_its_tests_had_passed_is_a_failure(folder):
    write_account(folder, "queue.xml", "fail")
    (folder / "test_results/queue.xml").write_text(GTEST.format(case=""))
    assert outcomes(folder) == [("build/queue", "Queue.Pops", "passed"), ("build/queue", "queue", "failed")]


def test_a_failed_test_is_not_counted_again_for_its_program(folder):
    write_account(folder, "queue.xml", "fail")
    failure = '<testcase name="Waits" classname="Queue"><failure message="1 != 2"/></testcase>'
    (folder / "test_results/queue.xml").write_text(GTEST.format(case=failure))
    assert outcomes(folder) == [
        ("build/queue", "Queue.Pops", "passed"), ("build/queue", "Queue.Waits", "failed")]


def test_a_program_that_left_no_results_is_a_failure(folder):
    write_account(folder, "queue.xml", "fail")
    assert outcomes(folder) == [("build/queue", "queue", "failed")]


def test_a_program_that_ctest_could_not_start_is_a_failure(folder):
    write_account(folder, "queue.xml", "notrun")
    assert outcomes(folder) == [("build/queue", "queue", "failed")]


def test_a_folder_in_which_nothing_ran_is_a_failure(folder):
    assert outcomes(folder) == [("build", "build", "failed")]


def test_rostest_counts_the_tests_of_the_program_that_it_ran(folder):
    write_account(folder, "rostest-queue.xml", "run")
    (folder / "test_results/rostest-queue.xml").write_text(
        '<testsuite><testcase classname="__main__.RosTest" name="testqueue_test"/></testsuite>')
    (folder / "test_results/rosunit-queue_test.xml").write_text(GTEST.format(case=""))
    assert outcomes(folder) == [("build/rosunit-queue_test", "Queue.Pops", "passed")]


def test_rostest_whose_program_died_is_a_failure(folder):
    write_account(folder, "rostest-queue.xml", "fail")
    (folder / "test_results/rostest-queue.xml").write_text(
        '<testsuite><testcase classname="__main__.RosTest" name="testqueue_test">'
        '<failure message="did not generate test results"/></testcase></testsuite>')
    assert outcomes(folder) == [("build/rostest-queue", "__main__.RosTest.testqueue_test", "failed")]


def test_the_last_line_counts_and_the_reasons_are_listed():
    cases = [case("passed"), case("passed"), case("skipped", "no data"), case("skipped", "no data")]
    assert summary(cases) == (0, ["skipped: 2 (2 x no data)", "2 passed, 0 failed"])


def test_failures_come_with_their_message():
    failed, lines = summary([case("failed", "1 != 2")])
    assert failed == 1
    assert lines == ["FAILED  build/queue_test: Queue.Waits", "        1 != 2", "0 passed, 1 failed"]


def test_no_test_may_skip_for_lack_of_data_that_is_there(tmp_path):
    skipped = case("skipped", "desk is not there; set SEMANTIC_SLAM_SHARED to test it")
    judged = summarise_tests.needless_skips_as_failures([skipped], tmp_path)
    assert [c.outcome for c in judged] == ["failed"]
    assert summarise_tests.needless_skips_as_failures([skipped], None) == [skipped]


def test_a_test_that_has_run_elsewhere_may_skip(tmp_path):
    skipped = case("skipped", "desk is not there; set SEMANTIC_SLAM_SHARED to test it")
    cases = [case("passed"), skipped]
    assert summarise_tests.needless_skips_as_failures(cases, tmp_path) == cases
