"""Exceptions. All of them are a PelageError."""

from __future__ import annotations

import json
from typing import Any, Dict, Optional


class PelageError(Exception):
    """What goes wrong between this package and a server."""


class Unreachable(PelageError):
    """No server answers at the address, the connection was lost, or no answer came in time."""


class NotStarted(PelageError):
    """A private server did not start. The message has the end of what it printed."""


class Problem(PelageError):
    """The server refused a request; nothing was changed by it.

    status: The HTTP status.
    title, detail: What is wrong, in general and in this case.
    pointer: JSON pointer of the bad member of the request, or None.
    limit: The limit that was broken, or None.
    nearest: The nearest known name to an unknown one, or None.
    document: The whole problem document (RFC 9457).
    """

    def __init__(self, status: int, document: Dict[str, Any]) -> None:
        self.status = status
        self.document = document
        self.title = str(document.get("title", f"The server answered {status}"))
        self.detail = str(document.get("detail", ""))
        self.pointer: Optional[str] = document.get("pointer")
        self.limit: Optional[str] = document.get("limit")
        self.nearest: Optional[str] = document.get("nearest")
        super().__init__(status, document)

    def __str__(self) -> str:
        hints = [f"{name}: {value}" for name, value in
                 (("field", self.pointer), ("limit", self.limit), ("nearest", self.nearest)) if value]
        return f"{self.status} {self.title}: {self.detail}" + (f" ({'; '.join(hints)})" if hints else "")


class Refused(Problem):
    """The request is at fault (4xx)."""


class NotFound(Refused):
    """There is no such scene or address (404)."""


class Conflict(Refused):
    """412: the scene is at another revision than `if_match`. 409: a newer frame took the view, a groom would be lost, or
    the server holds as many scenes as it takes."""


class Busy(Problem):
    """The server has other work or no room (429, 503), also after all retries."""


class Failed(Problem):
    """The server is at fault (500 and above)."""


def problem_of(status: int, body: bytes) -> Problem:
    """The exception for an answer of 400 or above; a body that is no problem document becomes its detail."""
    try:
        document = json.loads(body)
    except ValueError:
        document = None
    if not isinstance(document, dict):
        document = {"status": status, "detail": body[:200].decode("utf-8", "replace")}
    if status in (429, 503):
        return Busy(status, document)
    if status >= 500:
        return Failed(status, document)
    return {404: NotFound, 409: Conflict, 412: Conflict}.get(status, Refused)(status, document)
