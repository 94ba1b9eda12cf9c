"""Runs the tests of a folder in one process: those of each day, or those that are marked `@nightly`.

usage: run.py FOLDER [--nightly] [WORD...]     WORDs: only tests whose names have one of them
"""

import sys
import time
import unittest

SLOWEST = 8  # that are named at the end


def tests_of(suite):
    for test in suite:
        yield from tests_of(test) if isinstance(test, unittest.TestSuite) else (test,)


def is_nightly(test):
    return getattr(getattr(test, test._testMethodName, test), "nightly", False) or getattr(test, "nightly", False)


class TimedResult(unittest.TextTestResult):
    seconds = {}

    def startTest(self, test):
        self.began = time.monotonic()
        super().startTest(test)

    def stopTest(self, test):
        self.seconds[test.id()] = time.monotonic() - self.began
        super().stopTest(test)


def main(folder, *words):
    nightly = "--nightly" in words
    wanted = [word for word in words if word != "--nightly"]
    found = unittest.defaultTestLoader.discover(folder, pattern="test_*.py", top_level_dir=".")
    suite = unittest.TestSuite(test for test in tests_of(found) if is_nightly(test) == nightly and
                               (not wanted or any(word in test.id() for word in wanted)))
    result = unittest.TextTestRunner(resultclass=TimedResult, verbosity=2).run(suite)
    for name, seconds in sorted(TimedResult.seconds.items(), key=lambda item: -item[1])[:SLOWEST]:
        print(f"{seconds:7.1f} s  {name}")
    sys.exit(not result.wasSuccessful())


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.path.insert(0, ".")
    main(*sys.argv[1:])
