"""Errors of `pelage farm`, with advice and exit code."""

from __future__ import annotations

from ..errors import PelageError

FAILED, WRONG_USE, BAD_INPUT = 1, 2, 3  # exit codes, same as those of `pelage`


class FarmError(PelageError):
    """step: What to do next. code: The exit code of the program."""

    def __init__(self, message: str, step: str, code: int = FAILED) -> None:
        super().__init__(message)
        self.step = step
        self.code = code
