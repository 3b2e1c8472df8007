"""Read a file or a URL to its end, or say in one sentence why not."""

from __future__ import annotations

from http.client import HTTPException
from pathlib import Path
from typing import Any
from urllib.error import HTTPError, URLError
from urllib.request import Request, urlopen

from .. import __version__
from . import NamesError
from .file_url import FileUrl, path_of

TIMEOUT = 20.0
"""Seconds in which nothing comes."""

MAX_BYTES = 64_000_000
"""The largest of these files has less than a million."""

NOT_THERE = (404, 410)


class NotThereError(NamesError):
    """The place can be asked and has no such file."""


def fetch(place: FileUrl, timeout: float = TIMEOUT) -> bytes:
    """Return the bytes of a place; raises NotThereError, and NamesError where they do not come whole."""
    refuse_no_file(place)
    try:
        request = Request(place.url, headers={"User-Agent": f"rospkg/{__version__}"})
        with urlopen(request, timeout=timeout) as answer:
            data: bytes = answer.read(MAX_BYTES + 1)
            promised = answer.headers.get("Content-Length", "")
    except HTTPError as error:
        kind = NotThereError if error.code in NOT_THERE else NamesError
        raise kind(f"{place} can't be read: the server answers {error.code} {error.reason}") from None
    except URLError as error:
        kind = NotThereError if isinstance(error.reason, FileNotFoundError) else NamesError
        raise kind(f"{place} can't be read: {reason(error.reason)}") from None
    except (OSError, HTTPException, ValueError) as error:
        raise NamesError(f"{place} can't be read: {reason(error)}") from None
    if len(data) > MAX_BYTES:
        raise NamesError(f"{place} is larger than {MAX_BYTES // 1_000_000} MB, which none of these files is")
    if promised.isdecimal() and len(data) != int(promised):
        raise NamesError(f"{place} can't be read: {len(data)} of {promised} bytes came; try again")
    return data


def refuse_no_file(place: FileUrl) -> None:
    """Raise NamesError for a FIFO, a device or a folder of this machine, which could be waited for without end."""
    path = Path(path_of(place.url)) if place.url.startswith("file:") else None
    if path is not None and path.exists() and not path.is_file():
        raise NamesError(f"{place} can't be read: it is not a file")


def reason(error: Any) -> str:
    """Return what went wrong in the system's own words."""
    if isinstance(error, TimeoutError):
        return "nothing comes from there; is there a network, or a proxy to name in https_proxy?"
    said = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return f"{said}; is there a network, or a proxy to name in https_proxy?" if is_network(error) else said


def is_network(error: object) -> bool:
    import socket

    return isinstance(error, socket.gaierror | ConnectionError) or getattr(error, "errno", None) in (101, 113)
