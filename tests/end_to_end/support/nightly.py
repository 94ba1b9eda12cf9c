"""Marks a test, or a class of them, that takes too long for each day: tests/nightly.sh runs it."""


def nightly(test):
    test.nightly = True
    return test
