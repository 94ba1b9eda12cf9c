"""Prints why cases failed and counts the cases of all runners; its last line is `N passed, N failed, N skipped`.

usage: count.py FOLDER CTEST [--no-skips]   FOLDER has GoogleTest's XML files, CTEST is the file of `ctest --output-junit`. Fails if
a case failed, if there are none, and with --no-skips if GoogleTest skipped one. Python skips a case if the machine lacks a program
or a right for it; in CI such a case fails by itself.
"""
import collections
import pathlib
import re
import sys
import xml.etree.ElementTree as xml


MAX_LINES = 40  # printed for one failure
NODE_FAILURE = r"^ *not ok .*\n(?:(?! *\.\.\.$).*\n)*"
UNITTEST_FAILURE = r"^=+\n(?:FAIL|ERROR): .*\n(?:(?!=+$|Ran \d).*\n)*"
GOOGLETEST_FAILURE = r"^\[ RUN .*\n(?:(?!\[ {7}OK|\[  FAILED).*\n)*\[  FAILED.*\n"


def failures_in(text):
    """Returns the output of a runner for each failed test; the end of the output if it has none."""
    return re.findall("|".join((NODE_FAILURE, UNITTEST_FAILURE, GOOGLETEST_FAILURE)), text, re.M) or ["\n".join(text.splitlines()[-MAX_LINES:])]


def print_failures(ctest):
    """Prints the failures again at the end of all output, so that they are found without reading what passed."""
    for case in xml.parse(ctest).iter("testcase"):
        if case.find("failure") is None:
            continue
        for failure in failures_in(case.findtext("system-out") or ""):
            print(f"--- {case.get('name')}", *failure.splitlines()[:MAX_LINES], sep="\n")


def outcome(case):
    if case.find("failure") is not None:
        return "failed"
    return "skipped" if case.get("result") == "skipped" else "passed"


def cases_of_googletest(path):
    for case in xml.parse(path).iter("testcase"):
        if case.get("status") == "run" or case.get("result") == "skipped":
            yield f"{path.stem} {case.get('classname')}.{case.get('name')}", outcome(case), 1


def number(pattern, text):
    found = re.search(pattern, text, re.M)
    return int(found[1]) if found else 0


def counts_in(text):
    """Returns the numbers of passed, failed and skipped cases that unittest or node print at their end; None for others."""
    ran = re.search(r"^Ran (\d+) tests? in", text, re.M)
    if ran:
        failed = number(r"^FAILED .*failures=(\d+)", text) + number(r"^FAILED .*errors=(\d+)", text)
        skipped = number(r"^(?:OK|FAILED) .*skipped=(\d+)", text)
        return int(ran[1]) - failed - skipped, failed, skipped
    if re.search(r"^# pass \d+$", text, re.M):
        return tuple(number(rf"^# {word} (\d+)$", text) for word in ("pass", "fail", "skipped"))
    return None


def cases_of_program(case):
    """Yields the counts of a program without GoogleTest. If it fails, at least one case counts as failed."""
    name, good = case.get("name"), case.find("failure") is None
    passed, failed, skipped = counts_in(case.findtext("system-out") or "") or (int(good), 0, 0)
    yield name, "passed", passed
    yield name, "failed", failed if good else max(failed, 1)
    yield name, "skipped by choice", skipped


def cases(folder, ctest):
    of_googletest = {path.stem: path for path in sorted(pathlib.Path(folder).glob("*.xml"))}
    for case in xml.parse(ctest).iter("testcase"):
        path = of_googletest.pop(case.get("name"), None)
        found = list(cases_of_googletest(path)) if path else []
        if path is None or (case.find("failure") is not None and all(what != "failed" for _, what, _ in found)):
            found += cases_of_program(case)  # also one that crashed after its cases
        yield from found


def main():
    folder, ctest, *options = sys.argv[1:]
    count = collections.Counter()
    print_failures(ctest)
    for name, what, times in cases(folder, ctest):
        count[what] += times
        if what != "passed" and times:
            print(f"{what}: {name}" + (f" ({times})" if times > 1 else ""))
    print(f"{count['passed']} passed, {count['failed']} failed, {count['skipped'] + count['skipped by choice']} skipped")
    no_skips = "--no-skips" in options
    sys.exit(count["failed"] > 0 or count["passed"] == 0 or (no_skips and count["skipped"] > 0))


main()
