"""Messages of the Language Server Protocol in a stream of bytes: a header with their length, and a body."""

from __future__ import annotations

from collections.abc import Iterator
from typing import BinaryIO


def bodies(stream: BinaryIO) -> Iterator[bytes]:
    """Yield the body of each message, until the stream ends or breaks off."""
    while header := stream.readline():
        length = 0
        while header.strip():
            name, _, value = header.partition(b":")
            if name.strip().lower() == b"content-length" and value.strip().isdigit():
                length = int(value)
            header = stream.readline()
        body = stream.read(length)
        if len(body) < length:
            return
        if body:
            yield body


def framed(body: bytes) -> bytes:
    """Return a message with its header."""
    return b"Content-Length: %d\r\n\r\n" % len(body) + body
