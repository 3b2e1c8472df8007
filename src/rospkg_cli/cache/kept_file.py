"""A file of the cache: fields of text, replaced in one step; one that is damaged counts as absent."""

from __future__ import annotations

import os
from zlib import crc32

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

MAGIC = b"rospkg-cache-1"
MAX_BYTES = 30_000_000
"""A larger file is not kept, nor read."""

STRAY = ".rospkg-tmp"
"""How the name of a file ends that is being written."""


def load(path: str) -> list[str] | None:
    """Return the fields of a file; None where it is absent, damaged or of another form."""
    try:
        with open(path, "rb") as stream:
            head, _, body = stream.read(MAX_BYTES).partition(b"\n")
        if head != header(body):
            return None
        return body.decode("utf-8", "surrogatepass").split("\0")
    except (OSError, UnicodeError, MemoryError):
        return None


def save(path: str, fields: Sequence[str]) -> None:
    """Write a file in one step, or not at all: a full disk or a field that holds a NUL says nothing."""
    text = "\0".join(fields)
    body = text.encode("utf-8", "surrogatepass")
    if text.count("\0") != len(fields) - 1 or len(body) > MAX_BYTES - 100:
        return
    name = f"{path}.{os.getpid()}{STRAY}"
    try:
        descriptor = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
    except OSError:
        return
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(header(body) + b"\n" + body)
        os.replace(name, path)
    except BaseException as error:
        remove(name)
        if not isinstance(error, OSError):
            raise


def header(body: bytes) -> bytes:
    return b"%s %08x %d" % (MAGIC, crc32(body), len(body))


def remove(path: str) -> int:
    """Remove a file; return how many bytes that gives back."""
    try:
        size = os.lstat(path).st_size
        os.unlink(path)
    except OSError:
        return 0
    return size
