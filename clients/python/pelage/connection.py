"""HTTP with retries."""

from __future__ import annotations

import contextlib
import http.client
import json
import random
import shutil
import socket
import threading
import time
import urllib.parse
import uuid
from typing import Any, BinaryIO, Dict, Iterator, Mapping, NamedTuple, Optional

from .errors import PelageError, Unreachable, problem_of
from .progress import Progress, ReportProgress

IDLE_SECONDS = 1.0  # a server closes a connection that nobody uses after 2 seconds
LONGEST_DELAY = 30.0  # seconds between two tries
CHUNK = 1 << 18  # bytes that are sent or written at a time
LOST = (OSError, http.client.HTTPException)

Query = Mapping[str, Any]


class Request(NamedTuple):
    """repeatable: Whether sending it twice does no harm. into: Takes the body of a good answer."""

    method: str
    path: str
    content: Optional[bytes]
    headers: Dict[str, str]
    repeatable: bool
    progress: Optional[ReportProgress] = None
    into: Optional[BinaryIO] = None


class Answer(NamedTuple):
    """headers: Names in lower case."""

    status: int
    headers: Dict[str, str]
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


class Connection:
    """A server's address. Any number of threads may use it; each has a connection of its own, which is kept open.

    Requests that do no harm when they are sent twice are tried again when the connection is lost: those that read, and
    those that carry an Idempotency-Key. All are tried again when the server has no room (429, 503) or is not there yet.
    """

    def __init__(self, address: str, token: Optional[str], timeout: float, retries: int) -> None:
        """timeout: Seconds without a sign of the server. retries: Tries after the first.

        Raises ValueError for an address that is not http or https.
        """
        parts = urllib.parse.urlsplit(address)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise ValueError(f"{address!r} is no address of a server, such as http://127.0.0.1:8080")
        self.address = address.rstrip("/")
        self.retries = retries
        self._parts = parts
        self._timeout = timeout
        self._headers = {"Authorization": f"Bearer {token}"} if token else {}
        self._threads = threading.local()

    def get(self, path: str, query: Optional[Query] = None, *, retries: Optional[int] = None) -> Answer:
        return self._answer(Request("GET", with_query(path, query), None, {}, True), retries)

    def get_into(self, file: BinaryIO, path: str, query: Optional[Query] = None) -> Answer:
        """The answer without its body, which is written to the file as it comes."""
        return self._answer(Request("GET", with_query(path, query), None, {}, True, into=file))

    def post(
        self,
        path: str,
        document: Mapping[str, Any],
        *,
        query: Optional[Query] = None,
        headers: Optional[Mapping[str, str]] = None,
        changes: bool = True,
    ) -> Answer:
        """changes: Whether the request changes something, and so needs a key to be sent twice."""
        sent = {"Content-Type": "application/json", **(headers or {})}
        if changes:
            sent["Idempotency-Key"] = uuid.uuid4().hex
        return self._answer(Request("POST", with_query(path, query), encoded(document), sent, True))

    def put(
        self,
        path: str,
        content: bytes,
        *,
        query: Optional[Query] = None,
        headers: Optional[Mapping[str, str]] = None,
        repeatable: bool = False,
        progress: Optional[ReportProgress] = None,
    ) -> Answer:
        sent = {"Content-Type": "application/octet-stream", **(headers or {})}
        return self._answer(Request("PUT", with_query(path, query), content, sent, repeatable, progress))

    def post_bytes(self, path: str, content: bytes, query: Optional[Query] = None) -> Answer:
        sent = {"Content-Type": "application/octet-stream"}
        return self._answer(Request("POST", with_query(path, query), content, sent, False))

    def delete(self, path: str) -> Answer:
        return self._answer(Request("DELETE", path, None, {}, False))

    @contextlib.contextmanager
    def stream(self, path: str, headers: Mapping[str, str], timeout: float) -> Iterator[http.client.HTTPResponse]:
        """An answer that is read line by line, on a connection of its own. Raises `Problem` where it is refused."""
        with contextlib.closing(self._connect(timeout)) as connection:
            connection.request("GET", self._parts.path.rstrip("/") + path, headers={**self._headers, **headers})
            with connection.getresponse() as answer:
                if answer.status >= 400:
                    raise problem_of(answer.status, answer.read())
                yield answer

    def close(self) -> None:
        """Closes the connection of this thread; a later request opens another."""
        connection = getattr(self._threads, "connection", None)
        if connection is not None:
            connection.close()

    def _answer(self, request: Request, retries: Optional[int] = None) -> Answer:
        left = self.retries if retries is None else retries
        lost = False
        for attempt in range(left + 1):
            try:
                answer = self._once(request)
                if attempt == left or not is_refused_for_now(answer, lost):
                    return checked(answer)
                time.sleep(delay(attempt, answer.headers.get("retry-after", "")))
            except LOST as error:
                self.close()
                again = request.repeatable or isinstance(error, ConnectionRefusedError)
                if attempt == left or not again or isinstance(error, socket.timeout):
                    raise Unreachable(f"{self.address} does not answer: {error or type(error).__name__}") from error
                lost = True
                time.sleep(delay(attempt))
        raise AssertionError("the last attempt returns or raises")

    def _once(self, request: Request) -> Answer:
        connection = self._connection(request.repeatable)
        headers = {**self._headers, **request.headers}
        content: Any = request.content
        if request.content is not None and request.progress is not None:
            headers["Content-Length"] = str(len(request.content))
            content = in_chunks(request.content, request.progress)
        try:
            connection.request(request.method, self._parts.path.rstrip("/") + request.path, content, headers)
        except (BrokenPipeError, ConnectionResetError):
            if request.content is None:
                raise
            # A server that refuses a body need not read it: its answer may be there all the same.
        answer = connection.getresponse()
        body = answer.read() if request.into is None or answer.status != 200 else copied(answer, request.into)
        self._threads.used = time.monotonic()
        return Answer(answer.status, {name.lower(): value for name, value in answer.getheaders()}, body)

    def _connection(self, repeatable: bool) -> http.client.HTTPConnection:
        """That of this thread; a new one where the server may have closed it, or nothing may be sent twice."""
        connection: Optional[http.client.HTTPConnection] = getattr(self._threads, "connection", None)
        if connection is None or not repeatable or time.monotonic() - self._threads.used > IDLE_SECONDS:
            self.close()
            connection = self._connect(self._timeout)
            self._threads.connection = connection
            self._threads.used = time.monotonic()
        return connection

    def _connect(self, timeout: float) -> http.client.HTTPConnection:
        host, port = str(self._parts.hostname), self._parts.port
        if self._parts.scheme == "https":
            return http.client.HTTPSConnection(host, port, timeout=timeout)
        return http.client.HTTPConnection(host, port, timeout=timeout)


