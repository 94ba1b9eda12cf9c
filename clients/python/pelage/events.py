"""Server-sent events, and the news of a scene."""

from __future__ import annotations

import json
import time
from typing import Any, Dict, Iterable, Iterator, NamedTuple, Optional, Union, cast

from .connection import LOST, Connection, delay
from .errors import Busy, Unreachable
from .schemas import ChangeEvent, SceneEvent

SILENCE = 60.0  # seconds without data after which a connection counts as lost; the server sends a comment every 15


class Message(NamedTuple):
    """event: Its type, "message" by default. data: Its lines. id: Id of this message, else of the latest that had one."""

    event: str
    data: str
    id: str


class SceneState(NamedTuple):
    """The state of a scene: the first event, sent again after a new model or a subdivision."""

    revision: int
    data: SceneEvent


class Change(NamedTuple):
    """One revision of the log."""

    revision: int
    data: ChangeEvent


class Removed(NamedTuple):
    """The scene was removed; the last event. revision: The last known one."""

    revision: int


News = Union[SceneState, Change, Removed]


def messages(lines: Iterable[bytes]) -> Iterator[Message]:
    """Parses a stream of server-sent events. Drops an event that no empty line ends."""
    members: Dict[str, str] = {}
    last_id = ""
    for raw in lines:
        line = raw.decode("utf-8", "replace").rstrip("\r\n")
        if line:
            name, _, value = line.partition(":")
            value = value[1:] if value.startswith(" ") else value
            members[name] = f"{members[name]}\n{value}" if name == "data" and name in members else value
            continue
        last_id = members.get("id", last_id)
        if "data" in members:
            yield Message(members.get("event", "message"), members["data"], last_id)
        members = {}


def follow(connection: Connection, path: str, since: Optional[int]) -> Iterator[News]:
    """Yields events in order without gaps. Reconnects and resumes, at most `retries` times in a row.

    since: The last revision that is known, after which changes come first.
    Raises NotFound, Busy or Unreachable.
    """
    failures = 0
    while True:
        headers = {} if since is None else {"Last-Event-ID": str(since)}
        try:
            with connection.stream(path, headers, SILENCE) as stream:
                for message in messages(stream):
                    failures = 0
                    news = news_of(message, since or 0)
                    since = news.revision
                    yield news
                    if isinstance(news, Removed):
                        return
            reason: Any = "the stream ended"
        except (Busy, *LOST) as error:
            reason = error
        if failures == connection.retries:
            if isinstance(reason, Busy):
                raise reason
            raise Unreachable(f"{connection.address} does not answer: {reason}")
        time.sleep(delay(failures))
        failures += 1


def news_of(message: Message, last: int) -> News:
    data = json.loads(message.data)
    if message.event == "removed":
        return Removed(last)
    if message.event == "change":
        return Change(data["revision"], cast(ChangeEvent, data))
    return SceneState(data["revision"], cast(SceneEvent, data))
