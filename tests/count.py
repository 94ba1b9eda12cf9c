"""Counts the cases in GoogleTest's XML files; its last line is `N passed, N failed, N skipped`.

usage: count.py FOLDER [--no-skips]   fails where a case failed, where there are none, and at a skip with --no-skips
"""
import pathlib
import sys
import xml.etree.ElementTree as xml


def outcome(case):
    if case.find("failure") is not None:
        return "failed"
    return "skipped" if case.get("result") == "skipped" else "passed"


def cases(folder):
    for path in sorted(pathlib.Path(folder).glob("*.xml")):
        for case in xml.parse(path).iter("testcase"):
            if case.get("status") == "run" or case.get("result") == "skipped":
                yield path.stem, f"{case.get('classname')}.{case.get('name')}", outcome(case)


def main():
    folder, *options = sys.argv[1:]
    count = {"passed": 0, "failed": 0, "skipped": 0}
    for program, name, what in cases(folder):
        count[what] += 1
        if what != "passed":
            print(f"{what}: {program} {name}")
    print("{passed} passed, {failed} failed, {skipped} skipped".format(**count))
    no_skips = "--no-skips" in options
    sys.exit(count["failed"] > 0 or count["passed"] == 0 or (no_skips and count["skipped"] > 0))


main()