def checked(answer: Answer) -> Answer:
    if answer.status >= 400:
        raise problem_of(answer.status, answer.body)
    return answer


def copied(answer: http.client.HTTPResponse, file: BinaryIO) -> bytes:
    """Writes the body to the file, in place of what an earlier try wrote, and gives none."""
    file.seek(0)
    file.truncate()
    shutil.copyfileobj(answer, file, CHUNK)
    if answer.length:  # of a body that ends early http.client says nothing
        raise http.client.IncompleteRead(b"", answer.length)
    return b""


def is_refused_for_now(answer: Answer, lost: bool) -> bool:
    """Whether a later try may get another answer. After a lost connection the first try may still run (409)."""
    return answer.status in (429, 503) or (lost and answer.status == 409)


def delay(attempt: int, retry_after: str = "") -> float:
    """Seconds before the next try: what the server says, else twice as many each time, not the same for all clients."""
    if retry_after.isdecimal():
        return min(LONGEST_DELAY, float(retry_after))
    return min(LONGEST_DELAY, 0.1 * 2.0**attempt * random.uniform(0.5, 1))


def in_chunks(content: bytes, progress: ReportProgress) -> Iterator[bytes]:
    """The content in parts, with a report after each."""
    for begin in range(0, len(content), CHUNK):
        yield content[begin : begin + CHUNK]
        done = min(len(content), begin + CHUNK)
        progress(Progress(done / len(content), f"{done / 1e6:.1f} of {len(content) / 1e6:.1f} MB sent"))


def encoded(document: Mapping[str, Any]) -> bytes:
    """JSON. NumPy's arrays and numbers are written as lists and numbers; NaN and infinity raise ValueError."""
    return json.dumps(document, allow_nan=False, default=plain).encode()


def plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise PelageError(f"{type(value).__name__} cannot be sent as JSON")


def with_query(path: str, query: Optional[Query]) -> str:
    """The path with the query; members that are None are left out, lists have commas."""
    given = {name: query_text(value) for name, value in (query or {}).items() if value is not None}
    return f"{path}?{urllib.parse.urlencode(given)}" if given else path


def query_text(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ",".join(map(query_text, value))
    return str(value)


def quoted(name: str) -> str:
    """A name as one part of a path."""
    return urllib.parse.quote(name, safe="")
