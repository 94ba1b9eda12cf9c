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

IDLE_SECONDS = 1.0  # a connection idle for longer is replaced; the server closes one after 2 seconds
LONGEST_DELAY = 30.0  # seconds between two tries
CHUNK = 1 << 18  # bytes that are sent or written at a time
LOST = (OSError, http.client.HTTPException)

Query = Mapping[str, Any]


class Request(NamedTuple):
    """repeatable: True if sending it twice does no harm. into: File for the body of a successful answer."""

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
        """timeout: Seconds without data from the server. retries: Attempts after the first.

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
        """Writes the body to the file as it arrives; returns the answer without it."""
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
        """changes: True if the request changes something and so needs an Idempotency-Key for retries."""
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
        """Opens an answer to be read line by line, on a separate connection. Raises `Problem` if it is refused."""
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
            # Sending failed, but a server that refuses a body may have answered without reading it.
        answer = connection.getresponse()
        body = answer.read() if request.into is None or answer.status != 200 else copied(answer, request.into)
        self._threads.used = time.monotonic()
        return Answer(answer.status, {name.lower(): value for name, value in answer.getheaders()}, body)

    def _connection(self, repeatable: bool) -> http.client.HTTPConnection:
        """Returns this thread's connection; a new one if the server may have closed it or a retry is not allowed."""
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
    """Writes the body to the file, replacing what an earlier attempt wrote. Returns an empty body."""
    file.seek(0)
    file.truncate()
    shutil.copyfileobj(answer, file, CHUNK)
    if answer.length:  # http.client does not report a body that ends early
        raise http.client.IncompleteRead(b"", answer.length)
    return b""


def is_refused_for_now(answer: Answer, lost: bool) -> bool:
    """Returns True if a retry may succeed. After a lost connection the first attempt may still be running (409)."""
    return answer.status in (429, 503) or (lost and answer.status == 409)


def delay(attempt: int, retry_after: str = "") -> float:
    """Returns the seconds before the next attempt: Retry-After, else exponential backoff with jitter."""
    if retry_after.isdecimal():
        return min(LONGEST_DELAY, float(retry_after))
    return min(LONGEST_DELAY, 0.1 * 2.0**attempt * random.uniform(0.5, 1))


def in_chunks(content: bytes, progress: ReportProgress) -> Iterator[bytes]:
    """Yields the content in chunks and reports the progress after each."""
    for begin in range(0, len(content), CHUNK):
        yield content[begin : begin + CHUNK]
        done = min(len(content), begin + CHUNK)
        progress(Progress(done / len(content), f"{done / 1e6:.1f} of {len(content) / 1e6:.1f} MB sent"))


def encoded(document: Mapping[str, Any]) -> bytes:
    """Encodes as JSON. NumPy arrays and numbers become lists and numbers; NaN and infinity raise ValueError."""
    return json.dumps(document, allow_nan=False, default=plain).encode()


def plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise PelageError(f"{type(value).__name__} cannot be sent as JSON")


def with_query(path: str, query: Optional[Query]) -> str:
    """Returns the path with the query string; omits members that are None, joins lists with commas."""
    given = {name: query_text(value) for name, value in (query or {}).items() if value is not None}
    return f"{path}?{urllib.parse.urlencode(given)}" if given else path


def query_text(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ",".join(map(query_text, value))
    return str(value)


def quoted(name: str) -> str:
    """Percent-encodes a name as one segment of a path."""
    return urllib.parse.quote(name, safe="")
